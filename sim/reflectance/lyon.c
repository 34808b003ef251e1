/* (1 − x/k)^k with x = w(1−c), zero where the base is negative: R. Lyon's family (Phong shading
 * reformulation for hardware renderer simplification, Apple TR 43, 1993). The thesis's
 * cosine-quadratic (2.15) is its member k = 2 with the width w of equal integral, and (2.26) is
 * that times a factor. */
#include <math.h>

#include "multiversion.h"
#include "reflectance/definition.h"
#include "reflectance/search.h"

/* The factor of (2.26), (n + A)/B. */
#define ENERGY_A 6.0
#define ENERGY_B 24.55

static int squarings_of(int k)
{
    return k <= 1 ? 0 : 1 + squarings_of(k / 2);
}

static double lyon(const glint_reflectance *prepared, double c)
{
    const double line = prepared->lyon.slope * (c - 1.0) + 1.0;
    double value = line > 0.0 ? line : 0.0;
    for (int i = 0; i < prepared->lyon.squarings; i++)
        value *= value;
    return prepared->lyon.scale * value;
}

GLINT_MULTIVERSION
static void batch_lyon(const glint_reflectance *prepared, const float *restrict cosine,
                       size_t count, float *restrict value)
{
    const float slope = (float)prepared->lyon.slope;
    const float scale = (float)prepared->lyon.scale;
    for (size_t i = 0; i < count; i++) {
        const float line = slope * (glint_held_cosine(cosine[i]) - 1.0f) + 1.0f;
        value[i] = line > 0.0f ? line : 0.0f;
    }
    for (int s = 0; s < prepared->lyon.squarings; s++)
        for (size_t i = 0; i < count; i++)
            value[i] *= value[i];
    for (size_t i = 0; i < count; i++)
        value[i] *= scale;
}

/* ---- Widths ---------------------------------------------------------------------------------- */

double glint_lyon_slope_equal(int k, double n)
{
    return (n + 1.0) / (k + 1.0);
}

typedef struct lyon_error {
    glint_reflectance lobe;
    double n;
    double sign; /* 1: where the lobe is above cosⁿ, −1: where it is below */
} lyon_error;

static double error_at(const void *context, double u)
{
    const lyon_error *e = context;
    return e->sign * (lyon(&e->lobe, 1.0 - u) - exp(e->n * log1p(-u)));
}

typedef struct lyon_search {
    int k;
    double n;
} lyon_search;

/* Beyond u = FAR/n both are next to nothing for any width of interest: e^-FAR. */
#define FAR     40.0
#define SAMPLES 160

static double largest_error(const lyon_search *search, double slope, double sign)
{
    lyon_error e = {.n = search->n, .sign = sign};
    e.lobe.lyon.slope = slope;
    e.lobe.lyon.squarings = squarings_of(search->k);
    e.lobe.lyon.scale = 1.0;
    const double end = search->n > FAR ? FAR / search->n : 1.0;
    return glint_search_maximum(error_at, &e, 0.0, end, SAMPLES, NULL);
}

/* At each cosine the lobe falls as the slope grows, so the largest error upwards falls and the one
 * downwards rises: where they are equal the larger of them is the smallest. */
static double excess(const void *context, double slope)
{
    const lyon_search *search = context;
    return largest_error(search, slope, 1.0) - largest_error(search, slope, -1.0);
}

double glint_lyon_slope_minimax(int k, double n)
{
    const lyon_search search = {k, n};
    return glint_search_zero(excess, &search, 0.0, n + 1.0);
}

/* ---- Definitions ----------------------------------------------------------------------------- */

static void prepare_lyon(int k, double slope, double scale, glint_reflectance *prepared)
{
    prepared->of_cosine = lyon;
    prepared->lyon.slope = slope;
    prepared->lyon.squarings = squarings_of(k);
    prepared->lyon.scale = scale;
}

static void prepare_energy(const glint_reflectance_parameters *parameters,
                           glint_reflectance *prepared)
{
    prepare_lyon(2, glint_lyon_slope_equal(2, parameters->n), (parameters->n + ENERGY_A) / ENERGY_B,
                 prepared);
}

#define PREPARE(K)                                                                                 \
    static void prepare_##K##_equal(const glint_reflectance_parameters *parameters,                \
                                    glint_reflectance *prepared)                                   \
    {                                                                                              \
        prepare_lyon(K, glint_lyon_slope_equal(K, parameters->n), 1.0, prepared);                  \
    }                                                                                              \
    static void prepare_##K##_minimax(const glint_reflectance_parameters *parameters,              \
                                      glint_reflectance *prepared)                                 \
    {                                                                                              \
        prepare_lyon(K, glint_lyon_slope_minimax(K, parameters->n), 1.0, prepared);                \
    }
PREPARE(2)
PREPARE(4)
PREPARE(8)
PREPARE(16)
#undef PREPARE

#define EDGES_EQUAL "n < k: not yet zero at c = 0; zero below c = 1 − k/w"

#define LYON(DEFINITION, K, WHICH, EDGES)                                                          \
    const glint_reflectance_definition glint_reflectance_##DEFINITION = {                          \
        .info = {.title = "Lyon's, k = " #K ", " #WHICH " width",                                  \
                 .equation = "",                                                                   \
                 .formula = "(w/" #K " (c−1) + 1)^" #K,                                            \
                 .edges = EDGES,                                                                   \
                 .cosine = GLINT_REFLECTANCE_OF_NH,                                                \
                 .n_max = GLINT_EXPONENT_MAX},                                                     \
        .prepare = prepare_##K##_##WHICH,                                                          \
        .batch = batch_lyon,                                                                       \
    };
LYON(lyon_2_minimax, 2, minimax, "n = 0: 1 everywhere; zero below c = 1 − k/w")
LYON(lyon_4, 4, equal, EDGES_EQUAL)
LYON(lyon_4_minimax, 4, minimax, "n = 0: 1 everywhere; zero below c = 1 − k/w")
LYON(lyon_8, 8, equal, EDGES_EQUAL)
LYON(lyon_8_minimax, 8, minimax, "n = 0: 1 everywhere; zero below c = 1 − k/w")
LYON(lyon_16, 16, equal, EDGES_EQUAL)
LYON(lyon_16_minimax, 16, minimax, "n = 0: 1 everywhere; zero below c = 1 − k/w")

const glint_reflectance_definition glint_reflectance_cosine_quadratic = {
    .info = {.title = "the cosine-quadratic (Lyon's, k = 2, equal width)",
             .equation = "(2.15)",
             .formula = "((n+1)/3 (c−1) + 1)²",
             .edges = "n = 1: 1/9 at c = 0; n = 2: c² itself; n > 2: zero below c = (n−2)/(n+1), "
                      "where the parabola would rise again",
             .cosine = GLINT_REFLECTANCE_OF_NH,
             .n_max = GLINT_EXPONENT_MAX},
    .prepare = prepare_2_equal,
    .batch = batch_lyon,
};

const glint_reflectance_definition glint_reflectance_energy_conserving = {
    .info = {.title = "the cosine-quadratic, normalised",
             .equation = "(2.26)",
             .formula = "(n+6)/24.55 ((n+1)/3 (c−1) + 1)²",
             .edges = "as cosine-quadratic; above 1 at the centre from n = 19 on",
             .cosine = GLINT_REFLECTANCE_OF_NH,
             .n_max = GLINT_EXPONENT_MAX},
    .prepare = prepare_energy,
    .batch = batch_lyon,
};
