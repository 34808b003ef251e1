/* The shift-accumulate divider: section 2.4. */
#include <math.h>

#include "report/chart.h"
#include "report/divider_error.h"
#include "report/divider_frames.h"
#include "report/quadratic_frames.h"
#include "report/texts.h"

/* Clocks per operation on the thesis's processor. The thesis does not give them: these are inferred
 * as the smallest integers that yield both of its totals. */
#define CLOCKS_ADDITION           3
#define CLOCKS_DIVISION           41
#define CLOCKS_DIVISION_BY_SHIFTS 20

static const char *const rules[GLINT_BITS_RULE_COUNT] = {"rounded", "truncated"};

/* ---- The error by numbers of shifts ---------------------------------------------------------- */

static void put_example(glint_numbers *numbers)
{
    const glint_divider_example example = glint_divider_example_of(255, 7, 6);
    glint_number_put(numbers, example.bits, "divider.example.bits");
    glint_number_put(numbers, example.exact, "divider.example.exact");
    glint_number_put(numbers, example.sum, "divider.example.sum");
    glint_number_put(numbers, example.exact - example.sum, "divider.example.error");
    glint_number_put(numbers, example.relative, "divider.example.relative");
}

static void put_error(glint_numbers *numbers, const char *rule, int shifts,
                      const glint_divider_error *error)
{
    const bool wrong = error->displayed > 0;
    const struct {
        const char *name;
        double value;
    } of[] = {{"absolute", error->absolute},
              {"absolute.k", error->absolute_k},
              {"relative", error->relative},
              {"relative.k", error->relative_k},
              {"relative.mean", error->relative_mean},
              {"last", error->last_pixel},
              {"last.k", error->last_pixel_k},
              {"shown", error->displayed},
              {"shown.k", wrong ? (double)error->displayed_k : NAN},
              {"shown.difference", wrong ? (double)error->displayed_difference : NAN}};
    for (size_t i = 0; i < sizeof of / sizeof of[0]; i++)
        glint_number_put(numbers, of[i].value, "divider.%s.%d.%s", rule, shifts, of[i].name);
}

/* within-half: as glint_divider_first_within_half(); exact: the least number of shifts with which,
 * and with all above it, nothing wrong is shown. */
static void put_errors(glint_numbers *numbers)
{
    for (int i = GLINT_DIVIDER_SHIFTS_MIN; i <= GLINT_DIVIDER_SHIFTS_MAX; i++) {
        char shifts[16];
        snprintf(shifts, sizeof shifts, "%d", i);
        glint_number_add_word(numbers, "divider.shifts", shifts);
    }
    glint_number_put(numbers, GLINT_DIVIDER_SHIFTS_DEFAULT, "divider.default");
    for (int rule = 0; rule < GLINT_BITS_RULE_COUNT; rule++) {
        int exact = GLINT_DIVIDER_SHIFTS_MIN;
        for (int i = GLINT_DIVIDER_SHIFTS_MIN; i <= GLINT_DIVIDER_SHIFTS_MAX; i++) {
            const glint_divider_error error = glint_divider_error_of(i, (glint_bits_rule)rule);
            put_error(numbers, rules[rule], i, &error);
            exact = error.displayed > 0 ? i + 1 : exact;
        }
        glint_number_put(numbers, exact, "divider.%s.exact", rules[rule]);
        glint_number_put(numbers, glint_divider_first_within_half((glint_bits_rule)rule),
                         "divider.%s.within-half", rules[rule]);
    }
}

/* Figure 2.12. */
static glint_status draw_errors(glint_report *report, glint_error *err)
{
    enum { SHOWN = 3, K_COUNT = GLINT_DIVIDER_K_MAX - GLINT_ERROR_K_MIN + 1 };
    static const int shifts[SHOWN] = {6, 7, 8};
    static const glint_chart chart = {
        .name = "figure-2.12",
        .title = "Relative error of the increment by span length (figure 2.12)",
        .x_label = "span length k",
        .y_label = "relative error, %",
        .settings = "set xrange [1.5:16.5]\nset yrange [0:*]\nset xtics 2, 1\nset key top left\n",
        .style = "linespoints",
        .curves = SHOWN,
        .curve = {"n = 6", "n = 7", "n = 8"}};
    double values[K_COUNT * (1 + SHOWN)], *value = values;
    for (int k = GLINT_ERROR_K_MIN; k <= GLINT_DIVIDER_K_MAX; k++) {
        *value++ = k;
        for (int i = 0; i < SHOWN; i++)
            *value++ = 100.0 * glint_divider_relative_error(shifts[i], GLINT_BITS_ROUNDED, k);
    }
    return glint_chart_draw(report, &chart, values, K_COUNT, err);
}

/* ---- Table 2.1 ------------------------------------------------------------------------------- */

static const glint_span_operations table_21_stated = {{
    [GLINT_SPAN_EDGE_INCREMENTS] = {18, 9},
    [GLINT_SPAN_EDGE_POINTS] = {99, 0},
    [GLINT_SPAN_ROW_INCREMENTS] = {66, 33},
    [GLINT_SPAN_ROW_POINTS] = {225, 0},
}};

static double clocks_of(glint_operations operations, int clocks_of_a_division)
{
    return (double)(operations.additions * CLOCKS_ADDITION +
                    operations.divisions * (uint64_t)clocks_of_a_division);
}

static void put_operations(glint_numbers *numbers, const char *of, const char *stage,
                           glint_operations operations)
{
    glint_number_put(numbers, (double)operations.additions, "divider.%s.%s.additions", of, stage);
    glint_number_put(numbers, (double)operations.divisions, "divider.%s.%s.divisions", of, stage);
}

static void put_counts(glint_numbers *numbers, const char *of,
                       const glint_span_operations *operations)
{
    static const char *const stages[GLINT_SPAN_STAGE_COUNT] = {"edge-increments", "edge-points",
                                                               "row-increments", "row-points"};
    glint_operations total = {0};
    for (int i = 0; i < GLINT_SPAN_STAGE_COUNT; i++) {
        total.additions += operations->stage[i].additions;
        total.divisions += operations->stage[i].divisions;
        put_operations(numbers, of, stages[i], operations->stage[i]);
    }
    const double by_division = clocks_of(total, CLOCKS_DIVISION);
    const double by_shifts = clocks_of(total, CLOCKS_DIVISION_BY_SHIFTS);
    put_operations(numbers, of, "all", total);
    glint_number_put(numbers, by_division, "divider.%s.clocks", of);
    glint_number_put(numbers, by_shifts, "divider.%s.clocks-by-shifts", of);
    glint_number_put(numbers, by_division / by_shifts, "divider.%s.faster", of);
}

static glint_status put_table_21(glint_numbers *numbers, glint_error *err)
{
    glint_table_21 table;
    const glint_status status = glint_count_table_21(GLINT_DIVIDER_SHIFTS_DEFAULT, &table, err);
    if (status != GLINT_OK)
        return status;
    put_counts(numbers, "stated", &table_21_stated);
    put_counts(numbers, "described", &table.described);
    put_counts(numbers, "drawn", &table.drawn);
    glint_number_put(numbers, CLOCKS_ADDITION, "divider.clocks.addition");
    glint_number_put(numbers, CLOCKS_DIVISION, "divider.clocks.division");
    glint_number_put(numbers, CLOCKS_DIVISION_BY_SHIFTS, "divider.clocks.division-by-shifts");
    glint_number_put(numbers, (double)table.described_edge_points,
                     "divider.described.edge-points.count");
    glint_number_put(numbers, (double)table.described_rows, "divider.described.rows");
    glint_number_put(numbers, (double)table.described_pixels, "divider.described.pixels");
    glint_number_put(numbers, (double)table.drawn_rows, "divider.drawn.rows");
    glint_number_put(numbers, (double)table.drawn_pixels, "divider.drawn.pixels");
    glint_number_put(numbers, table.area, "divider.drawn.area");
    return GLINT_OK;
}

/* ---- Whole frames ---------------------------------------------------------------------------- */

static void put_scene(glint_numbers *numbers, const char *name, const glint_divider_scene *scene)
{
    const double object = (double)scene->frames[0].difference.object_pixels;
    glint_number_put(numbers, (double)scene->drawn, "divider.%s.triangles", name);
    glint_number_put(numbers, object / (double)scene->drawn, "divider.%s.pixels-each", name);
    glint_number_put(numbers, (double)scene->divisions, "divider.%s.divisions", name);
    for (int i = 0; i < GLINT_DIVIDER_FRAMES; i++) {
        const glint_divider_frame *frame = &scene->frames[i];
        const double differing = (double)frame->difference.differing_pixels;
        glint_number_put(numbers, frame->difference.nmse, "divider.%s.%d.nmse", name,
                         frame->shifts);
        glint_number_put(numbers, frame->difference.largest, "divider.%s.%d.largest", name,
                         frame->shifts);
        glint_number_put(numbers, differing / object, "divider.%s.%d.differing", name,
                         frame->shifts);
    }
}

static void put_scenes(glint_numbers *numbers, const glint_divider_scene *scenes)
{
    double worst = 0.0, verilog = 0.0, triangles = 0.0, with_longer = 0.0;
    int longest = 0;
    for (int i = 0; i < GLINT_DIVIDER_SCENES; i++) {
        const glint_divider_scene *scene = &scenes[i];
        char name[64];
        snprintf(name, sizeof name, "%s-%d", scene->model, scene->density);
        glint_number_add_word(numbers, "divider.scenes", name);
        put_scene(numbers, name, scene);
        worst = fmax(worst, scene->frames[0].difference.nmse);
        for (int j = 0; j < GLINT_DIVIDER_FRAMES; j++)
            verilog += (double)scene->frames[j].verilog_pixels;
        triangles += (double)scene->rows.triangles;
        with_longer += (double)scene->rows.with_longer;
        longest = scene->rows.longest > longest ? scene->rows.longest : longest;
    }
    glint_number_put(numbers, worst, "divider.worst-nmse");
    glint_number_put(numbers, verilog, "divider.verilog-differing");
    glint_number_put(numbers, triangles, "divider.average.triangles");
    glint_number_put(numbers, with_longer, "divider.average.with-longer");
    glint_number_put(numbers, longest, "divider.average.longest");
}

glint_status glint_chapter_divider(glint_report *report, glint_error *err)
{
    glint_divider_scene scenes[GLINT_DIVIDER_SCENES];
    put_example(&report->numbers);
    put_errors(&report->numbers);
    glint_status status = put_table_21(&report->numbers, err);
    if (status == GLINT_OK)
        status = glint_report_write_lines(report, glint_drawing_divider, "figure-2.13.svg", err);
    if (status == GLINT_OK)
        status = draw_errors(report, err);
    if (status == GLINT_OK)
        status = glint_divider_render_scenes(report, scenes, err);
    if (status == GLINT_OK)
        put_scenes(&report->numbers, scenes);
    return status == GLINT_OK ? glint_quadratic_measure_frames(report, err) : status;
}
