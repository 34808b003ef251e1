/* The quadratic in the cosine (2.3): ac² + (1−a)c, through cosⁿ at its inflection. */
#include <math.h>

#include "multiversion.h"
#include "reflectance/definition.h"

double glint_quadratic_a(double n)
{
    if (n <= 1.0)
        return 0.0;
    /* t = cos arctg 1/√(n−1) = √((n−1)/n) (2.4), a = (t^(n−1) − 1)/(t − 1) (2.7), where
     * 1 − t = (1/n)/(1 + t) and t^(n−1) − 1 = expm1(…). */
    const double t = sqrt((n - 1.0) / n);
    return -expm1(0.5 * (n - 1.0) * log1p(-1.0 / n)) * n * (1.0 + t);
}

/* ac² + (1−a)c = c(1 − a(1−c)): negative below c = (a−1)/a. */
static double quadratic(const glint_reflectance *prepared, double c)
{
    const double line = 1.0 - prepared->quadratic.a * (1.0 - c);
    return line > 0.0 ? c * line : 0.0;
}

static void prepare_quadratic(const glint_reflectance_parameters *parameters,
                              glint_reflectance *prepared)
{
    prepared->of_cosine = quadratic;
    prepared->quadratic.a = glint_quadratic_a(parameters->n);
}

GLINT_MULTIVERSION
static void batch_quadratic(const glint_reflectance *prepared, const float *restrict cosine,
                            size_t count, float *restrict value)
{
    const float a = (float)prepared->quadratic.a;
    for (size_t i = 0; i < count; i++) {
        const float c = glint_held_cosine(cosine[i]);
        const float line = 1.0f - a * (1.0f - c);
        value[i] = line > 0.0f ? c * line : 0.0f;
    }
}

const glint_reflectance_definition glint_reflectance_quadratic = {
    .info = {.title = "the quadratic",
             .equation = "(2.3) to (2.8)",
             .formula = "ac² + (1−a)c",
             .edges =
                 "n = 1: (2.4) divides by zero, the limit is a = 0, c itself; n = 2: c² itself; "
                 "zero below c = (a−1)/a, where the polynomial is negative",
             .cosine = GLINT_REFLECTANCE_OF_NH,
             .n_min = 1,
             .n_max = GLINT_EXPONENT_MAX},
    .prepare = prepare_quadratic,
    .batch = batch_quadratic,
};
