/* divider.md. */
#include "report/divider_parts.h"

#include <inttypes.h>

static int count_of(const glint_claims *claims, glint_verdict verdict)
{
    int count = 0;
    for (int i = 0; i < claims->count; i++)
        count += claims->claim[i].verdict == verdict;
    return count;
}

static void write_claims(FILE *out, const glint_claims *claims, const char *level)
{
    fprintf(out,
            "%s What the thesis says\n\n"
            "%d numbers of section 2.4 beside the measured ones. A number holds when the measured "
            "one,\nrounded to the digits that the thesis prints, is the same, one of *at most* "
            "when it is no larger: %d do, %d do not, %d cannot be\ndecided, as they were computed "
            "from the stated one.\n\n"
            "| | thesis | measured | |\n|---|---:|---:|---|\n",
            level, claims->count, count_of(claims, GLINT_HOLDS),
            count_of(claims, GLINT_DOES_NOT_HOLD), count_of(claims, GLINT_CANNOT_BE_DECIDED));
    for (int i = 0; i < claims->count; i++) {
        const glint_claim *claim = &claims->claim[i];
        const char *mark = claim->verdict == GLINT_DOES_NOT_HOLD ? "**" : "";
        fprintf(out, "| %s | %.*f | %.8g | %s%s%s: %s |\n", claim->what, claim->judged.decimals,
                claim->judged.stated, claim->judged.lowest, mark,
                glint_verdict_names[claim->verdict], mark, claim->note);
    }
}

static void write_increment_table(FILE *out, const glint_divider_error *errors)
{
    fprintf(out, "| shifts | largest absolute, levels | at k | largest relative, %% | at k | mean "
                 "relative, %% |\n|---:|---:|---:|---:|---:|---:|\n");
    for (int i = 0; i < GLINT_REPORT_SHIFTS; i++)
        fprintf(out, "| %d | %.4f | %d | %.4f | %d | %.4f |\n", GLINT_DIVIDER_SHIFTS_MIN + i,
                errors[i].absolute, errors[i].absolute_k, 100.0 * errors[i].relative,
                errors[i].relative_k, 100.0 * errors[i].relative_mean);
}

static void write_increment(FILE *out, const glint_divider_report *report, const char *level)
{
    fprintf(out,
            "\n%s Error of one increment\n\n"
            "For a difference of 255 and spans of k = %d to %d; k = 1 is exact. The circuit's "
            "table holds 2^n/k\nrounded to nearest:\n\n",
            level, GLINT_ERROR_K_MIN, GLINT_DIVIDER_K_MAX);
    write_increment_table(out, report->error[GLINT_BITS_ROUNDED]);
    fprintf(out, "\nA table of truncated bits would give:\n\n");
    write_increment_table(out, report->error[GLINT_BITS_TRUNCATED]);
    fprintf(out, "\n%s\n",
            report->plotted ? "![relative error by k for 6, 7 and 8 shifts](figure-2.12.svg)"
                            : "There was no gnuplot, so figure-2.12.svg and figure-2.12.png "
                              "were not made; their data is in\nfigure-2.12.dat.");
}

static void write_displayed(FILE *out, const glint_divider_error *error)
{
    if (error->displayed == 0)
        fprintf(out, " 0 | | |");
    else
        fprintf(out, " %d | %d | %d |", error->displayed, error->displayed_k,
                error->displayed_difference);
}

static void write_last_pixel_table(FILE *out, const glint_divider_error *errors)
{
    fprintf(out, "| shifts | before rounding, levels | at k | shown, levels | at k | at difference "
                 "|\n|---:|---:|---:|---:|---:|---:|\n");
    for (int i = 0; i < GLINT_REPORT_SHIFTS; i++) {
        fprintf(out, "| %d | %.4f | %d |", GLINT_DIVIDER_SHIFTS_MIN + i, errors[i].last_pixel,
                errors[i].last_pixel_k);
        write_displayed(out, &errors[i]);
        fputc('\n', out);
    }
}

/* The least number of shifts with which, and with all above it, nothing wrong is shown; one more
 * than the most: there is none. */
static int first_exact(const glint_divider_error *errors)
{
    int first = GLINT_REPORT_SHIFTS;
    while (first > 0 && errors[first - 1].displayed == 0)
        first--;
    return GLINT_DIVIDER_SHIFTS_MIN + first;
}

static void write_last_pixel(FILE *out, const glint_divider_report *report, const char *level)
{
    fprintf(out,
            "\n%s Error at the last pixel of a span\n\n"
            "The increment is added k times, and its error with it. Before rounding: for a "
            "difference of 255. Shown:\nas the span unit gives the last pixel, rounded half up to "
            "8 bits, the largest over every difference\n-255 to 255 and every k, rising from 0 or "
            "falling from 255.\n\n",
            level);
    write_last_pixel_table(out, report->error[GLINT_BITS_ROUNDED]);
    fprintf(
        out,
        "\nFrom %d shifts on the last pixel is within half a level for every k; from %d on what "
        "is shown is exact. The default is\n%d shifts.\n\nWith truncated bits the last pixel is "
        "within half a level from %d shifts on:\n\n",
        report->first_within_half[GLINT_BITS_ROUNDED],
        first_exact(report->error[GLINT_BITS_ROUNDED]), GLINT_DIVIDER_SHIFTS_DEFAULT,
        report->first_within_half[GLINT_BITS_TRUNCATED]);
    write_last_pixel_table(out, report->error[GLINT_BITS_TRUNCATED]);
}

static void write_counts(FILE *out, const char *name, const glint_operations *stated,
                         const glint_operations *described, const glint_operations *drawn)
{
    fprintf(out,
            "| %s | %" PRIu64 " / %" PRIu64 " | %" PRIu64 " / %" PRIu64 " | %" PRIu64 " / %" PRIu64
            " |\n",
            name, stated->additions, stated->divisions, described->additions, described->divisions,
            drawn->additions, drawn->divisions);
}

static void write_clocks(FILE *out, const char *name, uint64_t clocks_of_a_division,
                         const glint_operations *totals)
{
    fprintf(out, "| %s |", name);
    for (int i = 0; i < 3; i++)
        fprintf(out, " %" PRIu64 " |", glint_operations_clocks(totals[i], clocks_of_a_division));
    fputc('\n', out);
}

static void write_ratios(FILE *out, const glint_operations *totals)
{
    fprintf(out, "| times faster |");
    for (int i = 0; i < 3; i++)
        fprintf(out, " %.4f |",
                (double)glint_operations_clocks(totals[i], GLINT_CLOCKS_DIVISION) /
                    (double)glint_operations_clocks(totals[i], GLINT_CLOCKS_DIVISION_BY_SHIFTS));
    fputc('\n', out);
}

static void write_count_table(FILE *out, const glint_table_21 *table)
{
    static const char *const stages[GLINT_SPAN_STAGE_COUNT] = {
        "increments along edges", "points of edges", "increments along rows", "points of rows"};
    const glint_operations totals[3] = {glint_operations_total(&glint_table_21_stated),
                                        glint_operations_total(&table->described),
                                        glint_operations_total(&table->drawn)};
    fprintf(out, "| additions / divisions | Table 2.1 | as described | as drawn "
                 "|\n|---|---:|---:|---:|\n");
    for (int i = 0; i < GLINT_SPAN_STAGE_COUNT; i++)
        write_counts(out, stages[i], &glint_table_21_stated.stage[i], &table->described.stage[i],
                     &table->drawn.stage[i]);
    write_counts(out, "in all", &totals[0], &totals[1], &totals[2]);
    write_clocks(out, "clocks with division (inferred)", GLINT_CLOCKS_DIVISION, totals);
    write_clocks(out, "clocks with the sum instead (inferred)", GLINT_CLOCKS_DIVISION_BY_SHIFTS,
                 totals);
    write_ratios(out, totals);
}

static void write_table_21(FILE *out, const glint_table_21 *table, const char *level)
{
    const glint_operations total = glint_operations_total(&table->described);
    fprintf(out,
            "\n%s Table 2.1: operations of one triangle\n\n"
            "Counted by the rasterizer's span unit while it works on the thesis's triangle, "
            "AB 7/8, AC 9/12, BC 16/4\n(dx/dy), three colour components:\n\n",
            level);
    write_count_table(out, table);
    fprintf(
        out,
        "\n*As described* by the thesis: each edge along the longer of dx and "
        "dy, 8, 12 and 16\nsteps, and the points between its ends, %" PRIu64
        " in all; each row between top and bottom, %" PRIu64
        ", from the left\nedge's point to the right one's, and the %" PRIu64
        " pixels strictly inside. An increment is two subtractions and a\ndivision, a point one "
        "addition.\n\n"
        "*As drawn*: what the rasterizer does for a picture. The fill rule gives %" PRIu64
        " rows and %" PRIu64 " pixels, those\ninside and those on one edge: pixels on the other "
        "edges are a neighbouring triangle's. The first pixel\nof a row has its edge's value and "
        "costs no addition; a row of one pixel divides nothing; and an edge is\nwalked no "
        "further than to its last row.\n\n"
        "The thesis gives no clocks of single operations. With %d for an addition, %d for a "
        "division "
        "and %d for the sum\n(2.18) that replaces one, what is described takes %" PRIu64
        " and %" PRIu64 " clocks, where the thesis has %d and %d: these\nthree are inferred from "
        "that, not measured.\n",
        table->described_edge_points, table->described_rows, table->described_pixels,
        table->drawn_rows, table->drawn_pixels, GLINT_CLOCKS_ADDITION, GLINT_CLOCKS_DIVISION,
        GLINT_CLOCKS_DIVISION_BY_SHIFTS, glint_operations_clocks(total, GLINT_CLOCKS_DIVISION),
        glint_operations_clocks(total, GLINT_CLOCKS_DIVISION_BY_SHIFTS),
        GLINT_CLOCKS_STATED_DIVISION, GLINT_CLOCKS_STATED_BY_SHIFTS);
}

static void write_frame(FILE *out, const glint_divider_scene *scene,
                        const glint_divider_frame *frame)
{
    fprintf(out,
            "| %s, density %d | %" PRIu64 " | %.3g | %" PRIu64 " | %d | %.3g | %d | %.2f %% | "
            "%" PRIu64 " | ![frame](%s) | ![difference](%s) |\n",
            scene->model, scene->density, scene->drawn,
            (double)frame->difference.object_pixels / (double)scene->drawn, scene->divisions,
            frame->shifts, frame->difference.nmse, frame->difference.largest,
            100.0 * (double)frame->difference.differing_pixels /
                (double)frame->difference.object_pixels,
            frame->verilog_pixels, frame->picture, frame->difference_picture);
}

static void write_pictures(FILE *out, const glint_divider_scene *scene)
{
    const glint_divider_frame *first = &scene->frames[0];
    fprintf(out,
            "\n%s, density %d: exact, by %d shifts, and where the two differ.\n\n"
            "![exact](%s) ![by %d shifts](%s) ![difference](%s)\n",
            scene->model, scene->density, first->shifts, scene->exact_picture, first->shifts,
            first->picture, first->difference_picture);
}

static void write_frames(FILE *out, const glint_divider_scene *scenes, const char *level)
{
    fprintf(
        out,
        "\n%s Whole frames\n\n"
        "Gouraud's shading, %dx%d, against the same frame with exact values along edges and "
        "spans, rounded half up.\nEach model as fine as it is by default, and with larger "
        "triangles. Section 3.4 reads an NMSE of\nup to 0.0001 as no visible difference, "
        "0.00025 as slight, 0.001 as visible ones.\n\n"
        "Beside the table's bits there is this: a run longer than %d steps is cut, and its values "
        "at the cuts are rounded to 8\nbits; and an exact half is rounded up, which an error "
        "below, "
        "however small, turns down.\n\n"
        "The frames are by the C model of the divider; *by the Verilog* is how many pixels of the "
        "same frames\ndiffer from them when the circuit is simulated.\n\n"
        "| model | triangles drawn | pixels of each | divisions | shifts | NMSE | largest, levels "
        "| pixels that "
        "differ | by the Verilog | frame | difference |\n"
        "|---|---:|---:|---:|---:|---:|---:|---:|---:|---|---|\n",
        level, GLINT_DIVIDER_FRAME_WIDTH, GLINT_DIVIDER_FRAME_HEIGHT, GLINT_DIVIDER_K_MAX);
    for (int i = 0; i < GLINT_DIVIDER_SCENES; i++)
        for (int j = 0; j < GLINT_DIVIDER_FRAMES; j++)
            write_frame(out, &scenes[i], &scenes[i].frames[j]);
    for (int i = 0; i < GLINT_DIVIDER_SCENES; i++)
        write_pictures(out, &scenes[i]);
}

void glint_divider_write_parts(FILE *out, const glint_divider_report *report, const char *level)
{
    write_claims(out, &report->claims, level);
    write_increment(out, report, level);
    write_last_pixel(out, report, level);
    write_table_21(out, &report->table, level);
    write_frames(out, report->scenes, level);
}

void glint_divider_write_markdown(FILE *out, const glint_divider_report *report)
{
    fprintf(out, "# The shift-accumulate divider in numbers\n\n"
                 "Made by `glint report divider`. The circuit, and what the thesis leaves open "
                 "about it, is in the project's\ndocs/divider.md.\n\n");
    glint_divider_write_parts(out, report, "##");
}
