/* Measures the numbers behind the claims of section 2.5. */
#include <math.h>

#include "report/energy.h"

/* The exponents that the thesis's figure 2.15 shows as not conserving energy. */
#define CLAIMED_LAST 17

void glint_energy_put_curve(glint_numbers *numbers, const char *name,
                            const double albedo[GLINT_ENERGY_N_MAX])
{
    int count = 0, first = 0, last = 0, largest = 0;
    for (int i = 0; i < GLINT_ENERGY_N_MAX; i++) {
        if (albedo[i] > GLINT_ENERGY_ONE) {
            first = count++ == 0 ? i + 1 : first;
            last = i + 1;
        }
        largest = albedo[i] > albedo[largest] ? i : largest;
    }
    glint_number_put(numbers, count, "energy.%s.above", name);
    glint_number_put(numbers, count > 0 ? (double)first : NAN, "energy.%s.above.first", name);
    glint_number_put(numbers, count > 0 ? (double)last : NAN, "energy.%s.above.last", name);
    glint_number_put(numbers, albedo[largest], "energy.%s.largest", name);
    glint_number_put(numbers, largest + 1, "energy.%s.largest.n", name);
    for (int n = CLAIMED_LAST; n < CLAIMED_LAST + 4; n++)
        glint_number_put(numbers, albedo[n - 1], "energy.%s.at-%d", name, n);
    glint_number_put(numbers, albedo[GLINT_ENERGY_N_MAX - 1], "energy.%s.at-1000", name);
}

/* The largest relative difference of two curves, and where. */
static double apart_by(const double *curve, const double *other, int *n)
{
    double apart = 0.0;
    *n = 1;
    for (int i = 0; i < GLINT_ENERGY_N_MAX; i++) {
        const double difference = fabs(curve[i] / other[i] - 1.0);
        *n = difference > apart ? i + 1 : *n;
        apart = fmax(apart, difference);
    }
    return apart;
}

static void put_apart(glint_numbers *numbers, const char *name, const double *curve,
                      const double *other)
{
    int n;
    const double apart = apart_by(curve, other, &n);
    glint_number_put(numbers, apart, "energy.%s.apart", name);
    glint_number_put(numbers, n, "energy.%s.apart.n", name);
}

/* How many exponents have an albedo of 1 or more. */
static int full_count(const double *albedo)
{
    int count = 0;
    for (int i = 0; i < GLINT_ENERGY_N_MAX; i++)
        count += albedo[i] >= 1.0;
    return count;
}

/* How many cells of a table have a larger R than normal incidence, its first angle, has at the same
 * n. */
static int above_normal(const glint_energy_table *grid, int model)
{
    int count = 0;
    for (int n = 0; n < grid->plan.n_count; n++)
        for (int i = 1; i < grid->plan.angle_count; i++)
            count += glint_energy_at(grid, model, n, i)->quadrature >
                     glint_energy_at(grid, model, n, 0)->quadrature;
    return count;
}

/* The exponents that are above 1 up to CLAIMED_LAST, and only there, but for so many. */
static int otherwise_count(const double *albedo)
{
    int count = 0;
    for (int i = 0; i < GLINT_ENERGY_N_MAX; i++)
        count += (albedo[i] > GLINT_ENERGY_ONE) != (i < CLAIMED_LAST);
    return count;
}

static void put_curves(glint_numbers *numbers, const glint_energy_normal *normal)
{
    const struct {
        const char *name;
        const double *albedo;
    } curves[] = {{"w", normal->w},
                  {"with-limit", normal->with_limit},
                  {"held", normal->held},
                  {"claimed", normal->claimed},
                  {"blinn-with-factor", normal->blinn},
                  {"half-angle", normal->half_angle},
                  {"solid-angle", normal->solid_angle}};
    for (size_t i = 0; i < sizeof curves / sizeof curves[0]; i++)
        glint_energy_put_curve(numbers, curves[i].name, curves[i].albedo);
    put_apart(numbers, "half-angle", normal->half_angle, normal->w);
    put_apart(numbers, "solid-angle", normal->solid_angle, normal->held);
    put_apart(numbers, "with-limit", normal->with_limit, normal->w);
    put_apart(numbers, "device", normal->device, normal->w);
    glint_number_put(numbers, normal->centre[GLINT_ENERGY_N_MAX - 1], "energy.half-angle.centre");
    glint_number_put(numbers, otherwise_count(normal->w), "energy.w.otherwise");
    glint_number_put(numbers, full_count(normal->w), "energy.w.full");
    glint_number_put(numbers, full_count(normal->blinn), "energy.blinn-with-factor.full");
}

void glint_energy_put(glint_numbers *numbers, const glint_energy_results *results)
{
    const glint_energy_normal *normal = &results->normal;
    double zero[2] = {NAN, NAN}, asymmetry = 0.0;
    int in_front = 1;
    put_curves(numbers, normal);
    for (int i = 0; i < GLINT_ENERGY_N_MAX; i++)
        glint_number_widen(zero, normal->zero[i]);
    glint_number_put_range(numbers, zero[0], zero[1], "energy.zero");
    while (in_front < GLINT_ENERGY_N_MAX && glint_printed_limit(in_front) > acos(0.0))
        in_front++;
    glint_number_put(numbers, in_front, "energy.with-limit.in-front-from");
    for (int i = 0; i < GLINT_REFLECTANCE_COUNT; i++)
        asymmetry = fmax(asymmetry, results->asymmetry[i]);
    glint_number_put(numbers, ceil(1e4 * results->claimed.b) * 1e-4, "energy.smallest-b.up");
    glint_number_put(numbers, asymmetry, "energy.asymmetry");
    glint_number_put(numbers, GLINT_REFLECTANCE_COUNT, "energy.model-count");
    glint_number_put(numbers, above_normal(results->grid, GLINT_REFLECTANCE_COSINE_QUADRATIC),
                     "energy.w.above-normal");
    glint_number_put(numbers, above_normal(results->grid, GLINT_REFLECTANCE_ENERGY_CONSERVING),
                     "energy.claimed.above-normal");
}
