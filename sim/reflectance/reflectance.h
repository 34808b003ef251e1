/* The reflectance models of the thesis, and their references, behind one interface.
 *
 *     glint_reflectance schlick;
 *     const glint_reflectance_parameters glossy = {.n = 80};
 *     if (glint_reflectance_prepare(GLINT_REFLECTANCE_SCHLICK, &glossy, &schlick, &error) ==
 * GLINT_OK) w = glint_reflectance_of_cosine(&schlick, 0.99);
 *
 * There are three kinds of models. Lambert's is N·L. A *lobe* is a function of one cosine and n: of
 * N·H, or for Phong's of R·V. A *microfacet* model needs all the cosines of a glint_geometry.
 * Directions have unit length and point away from the surface: N the normal, L to the light, V to
 * the viewer, H = (L+V)/|L+V|, R = 2(L·N)N − L (2.10).
 *
 * Preparing computes whatever depends only on n (a coefficient, a search for the best width: at
 * most about a millisecond). The prepared value is plain data: it may be copied and used by any
 * number of threads.
 *
 * docs/models.md compares the models and explains how misprinted equations are interpreted. */
#ifndef GLINT_SIM_REFLECTANCE_REFLECTANCE_H
#define GLINT_SIM_REFLECTANCE_REFLECTANCE_H

#include <stdbool.h>
#include <stddef.h>

#include "glint_status.h"
#include "reflectance/vec3.h"

/* X(enumerator, definition, name): the name is used on command lines and in tables. */
#define GLINT_REFLECTANCE_MODELS(X)                                                                \
    X(LAMBERT, lambert, "lambert")                                                                 \
    X(PHONG, phong, "phong")                                                                       \
    X(BLINN, blinn, "blinn")                                                                       \
    X(BLINN_NORMALIZED, blinn_normalized, "blinn-normalized")                                      \
    X(TORRANCE_SPARROW, torrance_sparrow, "torrance-sparrow")                                      \
    X(COOK_TORRANCE, cook_torrance, "cook-torrance")                                               \
    X(SCHLICK, schlick, "schlick")                                                                 \
    X(SCHLICK_MODIFIED, schlick_modified, "schlick-modified")                                      \
    X(SCHLICK_MODIFIED_ANGLE, schlick_modified_angle, "schlick-modified-angle")                    \
    X(SCHLICK_MODIFIED_LINEAR, schlick_modified_linear, "schlick-modified-linear")                 \
    X(SCHLICK_MODIFIED_SQUARED, schlick_modified_squared, "schlick-modified-squared")              \
    X(SCHLICK_MODIFIED_POWER, schlick_modified_power, "schlick-modified-power")                    \
    X(QUADRATIC, quadratic, "quadratic")                                                           \
    X(COSINE_QUADRATIC, cosine_quadratic, "cosine-quadratic")                                      \
    X(ENERGY_CONSERVING, energy_conserving, "energy-conserving")                                   \
    X(LYON_2_MINIMAX, lyon_2_minimax, "lyon-2-minimax")                                            \
    X(LYON_4, lyon_4, "lyon-4")                                                                    \
    X(LYON_4_MINIMAX, lyon_4_minimax, "lyon-4-minimax")                                            \
    X(LYON_8, lyon_8, "lyon-8")                                                                    \
    X(LYON_8_MINIMAX, lyon_8_minimax, "lyon-8-minimax")                                            \
    X(LYON_16, lyon_16, "lyon-16")                                                                 \
    X(LYON_16_MINIMAX, lyon_16_minimax, "lyon-16-minimax")                                         \
    X(LOG2_N, log2_n, "log2-n")                                                                    \
    X(DEVICE, device, "device")

typedef enum glint_reflectance_model {
#define GLINT_REFLECTANCE_ENUMERATOR(id, definition, name) GLINT_REFLECTANCE_##id,
    GLINT_REFLECTANCE_MODELS(GLINT_REFLECTANCE_ENUMERATOR)
#undef GLINT_REFLECTANCE_ENUMERATOR
        GLINT_REFLECTANCE_COUNT
} glint_reflectance_model;

/* The argument of a model. */
typedef enum glint_reflectance_cosine {
    GLINT_REFLECTANCE_OF_NL,      /* N·L */
    GLINT_REFLECTANCE_OF_RV,      /* R·V, the thesis's cos α and cos λ */
    GLINT_REFLECTANCE_OF_NH,      /* N·H, the thesis's cos γ */
    GLINT_REFLECTANCE_OF_GEOMETRY /* a microfacet model: several cosines */
} glint_reflectance_cosine;

typedef struct glint_reflectance_info {
    const char *title;    /* "Schlick's" */
    const char *equation; /* "(1.5), (2.1)": numbers of the thesis; empty: not from it */
    const char *formula;  /* c: the cosine */
    const char *edges;    /* what happens at the ends of the domain */
    glint_reflectance_cosine cosine;
    double n_min, n_max; /* accepted exponents; the thesis's are 1…1000 */
    bool whole_n;        /* integers only */
} glint_reflectance_info;

/* NULL for an unknown number. */
const glint_reflectance_info *glint_reflectance_describe(glint_reflectance_model model);

/* glint_reflectance_names[GLINT_REFLECTANCE_BLINN] is "blinn"; the list ends with NULL. */
extern const char *const glint_reflectance_names[];

/* false when no model has the name; *model is then left alone. */
bool glint_reflectance_find(const char *name, glint_reflectance_model *model);

/* The largest exponent that any model accepts. */
#define GLINT_EXPONENT_MAX 1e6

/* The normal reflectance of glass and of most plastics, refractive index 1.5. */
#define GLINT_F0_DEFAULT 0.04

typedef struct glint_reflectance_parameters {
    double n;  /* exponent; microfacet models: roughness m = glint_roughness_of_exponent(n) */
    double f0; /* microfacet models: F at normal incidence, 0…1; 1 is a mirror at every angle */
} glint_reflectance_parameters;

/* The link of Beckmann's m to Blinn's n: m = √(2/(n+2)), with which both lobes have the same
 * curvature at their centre and, normalised, the same height. m: 0 < m ≤ 1, n ≥ 0. */
double glint_roughness_of_exponent(double n);
double glint_exponent_of_roughness(double m);

/* The constant of Torrance and Sparrow's D: 1 / ∫ e^(−α²/m²) cos α dω over the hemisphere. */
double glint_gaussian_facets(double m);

/* A model with everything that depends only on its parameters. The fields are private. */
typedef struct glint_reflectance {
    glint_reflectance_model model;
    double n;
    double (*of_cosine)(const struct glint_reflectance *prepared, double cosine); /* 0…1 */
    union {
        struct {
            double scale; /* of cosⁿ */
        } power;
        struct {
            int squarings;
        } log2_n;
        struct {
            double a; /* the exponent of Table 3.2 */
        } schlick;
        struct {
            double a; /* (2.8) */
        } quadratic;
        struct {
            double slope;  /* the width w over k; k = 2: σ */
            int squarings; /* log2 k */
            double scale;
        } lyon;
        struct {
            double m2;         /* m² */
            double facets;     /* the constant of D: ∫ D cos α dω = 1 */
            double refraction; /* index; infinite for f0 = 1 */
        } microfacet;
    };
} glint_reflectance;

/* GLINT_BAD_ARGUMENT, with err (may be NULL) filled, when a parameter is outside the model's
 * domain, and *prepared is left alone. */
glint_status glint_reflectance_prepare(glint_reflectance_model model,
                                       const glint_reflectance_parameters *parameters,
                                       glint_reflectance *prepared, glint_error *err);

/* The value at a cosine, which must be a number; outside 0…1 it is clamped. NaN for microfacet
 * models. */
static inline double glint_reflectance_of_cosine(const glint_reflectance *prepared, double cosine)
{
    const double above = cosine < 0.0 ? 0.0 : cosine;
    return prepared->of_cosine(prepared, above > 1.0 ? 1.0 : above);
}

/* The same for many cosines in single precision, which is faster. It differs from
 * glint_reflectance_of_cosine() by at most 1e-6 times the lobe's height (its value at 1), or 1e-6
 * if the height is below 1. This is not a relative bound: of energy-conserving with n = 1e5, whose
 * height is 4074, it is 0.004 everywhere. The arrays may not overlap. */
void glint_reflectance_batch(const glint_reflectance *prepared, const float *restrict cosine,
                             size_t count, float *restrict value);

/* One value with all checks: prepares, evaluates, discards. GLINT_BAD_ARGUMENT when n is outside
 * the model's domain, cosine is not in 0…1, or the model is a microfacet one. */
glint_status glint_reflectance_eval(glint_reflectance_model model, double n, double cosine,
                                    double *value, glint_error *err);

/* The cosines between the directions at a point. */
typedef struct glint_geometry {
    double nl, nv, nh, rv; /* N·L, N·V, N·H, R·V */
    double vh;             /* V·H = L·H */
} glint_geometry;

/* From three directions. GLINT_BAD_ARGUMENT when the length of one is not 1 to within 1e-6, or when
 * L = −V, where H is undefined. */
glint_status glint_geometry_of(glint_vec3 normal, glint_vec3 light, glint_vec3 viewer,
                               glint_geometry *geometry, glint_error *err);

/* The factor on the light's intensity, besides Kd or Ks: N·L in (1.2), the lobe in (1.6) and
 * (2.11), Rs in (1.4). 0 where N·L ≤ 0 or N·V ≤ 0. For Lambert's and the microfacet models it is
 * π·BRDF·(N·L), so that Lambert's white is 1. */
double glint_reflectance_intensity(const glint_reflectance *prepared,
                                   const glint_geometry *geometry);

/* The BRDF f_r of (2.20) to (2.22), per steradian: 1/π for Lambert's; the lobe itself for lobes, as
 * (2.23) has it; FDG / (4 (N·L)(N·V)) for microfacet models. Symmetric in L and V for every model.
 * 0 where N·L ≤ 0 or N·V ≤ 0. */
double glint_reflectance_brdf(const glint_reflectance *prepared, const glint_geometry *geometry);

/* Coefficient a of the quadratic (2.3) for one n ≥ 1, by (2.8) rewritten without cancellation. For
 * n = 1, where (2.4) divides by zero, its limit 0, with which the quadratic is c itself. */
double glint_quadratic_a(double n);

/* The slope w/k of (1 + (w/k)(c−1))^k, zero where the base is negative; k is 2, 4, 8 or 16.
 * Equal integral, from the zero to 1: (n+1)/(k+1); σ for k = 2. Minimax: the largest difference
 * from cⁿ over 0…1 is as small as it can be. */
double glint_lyon_slope_equal(int k, double n);
double glint_lyon_slope_minimax(int k, double n);

/* Where the epicentre of a highlight ends: cosⁿ = 0.6 (section 2.1). */
#define GLINT_EPICENTRE_LEVEL 0.6

/* The exponent a of Table 3.2, which does not state it: the one that minimises the largest relative
 * error in the epicentre. n ≥ 1. */
double glint_schlick_power_a(double n);

#endif
