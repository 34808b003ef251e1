/* `glint report --chapter divider`: what it writes, and what it says when it cannot. */
#define _XOPEN_SOURCE 700

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <signal.h>
#include <sys/resource.h>

#include "../scratch.h"
#include "file/json.h"
#include "image/image.h"
#include "run.h"

static bool gnuplot_is_there(void)
{
    return system("command -v gnuplot >/dev/null") == 0;
}

static outcome report(const char *options)
{
    char command_line[1200];
    snprintf(command_line, sizeof command_line, "report --chapter divider --out %s%s",
             scratch_path("report"), options);
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
        "22 claims: 16 hold, 3 do not hold, 3 cannot be decided as stated.",
        "is 36.4286 levels | **holds** | 36.428571 |",
        "it is 35.8594 levels | **holds** | 35.859375 |",
        "is 0.5692 of a level | **holds** | 0.56919643 |",
        "is 0.5693 | **does not hold** | 0.56919643 |",
        "is 1.56 % | **holds** | 1.5625 %, the same",
        "is 0.4427 of a level | **holds** | 0.44270833 at k = 9 |",
        "is 0.81 % | **holds** | 0.8073 %, counting each k once |",
        "408 additions in all | **holds** | 408 |",
        "42 divisions in all | **holds** | 42 |",
        "2946 clocks with division | **cannot be decided** | 2946, but",
        "2064 clocks with the sum instead | **cannot be decided** | 2064, ",
        "1.43 times faster | **cannot be decided** | 1.4273256, ",
        "has 100 pixels | **does not hold** | 79 are drawn; its area is 78 |",
        "a span may be 22 levels off",
        "| 8 | 0.4427 | 9 | 1.5625 % | 9 | 0.8073 % |",
        "With 8 truncated bits the largest error is 0.6896 of a level",
        "| 12 | 0.0267 | 14 | 0.1465 % | 14 | 0.0423 % | 0.3735 | 14 | 0 | – | – |",
        "From 12 shifts on, the last pixel is within half a level for every k; from 12 on, it is",
        "3 for an addition, 41 for a division and 20 for the sum",
        "| clocks with division, inferred | 2946 | 2946 | 2733 |",
        "| in all | 408 / 42 | 408 / 42 | 378 / 39 |",
        "They are inferred, not measured",
        "0 pixels of all these frames differ",
        "Rendered again with the Verilog, 0 pixels of these frames differ.",
        "| means | 0.028 |",
    };
    char *text = scratch_read(in_report("index.md"), NULL);
    for (char *at = text; (at = strchr(at, '\n')) != NULL;) /* wherever its lines break */
        *at = ' ';
    for (size_t i = 0; i < sizeof parts / sizeof parts[0]; i++)
        assert_says(text, parts[i]);
    assert_null(strstr(text, "## Summary")); /* of the whole report */
    free(text);
}

static json_t *read_json(void)
{
    char *text = scratch_read(in_report("index.json"), NULL);
    json_t *json = json_loads(text, JSON_REJECT_DUPLICATES | JSON_DECODE_ANY, NULL);
    assert_non_null(json);
    free(text);
    return json;
}

static double number(const json_t *json, const char *name)
{
    const json_t *item = json_object_get(json_object_get(json, "numbers"), name);
    if (!json_is_number(item))
        fail_msg("no number %s", name);
    return json_number_value(item);
}

static void the_json_has_the_numbers(void **state)
{
    (void)state;
    json_t *json = read_json();
    assert_true(number(json, "divider.rounded.8.absolute.k") == 9.0);
    assert_true(fabs(number(json, "divider.rounded.8.absolute") - 0.4427) < 0.00005);
    assert_true(fabs(100.0 * number(json, "divider.rounded.8.relative.mean") - 0.81) < 0.005);
    assert_true(number(json, "divider.rounded.within-half") == 12.0);
    assert_true(number(json, "divider.described.all.additions") == 408.0);
    assert_true(number(json, "divider.described.clocks") == 2946.0);
    assert_true(number(json, "divider.described.clocks-by-shifts") == 2064.0);
    json_decref(json);
}

/* Each frame is no farther from the exact one than that with fewer shifts; the one that was written
 * is as far as said. */
static void the_frames_are_as_far_from_exact_as_said(void **state)
{
    (void)state;
    static const char *const scenes[] = {"teapot-20", "teapot-6", "sphere-128", "sphere-72"};
    static const int shifts[] = {6, 7, 8, 12, 16};
    json_t *json = read_json();
    for (int scene = 0; scene < 4; scene++) {
        double before = INFINITY;
        for (int i = 0; i < 5; i++) {
            char name[64];
            snprintf(name, sizeof name, "divider.%s.%d.nmse", scenes[scene], shifts[i]);
            const double nmse = number(json, name);
            assert_true(nmse > 0.0 && nmse <= before);
            before = nmse;
        }
    }
    glint_error err;
    glint_image *exact, *frame;
    glint_image_difference difference;
    assert_int_equal(glint_image_read_png(in_report("divider-exact.png"), &exact, &err), GLINT_OK);
    assert_int_equal(glint_image_read_png(in_report("divider-frame.png"), &frame, &err), GLINT_OK);
    assert_int_equal(glint_image_compare(exact, frame, &difference, &err), GLINT_OK);
    assert_true(fabs(number(json, "divider.teapot-20.6.nmse") / difference.nmse - 1.0) < 1e-12);
    assert_true(number(json, "divider.teapot-20.6.largest") == difference.largest);
    assert_true(difference.object_pixels > 50000 && difference.mask_pixels == 0);
    glint_image_destroy(frame);
    assert_int_equal(glint_image_read_png(in_report("divider-difference.png"), &frame, &err),
                     GLINT_OK);
    assert_int_equal(frame->width, exact->width);
    glint_image_destroy(frame);
    glint_image_destroy(exact);
    json_decref(json);
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
    char *file = scratch_read(in_report("index.json"), NULL);
    assert_string_equal(done.out, file);
    free(file);
    forget(&done);
}

static void the_summary_says_what_holds(void **state)
{
    (void)state;
    outcome done = report(" --threads 3");
    assert_says(done.out, "holds              2.4: 8 shifts: the largest absolute error of an ");
    assert_says(done.out,
                "does not hold      2.4: The same error, one line further down, is 0.5693; ");
    assert_says(done.out, "16 hold, 3 do not hold, 3 cannot be decided as stated; ");
    assert_says(done.out, "/index.html, index.md and index.json\n");
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
                   "glint report: gnuplot (package gnuplot-nox) is not installed, so the figures "
                   "were not made\n");
    assert_says(done.out, "/index.html, index.md and index.json\n");
    forget(&done);
    assert_int_equal(access(in_report("figure-2.12.svg"), F_OK), -1);
    char *text = scratch_read(in_report("index.md"), NULL);
    assert_says(text, "(There was no gnuplot to draw it; the data is in figure-2.12.dat.)");
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
    snprintf(command_line, sizeof command_line, "report --chapter divider --out %s",
             scratch_path("file/x"));
    snprintf(expected, sizeof expected,
             "glint report: %s: cannot create this directory: Not a directory\n",
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
        {"report --chapter thesis", "glint report: --chapter: \"thesis\" is none of device, lobes, "
                                    "divider, energy, frames, rasterizers, "
                                    "speed, units, trace\n"},
        {"report divider", "glint report: unexpected argument \"divider\"\n"},
        {"report --threads 0", "glint report: --threads: \"0\" is not an integer from 1 to 64\n"},
        {"report --out=", "glint report: --out: \"\" is not a non-empty DIR\n"},
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
