/* Schlick's rational lobe (1.5), (2.1), and the readings of its modification (2.2), Table 3.2.
 *
 * All are c / (c + d + extra) with d = n(1−c); what (2.2) adds is misprinted or misplaced, and the
 * readings differ in it. docs/models.md says what each comes to. */
#include <math.h>

#include "multiversion.h"
#include "reflectance/definition.h"
#include "reflectance/search.h"

/* ---- Formulas -------------------------------------------------------------------------------- */

static double schlick(const glint_reflectance *prepared, double c)
{
    return c / (c + prepared->n * (1.0 - c));
}

/* 0.5 n(1 − c²) = 0.5 d (1+c) */
static double modified(const glint_reflectance *prepared, double c)
{
    const double d = prepared->n * (1.0 - c);
    return c / (c + d + 0.5 * d * (1.0 + c));
}

/* 0.5 n(1 − cos(γ²)) = n sin²(γ²/2) */
static double modified_angle(const glint_reflectance *prepared, double c)
{
    const double angle = acos(c);
    const double sine = sin(0.5 * angle * angle);
    return c / (c + prepared->n * (1.0 - c + sine * sine));
}

/* 0.5 n(1 − c)² */
static double modified_linear(const glint_reflectance *prepared, double c)
{
    const double d = prepared->n * (1.0 - c);
    return c / (c + d + 0.5 * d * (1.0 - c));
}

/* 0.5 (n(1 − c))² */
static double modified_squared(const glint_reflectance *prepared, double c)
{
    const double d = prepared->n * (1.0 - c);
    return c / (c + d + 0.5 * d * d);
}

static double modified_power(const glint_reflectance *prepared, double c)
{
    return pow(c, prepared->schlick.a) / (c + prepared->n * (1.0 - c));
}

/* ---- The same in single precision, for many cosines ------------------------------------------ */

#define BATCH(NAME, EXTRA)                                                                         \
    GLINT_MULTIVERSION                                                                             \
    static void NAME(const glint_reflectance *prepared, const float *restrict cosine,              \
                     size_t count, float *restrict value)                                          \
    {                                                                                              \
        const float n = (float)prepared->n;                                                        \
        for (size_t i = 0; i < count; i++) {                                                       \
            const float c = glint_held_cosine(cosine[i]);                                          \
            const float d = n * (1.0f - c);                                                        \
            value[i] = c / (c + d + (EXTRA));                                                      \
        }                                                                                          \
    }
BATCH(batch_schlick, 0.0f)
BATCH(batch_modified, 0.5f * d * (1.0f + c))
BATCH(batch_linear, 0.5f * d * (1.0f - c))
BATCH(batch_squared, 0.5f * d * d)
#undef BATCH

/* ---- The exponent of Table 3.2 --------------------------------------------------------------- */

typedef struct power_error {
    double n, a;
    double sign; /* 1: where the model is too large, −1: where it is too small */
} power_error;

/* Relative error at c = 1 − u. */
static double error_at(const void *context, double u)
{
    const power_error *e = context;
    const double ratio = (e->a - e->n) * log1p(-u) - log1p((e->n - 1.0) * u);
    return e->sign * expm1(ratio);
}

#define SAMPLES 64

/* The largest error upwards less the largest one downwards: falls as a grows, as c^a does. */
static double excess(const void *context, double a)
{
    const double n = *(const double *)context;
    const double end = -expm1(log(GLINT_EPICENTRE_LEVEL) / n);
    const power_error above = {n, a, 1.0}, below = {n, a, -1.0};
    return glint_search_maximum(error_at, &above, 0.0, end, SAMPLES, NULL) -
           glint_search_maximum(error_at, &below, 0.0, end, SAMPLES, NULL);
}

double glint_schlick_power_a(double n)
{
    /* c/(c + d) itself is Schlick's and nowhere too small; with a = n the model is too small. */
    return n > 1.0 ? glint_search_zero(excess, &n, 1.0, n) : 1.0;
}

/* ---- Definitions ----------------------------------------------------------------------------- */

#define PREPARE(NAME, FORMULA)                                                                     \
    static void NAME(const glint_reflectance_parameters *parameters, glint_reflectance *prepared)  \
    {                                                                                              \
        (void)parameters;                                                                          \
        prepared->of_cosine = FORMULA;                                                             \
    }
PREPARE(prepare_schlick, schlick)
PREPARE(prepare_modified, modified)
PREPARE(prepare_angle, modified_angle)
PREPARE(prepare_linear, modified_linear)
PREPARE(prepare_squared, modified_squared)
#undef PREPARE

static void prepare_power(const glint_reflectance_parameters *parameters,
                          glint_reflectance *prepared)
{
    prepared->of_cosine = modified_power;
    prepared->schlick.a = glint_schlick_power_a(parameters->n);
}

#define SCHLICK(TITLE, EQUATION, FORMULA, EDGES)                                                   \
    {                                                                                              \
        .title = TITLE, .equation = EQUATION, .formula = FORMULA, .edges = EDGES,                  \
        .cosine = GLINT_REFLECTANCE_OF_NH, .n_min = 1, .n_max = GLINT_EXPONENT_MAX                 \
    }

const glint_reflectance_definition glint_reflectance_schlick = {
    .info = SCHLICK("Schlick's", "(1.5), (2.1)", "c/(n − nc + c)",
                    "n = 1: c itself; zero only at c = 0"),
    .prepare = prepare_schlick,
    .batch = batch_schlick,
};

const glint_reflectance_definition glint_reflectance_schlick_modified = {
    .info = SCHLICK("Schlick's modified, as printed: cos γ² is (cos γ)²", "(2.2)",
                    "c/(0.5n(1 − c²) + n − nc + c)", "n = 1: not c; zero only at c = 0"),
    .prepare = prepare_modified,
    .batch = batch_modified,
};

const glint_reflectance_definition glint_reflectance_schlick_modified_angle = {
    .info = SCHLICK("Schlick's modified, cos γ² is cos(γ²)", "(2.2)",
                    "c/(0.5n(1 − cos(γ²)) + n − nc + c)", "n = 1: not c; zero only at c = 0"),
    .prepare = prepare_angle,
};

const glint_reflectance_definition glint_reflectance_schlick_modified_linear = {
    .info = SCHLICK("Schlick's modified, the square on the parenthesis", "(2.2)",
                    "c/(0.5n(1 − c)² + n − nc + c)", "n = 1: not c; zero only at c = 0"),
    .prepare = prepare_linear,
    .batch = batch_linear,
};

const glint_reflectance_definition glint_reflectance_schlick_modified_squared = {
    .info = SCHLICK("Schlick's modified, the square on n too", "(2.2)",
                    "c/(0.5(n(1 − c))² + n − nc + c)", "n = 1: not c; zero only at c = 0"),
    .prepare = prepare_squared,
    .batch = batch_squared,
};

const glint_reflectance_definition glint_reflectance_schlick_modified_power = {
    .info = SCHLICK("Schlick's modified, a power, with the best a", "Table 3.2", "c^a/(n − nc + c)",
                    "n = 1: a = 1, c itself; zero only at c = 0"),
    .prepare = prepare_power,
};
