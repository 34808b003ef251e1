/* The thesis's numbers, one after the other as section 2.4 has them. */
#include "report/claims.h"

#include <math.h>

#define SAY(text, ...) snprintf(text, sizeof text, __VA_ARGS__)

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

/* Adds one; what and note are for the caller to print into. */
static glint_claim *add(glint_claims *claims, const glint_judged *judged)
{
    glint_claim *claim = &claims->claim[claims->count++];
    *claim = (glint_claim){.judged = *judged, .verdict = glint_judge(judged)};
    return claim;
}

static glint_claim *add_number(glint_claims *claims, double stated, int decimals, double measured)
{
    const glint_judged judged = glint_judged_number(GLINT_ROUNDS_TO, stated, decimals, measured);
    return add(claims, &judged);
}

static const glint_divider_error *error_by(const glint_claims_facts *facts, int shifts)
{
    return &facts->error[shifts - GLINT_DIVIDER_SHIFTS_MIN];
}

static void add_example(glint_claims *claims, const glint_divider_example *example)
{
    const int difference = example->difference, k = example->k, shifts = example->shifts;
    glint_claim *claim = add_number(claims, 9, 0, example->bits);
    SAY(claim->what, "(2.19): %dths of the sum for 1/%d with %d shifts, 1/8 + 1/64", 1 << shifts, k,
        shifts);
    SAY(claim->note, "%d/%d to the nearest whole number", 1 << shifts, k);
    claim = add_number(claims, 36.4286, 4, example->exact);
    SAY(claim->what, "exact increment %d/%d, levels", difference, k);
    SAY(claim->note, "difference %d, k = %d", difference, k);
    claim = add_number(claims, 35.8594, 4, example->sum);
    SAY(claim->what, "increment by the sum, k = %d, %d shifts, levels", k, shifts);
    SAY(claim->note, "difference %d, before rounding to a level", difference);
    claim = add_number(claims, 0.5692, 4, example->exact - example->sum);
    SAY(claim->what, "its absolute error, levels");
    SAY(claim->note, "of those two");
    claim = add_number(claims, 0.5693, 4, example->exact - example->sum);
    SAY(claim->what, "the same, as the relative error's numerator, levels");
    SAY(claim->note, "a line above the thesis has 0.5692 for the same difference");
    claim = add_number(claims, 1.56, 2, 100.0 * example->relative);
    SAY(claim->what, "its relative error, %%");
    SAY(claim->note, "of the exact increment; the same for every difference");
}

static double worst_nmse(const glint_divider_scene *scenes, int frame)
{
    double worst = 0.0;
    for (int i = 0; i < GLINT_DIVIDER_SCENES; i++)
        worst = fmax(worst, scenes[i].frames[frame].difference.nmse);
    return worst;
}

static void add_frames(glint_claims *claims, const glint_claims_facts *facts)
{
    const int shifts = facts->scenes[0].frames[0].shifts;
    const glint_judged judged =
        glint_judged_number(GLINT_AT_MOST, NMSE_NOT_VISIBLE, 4, worst_nmse(facts->scenes, 0));
    glint_claim *claim = add(claims, &judged);
    SAY(claim->what,
        "%d shifts: \"visually not worse\", as the largest NMSE of the frames below, at most "
        "(section 3.4)",
        shifts);
    SAY(claim->note, "over %d frames; the last pixel of one span may be %d levels off, see below",
        GLINT_DIVIDER_SCENES, error_by(facts, shifts)->displayed);
}

static void add_errors(glint_claims *claims, const glint_claims_facts *facts)
{
    enum { SHIFTS = 8 };
    const glint_divider_error *error = error_by(facts, SHIFTS);
    glint_claim *claim = add_number(claims, 0.4427, 4, error->absolute);
    SAY(claim->what, "%d shifts: largest absolute error, k = %d...%d, levels", SHIFTS,
        GLINT_ERROR_K_MIN, GLINT_DIVIDER_K_MAX);
    SAY(claim->note, "at k = %d; of one increment, not of a span", error->absolute_k);
    claim = add_number(claims, 0.81, 2, 100.0 * error->relative_mean);
    SAY(claim->what, "%d shifts: mean relative error, k = %d...%d, %%", SHIFTS, GLINT_ERROR_K_MIN,
        GLINT_DIVIDER_K_MAX);
    SAY(claim->note, "each k once; bits rounded to the nearest");
}

static void add_count(glint_claims *claims, const char *what, uint64_t stated, uint64_t counted)
{
    glint_claim *claim = add_number(claims, (double)stated, 0, (double)counted);
    SAY(claim->what, "Table 2.1: %s", what);
    SAY(claim->note, WALKED);
}

static void add_counts(glint_claims *claims, const glint_table_21 *table)
{
    static const char *const what[GLINT_SPAN_STAGE_COUNT][2] = {
        {"additions for the increments along edges", "divisions for the increments along edges"},
        {"additions for the points of edges", NULL},
        {"additions for the increments along rows", "divisions for the increments along rows"},
        {"additions for the points of rows", NULL},
    };
    for (int i = 0; i < GLINT_SPAN_STAGE_COUNT; i++) {
        const glint_operations stated = glint_table_21_stated.stage[i];
        const glint_operations run = table->described.stage[i];
        add_count(claims, what[i][0], stated.additions, run.additions);
        if (what[i][1] != NULL)
            add_count(claims, what[i][1], stated.divisions, run.divisions);
    }
    const glint_operations total = glint_operations_total(&table->described);
    add_count(claims, "additions in all", 408, total.additions);
    add_count(claims, "divisions in all", 42, total.divisions);
}

/* The clocks of an operation are inferred from these totals: they can be contradicted by the
 * counts, not proven, and no more can their quotient. */
static void add_clocks(glint_claims *claims, const glint_table_21 *table)
{
    const struct {
        const char *what, *operation;
        double stated;
        uint64_t clocks;
    } totals[] = {
        {"clocks with division", "a division", GLINT_CLOCKS_STATED_DIVISION, GLINT_CLOCKS_DIVISION},
        {"clocks with the sum instead", "a sum", GLINT_CLOCKS_STATED_BY_SHIFTS,
         GLINT_CLOCKS_DIVISION_BY_SHIFTS}};
    const glint_operations total = glint_operations_total(&table->described);
    double clocks[2];
    for (int i = 0; i < 2; i++) {
        clocks[i] = (double)glint_operations_clocks(total, totals[i].clocks);
        glint_judged judged = glint_judged_number(GLINT_ROUNDS_TO, totals[i].stated, 0, clocks[i]);
        judged.circular = true;
        glint_claim *claim = add(claims, &judged);
        SAY(claim->what, "%s", totals[i].what);
        SAY(claim->note, "%d an addition, %d %s: inferred from this number", GLINT_CLOCKS_ADDITION,
            (int)totals[i].clocks, totals[i].operation);
    }
    glint_judged judged = glint_judged_number(GLINT_ROUNDS_TO, 1.43, 2, clocks[0] / clocks[1]);
    judged.circular = true;
    glint_claim *claim = add(claims, &judged);
    SAY(claim->what, "times faster");
    SAY(claim->note, "the quotient of those two, neither of which can be decided; no time was "
                     "measured");
}

static void add_triangle(glint_claims *claims, const glint_table_21 *table)
{
    glint_claim *claim = add_number(claims, 100, 0, (double)table->drawn_pixels);
    SAY(claim->what, "pixels of the \"average triangle of 100 points\"");
    SAY(claim->note, "drawn; its area is %g pixels", table->area);
}

void glint_claims_check(const glint_claims_facts *facts, glint_claims *claims)
{
    claims->count = 0;
    add_example(claims, &facts->example);
    add_frames(claims, facts);
    add_errors(claims, facts);
    add_triangle(claims, facts->table);
    add_counts(claims, facts->table);
    add_clocks(claims, facts->table);
}
