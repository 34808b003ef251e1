/* What the command does when C and Verilog differ: $GLINT_BUILD/wrong/glint is the command with one
 * circuit, that of tests/lockstep/wrong/truncating, whose multipliers 13, 14, 15 cut off where the
 * C model rounds. */
#define _XOPEN_SOURCE 700

#include <inttypes.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "../scratch.h"
#include "image/image.h"
#include "run.h"
#include "wave/waveform.h"

static int choose_wrong_command(void **state)
{
    static char setting[1024];
    const char *build = getenv("GLINT_BUILD");
    (void)snprintf(setting, sizeof setting, "GLINT=%s/wrong/glint",
                   build != NULL ? build : "build");
    return putenv(setting) == 0 ? scratch_make(state) : -1;
}

static glint_image *read_picture(const char *path)
{
    glint_error err;
    glint_image *image;
    if (glint_image_read_png(path, &image, &err) != GLINT_OK) {
        fail_msg("%s", err.text);
    }
    return image;
}

static void a_frame_that_differs_is_a_failure(void **state)
{
    (void)state;
    char command_line[2048];
    glint_error err;
    glint_image_difference difference;
    (void)snprintf(command_line, sizeof command_line,
                   "render --model sphere --size 64x48 --lanes 1 --backend both --out %s",
                   scratch_path("frame.png"));
    outcome done = run(command_line, "");
    assert_int_equal(done.status, 1);
    glint_image *rtl = read_picture(scratch_path("frame.png"));
    glint_image *c = read_picture(scratch_path("frame-c.png"));
    glint_image *picture = read_picture(scratch_path("frame-diff.png"));
    assert_int_equal(glint_image_compare(c, rtl, &difference, &err), GLINT_OK);
    assert_true(difference.differing_pixels > 0);
    assert_int_equal(difference.largest, 1); /* cut off instead of rounded */
    (void)snprintf(command_line, sizeof command_line, "%" PRIu64 " differing pixels of %d",
                   difference.differing_pixels, 64 * 48);
    assert_says(done.out, command_line);
    glint_image_destroy(rtl);
    glint_image_destroy(c);
    glint_image_destroy(picture);
    forget(&done);
}

/* The words behind "NAME: " up to the end of the line; false when there is no such line. */
static bool find_line(const char *text, const char *name, char *line, size_t size)
{
    const char *at = strstr(text, name);
    if (at == NULL) {
        return false;
    }
    at += strlen(name);
    at += strspn(at, " ");
    (void)snprintf(line, size, "%.*s", (int)strcspn(at, "\n"), at);
    return true;
}

static void a_mismatch_is_a_failure_that_can_be_replayed(void **state)
{
    (void)state;
    char command_line[2048];
    char replay[1024];
    char first[1024];
    char again[1024];
    glint_error err;
    glint_wave_info info;
    (void)snprintf(command_line, sizeof command_line,
                   "verify --circuit specular --clocks 3000 --seed 5 --out %s",
                   scratch_path("failure"));
    outcome done = run(command_line, "");
    assert_int_equal(done.status, 1);
    assert_says(done.out, " mismatches of ");
    assert_true(find_line(done.out, "  clock ", first, sizeof first));
    assert_true(strstr(first, "block 13") != NULL || strstr(first, "block 14") != NULL ||
                strstr(first, "block 15") != NULL);
    assert_int_equal(
        glint_wave_read_info(scratch_path("failure/mismatch_cosine_pipelined_1.fst"), &info, &err),
        GLINT_OK);
    assert_int_equal(access(scratch_path("failure/mismatch_cosine_pipelined_1.gtkw"), R_OK), 0);

    /* The command printed, without the name of the program, finds the same mismatch first. */
    assert_true(find_line(done.out, "replay: build/glint ", replay, sizeof replay));
    (void)snprintf(command_line, sizeof command_line, "%s --out %s", replay,
                   scratch_path("failure-again"));
    outcome replayed = run(command_line, "");
    assert_int_equal(replayed.status, 1);
    assert_true(find_line(replayed.out, "  clock ", again, sizeof again));
    assert_string_equal(again, first);
    forget(&replayed);
    forget(&done);
}

/* A setting that was not built is refused, and named. */
static void a_circuit_that_is_not_there_is_told(void **state)
{
    (void)state;
    outcome done = run("eval --backend rtl --gate sign", "1 1 255 255 255\n");
    assert_int_equal(done.status, 1);
    assert_says(done.err, "no circuit was built");
    forget(&done);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_frame_that_differs_is_a_failure),
        cmocka_unit_test(a_mismatch_is_a_failure_that_can_be_replayed),
        cmocka_unit_test(a_circuit_that_is_not_there_is_told),
    };
    return cmocka_run_group_tests(tests, choose_wrong_command, scratch_remove);
}
