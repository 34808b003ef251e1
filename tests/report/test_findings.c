/* The rules of the verdicts, and what of many measurements counts. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "report/findings.h"
#include "report/quantile.h"

static void a_plain_number_holds_when_the_measured_one_rounds_to_it(void **state)
{
    (void)state;
    assert_true(glint_rounds_to(1.65, 1.7, 1) && glint_rounds_to(1.7499, 1.7, 1));
    assert_false(glint_rounds_to(1.649, 1.7, 1) || glint_rounds_to(1.7501, 1.7, 1));
    assert_true(glint_rounds_to(10.31, 10.0, 0));
    assert_false(glint_rounds_to(10.51, 10.0, 0) || glint_rounds_to(5.0, 10.0, 0));
    assert_true(glint_rounds_to(0.44270833, 0.4427, 4) && !glint_rounds_to(0.56919643, 0.5693, 4));
}

static void a_gain_holds_from_what_rounds_to_it_on(void **state)
{
    (void)state;
    assert_true(glint_reaches(1.65, 1.7, 1) && glint_reaches(1.79, 1.7, 1));
    assert_true(glint_reaches(25.0, 20.0, 0) && glint_reaches(19.5, 20.0, 0));
    assert_false(glint_reaches(1.649, 1.7, 1) || glint_reaches(19.49, 20.0, 0));
}

static void a_gain_on_both_sides_cannot_be_decided(void **state)
{
    (void)state;
    assert_int_equal(glint_verdict_of_gain(1.65, 2.0, 1.7, 1), GLINT_HOLDS);
    assert_int_equal(glint_verdict_of_gain(1.0, 1.649, 1.7, 1), GLINT_DOES_NOT_HOLD);
    assert_int_equal(glint_verdict_of_gain(1.52, 1.79, 1.7, 1), GLINT_CANNOT_BE_DECIDED);
    assert_int_equal(glint_verdict_of_gain(16.9, 25.0, 20.0, 0), GLINT_CANNOT_BE_DECIDED);
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
        cmocka_unit_test(a_gain_on_both_sides_cannot_be_decided),
        cmocka_unit_test(quantiles_lie_between_the_sorted_values),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
