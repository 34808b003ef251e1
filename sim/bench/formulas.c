/* Each formula is written once, in the list in formulas.h, and expands to its two loops here. Only
 * this file is compiled with -ffast-math: without it gcc calls powf one point at a time. */
#include "bench/formulas.h"

#include <math.h>

#include "multiversion.h"
#include "reflectance/reflectance.h"

static inline float glint_above_zero(float x)
{
    return x > 0.0f ? x : 0.0f;
}

static inline float glint_squared(float x)
{
    return x * x;
}

const char *const glint_formula_names[GLINT_FORMULA_COUNT] = {
#define NAME(id, name, value) name,
    GLINT_FORMULAS(NAME)
#undef NAME
};

glint_formula_constants glint_formula_prepare(glint_formula formula, int n)
{
    glint_formula_constants constants = {.n = (float)n};
    if (formula == GLINT_FORMULA_QUADRATIC) {
        const double a = glint_quadratic_a(n);
        constants.p = (float)a;
        constants.q = (float)(1.0 - a);
    } else if (formula == GLINT_FORMULA_COSINE_QUADRATIC) {
        constants.p = (float)glint_lyon_slope_equal(2, n);
    } else if (formula == GLINT_FORMULA_LYON_4) {
        constants.p = (float)glint_lyon_slope_equal(4, n);
    }
    return constants;
}

/* The empty assembly keeps the compiler from joining a point with its neighbours. */
#define LOOPS(id, name, value)                                                                     \
    static void scalar_##id(const glint_formula_constants *constants,                              \
                            const float *restrict cosine, size_t count, float *restrict result)    \
    {                                                                                              \
        const float n = constants->n, p = constants->p, q = constants->q;                          \
        for (size_t i = 0; i < count; i++) {                                                       \
            const float c = cosine[i];                                                             \
            (void)n, (void)p, (void)q;                                                             \
            result[i] = value;                                                                     \
            __asm__ volatile("" ::: "memory");                                                     \
        }                                                                                          \
    }                                                                                              \
    GLINT_MULTIVERSION                                                                             \
    static void vectorised_##id(const glint_formula_constants *constants,                          \
                                const float *restrict cosine, size_t count,                        \
                                float *restrict result)                                            \
    {                                                                                              \
        const float n = constants->n, p = constants->p, q = constants->q;                          \
        for (size_t i = 0; i < count; i++) {                                                       \
            const float c = cosine[i];                                                             \
            (void)n, (void)p, (void)q;                                                             \
            result[i] = value;                                                                     \
        }                                                                                          \
    }
GLINT_FORMULAS(LOOPS)
#undef LOOPS

static glint_formula_loop *const scalar[] = {
#define LOOP(id, name, value) scalar_##id,
    GLINT_FORMULAS(LOOP)
#undef LOOP
};

static glint_formula_loop *const vectorised[] = {
#define LOOP(id, name, value) vectorised_##id,
    GLINT_FORMULAS(LOOP)
#undef LOOP
};

glint_formula_loop *glint_formula_scalar(glint_formula formula)
{
    return scalar[formula];
}

glint_formula_loop *glint_formula_vectorised(glint_formula formula)
{
    return vectorised[formula];
}

#ifdef __clang__
#define COMPILER "clang " __clang_version__
#else
#define COMPILER "gcc " __VERSION__
#endif

const char *glint_formula_compiler(void)
{
    return COMPILER;
}

const char *glint_formula_flags(void)
{
    static const char *const flags[] = {COMPILER " -O3 -ffast-math, baseline vector instructions",
                                        COMPILER " -O3 -ffast-math, AVX2",
                                        COMPILER " -O3 -ffast-math, AVX-512"};
#if defined(__x86_64__) && !defined(GLINT_SANITIZED)
    __builtin_cpu_init();
    return flags[__builtin_cpu_supports("avx512bw") ? 2 : __builtin_cpu_supports("avx2") ? 1 : 0];
#else
    return flags[0];
#endif
}
