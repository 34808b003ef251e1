/* `glint report`: the whole of it, at reduced size. */
#define _XOPEN_SOURCE 700

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cjson/cJSON.h>
#include <cmocka.h>

#include "../scratch.h"

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

static cJSON *read_json(void)
{
    char *text = read_report("index.json");
    cJSON *json = cJSON_Parse(text);
    assert_non_null(json);
    free(text);
    return json;
}

/* The claim of a place in the thesis that has the words. */
static const cJSON *claim(const cJSON *json, const char *where, const char *words)
{
    const cJSON *entry;
    cJSON_ArrayForEach(entry, cJSON_GetObjectItem(json, "claims"))
    {
        if (strcmp(cJSON_GetObjectItem(entry, "where")->valuestring, where) == 0 &&
            strstr(cJSON_GetObjectItem(entry, "claim")->valuestring, words) != NULL)
            return entry;
    }
    fail_msg("no claim of %s with \"%s\"", where, words);
    return NULL;
}

static const char *text_of(const cJSON *entry, const char *name)
{
    return cJSON_GetObjectItem(entry, name)->valuestring;
}

static const cJSON *section(const cJSON *json, const char *name)
{
    const cJSON *found = cJSON_GetObjectItem(json, name);
    assert_non_null(found);
    return found;
}

static double number(const cJSON *json, const char *name)
{
    const cJSON *found = section(json, name);
    assert_true(cJSON_IsNumber(found));
    return found->valuedouble;
}

static void claims_have_their_verdicts(void **state)
{
    (void)state;
    static const struct {
        const char *where, *words, *verdict, *measured;
    } expected[] = {
        {"2.1", "Schlick's function (2.1)", "does not hold", "10.31 %"},
        {"2.7, 3.4, Conclusions", "Schlick's function (2.1)", "holds", "10.31 %"},
        {"2.7, Conclusions", "Modified Schlick (2.2)", "does not hold", "from n = 2 on has 2.7 %"},
        {"Table 3.2, 3.4", "cos^a", "does not hold", "1.49 % with the best a"},
        {"2.2", "levels of 0.56", "does not hold", "3.16 % at n = 1000"},
        {"Conclusions", "in the epicentre at most 2 %", "does not hold", "3.16 % at n = 1000"},
        {"(2.8)", "tabulated", "does not hold", "1 of 1000 divides by zero, the first at n = 1;"},
        {"(2.13), (2.14)", "integral", "holds", "equal to within"},
        {"2.3", "n = 2…1000", "holds", "0.0913"},
        {"2.3", "at most 0.1, n = 1", "does not hold", "0.1111 at n = 1, c = 0, where"},
        {"2.7, 3.1, Conclusions", "in the epicentre", "does not hold", "14.7 %"},
        {"2.3", "√(1+2n)/n, n = 3…1000", "holds", "at n = 1 the error there is -11.1 %"},
        {"2.3", "level of 0.2 or more", "holds", "0.368 to 0.422"},
        {"2.3", "level of 0.4 or less", "holds", "0.368 to 0.422"},
        {"2.3", "largest relative error of all", "does not hold", "up to 20.8 %; "},
        {"2.7, 3.1, Conclusions", "zone of decay", "does not hold",
         "1056 % at n = 1; from n = 2 on 100 %, at n = 3"},
        {"2.3", "√(6n−3)/(n−2)", "does not hold", "there W is zero"},
        {"3.1", "4 times below", "does not hold", "0.70 times"},
        {"3.4", "10 times as accurate", "does not hold", "Schlick's function 3.3 times by"},
        {"Table 3.2", "Quadratic, n < 170: NMSE at most 0.00026", "does not hold", " at n = 13"},
        {"Table 3.2", "Cosine-quadratic: NMSE at most 0.00008; highlight white, Ka = 0.2",
         "does not hold", "0.0018 at n = 13"},
        {"Table 3.2", "Cosine-quadratic: NMSE at most 0.00008; highlight white, Ka = 1",
         "does not hold", "0.00028 at n = 13, teapot"},
        {"Table 3.2",
         "Cosine-quadratic: NMSE at most 0.00008; highlight of the object's colour, Ka = 1",
         "holds", "5.8e-05 at n = 13, teapot"},
        {"2.4", "largest absolute error, k = 2...16", "holds", "0.44270833"},
        {"2.4", "clocks with division", "cannot be decided", "2946"},
        {"2.4", "times faster: 1.43", "cannot be decided", "1.4273256"},
        {"(2.20)", "reciprocal", "holds", "difference 0, over all 23"},
        {"2.5", "R ≥ 1", "does not hold", "for 0 exponents of Blinn's with (n+6)/(8π)"},
        {"(2.24)", "(cos θ₀)/2", "does not hold", "centre is 27501 at n = 1000"},
        {"(2.25)", "over dω₀", "does not hold", "with dω₀ = sin θ₀ dθ₀ R = 0.5346 at n = 17"},
        {"2.5, figure 2.15", "n = 1…17", "does not hold",
         "By (2.25) with dθ₀, to 5.8/√n, n = 1…20"},
        {"(2.25)", "first lobe", "does not hold", "at 4.1888/√n to 4.8978/√n"},
        {"2.5, figure 2.15", "n = 1…17", "does not hold",
         "R > 1 for n = 1…19, 19 exponents, otherwise for 2; "},
        {"2.5", "worst case", "holds", "0 cells"},
        {"(2.26), figure 2.16", "24.55", "does not hold", "B must be 25.944 "},
        {"figure 2.16", "(n+6)/(8π)", "holds", "at most 0.999992"},
    };
    cJSON *json = read_json();
    for (size_t i = 0; i < sizeof expected / sizeof expected[0]; i++) {
        const cJSON *found = claim(json, expected[i].where, expected[i].words);
        assert_string_equal(text_of(found, "verdict"), expected[i].verdict);
        assert_says(text_of(found, "measured"), expected[i].measured);
    }
    cJSON_Delete(json);
}

/* A claim without the conditions of its number says little. */
static void claims_have_their_conditions(void **state)
{
    (void)state;
    cJSON *json = read_json();
    const cJSON *entry;
    int count = 0;
    cJSON_ArrayForEach(entry, cJSON_GetObjectItem(json, "claims"))
    {
        assert_true(text_of(entry, "measured")[0] != '\0');
        if (text_of(entry, "conditions")[0] == '\0')
            fail_msg("no conditions: %s", text_of(entry, "claim"));
        assert_true(strlen(text_of(entry, "conditions")) < 511); /* there it would be cut */
        assert_true(strlen(text_of(entry, "measured")) < 383);
        count++;
    }
    assert_true(count > 30);
    cJSON_Delete(json);
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
    cJSON *json = read_json();
    const cJSON *entry;
    cJSON_ArrayForEach(entry, cJSON_GetObjectItem(json, "claims"))
    {
        const char *rule = text_of(entry, "rule"), *expected = "cannot be decided";
        const double stated = number(entry, "stated"), decimals = number(entry, "decimals");
        const double lowest = number(entry, "lowest"), highest = number(entry, "highest");
        const bool all =
            keeps(rule, lowest, stated, decimals) && keeps(rule, highest, stated, decimals);
        const bool none = !keeps(rule, lowest, stated, decimals) &&
                          !keeps(rule, highest, stated, decimals) &&
                          (lowest > stated) == (highest > stated);
        assert_true(lowest <= highest);
        if (all && !cJSON_IsTrue(cJSON_GetObjectItem(entry, "circular")))
            expected = "holds";
        if (none)
            expected = "does not hold";
        if (strcmp(text_of(entry, "verdict"), expected) != 0)
            fail_msg("%s: %s, not %s", text_of(entry, "claim"), text_of(entry, "verdict"),
                     expected);
    }
    cJSON_Delete(json);
}

/* The scene that the conditions name, rendered by another command, has the claim's NMSE. */
static void claims_on_frames_are_of_the_scene_they_name(void **state)
{
    (void)state;
    static const char *const highlights[][2] = {{"white", "255,255,255"},
                                                {"of the object's colour", "238,138,32"}};
    static const char *const ambients[] = {"0.2", "1"};
    cJSON *json = read_json();
    for (int i = 0; i < 4; i++) {
        char words[128], line[1400];
        snprintf(words, sizeof words,
                 "Cosine-quadratic: NMSE at most 0.00008; highlight %s, Ka = %s",
                 highlights[i / 2][0], ambients[i % 2]);
        const cJSON *found = claim(json, "Table 3.2", words);
        assert_says(text_of(found, "measured"), "at n = 13, teapot");
        snprintf(line, sizeof line,
                 "study --a blinn --b cosine-quadratic --model teapot --n 13 --frames 0 --size "
                 "160x120 --color 238,138,32 --highlight %s --ka %s --kd 0.5 --ks 0.5 --json "
                 "--out %s",
                 highlights[i / 2][1], ambients[i % 2], scratch_path("study"));
        outcome done = run(line, "");
        assert_outcome(&done, 0, "");
        cJSON *study = cJSON_Parse(done.out);
        const double nmse = number(cJSON_GetArrayItem(section(study, "rows"), 0), "nmse");
        assert_true(fabs(number(found, "highest") / nmse - 1.0) < 1e-9);
        cJSON_Delete(study);
        forget(&done);
    }
    cJSON_Delete(json);
}

static void the_device_stands_beside_the_formulas(void **state)
{
    (void)state;
    cJSON *json = read_json();
    const cJSON *lobes = cJSON_GetObjectItem(json, "lobes");
    const cJSON *formula = cJSON_GetObjectItem(lobes, "cosine-quadratic");
    const cJSON *device = cJSON_GetObjectItem(lobes, "device");
    const cJSON *verilog = cJSON_GetObjectItem(lobes, "device-verilog");
    const double of_formula = cJSON_GetObjectItem(formula, "absolute")->valuedouble;
    const double of_device = cJSON_GetObjectItem(device, "absolute")->valuedouble;
    assert_true(fabs(of_formula - 1.0 / 9.0) < 1e-9);
    assert_true(of_device != of_formula && fabs(of_device - of_formula) < 4e-5);
    assert_true(of_device == cJSON_GetObjectItem(verilog, "absolute")->valuedouble);
    char *text = read_report("index.md");
    assert_says(text, " 0 of 3670030 values of W differ");
    free(text);
    cJSON_Delete(json);
}

/* In the table of every section on highlights. */
static void both_circuits_have_their_rows(void **state)
{
    (void)state;
    static const char *const rows[] = {"| *device*, C model | `(2.15)",
                                       "| *device*, Verilog | `the same",
                                       "| *device*, C model | 2.783876 | 1 | 0° | 19: 1…19 |",
                                       "| *device*, Verilog | 2.783876 | 1 | 0° | 19: 1…19 |",
                                       "| the same, *device*, C model | 6 | 25.9440",
                                       "| the same, *device*, Verilog | 6 | 25.9440",
                                       "| *device*, Verilog | ![device-verilog in the white",
                                       "| schlick-modified-squared | blinn |",
                                       "| c | blinn |",
                                       "| rtl | blinn |",
                                       "| *device*, C model | | | ",
                                       "| *device*, Verilog, one lane | ",
                                       "| *device*, Verilog, 16 lanes | | | ",
                                       "| sphere | *device*, C model | ",
                                       "| sphere | *device*, Verilog | ",
                                       "| teapot | *device*, C model | ",
                                       "| teapot | *device*, Verilog | "};
    static const char *const numbers[] = {"largest", "largest_n", "largest_angle",
                                          "exponents_above_1", "asymmetry"};
    char *text = read_report("index.md");
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++)
        assert_says(text, rows[i]);
    free(text);
    /* The C model and the Verilog are one circuit: to the last bit. */
    cJSON *json = read_json();
    const cJSON *energy = cJSON_GetObjectItem(json, "energy");
    const cJSON *models = cJSON_GetObjectItem(energy, "models");
    const cJSON *model = cJSON_GetObjectItem(models, "device");
    const cJSON *verilog = cJSON_GetObjectItem(models, "device-verilog");
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++)
        assert_true(cJSON_GetObjectItem(model, numbers[i])->valuedouble ==
                    cJSON_GetObjectItem(verilog, numbers[i])->valuedouble);
    assert_true(
        cJSON_GetObjectItem(cJSON_GetObjectItem(energy, "smallest_b_device"), "b")->valuedouble ==
        cJSON_GetObjectItem(cJSON_GetObjectItem(energy, "smallest_b_device_verilog"), "b")
            ->valuedouble);
    cJSON_Delete(json);
}

static const cJSON *times_of(const cJSON *json, const char *figure, const char *method)
{
    const cJSON *entry;
    cJSON_ArrayForEach(entry, section(section(json, "frames"), "times"))
    {
        if (strcmp(text_of(entry, "figure"), figure) == 0 &&
            strcmp(text_of(entry, "method"), method) == 0)
            return entry;
    }
    fail_msg("no times of %s by %s", figure, method);
    return NULL;
}

/* Figure 3.13 in numbers: in the JSON what the figure is drawn from, of every method. */
static void times_of_frames_are_in_the_json_and_the_figure(void **state)
{
    (void)state;
    static const char *const figures[] = {"sphere", "teapot"};
    static const char *const names[] = {"blinn", "cosine-quadratic", "c", "rtl"};
    cJSON *json = read_json();
    for (int row = 0; row < 2 * 5; row++) {
        char name[64], *at;
        snprintf(name, sizeof name, "figure-3.13-%s.dat", figures[row / 5]);
        char *data = read_report(name);
        const char *line = data;
        for (int i = 0; i < 2 + row % 5; i++)
            line = strchr(line, '\n') + 1;
        const double n = strtod(line, &at);
        for (int curve = 0; curve < 4; curve++) {
            const cJSON *by_n = section(times_of(json, figures[row / 5], names[curve]), "by_n");
            assert_int_equal(cJSON_GetArraySize(by_n), 5);
            const cJSON *of_n = cJSON_GetArrayItem(by_n, row % 5);
            const double milliseconds = 1e3 * number(of_n, "seconds");
            assert_true(number(of_n, "n") == n && milliseconds > 0.0);
            assert_true(number(of_n, "to_cos_n") > 0.0);
            assert_true(fabs(strtod(at, &at) / milliseconds - 1.0) < 1e-6);
        }
        assert_true(*at == '\n');
        free(data);
    }
    cJSON_Delete(json);
}

static int compare_numbers(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* The conditions name the rule, and the verdict is what the rule makes of the numbers. */
static void timed_claims_are_judged_by_the_rule_they_name(void **state)
{
    (void)state;
    static const char *const figures[] = {"sphere", "teapot"};
    cJSON *json = read_json();
    for (int i = 0; i < 2; i++) {
        double ratio[5];
        const cJSON *by_n = section(times_of(json, figures[i], "cosine-quadratic"), "by_n");
        for (int n = 0; n < 5; n++)
            ratio[n] = number(cJSON_GetArrayItem(by_n, n), "to_cos_n");
        qsort(ratio, 5, sizeof *ratio, compare_numbers);
        const bool least = 100.0 * (1.0 / ratio[3] - 1.0) >= 19.5,
                   most = 100.0 * (1.0 / ratio[1] - 1.0) >= 19.5;
        char words[64];
        snprintf(words, sizeof words, "(figure 3.13): %s", figures[i]);
        const cJSON *found = claim(json, "3.4", words);
        assert_string_equal(text_of(found, "verdict"), least  ? "holds"
                                                       : most ? "cannot be decided"
                                                              : "does not hold");
        assert_says(text_of(found, "conditions"),
                    "by the middle half of the n, at 19.5 % or above");
    }
    static const char *const kinds[] = {"one point after the other", "vectorised"};
    for (int i = 0; i < 2; i++) {
        const cJSON *found = claim(json, "3.1, 3.4", kinds[i]);
        double median, lowest, highest;
        assert_int_equal(sscanf(text_of(found, "measured"), "%lf times, the median of %lf to %lf",
                                &median, &lowest, &highest),
                         3);
        assert_true(lowest <= median && median <= highest);
        /* The numbers are rounded: nothing is said of one that is the limit itself. */
        if (lowest > 1.65)
            assert_string_equal(text_of(found, "verdict"), "holds");
        if (highest < 1.65)
            assert_string_equal(text_of(found, "verdict"), "does not hold");
        if (lowest < 1.65 && highest > 1.65)
            assert_string_equal(text_of(found, "verdict"), "cannot be decided");
        assert_says(text_of(found, "conditions"), "at 1.65 or above, which rounds to 1.7 or more");
    }
    char *text = read_report("index.md");
    assert_says(text, "any other number when the measured one rounds to it");
    free(text);
    cJSON_Delete(json);
}

static void speeds_of_the_device_and_ratios_are_in_the_json(void **state)
{
    (void)state;
    static const struct {
        const char *name, *kind;
    } rates[] = {{"schlick", "scalar"},
                 {"schlick", "vectorised"},
                 {"cosine-quadratic", "scalar"},
                 {"cosine-quadratic", "vectorised"},
                 {"device", "vectorised"},
                 {"device-verilog-1", "scalar"},
                 {"device-verilog-16", "vectorised"}};
    cJSON *json = read_json();
    for (size_t i = 0; i < sizeof rates / sizeof rates[0]; i++) {
        const cJSON *entry = section(section(json, "speed"), rates[i].name);
        char ratio[64];
        snprintf(ratio, sizeof ratio, "%s_to_schlick", rates[i].kind);
        assert_true(number(entry, rates[i].kind) > 1e5);
        assert_true(number(entry, ratio) > 0.0);
        if (i < 2)
            assert_true(number(entry, ratio) == 1.0);
    }
    cJSON_Delete(json);
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
                "Not in the figure, as NMSE is 0: quadratic at n = 2; cosine-quadratic at n = 2.*");
    free(page);
}

static void the_summary_counts_the_verdicts(void **state)
{
    (void)state;
    cJSON *json = read_json();
    const cJSON *entry;
    int holds = 0, others = 0, open = 0;
    cJSON_ArrayForEach(entry, cJSON_GetObjectItem(json, "claims"))
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
    assert_says(text, "cannot be decided as stated.\n");
    assert_says(text, "with `--quick`");
    free(text);
    cJSON_Delete(json);
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
    terminal_wait_for(&terminal, child, "glint report: 5 of 5: ", shown, sizeof shown);
    assert_says(shown, "glint report: 1 of 5: ");
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
        cmocka_unit_test(claims_have_their_conditions),
        cmocka_unit_test(verdicts_follow_from_the_numbers_beside_them),
        cmocka_unit_test(claims_on_frames_are_of_the_scene_they_name),
        cmocka_unit_test(the_device_stands_beside_the_formulas),
        cmocka_unit_test(both_circuits_have_their_rows),
        cmocka_unit_test(times_of_frames_are_in_the_json_and_the_figure),
        cmocka_unit_test(timed_claims_are_judged_by_the_rule_they_name),
        cmocka_unit_test(speeds_of_the_device_and_ratios_are_in_the_json),
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
