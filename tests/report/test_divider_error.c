/* The divider's errors against rationals compared in integers, and the thesis's numbers of section
 * 2.4 each within its printed digits. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

#include "report/divider_error.h"

static void assert_near(double found, double expected, double tolerance)
{
    if (!(fabs(found - expected) <= tolerance))
        fail_msg("%.9g is more than %g from %.9g", found, tolerance, expected);
}

/* 2ⁿ/k by subtraction, rounded half up or cut off. */
static int64_t bits_of(int shifts, int k, bool rounded)
{
    int64_t left = INT64_C(1) << shifts, bits = 0;
    for (; left >= k; left -= k)
        bits++;
    return rounded && 2 * left >= k ? bits + 1 : bits;
}

/* A positive rational. */
typedef struct ratio {
    int64_t up, down;
} ratio;

static bool larger(ratio a, ratio b)
{
    return a.up * b.down > b.up * a.down;
}

static void keep(ratio value, int k, ratio *largest, int *largest_k)
{
    if (larger(value, *largest)) {
        *largest = value;
        *largest_k = k;
    }
}

static void check_one(int shifts, glint_bits_rule rule)
{
    const int64_t one = INT64_C(1) << shifts;
    ratio absolute = {0, 1}, relative = {0, 1}, last = {0, 1};
    int absolute_k = 0, relative_k = 0, last_k = 0;
    double sum = 0.0;
    for (int k = 2; k <= 16; k++) {
        const int64_t off = llabs(bits_of(shifts, k, rule == GLINT_BITS_ROUNDED) * k - one);
        keep((ratio){255 * off, k * one}, k, &absolute, &absolute_k);
        keep((ratio){off, one}, k, &relative, &relative_k);
        keep((ratio){255 * off, one}, k, &last, &last_k);
        assert_near(glint_divider_relative_error(shifts, rule, k), (double)off / (double)one, 0.0);
        sum += (double)off / (double)one;
    }
    const glint_divider_error error = glint_divider_error_of(shifts, rule);
    assert_near(error.absolute, (double)absolute.up / (double)absolute.down, 1e-15);
    assert_int_equal(error.absolute_k, absolute_k);
    assert_near(error.relative, (double)relative.up / (double)relative.down, 0.0);
    assert_int_equal(error.relative_k, relative_k);
    assert_near(error.last_pixel, (double)last.up / (double)last.down, 0.0);
    assert_int_equal(error.last_pixel_k, last_k);
    assert_near(error.relative_mean, sum / 15.0, 1e-15);
}

static void errors_are_those_of_the_rationals(void **state)
{
    (void)state;
    for (int shifts = 6; shifts <= 16; shifts++) {
        check_one(shifts, GLINT_BITS_ROUNDED);
        check_one(shifts, GLINT_BITS_TRUNCATED);
    }
}

static int64_t floor_div(int64_t a, int64_t b)
{
    return a / b - (a % b < 0);
}

/* The shown last pixel: from + round half up(k·d·b/2ⁿ), held in 0…255. */
static int worst_shown(int shifts, bool rounded)
{
    const int64_t one = INT64_C(1) << shifts;
    int worst = 0;
    for (int k = 2; k <= 16; k++)
        for (int d = -255; d <= 255; d++) {
            const int64_t sum = k * d * bits_of(shifts, k, rounded);
            int64_t shown = (d < 0 ? 255 : 0) + floor_div(2 * sum + one, 2 * one);
            shown = shown < 0 ? 0 : shown > 255 ? 255 : shown;
            const int wrong = (int)llabs(shown - ((d < 0 ? 255 : 0) + d));
            worst = wrong > worst ? wrong : worst;
        }
    return worst;
}

static void the_shown_last_pixel_is_the_rounded_sum(void **state)
{
    (void)state;
    for (int shifts = 6; shifts <= 16; shifts++) {
        assert_int_equal(glint_divider_error_of(shifts, GLINT_BITS_ROUNDED).displayed,
                         worst_shown(shifts, true));
        assert_int_equal(glint_divider_error_of(shifts, GLINT_BITS_TRUNCATED).displayed,
                         worst_shown(shifts, false));
    }
}

static void six_shifts_and_seven_pixels(void **state)
{
    (void)state;
    assert_int_equal(glint_bits_by_rule(6, GLINT_BITS_ROUNDED, 7), 9);
    assert_near(255.0 / 7.0, 36.4286, 0.00005);
    assert_near(255.0 * glint_bits_by_rule(6, GLINT_BITS_ROUNDED, 7) / 64.0, 35.8594, 0.00005);
    const double relative = glint_divider_relative_error(6, GLINT_BITS_ROUNDED, 7);
    assert_near(relative * 255.0 / 7.0, 0.5692, 0.00005);
    assert_near(100.0 * relative, 1.56, 0.005);
    /* What the report says of six shifts beside the thesis's conclusion. */
    assert_int_equal(glint_divider_error_of(6, GLINT_BITS_ROUNDED).displayed, 22);
}

static void eight_shifts(void **state)
{
    (void)state;
    const glint_divider_error rounded = glint_divider_error_of(8, GLINT_BITS_ROUNDED);
    assert_near(rounded.absolute, 0.4427, 0.00005);
    assert_int_equal(rounded.absolute_k, 9);
    assert_near(100.0 * rounded.relative_mean, 0.81, 0.005);
    assert_near(100.0 * rounded.relative_mean, 0.807, 0.0005);
    assert_near(glint_divider_error_of(8, GLINT_BITS_TRUNCATED).absolute, 0.69, 0.005);
}

static void the_default_is_the_first_within_half_a_level(void **state)
{
    (void)state;
    assert_int_equal(glint_divider_first_within_half(GLINT_BITS_ROUNDED), 12);
    assert_int_equal(GLINT_DIVIDER_SHIFTS_DEFAULT, 12);
    assert_true(glint_divider_error_of(11, GLINT_BITS_ROUNDED).last_pixel > 0.5);
    assert_int_equal(glint_divider_error_of(12, GLINT_BITS_ROUNDED).displayed, 0);
    assert_true(glint_divider_error_of(8, GLINT_BITS_ROUNDED).displayed > 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(errors_are_those_of_the_rationals),
        cmocka_unit_test(the_shown_last_pixel_is_the_rounded_sum),
        cmocka_unit_test(six_shifts_and_seven_pixels),
        cmocka_unit_test(eight_shifts),
        cmocka_unit_test(the_default_is_the_first_within_half_a_level),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
