/* See frame_times.h. A method's time means something beside that of cosⁿ in the same minutes: each
 * is timed in pairs with it. */
#include "report/frame_times.h"

#include <limits.h>

#include "bench/formulas.h"
#include "report/chart.h"
#include "report/quantile.h"

#define SAY(text, ...) snprintf(text, sizeof text, __VA_ARGS__)

#define REFERENCE "blinn"

/* Section 3.4: productivity up to that much higher, in per cent. Productivity is frames a second.
 */
#define STATED 20.0

static const struct {
    const char *name, *title;
    int frames; /* timed for each n in a round; the claims are on the first */
} methods[GLINT_TIMED_COUNT] = {
    [GLINT_TIMED_COSINE_QUADRATIC] = {"cosine-quadratic", "cosine-quadratic", 5},
    [GLINT_TIMED_DEVICE] = {"c", "*device*, C model", 3},
    [GLINT_TIMED_VERILOG] = {"rtl", "*device*, Verilog", 3},
};

#define ROUNDS 3

/* ---- Measuring ------------------------------------------------------------------------------- */

/* The studies of one figure, and what each round gave. */
typedef struct timing {
    glint_study *study[GLINT_TIMED_COUNT];
    glint_study_row row[ROUNDS][GLINT_TIMED_COUNT][GLINT_FRAME_EXPONENTS_MAX];
} timing;

static glint_status create_studies(const glint_report *report, const glint_frame_times *times,
                                   const glint_mesh *mesh, timing *t, glint_error *err)
{
    glint_status status = GLINT_OK;
    glint_scene scene;
    glint_frame_scene(times->light, &scene);
    scene.mesh = mesh;
    for (int method = 0; method < GLINT_TIMED_COUNT && status == GLINT_OK; method++)
        status = glint_frame_study_create(report, &scene, times->width, times->height, REFERENCE,
                                          methods[method].name, &t->study[method], err);
    return status;
}

/* All methods of one n, then the next n; the whole again: what else the machine does for a while
 * meets neither one method nor one n alone. */
static glint_status run_rounds(const glint_report *report, const glint_frame_times *times,
                               timing *t, glint_error *err)
{
    glint_status status = GLINT_OK;
    for (int round = 0; round < ROUNDS; round++)
        for (int i = 0; i < times->count; i++)
            for (int method = 0; method < GLINT_TIMED_COUNT && status == GLINT_OK; method++)
                status = glint_study_run(t->study[method], times->n[i],
                                         report->quick ? 1 : methods[method].frames, report->stop,
                                         &t->row[round][method][i], err);
    return status;
}

/* Of the times the least, as what else the machine does only adds to them; of the ratios the
 * median.
 */
static glint_study_row merge(const timing *t, int method, int i)
{
    double seconds[2][ROUNDS], ratios[ROUNDS];
    glint_study_row merged = t->row[0][method][i];
    for (int round = 0; round < ROUNDS; round++) {
        const glint_study_row *row = &t->row[round][method][i];
        seconds[0][round] = row->seconds[0];
        seconds[1][round] = row->seconds[1];
        ratios[round] = row->ratio;
    }
    merged.frames *= ROUNDS;
    for (int which = 0; which < 2; which++)
        merged.seconds[which] = glint_quantile(seconds[which], ROUNDS, 0.0);
    merged.ratio = glint_quantile(ratios, ROUNDS, 0.5);
    return merged;
}

static glint_status time_mesh(const glint_report *report, const glint_mesh *mesh,
                              glint_test_figure figure, glint_frame_times *times, glint_error *err)
{
    timing t = {0};
    glint_status status = create_studies(report, times, mesh, &t, err);
    if (status == GLINT_OK)
        status = run_rounds(report, times, &t, err);
    for (int method = 0; method < GLINT_TIMED_COUNT; method++) {
        for (int i = 0; i < times->count; i++)
            times->row[figure][method][i] = merge(&t, method, i);
        glint_study_destroy(t.study[method]);
    }
    return status;
}

static glint_status time_figure(const glint_report *report, glint_test_figure figure,
                                glint_frame_times *times, glint_error *err)
{
    glint_mesh *mesh;
    glint_status status = glint_frame_mesh(figure, &mesh, err);
    if (status != GLINT_OK)
        return status;
    status = time_mesh(report, mesh, figure, times, err);
    glint_mesh_destroy(mesh);
    return status;
}

glint_status glint_frame_times_measure(const glint_report *report, glint_frame_times *times,
                                       glint_error *err)
{
    glint_status status = GLINT_OK;
    times->width = report->quick ? 160 : 640;
    times->height = report->quick ? 120 : 480;
    times->light = GLINT_LIGHT_WHITE;
    times->count = glint_frame_exponents(report->quick, times->n);
    for (int figure = 0; figure < GLINT_FIGURE_COUNT && status == GLINT_OK; figure++)
        status = time_figure(report, (glint_test_figure)figure, times, err);
    return status;
}

/* ---- What comes of it ------------------------------------------------------------------------ */

/* The median over n of the time of cosⁿ (0) or the method (1), milliseconds. */
static double milliseconds(const glint_frame_times *times, const glint_study_row *rows, int which)
{
    double seconds[GLINT_FRAME_EXPONENTS_MAX];
    for (int i = 0; i < times->count; i++)
        seconds[i] = rows[i].seconds[which];
    return 1e3 * glint_quantile(seconds, times->count, 0.5);
}

/* A share's quantile over n of the method's time to that of cosⁿ. */
static double ratio(const glint_frame_times *times, const glint_study_row *rows, double share)
{
    double ratios[GLINT_FRAME_EXPONENTS_MAX];
    for (int i = 0; i < times->count; i++)
        ratios[i] = rows[i].ratio;
    return glint_quantile(ratios, times->count, share);
}

static void write_row(FILE *out, const glint_frame_times *times, int figure,
                      const glint_study_row *rows, int which, const char *title)
{
    fprintf(out, "| %s | %s | %.2f |", glint_test_figure_names[figure], title,
            milliseconds(times, rows, which));
    if (which == 0)
        fputs(" 1 | |", out);
    else
        fprintf(out, " %.2f | %.2f…%.2f |", ratio(times, rows, 0.5), ratio(times, rows, 0.25),
                ratio(times, rows, 0.75));
    for (int i = 0; i < times->count; i++)
        fprintf(out, " %.2f |", 1e3 * rows[i].seconds[which]);
    fputc('\n', out);
}

static void write_table(FILE *out, const glint_frame_times *times, int threads)
{
    const glint_study_row(*sphere)[GLINT_FRAME_EXPONENTS_MAX] = times->row[GLINT_FIGURE_SPHERE];
    fprintf(
        out,
        "\n### Time of a frame (figure 3.13)\n\n"
        "Milliseconds from mesh to picture, %dx%d, %d threads. Each method is timed by turns "
        "with cos^n, %d pairs of frames\nfor each n (the *device*: %d), in %d rounds over all n "
        "and "
        "methods. A time is the least of the rounds' medians, as\nwhat else the machine does only "
        "adds to it; *to cos^n* is the median over n of the median of the pairs' ratios,\nbeside "
        "it "
        "the middle half of the n. The formulas are in single precision, cos^n by powf, (2.15) as "
        "vectorised by\nthe compiler; the Verilog is simulated, by Verilator. Compiler: %s;\n"
        "machine-dependent, as all times are.\n\n"
        "| figure | method | ms, median over n | to cos^n | middle half |",
        times->width, times->height, threads, sphere[GLINT_TIMED_COSINE_QUADRATIC][0].frames,
        sphere[GLINT_TIMED_DEVICE][0].frames, ROUNDS, glint_formula_compiler());
    for (int i = 0; i < times->count; i++)
        fprintf(out, " n = %d |", times->n[i]);
    fputs("\n|---|---|--:|--:|--:|", out);
    for (int i = 0; i < times->count; i++)
        fputs("--:|", out);
    fputc('\n', out);
    for (int figure = 0; figure < GLINT_FIGURE_COUNT; figure++) {
        write_row(out, times, figure, times->row[figure][GLINT_TIMED_COSINE_QUADRATIC], 0, "cos^n");
        for (int method = 0; method < GLINT_TIMED_COUNT; method++)
            write_row(out, times, figure, times->row[figure][method], 1, methods[method].title);
    }
}

static glint_status draw(glint_report *report, const glint_frame_times *times, int figure,
                         glint_error *err)
{
    enum { CURVES = 1 + GLINT_TIMED_COUNT };
    char name[64], title[64], caption[128];
    const glint_chart chart = {
        .name = name,
        .title = title,
        .x_label = "n",
        .y_label = "ms",
        .settings = "set logscale x\nset yrange [0:*]\n" GLINT_CHART_KEY_BELOW,
        .curves = CURVES,
        .curve = {"cos^n", "cosine-quadratic", "device, C model", "device, Verilog"},
        .caption = caption};
    SAY(name, "figure-3.13-%s", glint_test_figure_names[figure]);
    SAY(title, "Time of a frame against n, %s", glint_test_figure_names[figure]);
    SAY(caption, "Figure 3.13, %s: the time of a frame, from mesh to picture.",
        glint_test_figure_names[figure]);
    double values[GLINT_FRAME_EXPONENTS_MAX * (1 + CURVES)];
    for (int i = 0; i < times->count; i++) {
        double *value = &values[i * (1 + CURVES)];
        *value++ = times->n[i];
        *value++ = 1e3 * times->row[figure][GLINT_TIMED_COSINE_QUADRATIC][i].seconds[0];
        for (int method = 0; method < GLINT_TIMED_COUNT; method++)
            *value++ = 1e3 * times->row[figure][method][i].seconds[1];
    }
    return glint_chart_draw(report, &chart, values, times->count, err);
}

/* Frames a second more than with cosⁿ, per cent, where the frame takes so much of its time. */
static double gain_of(double time_ratio)
{
    return 100.0 * (1.0 / time_ratio - 1.0);
}

static void find(glint_findings *findings, const glint_frame_times *times, int figure, int threads)
{
    char scene_text[256], exponents[64];
    glint_scene scene = {0};
    const glint_study_row *rows = times->row[figure][GLINT_TIMED_COSINE_QUADRATIC];
    const glint_judged judged = {.rule = GLINT_REACHES,
                                 .stated = STATED,
                                 .decimals = 0,
                                 .lowest = gain_of(ratio(times, rows, 0.75)),
                                 .highest = gain_of(ratio(times, rows, 0.25))};
    glint_finding *finding = glint_findings_add(findings, "3.4", &judged);
    glint_frame_scene(times->light, &scene);
    glint_frame_scene_say(&scene, scene_text, sizeof scene_text);
    glint_frame_exponents_say(times->n, times->count, 0, INT_MAX, exponents, sizeof exponents);
    SAY(finding->claim, "Productivity up to %g %% higher than with cos^n (figure 3.13): %s", STATED,
        glint_test_figure_names[figure]);
    SAY(finding->measured,
        "%.1f %% more frames a second, %.1f %% less time, the median over n; the middle half of "
        "the n %.1f to %.1f %% more",
        gain_of(ratio(times, rows, 0.5)), 100.0 * (1.0 - ratio(times, rows, 0.5)), judged.lowest,
        judged.highest);
    SAY(finding->conditions,
        "this machine and renderer, %d threads, %dx%d; %s; %s, for each the median of %d rounds of "
        "%d pairs of frames; judged by the middle half of the n, at %g %% or above",
        threads, times->width, times->height, scene_text, exponents, ROUNDS,
        rows[0].frames / ROUNDS, STATED - 0.5);
}

void glint_frame_times_find(const glint_frame_times *times, int threads, glint_findings *findings)
{
    for (int figure = 0; figure < GLINT_FIGURE_COUNT; figure++)
        find(findings, times, figure, threads);
}

static bool add_row(cJSON *list, const glint_frame_times *times, int figure,
                    const glint_study_row *rows, int which, const char *method)
{
    cJSON *entry = cJSON_CreateObject();
    bool whole =
        cJSON_AddItemToArray(list, entry) &&
        cJSON_AddStringToObject(entry, "figure", glint_test_figure_names[figure]) != NULL &&
        cJSON_AddStringToObject(entry, "method", method) != NULL &&
        cJSON_AddNumberToObject(entry, "frames", rows[0].frames) != NULL &&
        cJSON_AddNumberToObject(entry, "median_milliseconds", milliseconds(times, rows, which)) !=
            NULL &&
        cJSON_AddNumberToObject(entry, "median_to_cos_n",
                                which == 0 ? 1.0 : ratio(times, rows, 0.5)) != NULL;
    cJSON *by_n = cJSON_AddArrayToObject(entry, "by_n");
    for (int i = 0; i < times->count && whole; i++) {
        cJSON *of_n = cJSON_CreateObject();
        whole = cJSON_AddItemToArray(by_n, of_n) &&
                cJSON_AddNumberToObject(of_n, "n", times->n[i]) != NULL &&
                cJSON_AddNumberToObject(of_n, "seconds", rows[i].seconds[which]) != NULL &&
                cJSON_AddNumberToObject(of_n, "to_cos_n", which == 0 ? 1.0 : rows[i].ratio) != NULL;
    }
    return whole;
}

static bool add_numbers(cJSON *numbers, const glint_frame_times *times)
{
    bool whole = true;
    cJSON *list = cJSON_AddArrayToObject(numbers, "times");
    for (int figure = 0; figure < GLINT_FIGURE_COUNT; figure++) {
        whole = whole && add_row(list, times, figure,
                                 times->row[figure][GLINT_TIMED_COSINE_QUADRATIC], 0, REFERENCE);
        for (int method = 0; method < GLINT_TIMED_COUNT; method++)
            whole = whole && add_row(list, times, figure, times->row[figure][method], 1,
                                     methods[method].name);
    }
    return whole;
}

glint_status glint_frame_times_write(glint_report *report, const glint_frame_times *times,
                                     glint_error *err)
{
    write_table(report->markdown, times, report->threads);
    glint_frame_times_find(times, report->threads, report->findings);
    if (!add_numbers(report->numbers, times))
        return glint_fail(err, GLINT_NO_MEMORY, "no memory for the frames' times");
    glint_status status = GLINT_OK;
    for (int figure = 0; figure < GLINT_FIGURE_COUNT && status == GLINT_OK; figure++)
        status = draw(report, times, figure, err);
    return status;
}
