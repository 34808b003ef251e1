/* The rules of the verdicts, and what of many measurements counts. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "report/quantile.h"
#include "report/verdict.h"

static glint_verdict of(glint_rule rule, double stated, int decimals, double measured)
{
    return glint_judge(&(glint_judged){rule, stated, decimals, measured, measured, false});
}

static bool holds(glint_rule rule, double stated, int decimals, double measured)
{
    const glint_verdict verdict = of(rule, stated, decimals, measured);
    assert_true(verdict == GLINT_HOLDS || verdict == GLINT_DOES_NOT_HOLD);
    return verdict == GLINT_HOLDS;
}

static void a_plain_number_holds_when_the_measured_one_rounds_to_it(void **state)
{
    (void)state;
    const glint_rule rule = GLINT_ROUNDS_TO;
    assert_true(holds(rule, 1.7, 1, 1.65) && holds(rule, 1.7, 1, 1.7499));
    assert_false(holds(rule, 1.7, 1, 1.649) || holds(rule, 1.7, 1, 1.7501));
    assert_true(holds(rule, 10.0, 0, 10.31));
    assert_false(holds(rule, 10.0, 0, 10.51) || holds(rule, 10.0, 0, 5.0));
    assert_true(holds(rule, 0.4427, 4, 0.44270833) && !holds(rule, 0.5693, 4, 0.56919643));
}

static void a_gain_holds_from_what_rounds_to_it_on(void **state)
{
    (void)state;
    const glint_rule rule = GLINT_REACHES;
    assert_true(holds(rule, 1.7, 1, 1.65) && holds(rule, 1.7, 1, 1.79));
    assert_true(holds(rule, 20.0, 0, 25.0) && holds(rule, 20.0, 0, 19.5));
    assert_false(holds(rule, 1.7, 1, 1.649) || holds(rule, 20.0, 0, 19.49));
}

static void a_limit_is_the_number_itself(void **state)
{
    (void)state;
    assert_true(holds(GLINT_AT_MOST, 3.2, 1, 3.2) && !holds(GLINT_AT_MOST, 3.2, 1, 3.2000001));
    assert_true(holds(GLINT_BELOW, 3.2, 1, 3.1999999) && !holds(GLINT_BELOW, 3.2, 1, 3.2));
    assert_true(holds(GLINT_AT_LEAST, 3.2, 1, 3.2) && !holds(GLINT_AT_LEAST, 3.2, 1, 3.1999999));
    assert_true(holds(GLINT_ABOVE, 3.2, 1, 3.2000001) && !holds(GLINT_ABOVE, 3.2, 1, 3.2));
}

static void what_lies_on_both_sides_cannot_be_decided(void **state)
{
    (void)state;
    static const struct {
        glint_judged judged;
        glint_verdict verdict;
    } cases[] = {
        {{GLINT_REACHES, 1.7, 1, 1.65, 2.0, false}, GLINT_HOLDS},
        {{GLINT_REACHES, 1.7, 1, 1.0, 1.649, false}, GLINT_DOES_NOT_HOLD},
        {{GLINT_REACHES, 1.7, 1, 1.52, 1.79, false}, GLINT_CANNOT_BE_DECIDED},
        {{GLINT_AT_MOST, 0.4, 1, 0.3, 10.0, false}, GLINT_CANNOT_BE_DECIDED},
        {{GLINT_AT_MOST, 0.4, 1, 0.5, 10.0, false}, GLINT_DOES_NOT_HOLD},
        {{GLINT_ROUNDS_TO, 1.0, 1, 0.5, 2.0, false}, GLINT_CANNOT_BE_DECIDED},
        {{GLINT_ROUNDS_TO, 1.0, 1, 1.5, 2.0, false}, GLINT_DOES_NOT_HOLD},
        {{GLINT_ROUNDS_TO, 1.0, 1, 0.98, 1.02, false}, GLINT_HOLDS},
        {{GLINT_ROUNDS_TO, 1.0, 1, NAN, NAN, false}, GLINT_CANNOT_BE_DECIDED},
        {{GLINT_AT_MOST, 1.0, 1, NAN, 0.5, false}, GLINT_CANNOT_BE_DECIDED},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++)
        assert_int_equal(glint_judge(&cases[i].judged), cases[i].verdict);
}

static void a_circle_contradicts_and_does_not_prove(void **state)
{
    (void)state;
    glint_judged judged = {GLINT_ROUNDS_TO, 2946.0, 0, 2946.0, 2946.0, true};
    assert_int_equal(glint_judge(&judged), GLINT_CANNOT_BE_DECIDED);
    judged.lowest = judged.highest = 2947.0;
    assert_int_equal(glint_judge(&judged), GLINT_DOES_NOT_HOLD);
}

static void quantiles_lie_between_the_sorted_values(void **state)
{
    (void)state;
    double five[] = {50.0, 10.0, 30.0, 20.0, 40.0}, four[] = {4.0, 1.0, 2.0, 3.0}, one[] = {7.0};
    assert_true(glint_quantile(five, 5, 0.5) == 30.0 && glint_quantile(five, 5, 0.25) == 20.0);
    assert_true(glint_quantile(five, 5, 0.0) == 10.0 && glint_quantile(five, 5, 1.0) == 50.0);
    assert_true(glint_quantile(four, 4, 0.5) == 2.5 && glint_quantile(four, 4, 0.25) == 1.75);
    assert_true(glint_quantile(one, 1, 0.25) == 7.0 && glint_quantile(one, 1, 1.0) == 7.0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_plain_number_holds_when_the_measured_one_rounds_to_it),
        cmocka_unit_test(a_gain_holds_from_what_rounds_to_it_on),
        cmocka_unit_test(a_limit_is_the_number_itself),
        cmocka_unit_test(what_lies_on_both_sides_cannot_be_decided),
        cmocka_unit_test(a_circle_contradicts_and_does_not_prove),
        cmocka_unit_test(quantiles_lie_between_the_sorted_values),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
