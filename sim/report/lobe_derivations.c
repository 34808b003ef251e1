/* What sections 2.2 and 2.3 derive, computed without the derivation: by summing and searching. The
 * names of the numbers are those of the claims that need them. */
#include "report/lobes.h"

#include <math.h>

#include "reflectance/search.h"

#define TABLE_OF_A 1000

/* ---- (2.8) ----------------------------------------------------------------------------------- */

/* As it is printed; false where it divides by zero. */
static bool printed_a(double n, double *a)
{
    const double tangent = 1.0 / sqrt(n - 1.0);
    const double cosine = cos(atan(tangent));
    *a = (pow(cosine, n - 1.0) - 1.0) / (cosine - 1.0);
    return isfinite(tangent) && isfinite(*a);
}

static void put_a(glint_numbers *numbers)
{
    int undefined = 0, first = 0;
    double lost = 0.0;
    for (int n = 1; n <= TABLE_OF_A; n++) {
        double a;
        if (printed_a(n, &a)) {
            lost = fmax(lost, fabs(a / glint_quadratic_a(n) - 1.0));
            continue;
        }
        first = undefined++ == 0 ? n : first;
    }
    glint_number_put(numbers, TABLE_OF_A, "lobes.a.count");
    glint_number_put(numbers, undefined, "lobes.a.undefined");
    glint_number_put(numbers, first > 0 ? (double)first : NAN, "lobes.a.undefined.first");
    glint_number_put(numbers, lost, "lobes.a.lost");
    glint_number_put(numbers, glint_quadratic_a(1.0), "lobes.a.limit");
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

static void put_integral(const glint_exponents *exponents, glint_numbers *numbers)
{
    double apart = 0.0, in_front_short = 0.0, short_n = 0.0;
    for (int i = 0; i < exponents->count; i++) {
        const double n = exponents->n[i];
        const double zero = acos((n - 2.0) / (n + 1.0));
        const double lost = 1.0 - integral_of_w(n, fmin(zero, acos(0.0)));
        apart = fmax(apart, fabs(integral_of_w(n, zero) - 1.0));
        if (lost > in_front_short) {
            in_front_short = lost;
            short_n = n;
        }
    }
    glint_number_put(numbers, apart, "lobes.integral.apart");
    glint_number_put(numbers, in_front_short, "lobes.integral.in-front-short");
    glint_number_put(numbers, short_n, "lobes.integral.in-front-short.n");
}

/* ---- The places of the largest errors -------------------------------------------------------- */

/* W/cosⁿ − 1 at a cosine. */
static double excess(const void *context, double cosine)
{
    const double n = *(const double *)context;
    return glint_formula_w(n, cosine) / pow(cosine, n) - 1.0;
}

/* Of n from GLINT_LOBE_ENDS_FROM on: for n = 1 and 2 the lobe has no end above the surface. */
typedef struct places {
    double apart[2];  /* of the place of the largest W/cosⁿ − 1, searched, from c = n/(n+1); in
                         widths of the lobe, 1/(n+1) */
    double level[2];  /* cosⁿ at c = n/(n+1) */
    double there[2];  /* W/cosⁿ − 1 at the place searched */
    double at_end[2]; /* 1 − W/cosⁿ where W is zero */
    double end_level[2];       /* cosⁿ at c = (n−2)/(n+1), where W is zero */
    double absolute_to_end[2]; /* the largest absolute error to the one there */
} places;

/* tan γ = √(1+2n)/n is c = n/(n+1); tan γ = √(6n−3)/(n−2) is c = (n−2)/(n+1). */
static void measure_places(double n, double largest_absolute, places *found)
{
    const double place = n / (n + 1.0), end = (n - 2.0) / (n + 1.0);
    double cosine;
    glint_number_widen(found->there, glint_search_maximum(excess, &n, end, 1.0, 512, &cosine));
    glint_number_widen(found->apart, (n + 1.0) * fabs(cosine - place));
    glint_number_widen(found->level, pow(place, n));
    glint_number_widen(found->at_end, -excess(&n, end));
    glint_number_widen(found->end_level, pow(end, n));
    glint_number_widen(found->absolute_to_end, largest_absolute / pow(end, n));
}

static void put_places(const glint_lobes *lobes, glint_numbers *numbers)
{
    static const double one = 1.0;
    const glint_accuracy *own = lobes->by_n[GLINT_REFLECTANCE_COSINE_QUADRATIC];
    places found = {{NAN, NAN}, {NAN, NAN}, {NAN, NAN}, {NAN, NAN}, {NAN, NAN}, {NAN, NAN}};
    for (int i = 0; i < lobes->exponents.count; i++)
        if (lobes->exponents.n[i] >= GLINT_LOBE_ENDS_FROM)
            measure_places(lobes->exponents.n[i], own[i].absolute.error, &found);
    glint_number_put(numbers, found.apart[1], "lobes.place.apart");
    glint_number_put_range(numbers, found.level[0], found.level[1], "lobes.place.level");
    glint_number_put(numbers, pow(one / (one + 1.0), one), "lobes.place.level-at-1");
    glint_number_put(numbers, found.there[1], "lobes.place.there");
    glint_number_put(numbers, excess(&one, one / (one + 1.0)), "lobes.place.there-at-1");
    glint_number_put(numbers, found.at_end[1], "lobes.place.at-end");
    glint_number_put(numbers, found.at_end[1] / found.there[1], "lobes.place.end-to-there");
    glint_number_put_range(numbers, found.end_level[0], found.end_level[1],
                           "lobes.place.end-level");
    glint_number_put_range(numbers, found.absolute_to_end[0], found.absolute_to_end[1],
                           "lobes.place.absolute-to-end");
}

void glint_derivations_put(const glint_lobes *lobes, glint_numbers *numbers)
{
    put_a(numbers);
    put_integral(&lobes->exponents, numbers);
    put_places(lobes, numbers);
}
