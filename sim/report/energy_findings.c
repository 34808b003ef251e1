/* The claims of section 2.5. */
#include <math.h>

#include "report/energy_parts.h"

#define SAY(text, ...) snprintf(text, sizeof text, __VA_ARGS__)

/* What the thesis's figure 2.15 shows as not conserving. */
#define CLAIMED_LAST 17

/* Integrals that differ by less are one and the same, relatively. */
#define SAME 1e-3

static glint_verdict holds_if(bool held)
{
    return held ? GLINT_HOLDS : GLINT_DOES_NOT_HOLD;
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

/* How many cells of the grid have a larger R than normal incidence at the same n. */
static int above_normal(const glint_energy_table *grid, int model)
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
    SAY(finding->conditions,
        "%d exponents n = 1…1000, %d incidences 0…89°, quadrature, double precision",
        grid->plan.n_count, grid->plan.angle_count);
}

static void find_plain(const glint_energy_results *results, glint_findings *findings)
{
    const glint_energy_normal *normal = &results->normal;
    const excess w = excess_of(normal->w), limited = excess_of(normal->with_limit);
    glint_finding *finding = glint_findings_add(
        findings, holds_if(w.first == 1 && w.last == CLAIMED_LAST), "2.5, figure 2.15");
    SAY(finding->claim, "W without a factor does not conserve energy for n = 1…%d", CLAIMED_LAST);
    SAY(finding->measured,
        "R > 1 for n = %d…%d; R = %.4f at n = 17, %.4f at 18, %.4f at 19, %.4f at 20. By (2.25) "
        "with dθ₀, to 5.8/√n, n = %d…%d (%.4f at 18)",
        w.first, w.last, normal->w[16], normal->w[17], normal->w[18], normal->w[19], limited.first,
        limited.last, normal->with_limit[17]);
    SAY(finding->conditions, "every n = 1…1000, normal incidence, W zero beyond its zero");
}

static void find_largest(const glint_energy_results *results, glint_findings *findings)
{
    const int above = above_normal(results->grid, GLINT_REFLECTANCE_COSINE_QUADRATIC);
    glint_finding *finding = glint_findings_add(findings, holds_if(above == 0), "2.5");
    SAY(finding->claim, "normal incidence is the worst case: no R(L) is larger than for L = N");
    SAY(finding->measured, "%d cells of the cosine-quadratic have a larger R than normal incidence",
        above);
    say_grid(finding, results->grid);
}

/* (2.24) has (cos θ₀)/2 for cos(θ₀/2). */
static void find_half_angle(const glint_energy_results *results, glint_findings *findings)
{
    const int last = GLINT_ENERGY_N_MAX - 1;
    const double centre = 1.0 - (GLINT_ENERGY_N_MAX + 1.0) / 6.0;
    double printed[GLINT_ENERGY_N_MAX], apart = 0.0;
    for (int i = 0; i < GLINT_ENERGY_N_MAX; i++) {
        printed[i] = glint_misprinted_albedo(i + 1);
        apart = fmax(apart, fabs(printed[i] / results->normal.w[i] - 1.0));
    }
    const excess above = excess_of(printed);
    glint_finding *finding = glint_findings_add(findings, holds_if(apart < SAME), "(2.24)");
    SAY(finding->claim, "at normal incidence, L = N, (2.23) becomes (2.24), with (cos θ₀)/2");
    SAY(finding->measured,
        "as printed the highlight's centre is %.0f at n = 1000 instead of 1 and R = %.0f instead "
        "of %.4f; R > 1 for %d exponents, n = %d…%d. A misprint: cos(θ₀/2) is meant",
        centre * centre, printed[last], results->normal.w[last], above.count, above.first,
        above.last);
    SAY(finding->conditions, "every n = 1…1000, over the hemisphere, in closed form; (2.25) has "
                             "cos(θ₀/2), and so has everything else here");
}

/* (2.25) has dω₀ for dθ₀. */
static void find_differential(const glint_energy_results *results, glint_findings *findings)
{
    const int last = GLINT_ENERGY_N_MAX - 1;
    const double *held = results->normal.held;
    double literal[GLINT_ENERGY_N_MAX], apart = 0.0;
    for (int i = 0; i < GLINT_ENERGY_N_MAX; i++) {
        const double limit = fmin(glint_printed_limit(i + 1), acos(0.0));
        literal[i] = glint_printed_albedo_by_solid_angle(i + 1, limit);
        apart = fmax(apart, fabs(literal[i] / held[i] - 1.0));
    }
    const excess above = excess_of(literal);
    glint_finding *finding = glint_findings_add(findings, holds_if(apart < SAME), "(2.25)");
    SAY(finding->claim, "R is the integral of W cos θ₀ sin θ₀ over dω₀");
    SAY(finding->measured,
        "with dω₀ = sin θ₀ dθ₀ R = %.4f at n = 17 and %.6f at 1000, above 1 only for n = %d…%d; "
        "with dθ₀ %.4f and %.6f. A misprint: dθ₀ is meant",
        literal[CLAIMED_LAST - 1], literal[last], above.first, above.last, held[CLAIMED_LAST - 1],
        held[last]);
    SAY(finding->conditions, "every n = 1…1000, to 5.8/√n, at most π/2; 2π and sin θ₀ are what "
                             "dω₀ has beside dθ₀; dθ₀ is read everywhere else here");
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
    glint_finding *finding =
        glint_findings_add(findings, holds_if(blinn == GLINT_ENERGY_N_MAX), "2.5");
    SAY(finding->claim,
        "by the law of conservation the incident energy is at most the reflected, R ≥ 1");
    SAY(finding->measured,
        "R ≥ 1 for %d exponents of Blinn's with (n+6)/(8π), which by figure 2.16 conserves, and "
        "for %d of W, which there does not. A slip: (2.22) has R ≤ 1",
        blinn, w);
    SAY(finding->conditions, "every n = 1…1000, normal incidence; R ≤ 1 is read everywhere else "
                             "here");
}

static void find_limit(const glint_energy_results *results, glint_findings *findings)
{
    const double *w = results->normal.w, *limited = results->normal.with_limit;
    double most = 0.0;
    int most_n = 0;
    for (int i = 0; i < GLINT_ENERGY_N_MAX; i++)
        if (fabs(limited[i] - w[i]) / w[i] > most) {
            most = fabs(limited[i] - w[i]) / w[i];
            most_n = i + 1;
        }
    const int last = GLINT_ENERGY_N_MAX - 1;
    const double zero = 2.0 * acos((last - 1.0) / (last + 2.0)) * sqrt(last + 1.0);
    glint_finding *finding = glint_findings_add(findings, holds_if(zero >= 5.8), "(2.25)");
    SAY(finding->claim, "the limit 5.8/√n takes in the first lobe of W only");
    SAY(finding->measured,
        "W is zero at %.4f/√n (n = 1000); R by (2.25) with dθ₀ is %.2f %% too large at n = 1000 "
        "and "
        "%.1f %% off at n = %d",
        zero, 100.0 * (limited[last] / w[last] - 1.0), 100.0 * most, most_n);
    SAY(finding->conditions, "every n = 1…1000, against the integral to the zero of W or to π/2");
}

static void find_claimed(const glint_energy_results *results, glint_findings *findings)
{
    const glint_energy_normal *normal = &results->normal;
    const excess above = excess_of(normal->claimed);
    glint_finding *finding =
        glint_findings_add(findings, holds_if(above.count == 0), "(2.26), figure 2.16");
    SAY(finding->claim, "(n+6)/24.55 · W conserves energy for n = 1…1000");
    SAY(finding->measured,
        "R > 1 for %d exponents, n = %d…%d: %.4f at n = %d, %.4f at 1000. With A = 6, B must be "
        "%.6g or more",
        above.count, above.first, above.last, above.largest, above.largest_n,
        normal->claimed[GLINT_ENERGY_N_MAX - 1], ceil(1e4 * results->claimed.b) * 1e-4);
    SAY(finding->conditions, "every n = 1…1000, normal incidence (the largest of all incidences)");
}

static void find_blinn(const glint_energy_results *results, glint_findings *findings)
{
    glint_energy_summary summary;
    glint_energy_summarize(results->grid, GLINT_REFLECTANCE_BLINN_NORMALIZED, &summary);
    glint_finding *finding =
        glint_findings_add(findings, holds_if(summary.n_above == 0), "figure 2.16");
    SAY(finding->claim, "Blinn's with (n+6)/(8π) conserves energy for n = 1…1000");
    SAY(finding->measured, "R is at most %.6f, at n = %g and %g°", summary.largest,
        summary.largest_n, summary.largest_angle);
    say_grid(finding, results->grid);
}

/* Relative differences of f_r that rounding alone can make. */
#define SYMMETRIC 1e-12

static void find_reciprocity(const glint_energy_results *results, glint_findings *findings)
{
    double largest = 0.0;
    for (int i = 0; i < GLINT_REFLECTANCE_COUNT; i++)
        largest = fmax(largest, results->asymmetry[i]);
    glint_finding *finding = glint_findings_add(findings, holds_if(largest <= SYMMETRIC), "(2.20)");
    SAY(finding->claim, "the reflectance function is reciprocal: f_r(L,V) = f_r(V,L)");
    SAY(finding->measured, "largest relative difference %.3g, over all %d models", largest,
        (int)GLINT_REFLECTANCE_COUNT);
    SAY(finding->conditions, "%llu pairs of directions for each model, seven n from 1 to 1000",
        (unsigned long long)results->pairs);
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
