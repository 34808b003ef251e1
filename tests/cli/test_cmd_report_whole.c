/* `glint report`: the whole of it, at reduced size. */
#define _XOPEN_SOURCE 700

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "../scratch.h"
#include "file/json.h"

#include "../child.h"
#include "../terminal.h"
#include "run.h"

static char *summary; /* what the run for all tests printed */

static outcome report(const char *options)
{
    char command_line[1200];
    snprintf(command_line, sizeof command_line, "report --quick --out %s%s", scratch_path("report"),
             options);
    return run(command_line, "");
}

static char *read_report(const char *name)
{
    char inside[128];
    snprintf(inside, sizeof inside, "report/%s", name);
    return scratch_read(scratch_path(inside), NULL);
}

static int make_report(void **state)
{
    if (scratch_make(state) != 0)
        return -1;
    outcome done = report("");
    const int failed = done.status != 0;
    if (failed)
        print_error("exit status %d, standard error \"%s\"\n", done.status, done.err);
    summary = strdup(done.out);
    forget(&done);
    return failed || summary == NULL ? -1 : 0;
}

static int forget_report(void **state)
{
    free(summary);
    return scratch_remove(state);
}

static json_t *read_json(void)
{
    char *text = read_report("index.json");
    json_t *json = json_loads(text, JSON_REJECT_DUPLICATES | JSON_DECODE_ANY, NULL);
    assert_non_null(json);
    free(text);
    return json;
}

/* The claim of a place in the thesis that has the words. */
static const json_t *claim(const json_t *json, const char *where, const char *words)
{
    const json_t *entry;
    glint_json_each(entry, json_object_get(json, "claims"))
    {
        if (strcmp(json_string_value(json_object_get(entry, "where")), where) == 0 &&
            strstr(json_string_value(json_object_get(entry, "claim")), words) != NULL)
            return entry;
    }
    fail_msg("no claim of %s with \"%s\"", where, words);
    return NULL;
}

static const char *text_of(const json_t *entry, const char *name)
{
    return json_string_value(json_object_get(entry, name));
}

static const json_t *section(const json_t *json, const char *name)
{
    const json_t *found = json_object_get(json, name);
    if (found == NULL)
        fail_msg("no %s", name);
    return found;
}

static double number(const json_t *json, const char *name)
{
    const json_t *found = section(json, name);
    assert_true(json_is_number(found));
    return json_number_value(found);
}

/* One of those measured, by its name. */
static double measured(const json_t *json, const char *name)
{
    return number(section(json, "numbers"), name);
}

static void claims_have_their_verdicts(void **state)
{
    (void)state;
    static const struct {
        const char *where, *words, *verdict, *measured;
    } expected[] = {
        {"3.1, figure 3.1", "Comparator 11", "does not hold", "2.85 on a sphere, n = 100"},
        {"3.1, figure 3.1", "Adders 6 and 8", "holds", "0.508 of a step, at n = 1"},
        {"2.1", "Schlick's function (2.1)", "does not hold", "10.31 %"},
        {"2.7, 3.4, Conclusions", "Schlick's function (2.1)", "holds", "10.31 %"},
        {"2.1", "6.8 % below Schlick", "does not hold", "2.7 % from n = 2 on"},
        {"Table 3.2, 3.4", "cos^a", "does not hold", "1.49 % with the best a"},
        {"2.2", "levels of 0.56", "does not hold", "3.16 % at n = 1000"},
        {"Conclusions", "in the epicentre at most 2 %", "does not hold", "3.16 % at n = 1000"},
        {"(2.8)", "tabulated", "does not hold", "zero for 1 of 1000 n, first at n = 1;"},
        {"(2.13), (2.14)", "integral", "holds", "equal to within"},
        {"2.3", "n = 2…1000", "holds", "0.0913"},
        {"2.3", "at most 0.1, n = 1", "does not hold", "0.1111 at c = 0, where"},
        {"2.7, 3.1, Conclusions", "in the epicentre", "does not hold", "14.7 %"},
        {"2.3", "√(1+2n)/n, n = 3…1000", "holds", "at n = 1 the error there is -11.1 %"},
        {"2.3", "level of 0.2 or more", "holds", "0.368 to 0.422"},
        {"2.3", "level of 0.4 or less", "holds", "0.368 to 0.422"},
        {"2.3", "largest relative error of all", "does not hold", "up to 20.8 % at that point; "},
        {"2.7, 3.1, Conclusions", "zone of decay", "does not hold",
         "1056 % at n = 1; 100 % from n = 2 on, as W"},
        {"2.3", "√(6n−3)/(n−2)", "does not hold", "there W is zero"},
        {"3.1", "4 times smaller", "does not hold", "0.70 times"},
        {"3.4", "10 times as accurate", "does not hold", "Schlick's function, 3.3 times by"},
        {"2.7, 3.4", "zone of decay better", "holds", "1.00 to 2.95 times smaller"},
        {"2.2", "spread evenly", "cannot be decided", "the thesis gives no measure of evenness"},
        {"Table 3.2", "Quadratic, n < 170: NMSE at most 0.00026", "does not hold", " at n = 13"},
        {"Table 3.2", "Cosine-quadratic: NMSE at most 0.00008", "does not hold",
         "0.001 to 0.0035 depending on the scene; worst at n = 13, teapot, figure 3.9, white"},
        {"3.4", "All the functions", "does not hold", "depending on the scene"},
        {"3.4, figure 3.13", "Productivity (frame rate) up to 20 %", NULL, /* by the machine */
         "more frames per second at best"},
        {"2.4", "largest absolute error of an increment", "holds", "0.44270833"},
        {"2.4", "at most 16 steps", "does not hold", "24 steps; 71 of 718 triangles"},
        {"Table 2.1", "clocks with division", "cannot be decided", "2946"},
        {"2.4", "1.43 times faster", "cannot be decided", "1.4273256"},
        {"(2.28)", "640 pixels", "does not hold", "1 too many for 2 of the 64 lengths"},
        {"(2.31)", "varying lengths", "does not hold", "3; 81 are needed"},
        {"2.6", "save traced rays", "holds", " over sphere and teapot"},
        {"2.6, figure 2.19", "InterpolOK", "does not hold", "two equal ends is lost"},
        {"(2.30)", "K ≤ 2.3", "does not hold", " of the interpolated pixels are"},
        {"2.6", "sharper than bilinear", "holds", " times, sphere and teapot"},
        {"2.6", "artefacts of nearest", "holds", " times as large; "},
        {"(2.20)", "reciprocal", "holds", "difference 0, over all 24"},
        {"2.5", "R ≥ 1", "does not hold", "for 0 exponents of Blinn's lobe with (n+6)/(8π)"},
        {"(2.24)", "(cos θ₀)/2", "does not hold",
         "at n = 1000 the centre of the highlight is 27501"},
        {"(2.25)", "over dω₀", "does not hold", "with dω₀ = sin θ₀ dθ₀, R is 0.5346 at n = 17"},
        {"2.5, figure 2.15", "n = 1…17", "does not hold",
         "By (2.25) with dθ₀, integrated to 5.8/√n, R > 1 for n = 1…20"},
        {"(2.25)", "first lobe", "does not hold", "θ₀ = 4.1888 to 4.8978; R by"},
        {"2.5, figure 2.15", "n = 1…17", "does not hold",
         "R > 1 for n = 1…19, which differs from the claim for 2 n: "},
        {"2.5", "worst case", "holds", "0 cells"},
        {"(2.26), figure 2.16", "24.55", "does not hold", "B must be at least 25.944"},
        {"figure 2.16", "(n+6)/(8π)", "holds", "at most 0.999992"},
    };
    json_t *json = read_json();
    for (size_t i = 0; i < sizeof expected / sizeof expected[0]; i++) {
        const json_t *found = claim(json, expected[i].where, expected[i].words);
        if (expected[i].verdict != NULL)
            assert_string_equal(text_of(found, "verdict"), expected[i].verdict);
        assert_says(text_of(found, "measured"), expected[i].measured);
    }
    json_decref(json);
}

static bool keeps(const char *rule, double number, double stated, double decimals)
{
    const double half = 0.5 / pow(10.0, decimals) + 1e-9 * fabs(stated);
    if (strcmp(rule, "at most") == 0)
        return !(number > stated);
    if (strcmp(rule, "below") == 0)
        return number < stated;
    if (strcmp(rule, "at least") == 0)
        return !(number < stated);
    if (strcmp(rule, "above") == 0)
        return number > stated;
    if (strcmp(rule, "rounds to") == 0)
        return number >= stated - half && number <= stated + half;
    assert_string_equal(rule, "reaches");
    return number >= stated - half;
}

/* From the numbers beside each verdict, by the rules that the report states. */
static void verdicts_follow_from_the_numbers_beside_them(void **state)
{
    (void)state;
    json_t *json = read_json();
    const json_t *entry;
    glint_json_each(entry, json_object_get(json, "claims"))
    {
        const char *expected = "cannot be decided";
        if (json_is_null(section(entry, "number"))) {
            assert_string_equal(text_of(entry, "verdict"), expected);
            continue;
        }
        const char *rule = text_of(entry, "rule");
        const double stated = number(entry, "stated"), decimals = number(entry, "decimals");
        const double lowest = number(entry, "lowest"), highest = number(entry, "highest");
        const bool all =
            keeps(rule, lowest, stated, decimals) && keeps(rule, highest, stated, decimals);
        const bool none = !keeps(rule, lowest, stated, decimals) &&
                          !keeps(rule, highest, stated, decimals) &&
                          (lowest > stated) == (highest > stated);
        assert_true(lowest <= highest);
        if (all && !json_is_true(json_object_get(entry, "circular")))
            expected = "holds";
        if (none)
            expected = "does not hold";
        if (strcmp(text_of(entry, "verdict"), expected) != 0)
            fail_msg("%s: %s, not %s", text_of(entry, "claim"), text_of(entry, "verdict"),
                     expected);
    }
    json_decref(json);
}

/* The scene that the claim's worst frame is of, rendered by another command, has its NMSE. */
static void a_claim_on_frames_is_of_the_scene_it_names(void **state)
{
    (void)state;
    char line[1400];
    json_t *json = read_json();
    snprintf(line, sizeof line,
             "study --a blinn --b cosine-quadratic --model teapot --n 13 --frames 0 --size 160x120 "
             "--color 238,138,32 --highlight 255,255,255 --ia 0 --kd 0.5 --ks 0.5 --json --out %s",
             scratch_path("study"));
    outcome done = run(line, "");
    assert_outcome(&done, 0, "");
    json_t *study = json_loads(done.out, JSON_REJECT_DUPLICATES | JSON_DECODE_ANY, NULL);
    const double nmse = number(json_array_get(section(study, "rows"), 0), "nmse");
    const json_t *found = claim(json, "Table 3.2", "Cosine-quadratic: NMSE at most 0.00008");
    assert_true(fabs(number(found, "highest") / nmse - 1.0) < 1e-9);
    assert_true(fabs(measured(json, "frames.cosine-quadratic.3.9-white") / nmse - 1.0) < 1e-9);
    json_decref(study);
    forget(&done);
    json_decref(json);
}

static void the_device_stands_beside_the_formulas(void **state)
{
    (void)state;
    json_t *json = read_json();
    const double of_formula = measured(json, "lobes.cosine-quadratic.absolute");
    const double of_device = measured(json, "lobes.device.absolute");
    assert_true(fabs(of_formula - 1.0 / 9.0) < 1e-9);
    assert_true(of_device != of_formula && fabs(of_device - of_formula) < 4e-5);
    assert_true(of_device == measured(json, "lobes.device-verilog.absolute"));
    json_decref(json);
}

/* The gates cosine and sign are one, the C model and the Verilog too; that as drawn is neither. */
static void the_device_is_the_first_chapter(void **state)
{
    (void)state;
    json_t *json = read_json();
    assert_true(measured(json, "device.points") == 3670030.0);
    assert_true(measured(json, "device.sign.differing") == 0.0);
    assert_true(measured(json, "device.verilog-differing") == 0.0);
    assert_true(measured(json, "device.sign.nmse") == 0.0);
    assert_true(measured(json, "device.drawn.differing") > 1e6);
    assert_true(fabs(measured(json, "device.drawn.nmse") - 2.84958) < 5e-6);
    json_decref(json);
    char *text = read_report("index.md");
    const char *device = strstr(text, "## The device (section 3.1");
    assert_non_null(device);
    assert_true(device < strstr(text, "## The formulas"));
    assert_says(text, "![the same, destroyed](device-drawn.png)");
    free(text);
}

/* In the table of every chapter on highlights. */
static void both_circuits_have_their_rows(void **state)
{
    (void)state;
    static const char *const rows[] = {"| device | `(2.15) in fixed point, C`",
                                       "| device-verilog | `the same, Verilog`",
                                       "| device | 2.783876 | 1, 0° | 19: 1…19 |",
                                       "| device-verilog | 2.783876 | 1, 0° | 19: 1…19 |",
                                       "| smallest-b-device | 6 | 25.9440",
                                       "| smallest-b-device-verilog | 6 | 25.9440",
                                       "![device-verilog in the white furnace]",
                                       "| schlick-modified-squared | 0.0",
                                       "| c | 0.00",
                                       "| rtl | 0.00",
                                       "| rtl-against-c | 0 |",
                                       "| *device*, C model | | | ",
                                       "| *device*, Verilog, one lane | ",
                                       "| *device*, Verilog, 16 lanes | | | ",
                                       "| device, C model | ",
                                       "| device, Verilog | "};
    static const char *const numbers[] = {"grid-largest", "grid-largest.n", "grid-largest.angle",
                                          "grid-above", "asymmetry"};
    char *text = read_report("index.md");
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++)
        assert_says(text, rows[i]);
    free(text);
    /* The C model and the Verilog are one circuit: to the last bit. */
    json_t *json = read_json();
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++) {
        char model[64], verilog[64];
        snprintf(model, sizeof model, "energy.device.%s", numbers[i]);
        snprintf(verilog, sizeof verilog, "energy.device-verilog.%s", numbers[i]);
        assert_true(measured(json, model) == measured(json, verilog));
    }
    assert_true(measured(json, "energy.smallest-b-device.b") ==
                measured(json, "energy.smallest-b-device-verilog.b"));
    json_decref(json);
}

/* Figure 3.13 in numbers: in the JSON what the figure is drawn from, of every method; the verdict
 * is on the largest gain. */
static void times_of_frames_are_in_the_json_and_the_figure(void **state)
{
    (void)state;
    static const char *const figures[] = {"sphere", "teapot"};
    static const char *const methods[] = {"blinn", "cosine-quadratic", "c", "rtl"};
    static const int exponents[] = {10, 100, 1000};
    double best = -1.0;
    json_t *json = read_json();
    for (int row = 0; row < 2 * 3; row++) {
        char name[64], *at;
        double milliseconds[4];
        snprintf(name, sizeof name, "figure-3.13-%s.dat", figures[row / 3]);
        char *data = read_report(name);
        const char *line = data;
        for (int i = 0; i < 2 + row % 3; i++)
            line = strchr(line, '\n') + 1;
        assert_true(strtod(line, &at) == exponents[row % 3]);
        for (int i = 0; i < 4; i++) {
            snprintf(name, sizeof name, "frames.time.%s.%s.%d", figures[row / 3], methods[i],
                     exponents[row % 3]);
            milliseconds[i] = measured(json, name);
            assert_true(milliseconds[i] > 0.0);
            assert_true(fabs(strtod(at, &at) / milliseconds[i] - 1.0) < 1e-6);
        }
        best = fmax(best, milliseconds[0] / milliseconds[1] - 1.0);
        assert_true(*at == '\n');
        free(data);
    }
    const json_t *found = claim(json, "3.4, figure 3.13", "Productivity (frame rate) up to 20 %");
    assert_true(fabs(number(found, "highest") / (100.0 * best) - 1.0) < 1e-9);
    assert_true(number(found, "lowest") == number(found, "highest"));
    json_decref(json);
}

static void speeds_are_in_the_json(void **state)
{
    (void)state;
    static const char *const rates[] = {"speed.schlick.scalar",          "speed.schlick.vectorised",
                                        "speed.cosine-quadratic.scalar", "speed.device",
                                        "speed.device-verilog-1",        "speed.device-verilog-16"};
    json_t *json = read_json();
    for (size_t i = 0; i < sizeof rates / sizeof rates[0]; i++) {
        char ratio[64];
        snprintf(ratio, sizeof ratio, "%s.ratio", rates[i]);
        assert_true(measured(json, rates[i]) > 0.1);
        assert_true(measured(json, ratio) > 0.0);
        if (i < 2)
            assert_true(measured(json, ratio) == 1.0);
    }
    json_decref(json);
}

/* Every claim has a row, a link to its chapter, and one back; what is linked is there. */
static void claims_and_chapters_are_linked(void **state)
{
    (void)state;
    json_t *json = read_json();
    char *page = read_report("index.html");
    int count = 0;
    const json_t *entry;
    glint_json_each(entry, section(json, "claims"))
    {
        char text[128];
        count++;
        assert_true(text_of(entry, "measured")[0] != '\0');
        snprintf(text, sizeof text, "<a id=\"claim-%d\"></a><a href=\"#%s\">", count,
                 text_of(entry, "chapter"));
        assert_says(page, text);
        snprintf(text, sizeof text, "<a href=\"#claim-%d\">", count);
        assert_says(page, text);
        snprintf(text, sizeof text, "<a id=\"%s\"></a>", text_of(entry, "chapter"));
        assert_says(page, text);
    }
    assert_true(count > 60);
    const char *title = strstr(page, "<h1>"), *contents = strstr(page, "<nav>"),
               *summary = strstr(page, "<h2>Summary"), *table = strstr(page, "<h2>The claims");
    assert_true(title != NULL && title < contents && contents < summary && summary < table);
    assert_null(strstr(table, "<h2>The device"));
    free(page);
    json_decref(json);
}

/* (2.25) has two readings, neither of which is called "as printed". */
static void the_readings_of_2_25_have_names_of_their_own(void **state)
{
    (void)state;
    static const char *const files[] = {"index.md", "figure-2.15.gnuplot", "figure-2.15.dat"};
    for (size_t i = 0; i < sizeof files / sizeof files[0]; i++) {
        char *text = read_report(files[i]);
        assert_null(strstr(text, "(2.25) as printed"));
        assert_says(text, "(2.25) with dθ");
        free(text);
    }
}

static void the_page_stands_alone(void **state)
{
    (void)state;
    char *page = read_report("index.html");
    assert_says(page, "<title>What the thesis claims, measured</title>");
    assert_says(page, "<span class=\"not\"><strong>does not hold</strong></span>");
    for (const char *at = strstr(page, "src=\""); at != NULL; at = strstr(at + 5, "src=\""))
        assert_memory_equal(at + 5, "data:image/", 11);
    assert_null(strstr(page, "<script"));
    assert_null(strstr(page, "href=\"http"));
    free(page);
}

static void figures_are_drawn(void **state)
{
    (void)state;
    static const char *const figures[] = {
        "2.2",  "2.3",  "2.4",         "2.5",         "2.6",    "2.7",  "2.10",        "2.12",
        "2.15", "2.16", "3.13-sphere", "3.13-teapot", "family", "nmse", "energy-angle"};
    char *page = read_report("index.md");
    for (size_t i = 0; i < sizeof figures / sizeof figures[0]; i++) {
        char expected[64];
        snprintf(expected, sizeof expected, "](figure-%s.svg)", figures[i]);
        assert_says(page, expected);
        snprintf(expected, sizeof expected, "figure-%s.svg", figures[i]);
        char *drawn = read_report(expected);
        assert_says(drawn, "</svg>");
        free(drawn);
        snprintf(expected, sizeof expected, "figure-%s.gnuplot", figures[i]);
        drawn = read_report(expected);
        assert_null(strstr(drawn, "label \"\"")); /* both axes have a name */
        free(drawn);
    }
    assert_says(page,
                "Not shown, since the NMSE is 0: quadratic at n = 2; cosine-quadratic at n = 2.*");
    free(page);
}

static void the_summary_counts_the_verdicts(void **state)
{
    (void)state;
    json_t *json = read_json();
    const json_t *entry;
    int holds = 0, others = 0, open = 0;
    glint_json_each(entry, json_object_get(json, "claims"))
    {
        const char *verdict = text_of(entry, "verdict");
        holds += strcmp(verdict, "holds") == 0;
        others += strcmp(verdict, "does not hold") == 0;
        open += strcmp(verdict, "cannot be decided") == 0;
    }
    char expected[128];
    snprintf(expected, sizeof expected, "%d hold, %d do not hold, %d cannot be decided as stated; ",
             holds, others, open);
    assert_says(summary, expected);
    char *text = read_report("index.md");
    snprintf(expected, sizeof expected, "%d claims: %d hold, ", holds + others + open, holds);
    assert_says(text, expected);
    assert_says(text, "with `--quick`");
    free(text);
    json_decref(json);
}

/* What cannot be written at the end is said at the beginning. */
static void a_page_that_cannot_be_is_said_before_the_work(void **state)
{
    (void)state;
    assert_int_equal(mkdir(scratch_path("early"), 0777), 0);
    assert_int_equal(mkdir(scratch_path("early/index.html"), 0777), 0);
    char command_line[1200], expected[1200];
    snprintf(command_line, sizeof command_line, "report --quick --out %s", scratch_path("early"));
    snprintf(expected, sizeof expected, "glint report: cannot write %s: Is a directory\n",
             scratch_path("early/index.html"));
    outcome done = run(command_line, "");
    assert_outcome(&done, 2, expected);
    forget(&done);
    assert_int_equal(remove(scratch_path("early/index.html")), 0);
    assert_int_equal(remove(scratch_path("early")), 0); /* nothing else is in it */
}

/* One that never ends by itself. */
static void write_endless_gnuplot(void)
{
    static const char before[] = "#!/bin/sh\n: >";
    char script[1200];
    assert_int_equal(mkdir(scratch_path("bin"), 0777), 0);
    const int length = snprintf(script, sizeof script, "%s%s\n/bin/sleep 10000\n", before,
                                scratch_path("plotting"));
    scratch_write(scratch_path("bin/gnuplot"), script, (size_t)length);
    assert_int_equal(chmod(scratch_path("bin/gnuplot"), 0755), 0);
}

/* As a terminal sends it: to all that it has started in its group, in which gnuplot is not. */
static void an_interrupt_ends_a_gnuplot_that_does_not_end(void **state)
{
    (void)state;
    char out[1024];
    snprintf(out, sizeof out, "%s", scratch_path("cut"));
    const char *const argv[] = {
        glint_under_test(), "report", "--quick", "--json", "--out", out, NULL};
    char *path = strdup(getenv("PATH"));
    assert_non_null(path);
    write_endless_gnuplot();
    setenv("PATH", scratch_path("bin"), 1);
    const pid_t child = child_start(argv, scratch_path("child.out"), scratch_path("child.err"));
    setenv("PATH", path, 1);
    free(path);
    const double start = child_seconds();
    while (access(scratch_path("plotting"), F_OK) != 0 && !child_has_ended(child) &&
           child_seconds() - start < child_patience)
        child_pause();
    kill(-child, SIGINT);
    assert_int_equal(child_wait(child, 200), 2);
    char *said = scratch_read(scratch_path("child.err"), NULL);
    assert_string_equal(said, "glint report: interrupted\n");
    free(said);
    said = scratch_read(scratch_path("child.out"), NULL);
    assert_string_equal(said, "");
    free(said);
    assert_int_equal(access(scratch_path("cut/index.html"), F_OK), -1);
}

/* A script reads the JSON, a person sees which section is under way. */
static void json_goes_to_standard_output_and_progress_to_a_terminal(void **state)
{
    (void)state;
    char out[1024], shown[4096];
    snprintf(out, sizeof out, "%s", scratch_path("scripted"));
    const char *const argv[] = {
        glint_under_test(), "report", "--quick", "--json", "--out", out, NULL};
    terminal terminal = terminal_open();
    const pid_t child = child_start(argv, scratch_path("child.out"), terminal.name);
    terminal_wait_for(&terminal, child, "glint report: 9 of 9: ", shown, sizeof shown);
    assert_says(shown, "glint report: 1 of 9: ");
    assert_int_equal(child_wait(child, 300), 0);
    terminal_close(&terminal);
    char *printed = scratch_read(scratch_path("child.out"), NULL);
    char *written = scratch_read(scratch_path("scripted/index.json"), NULL);
    assert_string_equal(printed, written);
    free(written);
    free(printed);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(claims_have_their_verdicts),
        cmocka_unit_test(verdicts_follow_from_the_numbers_beside_them),
        cmocka_unit_test(a_claim_on_frames_is_of_the_scene_it_names),
        cmocka_unit_test(the_device_stands_beside_the_formulas),
        cmocka_unit_test(the_device_is_the_first_chapter),
        cmocka_unit_test(both_circuits_have_their_rows),
        cmocka_unit_test(times_of_frames_are_in_the_json_and_the_figure),
        cmocka_unit_test(speeds_are_in_the_json),
        cmocka_unit_test(claims_and_chapters_are_linked),
        cmocka_unit_test(the_readings_of_2_25_have_names_of_their_own),
        cmocka_unit_test(the_page_stands_alone),
        cmocka_unit_test(figures_are_drawn),
        cmocka_unit_test(the_summary_counts_the_verdicts),
        cmocka_unit_test(a_page_that_cannot_be_is_said_before_the_work),
        cmocka_unit_test(an_interrupt_ends_a_gnuplot_that_does_not_end),
        cmocka_unit_test(json_goes_to_standard_output_and_progress_to_a_terminal),
    };
    return cmocka_run_group_tests(tests, make_report, forget_report);
}
