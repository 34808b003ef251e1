/* How far each lobe is from cosⁿ: the thesis's claims against measurements. Each test's comment
 * states the claim; docs/models.md quotes the figures. */
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>

#include "glint_formats.h"
#include "lobes.h"
#include "reflectance/accuracy.h"

static glint_accuracy measured(glint_reflectance_model model, double n, double level)
{
    const glint_reflectance r = prepared(model, n);
    glint_accuracy accuracy;
    assert_int_equal(glint_accuracy_measure(&r, level, &accuracy, NULL), GLINT_OK);
    return accuracy;
}

/* The largest over n = first…1000. */
typedef struct worst {
    double absolute, epicentre_absolute, epicentre_relative;
} worst;

/* The n that are measured: all up to 30, then ever fewer, and the last. */
static int next_n(int n)
{
    const int next = n + 1 + n / 30 * 3;
    return n < 1000 && next > 1000 ? 1000 : next;
}

static worst worst_of(glint_reflectance_model model, int first, double level)
{
    worst w = {0, 0, 0};
    for (int n = first; n <= 1000; n = next_n(n)) {
        const glint_accuracy a = measured(model, n, level);
        w.absolute = fmax(w.absolute, a.absolute.error);
        w.epicentre_absolute = fmax(w.epicentre_absolute, a.epicentre_absolute.error);
        w.epicentre_relative = fmax(w.epicentre_relative, a.epicentre_relative.error);
    }
    return w;
}

static void assert_near(double value, double expected, double tolerance)
{
    if (!(fabs(value - expected) <= tolerance))
        fail_msg("%.8g, expected %.8g", value, expected);
}

static void exact_lobes_have_no_error(void **state)
{
    (void)state;
    assert_near(worst_of(GLINT_REFLECTANCE_BLINN, 1, 0.6).absolute, 0, 1e-12);
    assert_near(worst_of(GLINT_REFLECTANCE_PHONG, 1, 0.6).epicentre_relative, 0, 1e-12);
}

/* (2.1): 3.2 % (2.1) or 10 % (2.7). */
static void schlick(void **state)
{
    (void)state;
    const worst w = worst_of(GLINT_REFLECTANCE_SCHLICK, 1, 0.6);
    assert_near(w.epicentre_relative, 0.1031, 5e-5);
    assert_near(w.epicentre_absolute, 0.0618, 5e-5);
    assert_near(w.absolute, 0.2034, 5e-5);
}

/* (2.2): 3.2 % (2.7), that is 6.8 % less than Schlick's 10 % (2.1), or 0.4 % (3.4). Only with the
 * square on n as well does the first hold, and only from n = 2 on. */
static void readings_of_the_modified_schlick(void **state)
{
    (void)state;
    const double level = 0.6;
    const worst printed = worst_of(GLINT_REFLECTANCE_SCHLICK_MODIFIED, 1, level);
    assert_near(printed.epicentre_relative, 0.2424, 5e-5);
    assert_near(measured(GLINT_REFLECTANCE_SCHLICK_MODIFIED, 1000, level).epicentre_relative.error,
                0.1757, 5e-5);
    assert_near(worst_of(GLINT_REFLECTANCE_SCHLICK_MODIFIED_ANGLE, 2, level).epicentre_relative,
                0.1029, 5e-5);
    assert_near(worst_of(GLINT_REFLECTANCE_SCHLICK_MODIFIED_LINEAR, 2, level).epicentre_relative,
                0.1030, 5e-5);
    const worst squared = worst_of(GLINT_REFLECTANCE_SCHLICK_MODIFIED_SQUARED, 2, level);
    assert_near(squared.epicentre_relative, 0.0271, 5e-5);
    assert_near(squared.absolute, 0.0689, 5e-5);
    assert_near(
        measured(GLINT_REFLECTANCE_SCHLICK_MODIFIED_SQUARED, 1, level).epicentre_relative.error,
        0.0741, 5e-5);
    assert_true(worst_of(GLINT_REFLECTANCE_SCHLICK_MODIFIED_SQUARED, 2, 0.56).epicentre_relative <
                0.032);
    const worst power = worst_of(GLINT_REFLECTANCE_SCHLICK_MODIFIED_POWER, 1, level);
    assert_near(power.epicentre_relative, 0.0149, 5e-5);
    assert_near(power.absolute, 0.1080, 1e-4);
}

/* (2.3): at most 3 % where cosⁿ ≥ 0.56, by figure 2.7 for n = 1…512. So it is up to n = 39. */
static void quadratic(void **state)
{
    (void)state;
    const worst w = worst_of(GLINT_REFLECTANCE_QUADRATIC, 1, 0.56);
    assert_near(w.epicentre_relative, 0.0316, 5e-5);
    assert_near(w.absolute, 0.2802, 5e-5);
    const worst small = worst_of(GLINT_REFLECTANCE_QUADRATIC, 1, 0.6);
    assert_near(small.epicentre_relative, w.epicentre_relative, 1e-9);
    assert_true(measured(GLINT_REFLECTANCE_QUADRATIC, 39, 0.56).epicentre_relative.error < 0.03);
    assert_true(measured(GLINT_REFLECTANCE_QUADRATIC, 40, 0.56).epicentre_relative.error > 0.03);
}

/* (2.15): absolute error at most 0.1; relative at most 3 %. */
static void cosine_quadratic(void **state)
{
    (void)state;
    const worst w = worst_of(GLINT_REFLECTANCE_COSINE_QUADRATIC, 2, 0.6);
    assert_near(w.absolute, 0.0913, 5e-5);
    assert_near(w.epicentre_absolute, 0.0882, 5e-5);
    assert_near(w.epicentre_relative, 0.1471, 5e-5);
    const glint_accuracy wide = measured(GLINT_REFLECTANCE_COSINE_QUADRATIC, 1, 0.6);
    assert_near(wide.absolute.error, 1.0 / 9.0, 1e-12);
    assert_near(wide.absolute.cosine, 0.0, 1e-12);
    /* The narrowest highlights: 0.0916, by the limit (1 − x/3)² against e^-x. */
    assert_near(measured(GLINT_REFLECTANCE_COSINE_QUADRATIC, 1e6, 0.6).absolute.error, 0.09157,
                5e-6);
}

/* 2.3: the largest relative error is at tan γ = √(1+2n)/n. It is cos γ = n/(n+1), where the error
 * does stand still, at 4/9·(1+1/n)ⁿ − 1; further out, where the lobe is 0, it is −100 %. */
static void largest_relative_error_in_closed_form(void **state)
{
    (void)state;
    for (int n = 3; n <= 1000; n++) {
        const glint_reflectance r = prepared(GLINT_REFLECTANCE_COSINE_QUADRATIC, n);
        const double c = cos(atan(sqrt(1.0 + 2.0 * n) / n));
        assert_near(c, n / (n + 1.0), 1e-15);
        const double at = glint_reflectance_of_cosine(&r, c) / pow(c, n) - 1.0;
        assert_near(at, 4.0 / 9.0 * pow(1.0 + 1.0 / n, n) - 1.0, 1e-10);
        const double to_zero = c - (n - 2.0) / (n + 1.0);
        for (int i = 1; i <= 50; i++) { /* from the centre to the lobe's end nothing is above it */
            const double inside = c + (1.0 - c) * i / 50, outside = c - to_zero * i / 50;
            assert_true(glint_reflectance_of_cosine(&r, inside) / pow(inside, n) - 1.0 < at);
            assert_true(glint_reflectance_of_cosine(&r, outside) / pow(outside, n) - 1.0 < at);
        }
    }
    const double limit = 4.0 / 9.0 * exp(1.0) - 1.0; /* 20.8 %, not 3 % */
    assert_near(limit, 0.2081, 5e-5);
    /* With a level below that place, the measured largest is there. */
    const glint_accuracy a = measured(GLINT_REFLECTANCE_COSINE_QUADRATIC, 100, 0.3);
    assert_near(a.epicentre_relative.cosine, 100.0 / 101.0, 1e-6);
    assert_near(a.epicentre_relative.error, 4.0 / 9.0 * pow(1.01, 100) - 1.0, 1e-9);
}

/* 2.3: the largest absolute error is at tan γ = √(6n−3)/(n−2). That is where the lobe ends, and the
 * error there, ((n−2)/(n+1))ⁿ, is at most e^-3: the largest is elsewhere, and 1.6 to 1.8 times
 * that. */
static void largest_absolute_error_in_closed_form(void **state)
{
    (void)state;
    for (int n = 3; n <= 1000; n++) {
        const double c = cos(atan(sqrt(6.0 * n - 3.0) / (n - 2.0)));
        assert_near(c, (n - 2.0) / (n + 1.0), 1e-14);
        const glint_reflectance r = prepared(GLINT_REFLECTANCE_COSINE_QUADRATIC, n);
        assert_near(glint_reflectance_of_cosine(&r, c), 0.0, 1e-20);
        assert_true(pow(c, n) < exp(-3.0));
    }
    for (int n = 3; n <= 1000; n = next_n(n)) {
        const glint_accuracy a = measured(GLINT_REFLECTANCE_COSINE_QUADRATIC, n, 0.6);
        assert_true(a.absolute.cosine > n / (n + 1.0));
        assert_true(a.absolute.error > 1.59 * pow((n - 2.0) / (n + 1.0), n));
    }
}

/* 3.1, 3.4: the epicentre's absolute error is a fourth, or a third, of Schlick's. */
static void cosine_quadratic_against_schlick(void **state)
{
    (void)state;
    const worst schlick = worst_of(GLINT_REFLECTANCE_SCHLICK, 2, 0.6);
    const worst ours = worst_of(GLINT_REFLECTANCE_COSINE_QUADRATIC, 2, 0.6);
    assert_near(ours.epicentre_absolute / schlick.epicentre_absolute, 1.43, 0.01);
    assert_near(schlick.absolute / ours.absolute, 2.23, 0.01);
    /* 3.4: the quadratic is more than ten times as accurate in the epicentre. */
    const worst quadratic = worst_of(GLINT_REFLECTANCE_QUADRATIC, 2, 0.6);
    assert_near(schlick.epicentre_absolute / quadratic.epicentre_absolute, 2.53, 0.01);
}

/* For highlights without end: k, equal width, minimax width. */
static void the_family(void **state)
{
    (void)state;
    static const struct {
        glint_reflectance_model equal, minimax;
        double equal_error, minimax_error;
    } members[] = {
        {GLINT_REFLECTANCE_COSINE_QUADRATIC, GLINT_REFLECTANCE_LYON_2_MINIMAX, 0.0916, 0.0699},
        {GLINT_REFLECTANCE_LYON_4, GLINT_REFLECTANCE_LYON_4_MINIMAX, 0.0509, 0.0332},
        {GLINT_REFLECTANCE_LYON_8, GLINT_REFLECTANCE_LYON_8_MINIMAX, 0.0270, 0.0162},
        {GLINT_REFLECTANCE_LYON_16, GLINT_REFLECTANCE_LYON_16_MINIMAX, 0.0139, 0.0080},
    };
    for (size_t i = 0; i < sizeof members / sizeof members[0]; i++) {
        assert_near(measured(members[i].equal, 1e6, 0.6).absolute.error, members[i].equal_error,
                    5e-5);
        assert_near(measured(members[i].minimax, 1e6, 0.6).absolute.error, members[i].minimax_error,
                    5e-5);
    }
}

/* What the rounding of the circuit adds to the error of its formula. */
static void the_device_adds_little(void **state)
{
    (void)state;
    for (int n = 1; n <= 1000; n = next_n(n)) {
        const double formula = measured(GLINT_REFLECTANCE_COSINE_QUADRATIC, n, 0.6).absolute.error;
        const double circuit = measured(GLINT_REFLECTANCE_DEVICE, n, 0.6).absolute.error;
        /* Half a code of the cosine at a slope of 2σ at most, half a code of σ by at most the
         * lobe's width 1/σ, both twice in the square, and the rounding of t and W. */
        const double sigma = (n + 1.0) / 3.0, code = 1.0 / GLINT_COS_ONE;
        const double sigma_code = 1.0 / (1 << GLINT_SIGMA_FRAC_BITS);
        assert_true(fabs(circuit - formula) <
                    sigma * code + sigma_code * fmin(1.0, 1.0 / sigma) + 1.5 * code);
    }
}

static void what_stands_for_no_power_is_refused(void **state)
{
    (void)state;
    glint_accuracy accuracy;
    glint_error err;
    const glint_reflectance lambert = prepared(GLINT_REFLECTANCE_LAMBERT, 5);
    const glint_reflectance facets = prepared(GLINT_REFLECTANCE_COOK_TORRANCE, 5);
    const glint_reflectance flat = prepared(GLINT_REFLECTANCE_BLINN, 0);
    const glint_reflectance blinn = prepared(GLINT_REFLECTANCE_BLINN, 5);
    assert_int_equal(glint_accuracy_measure(&lambert, 0.6, &accuracy, &err), GLINT_BAD_ARGUMENT);
    assert_string_equal(err.text, "model lambert does not approximate a power of the cosine");
    assert_int_equal(glint_accuracy_measure(&facets, 0.6, &accuracy, NULL), GLINT_BAD_ARGUMENT);
    assert_int_equal(glint_accuracy_measure(&flat, 0.6, &accuracy, NULL), GLINT_BAD_ARGUMENT);
    assert_int_equal(glint_accuracy_measure(&blinn, 1.0, &accuracy, &err), GLINT_BAD_ARGUMENT);
    assert_string_equal(err.text, "n = 5 must be above 0, and the level 1 between 0 and 1");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(exact_lobes_have_no_error),
        cmocka_unit_test(schlick),
        cmocka_unit_test(readings_of_the_modified_schlick),
        cmocka_unit_test(quadratic),
        cmocka_unit_test(cosine_quadratic),
        cmocka_unit_test(largest_relative_error_in_closed_form),
        cmocka_unit_test(largest_absolute_error_in_closed_form),
        cmocka_unit_test(cosine_quadratic_against_schlick),
        cmocka_unit_test(the_family),
        cmocka_unit_test(the_device_adds_little),
        cmocka_unit_test(what_stands_for_no_power_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
