/* The loops whose speed is measured compute what they are named after. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "bench/bench.h"
#include "reflectance/reflectance.h"

enum { COUNT = 1003 }; /* no multiple of any vector's length */

static const glint_reflectance_model models[GLINT_FORMULA_COUNT] = {
    [GLINT_FORMULA_POWER] = GLINT_REFLECTANCE_BLINN,
    [GLINT_FORMULA_SCHLICK] = GLINT_REFLECTANCE_SCHLICK,
    [GLINT_FORMULA_SCHLICK_MODIFIED] = GLINT_REFLECTANCE_SCHLICK_MODIFIED,
    [GLINT_FORMULA_QUADRATIC] = GLINT_REFLECTANCE_QUADRATIC,
    [GLINT_FORMULA_COSINE_QUADRATIC] = GLINT_REFLECTANCE_COSINE_QUADRATIC,
    [GLINT_FORMULA_LYON_4] = GLINT_REFLECTANCE_LYON_4,
};

static void check_loop(glint_formula formula, int n, glint_formula_loop *loop, const char *kind)
{
    static float cosine[COUNT], result[COUNT + 1];
    const glint_formula_constants constants = glint_formula_prepare(formula, n);
    for (int i = 0; i < COUNT; i++)
        cosine[i] = (float)i / (COUNT - 1);
    result[COUNT] = -1.0f;
    loop(&constants, cosine, COUNT, result);
    assert_true(result[COUNT] == -1.0f);
    for (int i = 0; i < COUNT; i++) {
        double exact;
        assert_int_equal(
            glint_reflectance_eval(models[formula], n, (double)cosine[i], &exact, NULL), GLINT_OK);
        /* The slope n multiplies the rounding of 1 − c. */
        if (!(fabs((double)result[i] - exact) <= 4e-7 * (n + 8)))
            fail_msg("%s, %s, n = %d, cosine %g: %g, not %g", glint_formula_names[formula], kind, n,
                     (double)cosine[i], (double)result[i], exact);
    }
}

static void loops_compute_their_models(void **state)
{
    (void)state;
    static const int exponents[] = {1, 2, 7, 60, 1000};
    for (int i = 0; i < GLINT_FORMULA_COUNT; i++) {
        const glint_formula formula = (glint_formula)i;
        for (size_t j = 0; j < sizeof exponents / sizeof exponents[0]; j++) {
            check_loop(formula, exponents[j], glint_formula_scalar(formula), "scalar");
            check_loop(formula, exponents[j], glint_formula_vectorised(formula), "vectorised");
        }
    }
}

static void rates_are_of_one_run(void **state)
{
    (void)state;
    glint_bench_formula_rates rates;
    assert_int_equal(glint_bench_formulas(0.01, NULL, &rates, NULL), GLINT_OK);
    for (int i = 0; i < GLINT_FORMULA_COUNT; i++)
        assert_true(rates.scalar[i] > 0.0 && rates.vectorised[i] > 0.0);
    assert_true(rates.scalar_to_schlick[GLINT_FORMULA_SCHLICK] == 1.0);
    assert_true(rates.vectorised_to_schlick[GLINT_FORMULA_SCHLICK] == 1.0);
}

static void it_can_be_interrupted(void **state)
{
    (void)state;
    static const volatile bool stop = true;
    glint_bench_formula_rates rates;
    glint_error err;
    assert_int_equal(glint_bench_formulas(60.0, &stop, &rates, &err), GLINT_INTERRUPTED);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(loops_compute_their_models),
        cmocka_unit_test(rates_are_of_one_run),
        cmocka_unit_test(it_can_be_interrupted),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
