/* `glint render --method trace`: its output, its figures, and what it rejects. */
#define _XOPEN_SOURCE 700

#include <setjmp.h>
#include <signal.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <time.h>

#include <cmocka.h>

#include "../scratch.h"

#include "../cli/run.h"
#include "file/json.h"
#include "image/image.h"

static outcome trace(const char *name, const char *options)
{
    char line[2048];
    snprintf(line, sizeof line, "render --force --method trace --out %s %s", scratch_path(name),
             options);
    return run(line, "");
}

static glint_image *read_picture(const char *name)
{
    glint_error err;
    glint_image *image;
    if (glint_image_read_png(scratch_path(name), &image, &err) != GLINT_OK)
        fail_msg("%s", err.text);
    return image;
}

static glint_image_difference difference_of(const char *a, const char *b)
{
    glint_image_difference difference;
    glint_error err;
    glint_image *first = read_picture(a);
    glint_image *second = read_picture(b);
    assert_int_equal(glint_image_compare(first, second, &difference, &err), GLINT_OK);
    glint_image_destroy(first);
    glint_image_destroy(second);
    return difference;
}

static void the_full_trace_is_the_rasterizers_frame(void **state)
{
    (void)state;
    char line[1024];
    outcome done = trace("full.png", "--size 200x150");
    assert_outcome(&done, 0, "");
    assert_says(done.out, "teapot, 200x150: 25440 triangles, ");
    assert_says(done.out, "trace: 30000 of 30000 pixels traced (100.00 %); tree built in ");
    assert_null(strstr(done.out, "drawn"));
    assert_null(strstr(done.out, "saved"));
    forget(&done);
    snprintf(line, sizeof line, "render --size 200x150 --out %s", scratch_path("raster.png"));
    done = run(line, "");
    assert_outcome(&done, 0, "");
    forget(&done);
    assert_in_range(difference_of("full.png", "raster.png").largest, 0, 1);
    done = trace("zero.png", "--size 200x150 --segment 0");
    assert_outcome(&done, 0, "");
    forget(&done);
    assert_int_equal(difference_of("full.png", "zero.png").differing_pixels, 0);
}

/* C and Verilog, by every fill, with every ray there is. */
static void both_backends_are_equal(void **state)
{
    (void)state;
    static const char *const options[] = {
        "",
        "--segment 7",
        "--segment 15 --fill mean --limit none",
        "--segment 7 --fill cubic --measure levels --limit 4",
        "--segment 7 --fill nearest",
        "--segment 5 --fill bilinear --measure rms",
        "--segment 7 --fill bicubic --shadows --reflect 0.5 --threads 3",
        "--segment 9 --segment-centre 3 --device power",
    };
    for (size_t i = 0; i < sizeof options / sizeof options[0]; i++) {
        char line[256];
        snprintf(line, sizeof line, "--backend both --size 160x120 %s", options[i]);
        outcome done = trace("both.png", line);
        assert_outcome(&done, 0, "");
        assert_says(done.out, "0 differing pixels of 19200\n");
        assert_int_equal(access(scratch_path("both-diff.png"), F_OK), -1);
        forget(&done);
    }
}

/* Where nothing of the object is traced the full trace still knows that it is there. */
static void an_object_between_traced_pixels_is_not_outside(void **state)
{
    (void)state;
    static const char *const backends[] = {"c", "both"};
    char line[256];
    for (size_t i = 0; i < sizeof backends / sizeof backends[0]; i++) {
        snprintf(line, sizeof line, "--size 40x1 --segment 16382 --backend %s", backends[i]);
        outcome done = trace("between.png", line);
        assert_outcome(&done, 0,
                       "glint render: the frame is empty: the object lies wholly between traced "
                       "pixels\n");
        assert_says(done.out, ", 0 fragments\n");
        if (i > 0)
            assert_says(done.out, "0 differing pixels of 40\n");
        glint_image_destroy(read_picture("between.png"));
        forget(&done);
    }
    /* From inside only back faces are seen. */
    outcome done = trace("outside.png", "--size 40x1 --segment 7 --model sphere --distance 0.1");
    assert_outcome(&done, 0, "glint render: the frame is empty: the object is outside it\n");
    forget(&done);
    done = trace("outside.png",
                 "--size 40x1 --segment 7 --model sphere --distance 0.1 --backend both");
    assert_outcome(&done, 2, "glint render: nothing to compare: the object is outside the frame\n");
    forget(&done);
}

static double number_of(const json_t *json, const char *name)
{
    const json_t *value = json_object_get(json, name);
    if (!json_is_number(value))
        fail_msg("no number %s", name);
    return json_number_value(value);
}

static json_t *figures(const char *options, json_t **whole)
{
    outcome done = trace("json.png", options);
    assert_outcome(&done, 0, "");
    *whole = json_loads(done.out, JSON_REJECT_DUPLICATES, NULL);
    assert_non_null(*whole);
    forget(&done);
    assert_string_equal(json_string_value(json_object_get(*whole, "method")), "trace");
    json_t *frame = json_array_get(json_object_get(*whole, "frames"), 0);
    return json_object_get(frame, "trace");
}

static void json_gives_the_figures(void **state)
{
    (void)state;
    json_t *whole;
    json_t *json = figures("--json --size 161x100 --segment 7", &whole);
    assert_int_equal(number_of(json, "segment"), 7);
    assert_string_equal(json_string_value(json_object_get(json, "fill")), "linear");
    assert_string_equal(json_string_value(json_object_get(json, "measure")), "delta-e");
    assert_true(number_of(json, "limit") == 2.3);
    assert_int_equal(number_of(json, "pixels"), 16100);
    assert_int_equal(number_of(json, "grid"), 100 * 21);
    assert_int_equal(number_of(json, "grid_by_2_28"), 100 * 22); /* 8 divides 160 */
    assert_true(number_of(json, "traced") > 2100 && number_of(json, "traced") < 16100);
    assert_true(number_of(json, "levels") >= 1 && number_of(json, "levels") <= 3);
    assert_true(number_of(json, "segments") > 100);
    assert_true(number_of(json, "segments") < number_of(json, "traced"));
    assert_true(number_of(json, "nmse") > 0.0 && number_of(json, "nmse") < 0.01);
    assert_true(number_of(json, "differing_pixels") > 0);
    assert_true(number_of(json, "largest") > 0);
    assert_true(number_of(json, "full_seconds") > 0.0);
    assert_true(number_of(json, "build_seconds") > 0.0);
    assert_true(number_of(json, "time_saved") < 1.0);
    assert_int_equal(number_of(json, "shadow_rays"), 0);
    json_decref(whole);
    json =
        figures("--json --size 161x100 --segment 7 --limit none --shadows --reflect 0.5", &whole);
    assert_int_equal(number_of(json, "traced"), number_of(json, "grid"));
    assert_int_equal(number_of(json, "levels"), 0);
    assert_null(json_object_get(json, "limit"));
    assert_true(number_of(json, "shadow_rays") > 0 && number_of(json, "mirror_rays") > 0);
    json_decref(whole);
    json = figures("--json --size 161x100 --segment 7 --fill bilinear --limit none", &whole);
    assert_int_equal(number_of(json, "traced"), 21 * 14);
    assert_null(json_object_get(json, "grid_by_2_28"));
    json_decref(whole);
    json = figures("--json --size 61x50", &whole);
    assert_int_equal(number_of(json, "traced"), 61 * 50);
    assert_true(number_of(json, "nmse") == 0.0);
    assert_null(json_object_get(json, "fill"));
    json_decref(whole);
}

/* People are told the same. */
static void the_figures_are_told(void **state)
{
    (void)state;
    outcome done = trace("told.png", "--size 161x100 --segment 7 --threads 1");
    assert_outcome(&done, 0, "");
    assert_says(done.out, " of 16100 pixels traced (");
    assert_says(done.out, "segments 7, linear, limit 2.3 delta-e: ");
    assert_says(done.out, "without halving: 2200 by (2.28), exactly 2100\n");
    assert_says(done.out, "against the full trace: NMSE ");
    assert_says(done.out, " s in full, ");
    assert_says(done.out, " % saved\n");
    forget(&done);
    done = trace("told.png", "--size 161x100 --segment 7 --fill bicubic --limit none");
    assert_outcome(&done, 0, "");
    assert_says(done.out, "blocks 7, bicubic, no limit: ");
    assert_null(strstr(done.out, "(2.28)"));
    forget(&done);
    done = trace("told.png", "--size 161x100 --segment 7 --segment-centre 1 --shadows");
    assert_outcome(&done, 0, "");
    assert_says(done.out, ", 1 in the centre, ");
    assert_says(done.out, " shadow rays");
    forget(&done);
}

static void what_makes_no_sense_is_refused(void **state)
{
    (void)state;
    static const char *const refusals[][2] = {
        {"--shading flat", "--method trace computes the light wherever a ray ends: it needs "
                           "--shading phong"},
        {"--backend gl", "--method trace and --backend gl both say what draws: give one of them"},
        {"--fill mean", "--fill needs --segment L: without it every pixel is traced"},
        {"--limit 3", "--limit needs --segment L: without it every pixel is traced"},
        {"--measure rms", "--measure needs --segment L: without it every pixel is traced"},
        {"--segment-centre 3",
         "--segment-centre needs --segment L: without it every pixel is traced"},
        {"--segment 0 --fill cubic", "--fill needs --segment L: without it every pixel is traced"},
        {"--segment 3 --limit -1", "--limit: \"-1\" is not none or a number from 0 to 1000"},
        {"--segment 3 --limit inf", "--limit: \"inf\" is not none or a number from 0 to 1000"},
        {"--segment 3 --limit none --measure rms",
         "--measure says nothing with --limit none: no difference is measured"},
        {"--segment 3 --fill bicubic --segment-centre 1",
         "--segment-centre needs --fill mean, linear or cubic: blocks are all of one size"},
        {"--segment 16384", "--segment: \"16384\" is not an integer from 0 to 16383"},
        {"--reflect 1.5", "--reflect: \"1.5\" is not a number from 0 to 1"},
        {"--fill best", "--fill: \"best\" is not one of mean, linear, cubic, nearest, bilinear, "
                        "bicubic"},
        {"--method raster", "--method is given twice"},
    };
    char said[512];
    for (size_t i = 0; i < sizeof refusals / sizeof refusals[0]; i++) {
        outcome done = trace("never.png", refusals[i][0]);
        snprintf(said, sizeof said, "glint render: %s\n", refusals[i][1]);
        assert_outcome(&done, 2, said);
        assert_string_equal(done.out, "");
        assert_int_equal(access(scratch_path("never.png"), F_OK), -1);
        forget(&done);
    }
}

/* They would change nothing. */
static void options_of_rays_need_them(void **state)
{
    (void)state;
    static const char *const options[] = {"segment 3",       "limit 3", "fill mean",
                                          "measure rms",     "shadows", "reflect 0.5",
                                          "segment-centre 2"};
    for (size_t i = 0; i < sizeof options / sizeof options[0]; i++) {
        char line[1024], said[256];
        snprintf(line, sizeof line, "render --out %s --%s", scratch_path("never.png"), options[i]);
        snprintf(said, sizeof said, "glint render: --%.*s needs --method trace\n",
                 (int)strcspn(options[i], " "), options[i]);
        outcome done = run(line, "");
        assert_outcome(&done, 2, said);
        forget(&done);
    }
}

/* The library that is found is none. */
static void a_missing_embree_is_one_line(void **state)
{
    (void)state;
    char line[2048];
    scratch_write(scratch_path("libembree3.so.3"), "none", 4);
    snprintf(line, sizeof line, "LD_LIBRARY_PATH=%s %s render --method trace --out %s 2>%s",
             scratch_directory, glint_under_test(), scratch_path("never.png"),
             scratch_path("said"));
    assert_int_equal(WEXITSTATUS(system(line)), 2);
    char *said = scratch_read(scratch_path("said"), NULL);
    assert_memory_equal(said,
                        "glint render: tracing rays needs Embree 3 (Debian's package "
                        "libembree3-3): ",
                        74);
    assert_int_equal(strchr(said, '\n') - said, strlen(said) - 1);
    assert_int_equal(access(scratch_path("never.png"), F_OK), -1);
    free(said);
    (void)remove(scratch_path("libembree3.so.3"));
}

/* The first part of the command, which the demo begins with, has no rays. */
static void the_demos_part_says_that_it_cannot(void **state)
{
    (void)state;
    const char *build = getenv("GLINT_BUILD");
    char line[2048];
    snprintf(line, sizeof line, "%s/glint-first render --method trace --out %s 2>%s",
             build != NULL ? build : "build", scratch_path("never.png"), scratch_path("said"));
    assert_int_equal(WEXITSTATUS(system(line)), 2);
    char *said = scratch_read(scratch_path("said"), NULL);
    assert_memory_equal(said, "glint: render --method trace is not in this program", 51);
    free(said);
}

/* A circuit that is wrong leaves a packet that replays. */
static void a_frame_that_differs_leaves_a_packet(void **state)
{
    (void)state;
    const char *build = getenv("GLINT_BUILD");
    char line[2048];
    snprintf(line, sizeof line,
             "--backend both --model sphere --size 96x80 --lanes 1 --segment 3 --threads 2 --rtl "
             "%s/wrong/truncating",
             build != NULL ? build : "build");
    outcome done = trace("wrong.png", line);
    assert_int_equal(done.status, 1);
    assert_says(done.out, "frame of 96x80, first at x=");
    assert_says(done.err, "c and rtl differ: see ");
    forget(&done);
    assert_true(difference_of("wrong.png", "wrong-c.png").differing_pixels > 0);
    snprintf(line, sizeof line, "replay %s --rtl %s/wrong/truncating",
             scratch_path("wrong-failure"), build != NULL ? build : "build");
    done = run(line, "");
    assert_outcome(&done, 1, NULL);
    assert_says(done.out, "the same mismatch");
    forget(&done);
}

static void an_interrupt_leaves_no_file(void **state)
{
    (void)state;
    char out[1024];
    snprintf(out, sizeof out, "%s", scratch_path("interrupted.png"));
    char *argv[] = {(char *)(uintptr_t)glint_under_test(),
                    "render",
                    "--size",
                    "8000x8000",
                    "--method",
                    "trace",
                    "--out",
                    out,
                    NULL};
    pid_t child;
    posix_spawn_file_actions_t actions;
    const plumbing none = {0};
    scratch_write(scratch_path("stdin"), "", 0);
    scratch_write(scratch_path("stdout"), "", 0);
    scratch_write(scratch_path("stderr"), "", 0);
    connect_streams(&actions, &none);
    const int before = scratch_count();
    assert_int_equal(posix_spawn(&child, argv[0], &actions, NULL, argv, environ), 0);
    posix_spawn_file_actions_destroy(&actions);
    /* Long enough to be at work, far too short to be done. */
    nanosleep(&(struct timespec){.tv_nsec = 300000000}, NULL);
    assert_int_equal(kill(child, SIGINT), 0);
    assert_int_equal(wait_for(child), 2);
    char *err = scratch_read(scratch_path("stderr"), NULL);
    assert_string_equal(err, "glint render: tracing abandoned: interrupted\n");
    free(err);
    assert_int_equal(scratch_count(), before);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_full_trace_is_the_rasterizers_frame),
        cmocka_unit_test(both_backends_are_equal),
        cmocka_unit_test(an_object_between_traced_pixels_is_not_outside),
        cmocka_unit_test(json_gives_the_figures),
        cmocka_unit_test(the_figures_are_told),
        cmocka_unit_test(what_makes_no_sense_is_refused),
        cmocka_unit_test(options_of_rays_need_them),
        cmocka_unit_test(a_missing_embree_is_one_line),
        cmocka_unit_test(the_demos_part_says_that_it_cannot),
        cmocka_unit_test(a_frame_that_differs_leaves_a_packet),
        cmocka_unit_test(an_interrupt_leaves_no_file),
    };
    return cmocka_run_group_tests(tests, scratch_make, scratch_remove);
}
