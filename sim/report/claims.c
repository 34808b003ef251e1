/* The thesis's numbers, one after the other as section 2.4 has them. */
#include "report/claims.h"

#include <math.h>

#include "report/divider_error.h"
#include "report/findings.h"

const glint_span_operations glint_table_21_stated = {{
    [GLINT_SPAN_EDGE_INCREMENTS] = {18, 9},
    [GLINT_SPAN_EDGE_POINTS] = {99, 0},
    [GLINT_SPAN_ROW_INCREMENTS] = {66, 33},
    [GLINT_SPAN_ROW_POINTS] = {225, 0},
}};

/* Section 3.4: no visible difference up to here. */
#define NMSE_NOT_VISIBLE 0.0001

/* The conditions of Table 2.1's counts. */
#define WALKED "the triangle below, three components, walked as the thesis describes"

glint_operations glint_operations_total(const glint_span_operations *operations)
{
    glint_operations total = {0};
    for (int i = 0; i < GLINT_SPAN_STAGE_COUNT; i++) {
        total.additions += operations->stage[i].additions;
        total.divisions += operations->stage[i].divisions;
    }
    return total;
}

uint64_t glint_operations_clocks(glint_operations operations, uint64_t clocks_of_a_division)
{
    return operations.additions * GLINT_CLOCKS_ADDITION +
           operations.divisions * clocks_of_a_division;
}

static void add(glint_claims *claims, glint_claim claim)
{
    claim.holds = !claim.undecided &&
                  (claim.at_most ? claim.measured <= claim.stated
                                 : glint_rounds_to(claim.measured, claim.stated, claim.decimals));
    claims->claim[claims->count++] = claim;
}

static void add_example(glint_claims *claims)
{
    const double exact = 255.0 / 7.0;
    const uint32_t bits = glint_divider_bits(6, 7);
    const double sum = 255.0 * bits / 64.0;
    const double relative = glint_divider_relative_error(6, GLINT_BITS_ROUNDED, 7);
    add(claims, (glint_claim){.what = "(2.19): 64ths of the sum for 1/7 with 6 shifts, 1/8 + 1/64",
                              .stated = 9,
                              .measured = bits,
                              .note = "64/7 to the nearest whole number"});
    add(claims, (glint_claim){.what = "exact increment 255/7, levels",
                              .stated = 36.4286,
                              .decimals = 4,
                              .measured = exact,
                              .note = "difference 255, k = 7"});
    add(claims, (glint_claim){.what = "increment by the sum, k = 7, 6 shifts, levels",
                              .stated = 35.8594,
                              .decimals = 4,
                              .measured = sum,
                              .note = "difference 255, before rounding to a level"});
    add(claims, (glint_claim){.what = "its absolute error, levels",
                              .stated = 0.5692,
                              .decimals = 4,
                              .measured = exact - sum,
                              .note = "of those two"});
    add(claims, (glint_claim){.what = "the same, as the relative error's numerator, levels",
                              .stated = 0.5693,
                              .decimals = 4,
                              .measured = exact - sum,
                              .note = "a slip: a line above the thesis has 0.5692"});
    add(claims, (glint_claim){.what = "its relative error, %",
                              .stated = 1.56,
                              .decimals = 2,
                              .measured = 100.0 * relative,
                              .note = "of the exact increment; the same for every difference"});
}

static double worst_nmse(const glint_divider_scene *scenes, int frame)
{
    double worst = 0.0;
    for (int i = 0; i < GLINT_DIVIDER_SCENES; i++)
        worst = fmax(worst, scenes[i].frames[frame].difference.nmse);
    return worst;
}

static void add_errors(glint_claims *claims, const glint_divider_scene *scenes)
{
    const glint_divider_error error = glint_divider_error_of(8, GLINT_BITS_ROUNDED);
    add(claims,
        (glint_claim){.what = "6 shifts: \"visually not worse\", as the largest NMSE of the frames "
                              "below, at most (section 3.4)",
                      .stated = NMSE_NOT_VISIBLE,
                      .decimals = 4,
                      .at_most = true,
                      .measured = worst_nmse(scenes, 0),
                      .note = "over frames; one span may end 22 levels off, see below"});
    add(claims, (glint_claim){.what = "8 shifts: largest absolute error, k = 2...16, levels",
                              .stated = 0.4427,
                              .decimals = 4,
                              .measured = error.absolute,
                              .note = "at k = 9; of one increment, not of a span"});
    add(claims, (glint_claim){.what = "8 shifts: mean relative error, k = 2...16, %",
                              .stated = 0.81,
                              .decimals = 2,
                              .measured = 100.0 * error.relative_mean,
                              .note = "each k once; bits rounded to the nearest"});
}

static void add_counts(glint_claims *claims, const glint_table_21 *table)
{
    static const char *const what[GLINT_SPAN_STAGE_COUNT][2] = {
        {"Table 2.1: additions for the increments along edges",
         "Table 2.1: divisions for the increments along edges"},
        {"Table 2.1: additions for the points of edges", NULL},
        {"Table 2.1: additions for the increments along rows",
         "Table 2.1: divisions for the increments along rows"},
        {"Table 2.1: additions for the points of rows", NULL},
    };
    for (int i = 0; i < GLINT_SPAN_STAGE_COUNT; i++) {
        const glint_operations stated = glint_table_21_stated.stage[i];
        const glint_operations run = table->described.stage[i];
        add(claims, (glint_claim){.what = what[i][0],
                                  .stated = (double)stated.additions,
                                  .measured = (double)run.additions,
                                  .note = WALKED});
        if (what[i][1] != NULL)
            add(claims, (glint_claim){.what = what[i][1],
                                      .stated = (double)stated.divisions,
                                      .measured = (double)run.divisions,
                                      .note = WALKED});
    }
}

static void add_totals(glint_claims *claims, const glint_table_21 *table)
{
    const glint_operations total = glint_operations_total(&table->described);
    const double before = (double)glint_operations_clocks(total, GLINT_CLOCKS_DIVISION);
    const double after = (double)glint_operations_clocks(total, GLINT_CLOCKS_DIVISION_BY_SHIFTS);
    add(claims, (glint_claim){.what = "Table 2.1: additions in all",
                              .stated = 408,
                              .measured = (double)total.additions,
                              .note = WALKED});
    add(claims, (glint_claim){.what = "Table 2.1: divisions in all",
                              .stated = 42,
                              .measured = (double)total.divisions,
                              .note = WALKED});
    add(claims, (glint_claim){.what = "clocks with division",
                              .stated = 2946,
                              .measured = before,
                              .undecided = true,
                              .note = "3 an addition, 41 a division: inferred from this number"});
    add(claims, (glint_claim){.what = "clocks with the sum instead",
                              .stated = 2064,
                              .measured = after,
                              .undecided = true,
                              .note = "3 an addition, 20 a sum: inferred from this number"});
    add(claims, (glint_claim){.what = "times faster",
                              .stated = 1.43,
                              .decimals = 2,
                              .measured = before / after,
                              .note = "the quotient of those two; no time was measured"});
}

static void add_triangle(glint_claims *claims, const glint_table_21 *table)
{
    add(claims, (glint_claim){.what = "pixels of the \"average triangle of 100 points\"",
                              .stated = 100,
                              .measured = (double)table->drawn_pixels,
                              .note = "its area is 78 pixels"});
}

void glint_claims_check(const glint_table_21 *table,
                        const glint_divider_scene scenes[GLINT_DIVIDER_SCENES],
                        glint_claims *claims)
{
    claims->count = 0;
    add_example(claims);
    add_errors(claims, scenes);
    add_triangle(claims, table);
    add_counts(claims, table);
    add_totals(claims, table);
}
