/* Lambert's cosine, and Phong's and Blinn's powers of one. */
#include <math.h>

#include "reflectance/definition.h"

#define PI 3.14159265358979323846

static double cosine_itself(const glint_reflectance *prepared, double cosine)
{
    (void)prepared;
    return cosine;
}

static void prepare_lambert(const glint_reflectance_parameters *parameters,
                            glint_reflectance *prepared)
{
    (void)parameters;
    prepared->of_cosine = cosine_itself;
}

static double lambert_brdf(const glint_reflectance *prepared, const glint_geometry *geometry)
{
    (void)prepared;
    (void)geometry;
    return 1.0 / PI;
}

static double power(const glint_reflectance *prepared, double cosine)
{
    return prepared->power.scale * pow(cosine, prepared->n);
}

static void prepare_power(const glint_reflectance_parameters *parameters,
                          glint_reflectance *prepared)
{
    (void)parameters;
    prepared->of_cosine = power;
    prepared->power.scale = 1.0;
}

static void prepare_normalized(const glint_reflectance_parameters *parameters,
                               glint_reflectance *prepared)
{
    prepared->of_cosine = power;
    prepared->power.scale = (parameters->n + 6.0) / (8.0 * PI);
}

static void batch_power(const glint_reflectance *prepared, const float *restrict cosine,
                        size_t count, float *restrict value)
{
    const float n = (float)prepared->n;
    const float scale = (float)prepared->power.scale;
    for (size_t i = 0; i < count; i++)
        value[i] = scale * powf(glint_held_cosine(cosine[i]), n);
}

const glint_reflectance_definition glint_reflectance_lambert = {
    .info = {.title = "Lambert's",
             .equation = "(1.2)",
             .formula = "c",
             .edges = "n is not used",
             .cosine = GLINT_REFLECTANCE_OF_NL,
             .n_max = GLINT_EXPONENT_MAX},
    .prepare = prepare_lambert,
    .brdf = lambert_brdf,
};

const glint_reflectance_definition glint_reflectance_phong = {
    .info = {.title = "Phong's",
             .equation = "(1.6), (2.9), (2.10)",
             .formula = "c^n",
             .edges = "n = 0: 1 everywhere; R·V below 0 counts as 0",
             .cosine = GLINT_REFLECTANCE_OF_RV,
             .n_max = GLINT_EXPONENT_MAX},
    .prepare = prepare_power,
    .batch = batch_power,
};

const glint_reflectance_definition glint_reflectance_blinn = {
    .info = {.title = "Blinn's",
             .equation = "(2.11)",
             .formula = "c^n",
             .edges = "n = 0: 1 everywhere",
             .cosine = GLINT_REFLECTANCE_OF_NH,
             .n_max = GLINT_EXPONENT_MAX},
    .prepare = prepare_power,
    .batch = batch_power,
};

const glint_reflectance_definition glint_reflectance_blinn_normalized = {
    .info = {.title = "Blinn's, normalised",
             .equation = "figure 2.16",
             .formula = "(n+6)/(8π) c^n",
             .edges = "n = 0: 3/(4π) everywhere; above 1 at the centre from n = 20 on",
             .cosine = GLINT_REFLECTANCE_OF_NH,
             .n_max = GLINT_EXPONENT_MAX},
    .prepare = prepare_normalized,
    .batch = batch_power,
};
