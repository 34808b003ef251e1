/* `--device`: a frame by each highlight unit, what is no option of one, the unit's points through
 * `eval`, and a packet of a wrong one's frame, which is of that unit. */
#define _XOPEN_SOURCE 700
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "../scratch.h"
#include "run.h"

static void expect(const char *command_line, const char *input, int status, const char *err)
{
    outcome done = run(command_line, input);
    assert_outcome(&done, status, err);
    forget(&done);
}

static void frames_in_c_and_verilog_are_equal(void **state)
{
    (void)state;
    static const char *const devices[] = {
        "power --accuracy quarter", "log2", "schlick", "newton", "lyon", "bipartite", "quadratic",
        "specular --gate sign"};
    for (size_t i = 0; i < sizeof devices / sizeof devices[0]; i++) {
        char line[512];
        (void)snprintf(line, sizeof line,
                       "render --device %s --lanes 1 --backend both --model sphere %s"
                       "--size 96x80 --force --out %s",
                       devices[i], strcmp(devices[i], "bipartite") != 0 ? "--n 50 " : "",
                       scratch_path("frame.png"));
        outcome done = run(line, "");
        assert_outcome(&done, 0, "");
        assert_says(done.out, "\n0 differing pixels of 7680\n");
        forget(&done);
    }
}

static void json_names_the_device(void **state)
{
    (void)state;
    char line[512];
    (void)snprintf(line, sizeof line, "render --device lyon --k 8 --size 64x48 --json --out %s",
                   scratch_path("named.png"));
    outcome done = run(line, "");
    assert_outcome(&done, 0, "");
    assert_says(done.out, "\"device\":\t\"lyon\"");
    assert_says(done.out, "\"k\":\t\"8\"");
    assert_null(strstr(done.out, "\"gate\""));
    forget(&done);
}

static void what_does_not_apply_is_refused(void **state)
{
    (void)state;
    expect("render --device power --gate sign --out a.png", "", 2,
           "glint render: --gate is of --device specular, not of power\n");
    expect("render --k 8 --out a.png", "", 2,
           "glint render: --k is of --device lyon, not of specular\n");
    expect("render --device power --backend real --specular blinn --out a.png", "", 2,
           "glint render: --specular and --device both name what computes the highlights: give one "
           "of them\n");
    expect("eval --device power --circuit power", "", 2,
           "glint eval: --device and --circuit name the same thing: give one of them\n");
    expect("render --device bipartite --exponent 16 --n 8 --out /dev/null/a.png", "", 2,
           "glint render: --n 8: --device bipartite with --exponent 16 is for that n alone\n");
}

static void eval_takes_points(void **state)
{
    (void)state;
    static const char *const backends[] = {"c", "rtl"};
    for (size_t i = 0; i < 2; i++) {
        char line[128];
        (void)snprintf(line, sizeof line, "eval --device power --lanes 1 --backend %s",
                       backends[i]);
        outcome done = run(line, "80 0.99 255 190 110\n0 0 1 2 3\n");
        assert_outcome(&done, 0, "");
        /* 0.99^80 is 0.4475: 1833 of 4096. */
        assert_string_equal(done.out,
                            "n,cos_code,w_code,r,g,b\n80,259523,1833,114,85,49\n0,0,4096,1,2,3\n");
        forget(&done);
    }
}

static void info_is_of_the_device(void **state)
{
    (void)state;
    outcome done = run("info --device power", "");
    assert_outcome(&done, 0, "");
    assert_says(done.out, "Power device");
    forget(&done);
}

/* Key block 12 shifts one place less where the integer part of L is 3. */
static void plant(void)
{
    const char *const argv[] = {
        "sh", "-c",
        "rm -rf \"$0\" && cp -r rtl \"$0\" && sed -i 's/? rom33 >> "
        "s3_mul10\\[G_BITS-1:TABLE_BITS\\]/"
        "? rom33 >> (s3_mul10[G_BITS-1:TABLE_BITS] - (s3_mul10[G_BITS-1:TABLE_BITS] == 3))/' "
        "\"$0\"/power_lane.v && ! cmp -s rtl/power_lane.v \"$0\"/power_lane.v",
        scratch_path("wrong"), NULL};
    pid_t child;
    assert_int_equal(posix_spawnp(&child, "sh", NULL, NULL, (char **)(uintptr_t)argv, environ), 0);
    assert_int_equal(wait_for(child), 0);
}

static void a_packet_is_of_the_device(void **state)
{
    (void)state;
    char line[1024];
    plant();
    (void)snprintf(line, sizeof line,
                   "render --device power --lanes 1 --backend both --model sphere --n 50 "
                   "--size 96x80 --out %s --rtl %s",
                   scratch_path("wrong.png"), scratch_path("wrong"));
    outcome done = run(line, "");
    assert_int_equal(done.status, 1);
    assert_says(done.out, "12, W: model ");
    assert_says(done.out, " eval --backend rtl --circuit power --accuracy half ");
    forget(&done);
    (void)snprintf(line, sizeof line, "replay %s --rtl %s", scratch_path("wrong-failure"),
                   scratch_path("wrong"));
    done = run(line, "");
    assert_outcome(&done, 1, "");
    assert_says(done.out, ": the same mismatch; ");
    forget(&done);
    (void)snprintf(line, sizeof line, "replay %s", scratch_path("wrong-failure"));
    expect(line, "", 0, NULL);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(frames_in_c_and_verilog_are_equal),
        cmocka_unit_test(json_names_the_device),
        cmocka_unit_test(what_does_not_apply_is_refused),
        cmocka_unit_test(eval_takes_points),
        cmocka_unit_test(info_is_of_the_device),
        cmocka_unit_test(a_packet_is_of_the_device),
    };
    return cmocka_run_group_tests(tests, scratch_make, scratch_remove);
}
