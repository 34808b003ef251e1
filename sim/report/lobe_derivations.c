/* What sections 2.2 and 2.3 derive, computed without the derivation: by summing and searching. */
#include <math.h>

#include "reflectance/search.h"
#include "report/lobe_parts.h"

#define TABLE_OF_A 1000

static const glint_span_of_n nothing = {NAN, NAN};

static void take(glint_span_of_n *span, double value)
{
    span->least = fmin(span->least, value); /* of NAN and a number it is the number */
    span->largest = fmax(span->largest, value);
}

/* ---- (2.8) ----------------------------------------------------------------------------------- */

/* As it is printed; false where it divides by zero. */
static bool printed_a(double n, double *a)
{
    const double tangent = 1.0 / sqrt(n - 1.0);
    const double cosine = cos(atan(tangent));
    *a = (pow(cosine, n - 1.0) - 1.0) / (cosine - 1.0);
    return isfinite(tangent) && isfinite(*a);
}

static void measure_a(glint_derivations *derived)
{
    derived->a_count = TABLE_OF_A;
    derived->a_limit = glint_quadratic_a(1.0);
    for (int n = 1; n <= TABLE_OF_A; n++) {
        double a;
        if (printed_a(n, &a)) {
            derived->a_lost = fmax(derived->a_lost, fabs(a / glint_quadratic_a(n) - 1.0));
            continue;
        }
        derived->a_first_undefined = derived->a_undefined == 0 ? n : derived->a_first_undefined;
        derived->a_undefined++;
    }
}

/* ---- (2.13), (2.14) -------------------------------------------------------------------------- */

double glint_formula_w(double n, double cosine)
{
    const double t = (n + 1.0) / 3.0 * (cosine - 1.0) + 1.0;
    return t > 0.0 ? t * t : 0.0;
}

/* ∫W sin γ dγ from 0 to an angle within the lobe, by Simpson's rule in γ, times n + 1. */
static double integral_of_w(double n, double to)
{
    enum { INTERVALS = 2000 };
    double sum = 0.0;
    for (int i = 0; i <= INTERVALS; i++) {
        const double angle = to * i / INTERVALS;
        const double weight = i == 0 || i == INTERVALS ? 1.0 : i % 2 == 1 ? 4.0 : 2.0;
        sum += weight * glint_formula_w(n, cos(angle)) * sin(angle);
    }
    return (n + 1.0) * sum * to / (3.0 * INTERVALS);
}

static void measure_integral(const glint_exponents *exponents, glint_derivations *derived)
{
    for (int i = 0; i < exponents->count; i++) {
        const double n = exponents->n[i];
        const double zero = acos((n - 2.0) / (n + 1.0));
        const double lost = 1.0 - integral_of_w(n, fmin(zero, acos(0.0)));
        derived->integral_apart = fmax(derived->integral_apart, fabs(integral_of_w(n, zero) - 1.0));
        if (lost > derived->in_front_short) {
            derived->in_front_short = lost;
            derived->in_front_short_n = n;
        }
    }
}

/* ---- The places of the largest errors -------------------------------------------------------- */

/* W/cosⁿ − 1 at a cosine. */
static double excess(const void *context, double cosine)
{
    const double n = *(const double *)context;
    return glint_formula_w(n, cosine) / pow(cosine, n) - 1.0;
}

/* tan γ = √(1+2n)/n is c = n/(n+1); tan γ = √(6n−3)/(n−2) is c = (n−2)/(n+1). */
static void measure_places(double n, double largest_absolute, glint_derivations *derived)
{
    const double place = n / (n + 1.0), end = (n - 2.0) / (n + 1.0);
    double cosine;
    take(&derived->relative_there, glint_search_maximum(excess, &n, end, 1.0, 512, &cosine));
    take(&derived->relative_apart, (n + 1.0) * fabs(cosine - place));
    take(&derived->relative_level, pow(place, n));
    take(&derived->relative_at_end, -excess(&n, end));
    take(&derived->level_at_end, pow(end, n));
    take(&derived->absolute_to_end, largest_absolute / pow(end, n));
}

void glint_derivations_measure(const glint_lobes *lobes, glint_derivations *derived)
{
    static const double one = 1.0;
    const glint_accuracy *own = lobes->by_n[GLINT_REFLECTANCE_COSINE_QUADRATIC];
    *derived = (glint_derivations){.relative_apart = nothing,
                                   .relative_level = nothing,
                                   .relative_there = nothing,
                                   .relative_at_end = nothing,
                                   .level_at_end = nothing,
                                   .absolute_to_end = nothing,
                                   .relative_at_1 = excess(&one, one / (one + 1.0)),
                                   .level_at_1 = pow(one / (one + 1.0), one)};
    measure_a(derived);
    measure_integral(&lobes->exponents, derived);
    for (int i = 0; i < lobes->exponents.count; i++)
        if (lobes->exponents.n[i] >= GLINT_LOBE_ENDS_FROM)
            measure_places(lobes->exponents.n[i], own[i].absolute.error, derived);
}
