/* The formulas that approximate cosⁿ, in single precision, each as two loops: point by point, and
 * as vectorised by the compiler. For measuring speed only; the models are in sim/reflectance. */
#ifndef GLINT_SIM_BENCH_FORMULAS_H
#define GLINT_SIM_BENCH_FORMULAS_H

#include <stddef.h>

/* X(enumerator, name, what is computed from the cosine c) */
#define GLINT_FORMULAS(X)                                                                          \
    X(POWER, "cos^n", powf(c, n))                                                                  \
    X(SCHLICK, "schlick", c / (n - n * c + c))                                                     \
    X(SCHLICK_MODIFIED, "schlick-modified", c / (0.5f * n * (1.0f - c * c) + n - n * c + c))       \
    X(QUADRATIC, "quadratic", glint_above_zero((p * c + q) * c))                                   \
    X(COSINE_QUADRATIC, "cosine-quadratic", glint_squared(glint_above_zero(p *(c - 1.0f) + 1.0f))) \
    X(LYON_4, "lyon-4", glint_squared(glint_squared(glint_above_zero(p *(c - 1.0f) + 1.0f))))

typedef enum glint_formula {
#define GLINT_FORMULA_ENUMERATOR(id, name, value) GLINT_FORMULA_##id,
    GLINT_FORMULAS(GLINT_FORMULA_ENUMERATOR)
#undef GLINT_FORMULA_ENUMERATOR
        GLINT_FORMULA_COUNT
} glint_formula;

extern const char *const glint_formula_names[GLINT_FORMULA_COUNT];

/* What depends on n alone: a and 1 − a of the quadratic, the slope of the others. */
typedef struct glint_formula_constants {
    float n, p, q;
} glint_formula_constants;

glint_formula_constants glint_formula_prepare(glint_formula formula, int n);

/* result[i] of cosine[i], 0…1. */
typedef void glint_formula_loop(const glint_formula_constants *constants,
                                const float *restrict cosine, size_t count, float *restrict result);

glint_formula_loop *glint_formula_scalar(glint_formula formula);

/* cosⁿ is vectorised by the C library's own vector powf (libmvec). */
glint_formula_loop *glint_formula_vectorised(glint_formula formula);

/* The compiler, with its version. */
const char *glint_formula_compiler(void);

/* How the loops were compiled: compiler, options, and the vector width that runs. */
const char *glint_formula_flags(void);

#endif
