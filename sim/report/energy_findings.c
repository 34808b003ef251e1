/* The claims of section 2.5. */
#include <math.h>
#include <string.h>

#include "report/energy_parts.h"

#define SAY(text, ...) snprintf(text, sizeof text, __VA_ARGS__)

/* What the thesis's figure 2.15 shows as not conserving. */
#define CLAIMED_LAST 17

/* Integrals that differ by less are one and the same, relatively. */
#define SAME 1e-3

/* A count of what contradicts a claim: there may be none. */
static glint_judged none_of(double count)
{
    return glint_judged_number(GLINT_AT_MOST, 0.0, 0, count);
}

/* The exponents with an albedo above 1, and the largest one. */
typedef struct excess {
    int count, first, last;
    double largest;
    int largest_n;
} excess;

static excess excess_of(const double *albedo)
{
    excess found = {0};
    for (int i = 0; i < GLINT_ENERGY_N_MAX; i++) {
        if (albedo[i] > GLINT_ENERGY_ONE) {
            found.count++;
            found.first = found.first == 0 ? i + 1 : found.first;
            found.last = i + 1;
        }
        if (albedo[i] > found.largest) {
            found.largest = albedo[i];
            found.largest_n = i + 1;
        }
    }
    return found;
}

int glint_energy_count_above(const double albedo[GLINT_ENERGY_N_MAX])
{
    return excess_of(albedo).count;
}

int glint_energy_above_normal(const glint_energy_table *grid, int model)
{
    int count = 0;
    for (int n = 0; n < grid->plan.n_count; n++)
        for (int i = 1; i < grid->plan.angle_count; i++)
            count += glint_energy_at(grid, model, n, i)->quadrature >
                     glint_energy_at(grid, model, n, 0)->quadrature;
    return count;
}

static void say_grid(glint_finding *finding, const glint_energy_table *grid)
{
    const glint_energy_plan *plan = &grid->plan;
    SAY(finding->conditions,
        "%d exponents n = %g…%g, %d incidences %g…%g°, quadrature, double precision; above 1 is "
        "above %g",
        plan->n_count, plan->n[0], plan->n[plan->n_count - 1], plan->angle_count, plan->angle[0],
        plan->angle[plan->angle_count - 1], GLINT_ENERGY_ONE);
}

/* What was measured at every exponent of glint_energy_normal. */
#define EVERY_N "every n = 1…%d"

static void find_plain(const glint_energy_results *results, glint_findings *findings)
{
    const glint_energy_normal *normal = &results->normal;
    const excess w = excess_of(normal->w), limited = excess_of(normal->with_limit);
    int otherwise = 0;
    for (int i = 0; i < GLINT_ENERGY_N_MAX; i++)
        otherwise += (normal->w[i] > GLINT_ENERGY_ONE) != (i < CLAIMED_LAST);
    const glint_judged judged = none_of(otherwise);
    glint_finding *finding = glint_findings_add(findings, "2.5, figure 2.15", &judged);
    SAY(finding->claim, "W without a factor does not conserve energy for n = 1…%d", CLAIMED_LAST);
    SAY(finding->measured, "R > 1 for n = %d…%d, %d exponents, otherwise for %d;", w.first, w.last,
        w.count, otherwise);
    for (int n = CLAIMED_LAST; n < CLAIMED_LAST + 4; n++) {
        const size_t length = strlen(finding->measured);
        snprintf(finding->measured + length, sizeof finding->measured - length,
                 "%s R = %.4f at n = %d", n > CLAIMED_LAST ? "," : "", normal->w[n - 1], n);
    }
    const size_t length = strlen(finding->measured);
    snprintf(finding->measured + length, sizeof finding->measured - length,
             ". By (2.25) with dθ₀, to 5.8/√n, n = %d…%d (%.4f at %d)", limited.first, limited.last,
             normal->with_limit[CLAIMED_LAST], CLAIMED_LAST + 1);
    SAY(finding->conditions,
        EVERY_N ", normal incidence, W zero beyond its zero; above 1 is above %g",
        GLINT_ENERGY_N_MAX, GLINT_ENERGY_ONE);
}

static void find_largest(const glint_energy_results *results, glint_findings *findings)
{
    const int above = glint_energy_above_normal(results->grid, GLINT_REFLECTANCE_COSINE_QUADRATIC);
    const glint_judged judged = none_of(above);
    glint_finding *finding = glint_findings_add(findings, "2.5", &judged);
    SAY(finding->claim, "normal incidence is the worst case: no R(L) is larger than for L = N");
    SAY(finding->measured, "%d cells of the cosine-quadratic have a larger R than normal incidence",
        above);
    say_grid(finding, results->grid);
}

/* The largest relative difference of two curves. */
static double apart_by(const double *curve, const double *other)
{
    double apart = 0.0;
    for (int i = 0; i < GLINT_ENERGY_N_MAX; i++)
        apart = fmax(apart, fabs(curve[i] / other[i] - 1.0));
    return apart;
}

/* (2.24) has (cos θ₀)/2 for cos(θ₀/2). */
static void find_half_angle(const glint_energy_results *results, glint_findings *findings)
{
    const int last = GLINT_ENERGY_N_MAX - 1;
    const glint_energy_normal *normal = &results->normal;
    const excess above = excess_of(normal->half_angle);
    const glint_judged judged =
        glint_judged_number(GLINT_AT_MOST, SAME, 3, apart_by(normal->half_angle, normal->w));
    glint_finding *finding = glint_findings_add(findings, "(2.24)", &judged);
    SAY(finding->claim, "at normal incidence, L = N, (2.23) becomes (2.24), with (cos θ₀)/2");
    SAY(finding->measured,
        "as printed the highlight's centre is %.0f at n = %d instead of 1 and R = %.0f instead "
        "of %.4f; R > 1 for %d exponents, n = %d…%d; the integrals differ by up to %.3g times",
        normal->centre[last], last + 1, normal->half_angle[last], normal->w[last], above.count,
        above.first, above.last, judged.lowest);
    SAY(finding->conditions,
        EVERY_N ", over the hemisphere, in closed form; the same is to within %g; cos(θ₀/2) is "
                "read, as (2.25) has it, everywhere else here",
        GLINT_ENERGY_N_MAX, SAME);
}

/* (2.25) has dω₀ for dθ₀. */
static void find_differential(const glint_energy_results *results, glint_findings *findings)
{
    const int last = GLINT_ENERGY_N_MAX - 1;
    const double *held = results->normal.held, *literal = results->normal.solid_angle;
    const excess above = excess_of(literal);
    const glint_judged judged =
        glint_judged_number(GLINT_AT_MOST, SAME, 3, apart_by(literal, held));
    glint_finding *finding = glint_findings_add(findings, "(2.25)", &judged);
    SAY(finding->claim, "R is the integral of W cos θ₀ sin θ₀ over dω₀");
    SAY(finding->measured,
        "with dω₀ = sin θ₀ dθ₀ R = %.4f at n = %d and %.6f at %d, above 1 only for n = %d…%d; "
        "with dθ₀ %.4f and %.6f",
        literal[CLAIMED_LAST - 1], CLAIMED_LAST, literal[last], last + 1, above.first, above.last,
        held[CLAIMED_LAST - 1], held[last]);
    SAY(finding->conditions,
        EVERY_N
        ", to 5.8/√n, at most π/2; the same is to within %g; 2π and sin θ₀ are what dω₀ has "
        "beside dθ₀; dθ₀ is read everywhere else here",
        GLINT_ENERGY_N_MAX, SAME);
}

/* How many exponents have an albedo of 1 or more. */
static int full_count(const double *albedo)
{
    int count = 0;
    for (int i = 0; i < GLINT_ENERGY_N_MAX; i++)
        count += albedo[i] >= 1.0;
    return count;
}

/* The sentence before (2.21) has the law the wrong way round. */
static void find_law(const glint_energy_results *results, glint_findings *findings)
{
    const int w = full_count(results->normal.w), blinn = full_count(results->normal.blinn);
    const glint_judged judged = glint_judged_number(GLINT_AT_LEAST, GLINT_ENERGY_N_MAX, 0, blinn);
    glint_finding *finding = glint_findings_add(findings, "2.5", &judged);
    SAY(finding->claim,
        "by the law of conservation the incident energy is at most the reflected, R ≥ 1");
    SAY(finding->measured,
        "R ≥ 1 for %d exponents of Blinn's with (n+6)/(8π), which by figure 2.16 conserves, and "
        "for %d of W, which there does not",
        blinn, w);
    SAY(finding->conditions,
        EVERY_N ", normal incidence; it holds when Blinn's has R ≥ 1 for all of them; (2.22) has "
                "R ≤ 1, which is read everywhere else here",
        GLINT_ENERGY_N_MAX);
}

static void find_limit(const glint_energy_results *results, glint_findings *findings)
{
    const glint_energy_normal *normal = &results->normal;
    const double *w = normal->w, *limited = normal->with_limit;
    const int last = GLINT_ENERGY_N_MAX - 1;
    glint_judged judged = {GLINT_AT_LEAST, 5.8, 1, normal->zero[0], normal->zero[0], false};
    double most = 0.0;
    int most_n = 0;
    for (int i = 0; i < GLINT_ENERGY_N_MAX; i++) {
        const double off = fabs(limited[i] - w[i]) / w[i];
        judged.lowest = fmin(judged.lowest, normal->zero[i]);
        judged.highest = fmax(judged.highest, normal->zero[i]);
        most_n = off > most ? i + 1 : most_n;
        most = fmax(most, off);
    }
    glint_finding *finding = glint_findings_add(findings, "(2.25)", &judged);
    SAY(finding->claim, "the limit %g/√n takes in the first lobe of W only", judged.stated);
    SAY(finding->measured,
        "W is zero at %.4f/√n to %.4f/√n; R by (2.25) with dθ₀ is off by %+.2f %% at n = %d, and "
        "the most, %.1f %%, at n = %d",
        judged.lowest, judged.highest, 100.0 * (limited[last] / w[last] - 1.0), last + 1,
        100.0 * most, most_n);
    SAY(finding->conditions,
        EVERY_N ", against the integral to the zero of W or to π/2; it holds when W is zero at "
                "%g/√n or beyond",
        GLINT_ENERGY_N_MAX, judged.stated);
}

static void find_claimed(const glint_energy_results *results, glint_findings *findings)
{
    const glint_energy_normal *normal = &results->normal;
    const excess above = excess_of(normal->claimed);
    const glint_judged judged = none_of(above.count);
    glint_finding *finding = glint_findings_add(findings, "(2.26), figure 2.16", &judged);
    SAY(finding->claim, "(n+6)/24.55 · W conserves energy for n = 1…%d", GLINT_ENERGY_N_MAX);
    SAY(finding->measured,
        "R > 1 for %d exponents, n = %d…%d: %.4f at n = %d, %.4f at %d. With A = %g, B must be "
        "%.6g or more",
        above.count, above.first, above.last, above.largest, above.largest_n,
        normal->claimed[GLINT_ENERGY_N_MAX - 1], GLINT_ENERGY_N_MAX, results->claimed.a,
        ceil(1e4 * results->claimed.b) * 1e-4);
    SAY(finding->conditions,
        EVERY_N
        ", normal incidence; %d cells of the grid of incidences have a larger R; above 1 is "
        "above %g",
        GLINT_ENERGY_N_MAX,
        glint_energy_above_normal(results->grid, GLINT_REFLECTANCE_ENERGY_CONSERVING),
        GLINT_ENERGY_ONE);
}

static void find_blinn(const glint_energy_results *results, glint_findings *findings)
{
    glint_energy_summary summary;
    glint_energy_summarize(results->grid, GLINT_REFLECTANCE_BLINN_NORMALIZED, &summary);
    const glint_judged judged = none_of(summary.n_above);
    glint_finding *finding = glint_findings_add(findings, "figure 2.16", &judged);
    SAY(finding->claim, "Blinn's with (n+6)/(8π) conserves energy for n = 1…%d",
        GLINT_ENERGY_N_MAX);
    SAY(finding->measured, "R is at most %.6f, at n = %g and %g°; above 1 for %d exponents",
        summary.largest, summary.largest_n, summary.largest_angle, summary.n_above);
    say_grid(finding, results->grid);
}

/* Relative differences of f_r that rounding alone can make. */
#define SYMMETRIC 1e-12

static void find_reciprocity(const glint_energy_results *results, glint_findings *findings)
{
    double largest = 0.0;
    for (int i = 0; i < GLINT_REFLECTANCE_COUNT; i++)
        largest = fmax(largest, results->asymmetry[i]);
    const glint_judged judged = glint_judged_number(GLINT_AT_MOST, SYMMETRIC, 12, largest);
    glint_finding *finding = glint_findings_add(findings, "(2.20)", &judged);
    SAY(finding->claim, "the reflectance function is reciprocal: f_r(L,V) = f_r(V,L)");
    SAY(finding->measured, "largest relative difference %.3g, over all %d models", largest,
        (int)GLINT_REFLECTANCE_COUNT);
    SAY(finding->conditions,
        "%llu pairs of directions for each model, over %d exponents n = %g…%g; equal is to within "
        "%g",
        (unsigned long long)results->pairs, results->pairs_n_count, results->pairs_n_first,
        results->pairs_n_last, SYMMETRIC);
}

void glint_energy_find(const glint_energy_results *results, glint_findings *findings)
{
    find_reciprocity(results, findings);
    find_law(results, findings);
    find_half_angle(results, findings);
    find_differential(results, findings);
    find_plain(results, findings);
    find_largest(results, findings);
    find_limit(results, findings);
    find_claimed(results, findings);
    find_blinn(results, findings);
}
