/* `glint report divider`: what it writes, and what it says when it cannot. */
#define _XOPEN_SOURCE 700

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cjson/cJSON.h>
#include <cmocka.h>

#include <signal.h>
#include <sys/resource.h>

#include "../scratch.h"
#include "image/image.h"
#include "run.h"

static bool gnuplot_is_there(void)
{
    return system("command -v gnuplot >/dev/null") == 0;
}

static outcome report(const char *options)
{
    char command_line[1200];
    snprintf(command_line, sizeof command_line, "report divider --out %s%s", scratch_path("report"),
             options);
    return run(command_line, "");
}

static const char *in_report(const char *name)
{
    char inside[128];
    snprintf(inside, sizeof inside, "report/%s", name);
    return scratch_path(inside);
}

/* Runs the report once for the tests that read its files. */
static int make_report(void **state)
{
    if (scratch_make(state) != 0)
        return -1;
    outcome done = report("");
    const int wanted = gnuplot_is_there() ? 0 : 1;
    const int failed = done.status != wanted;
    if (failed)
        print_error("exit status %d, standard error \"%s\"\n", done.status, done.err);
    forget(&done);
    return failed;
}

static void the_markdown_has_the_numbers(void **state)
{
    (void)state;
    static const char *const parts[] = {
        "| 36.4286 | 36.428571 | holds: ",
        "| 35.8594 | 35.859375 | holds: ",
        "| 0.5692 | 0.56919643 | holds: ",
        "| 0.5693 | 0.56919643 | **does not hold**",
        "| 1.56 | 1.5625 | holds: ",
        "| 0.4427 | 0.44270833 | holds",
        "| 0.81 | 0.80729167 | holds: ",
        "| 408 | 408 | holds: ",
        "| 42 | 42 | holds: ",
        "| 2946 | 2946 | cannot be decided: ",
        "| 2064 | 2064 | cannot be decided: ",
        "| 1.43 | 1.4273256 | cannot be decided: ",
        "| 100 | 79 | **does not hold**: drawn; its area is 78 pixels |",
        "below, at most (section 3.4) | 0.0001 | ",
        "one span may be 22 levels off",
        "| 0.4427 | 0.44270833 | holds: at k = 9;",
        "| 100 | 79 | **does not hold**",
        "| 8 | 0.4427 | 9 | 1.5625 | 9 | 0.8073 |",
        "| 8 | 0.6896 | 13 | 3.5156 | 13 | 1.0677 |",
        "| 12 | 0.3735 | 14 | 0 | | |",
        "From 12 shifts on the last pixel is within half a level for every k; from 12 on what",
        "for an addition, 41 for a division and 20 for the sum",
        "takes 2946 and 2064 clocks, where the thesis has 2946 and 2064",
        "| in all | 408 / 42 | 408 / 42 | 378 / 39 |",
        "inferred from that, not measured",
    };
    char *text = scratch_read(in_report("divider.md"), NULL);
    for (size_t i = 0; i < sizeof parts / sizeof parts[0]; i++)
        assert_says(text, parts[i]);
    free(text);
}

static cJSON *read_json(void)
{
    char *text = scratch_read(in_report("divider.json"), NULL);
    cJSON *json = cJSON_Parse(text);
    assert_non_null(json);
    free(text);
    return json;
}

static double number(const cJSON *json, const char *name)
{
    const cJSON *item = cJSON_GetObjectItem(json, name);
    assert_true(cJSON_IsNumber(item));
    return item->valuedouble;
}

static void the_json_has_the_numbers(void **state)
{
    (void)state;
    cJSON *json = read_json();
    const cJSON *errors = cJSON_GetObjectItem(json, "errors");
    assert_int_equal(cJSON_GetArraySize(errors), 11);
    const cJSON *eight = cJSON_GetArrayItem(errors, 2);
    const cJSON *rounded = cJSON_GetObjectItem(eight, "rounded");
    assert_true(number(eight, "shifts") == 8.0);
    assert_true(number(rounded, "absolute_k") == 9.0);
    assert_true(fabs(number(rounded, "absolute") - 0.4427) < 0.00005);
    assert_true(fabs(100.0 * number(rounded, "relative_mean") - 0.81) < 0.005);
    const cJSON *first = cJSON_GetObjectItem(json, "first_within_half_a_level");
    assert_true(number(first, "rounded") == 12.0);
    const cJSON *table = cJSON_GetObjectItem(json, "table_2_1");
    const cJSON *described = cJSON_GetObjectItem(table, "described");
    assert_true(number(cJSON_GetObjectItem(described, "total"), "additions") == 408.0);
    assert_true(number(described, "inferred_clocks") == 2946.0);
    assert_true(number(described, "inferred_clocks_by_shifts") == 2064.0);
    cJSON_Delete(json);
}

/* The frames of one scene: written, of the same object, and as far from the exact one as said. */
static void check_scene(const cJSON *scene)
{
    glint_error err;
    glint_image *exact, *frame;
    const cJSON *entry;
    double before = INFINITY;
    const char *name = cJSON_GetObjectItem(scene, "exact_picture")->valuestring;
    assert_int_equal(glint_image_read_png(in_report(name), &exact, &err), GLINT_OK);
    cJSON_ArrayForEach(entry, cJSON_GetObjectItem(scene, "by_shifts"))
    {
        glint_image_difference difference;
        name = cJSON_GetObjectItem(entry, "picture")->valuestring;
        assert_int_equal(glint_image_read_png(in_report(name), &frame, &err), GLINT_OK);
        assert_int_equal(glint_image_compare(exact, frame, &difference, &err), GLINT_OK);
        assert_true(fabs(number(entry, "nmse") / difference.nmse - 1.0) < 1e-12);
        assert_int_equal(difference.largest, number(entry, "largest"));
        assert_true(cJSON_IsNumber(cJSON_GetObjectItem(entry, "verilog_differing_pixels")));
        assert_true(number(entry, "verilog_differing_pixels") == 0.0);
        assert_int_equal(difference.mask_pixels, 0);
        assert_true(difference.object_pixels > 50000);
        assert_true(difference.nmse > 0.0 && difference.nmse <= before);
        before = difference.nmse;
        glint_image_destroy(frame);
        name = cJSON_GetObjectItem(entry, "difference_picture")->valuestring;
        assert_int_equal(glint_image_read_png(in_report(name), &frame, &err), GLINT_OK);
        assert_int_equal(frame->width, exact->width);
        glint_image_destroy(frame);
    }
    glint_image_destroy(exact);
}

static void the_frames_are_as_far_from_exact_as_said(void **state)
{
    (void)state;
    cJSON *json = read_json();
    const cJSON *scenes = cJSON_GetObjectItem(json, "frames");
    const cJSON *scene;
    assert_int_equal(cJSON_GetArraySize(scenes), 4);
    cJSON_ArrayForEach(scene, scenes)
    {
        assert_int_equal(cJSON_GetArraySize(cJSON_GetObjectItem(scene, "by_shifts")), 5);
        check_scene(scene);
    }
    cJSON_Delete(json);
}

static void the_figure_has_a_row_for_each_k(void **state)
{
    (void)state;
    char *data = scratch_read(in_report("figure-2.12.dat"), NULL);
    char *line = strchr(strchr(data, '\n') + 1, '\n');
    for (int k = 2; k <= 16; k++) {
        int found;
        double six, seven, eight;
        assert_int_equal(sscanf(line, " %d %lf %lf %lf", &found, &six, &seven, &eight), 4);
        assert_int_equal(found, k);
        if (k == 7)
            assert_true(six == 1.5625 && seven == 1.5625 && eight == 1.171875);
        line = strchr(line + 1, '\n');
    }
    assert_string_equal(line, "\n");
    free(data);
}

static void the_plots_are_pictures(void **state)
{
    (void)state;
    glint_error err;
    glint_image *plot;
    assert_true(gnuplot_is_there()); /* `make test` installs it */
    assert_int_equal(glint_image_read_png(in_report("figure-2.12.png"), &plot, &err), GLINT_OK);
    assert_int_equal(plot->width, 1200);
    size_t colored = 0;
    for (size_t i = 0; i < 3 * (size_t)plot->width * (size_t)plot->height; i += 3)
        colored += plot->rgb[i] != plot->rgb[i + 2];
    assert_true(colored > 3000); /* three lines across it */
    glint_image_destroy(plot);
    char *svg = scratch_read(in_report("figure-2.12.svg"), NULL);
    assert_says(svg, "<svg");
    assert_says(svg, "n = 8");
    assert_says(svg, "</svg>");
    free(svg);
}

static void the_json_printed_is_the_file(void **state)
{
    (void)state;
    outcome done = report(" --json --threads 1");
    char *file = scratch_read(in_report("divider.json"), NULL);
    assert_string_equal(done.out, file);
    free(file);
    forget(&done);
}

static void the_summary_says_what_holds(void **state)
{
    (void)state;
    outcome done = report(" --threads 3");
    assert_says(done.out, "holds              thesis 0.4427 ");
    assert_says(done.out, "does not hold:     thesis 0.5693 ");
    assert_says(done.out, "from 12 shifts on\n");
    assert_says(done.out, "teapot, density  20, 12 shifts: NMSE ");
    assert_says(done.out, "/divider.md");
    forget(&done);
}

/* With a PATH that has nothing in it. */
static void without_gnuplot_all_but_the_figure_is_made(void **state)
{
    (void)state;
    char *path = strdup(getenv("PATH"));
    assert_non_null(path);
    assert_int_equal(remove(in_report("figure-2.12.svg")), gnuplot_is_there() ? 0 : -1);
    setenv("PATH", scratch_path("nothing"), 1);
    outcome done = report("");
    setenv("PATH", path, 1);
    free(path);
    assert_outcome(&done, 2,
                   "glint report: there is no gnuplot (package gnuplot-nox), so figure-2.12.svg "
                   "and figure-2.12.png were not made\n");
    assert_says(done.out, "/divider.md, divider.json and the frames\n");
    forget(&done);
    assert_int_equal(access(in_report("figure-2.12.svg"), F_OK), -1);
    char *text = scratch_read(in_report("divider.md"), NULL);
    assert_says(text, "There was no gnuplot");
    free(text);
}

/* A gnuplot that fails is said, and leaves no half plot. */
static void a_failing_gnuplot_is_a_failure(void **state)
{
    (void)state;
    static const char script[] = "#!/bin/sh\necho half a plot\nexit 3\n";
    char *path = strdup(getenv("PATH"));
    assert_non_null(path);
    assert_int_equal(mkdir(scratch_path("bin"), 0777), 0);
    scratch_write(scratch_path("bin/gnuplot"), script, sizeof script - 1);
    assert_int_equal(chmod(scratch_path("bin/gnuplot"), 0755), 0);
    setenv("PATH", scratch_path("bin"), 1);
    outcome done = report("");
    setenv("PATH", path, 1);
    free(path);
    assert_int_equal(done.status, 2);
    assert_says(done.err, "glint report: gnuplot failed; run it in ");
    forget(&done);
    assert_int_equal(access(in_report("figure-2.12.svg"), F_OK), -1);
}

/* Files may grow to 16 KiB, which is less than the figure: as on a full disk, and gnuplot itself
 * does not notice. */
static void a_figure_that_does_not_fit_is_a_failure(void **state)
{
    (void)state;
    struct rlimit before, small;
    assert_true(gnuplot_is_there());
    assert_int_equal(remove(in_report("figure-2.12.png")), 0);
    assert_int_equal(getrlimit(RLIMIT_FSIZE, &before), 0);
    small = before;
    small.rlim_cur = 16384;
    void (*handler)(int) = signal(SIGXFSZ, SIG_IGN);
    setrlimit(RLIMIT_FSIZE, &small);
    outcome done = report("");
    setrlimit(RLIMIT_FSIZE, &before);
    signal(SIGXFSZ, handler);
    assert_int_equal(done.status, 2);
    assert_says(done.err, "/figure-2.12.gnuplot: File too large\n");
    forget(&done);
    assert_int_equal(access(in_report("figure-2.12.svg"), F_OK), -1);
    assert_int_equal(access(in_report("figure-2.12.png"), F_OK), -1);
}

static void a_directory_that_cannot_be_is_a_failure(void **state)
{
    (void)state;
    scratch_write(scratch_path("file"), "", 0);
    char command_line[1100], expected[1200];
    snprintf(command_line, sizeof command_line, "report divider --out %s", scratch_path("file/x"));
    snprintf(expected, sizeof expected,
             "glint report: %s: cannot make this directory: Not a directory\n",
             scratch_path("file/x"));
    outcome done = run(command_line, "");
    assert_outcome(&done, 2, expected);
    assert_string_equal(done.out, "");
    forget(&done);
}

static void the_command_line_is_read_strictly(void **state)
{
    (void)state;
    static const struct {
        const char *command_line, *err;
    } refusals[] = {
        {"report divider --quick",
         "glint report: --quick goes with the whole report, not with divider\n"},
        {"report specular", "glint report: there is no report on \"specular\": only divider\n"},
        {"report divider divider", "glint report: unexpected argument \"divider\"\n"},
        {"report divider --threads 0",
         "glint report: --threads: \"0\" is not an integer from 1 to 64\n"},
        {"report divider --out=", "glint report: --out: \"\" is not a non-empty DIR\n"},
    };
    for (size_t i = 0; i < sizeof refusals / sizeof refusals[0]; i++) {
        outcome done = run(refusals[i].command_line, "");
        assert_outcome(&done, 2, refusals[i].err);
        assert_string_equal(done.out, "");
        forget(&done);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_markdown_has_the_numbers),
        cmocka_unit_test(the_json_has_the_numbers),
        cmocka_unit_test(the_frames_are_as_far_from_exact_as_said),
        cmocka_unit_test(the_figure_has_a_row_for_each_k),
        cmocka_unit_test(the_plots_are_pictures),
        cmocka_unit_test(the_json_printed_is_the_file),
        cmocka_unit_test(the_summary_says_what_holds),
        cmocka_unit_test(without_gnuplot_all_but_the_figure_is_made),
        cmocka_unit_test(a_failing_gnuplot_is_a_failure),
        cmocka_unit_test(a_figure_that_does_not_fit_is_a_failure),
        cmocka_unit_test(a_directory_that_cannot_be_is_a_failure),
        cmocka_unit_test(the_command_line_is_read_strictly),
    };
    return cmocka_run_group_tests(tests, make_report, scratch_remove);
}
