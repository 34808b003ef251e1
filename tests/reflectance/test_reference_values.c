/* Each model against values computed by other means: reference.h, by bc from the printed formulas;
 * and the prepared coefficients against the thesis's equations in long double. */
#define _XOPEN_SOURCE 700

#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>

#include "../scratch.h"

#include "../child.h"
#include "lobes.h"
#include "reference.h"

static void assert_close(double value, double expected, double tolerance, const char *model,
                         double n, double cosine)
{
    if (!(fabs(value - expected) <= tolerance))
        fail_msg("%s, n = %g, cosine %g: %.17g, expected %.17g", model, n, cosine, value, expected);
}

static void the_table_is_what_bc_computes_today(void **state)
{
    (void)state;
    const char *const argv[] = {"tests/reflectance/reference.sh", NULL};
    const pid_t child = child_start(argv, scratch_path("reference.h"), scratch_path("errors"));
    const int status = child_wait(child, 120);
    char *said = scratch_read(scratch_path("errors"), NULL);
    assert_string_equal(said, "");
    assert_int_equal(status, 0);
    char *computed = scratch_read(scratch_path("reference.h"), NULL);
    char *committed = scratch_read("tests/reflectance/reference.h", NULL);
    assert_string_equal(computed, committed);
    free(committed);
    free(computed);
    free(said);
}

static void lobes_have_the_values_of_their_formulas(void **state)
{
    (void)state;
    bool met[GLINT_REFLECTANCE_COUNT] = {false};
    for (size_t i = 0; i < sizeof reference_lobes / sizeof reference_lobes[0]; i++) {
        const glint_reflectance_model model = reference_lobes[i].model;
        const double n = reference_lobes[i].n, cosine = reference_lobes[i].cosine;
        const double expected = reference_lobes[i].value;
        double value = -1.0;
        assert_int_equal(glint_reflectance_eval(model, n, cosine, &value, NULL), GLINT_OK);
        /* The decimal cosine itself is rounded: n·2^-54 of the value. */
        assert_close(value, expected, 1e-15 + 1e-12 * expected, glint_reflectance_names[model], n,
                     cosine);
        met[model] = true;
    }
    /* Those that need a search, and the device, are tested by what defines them. */
    met[GLINT_REFLECTANCE_SCHLICK_MODIFIED_POWER] = met[GLINT_REFLECTANCE_DEVICE] = true;
    met[GLINT_REFLECTANCE_LYON_2_MINIMAX] = met[GLINT_REFLECTANCE_LYON_4_MINIMAX] = true;
    met[GLINT_REFLECTANCE_LYON_8_MINIMAX] = met[GLINT_REFLECTANCE_LYON_16_MINIMAX] = true;
    for (int model = 0; model < GLINT_REFLECTANCE_COUNT; model++)
        assert_true(met[model] || !is_lobe(model));
}

static glint_vec3 at(double from_normal, double around)
{
    return (glint_vec3){sin(from_normal) * cos(around), sin(from_normal) * sin(around),
                        cos(from_normal)};
}

static void microfacet_models_have_the_values_of_their_formulas(void **state)
{
    (void)state;
    const glint_vec3 normal = {0, 0, 1};
    for (size_t i = 0; i < sizeof reference_facets / sizeof reference_facets[0]; i++) {
        const glint_reflectance_parameters parameters = {.n = reference_facets[i].n,
                                                         .f0 = reference_facets[i].f0};
        glint_reflectance r;
        glint_geometry g;
        assert_int_equal(
            glint_reflectance_prepare(reference_facets[i].model, &parameters, &r, NULL), GLINT_OK);
        assert_int_equal(
            glint_geometry_of(normal, at(reference_facets[i].light, 0),
                              at(reference_facets[i].viewer, reference_facets[i].around), &g, NULL),
            GLINT_OK);
        const double expected = reference_facets[i].brdf;
        const double brdf = glint_reflectance_brdf(&r, &g);
        /* Where the exponent is −10 its last bit is one of the value's last four; the Gaussian
         * takes the arc cosine of a cosine near 1. */
        assert_close(brdf, expected, 1e-10 * expected,
                     glint_reflectance_names[reference_facets[i].model], parameters.n, g.nh);
        assert_close(glint_reflectance_intensity(&r, &g), acos(-1.0) * brdf * g.nl, 1e-12 * brdf,
                     "intensity", parameters.n, g.nl);
    }
}

/* (2.8) as printed; in long double it still loses what n costs, 10 bits of 64. */
static void quadratic_table_is_that_of_2_8(void **state)
{
    (void)state;
    assert_true(glint_quadratic_a(1) == 0.0);
    for (int n = 2; n <= 1000; n++) {
        const long double t = cosl(atanl(1.0L / sqrtl(n - 1.0L)));
        const long double a = (powl(t, n - 1.0L) - 1.0L) / (t - 1.0L);
        assert_close(glint_quadratic_a(n), (double)a, 1e-14 * (double)a, "a", n, (double)t);
        assert_true(glint_quadratic_a(n) > glint_quadratic_a(n - 1));
    }
    assert_close(glint_quadratic_a(2), 1.0, 1e-15, "a", 2, 0);
    /* Narrow highlights: t^(n−1) → e^-1/2 and 1 − t → 1/(2n). */
    assert_close(glint_quadratic_a(1e6) / 1e6, 2.0 * (1.0 - exp(-0.5)), 1e-6, "a/n", 1e6, 0);
    /* n → 1: the limit that takes the place of 0/0. */
    assert_close(glint_quadratic_a(1.0 + 1e-9), 0.0, 2e-8, "a", 1, 0);
}

static void quadratic_meets_the_power_at_its_inflection(void **state)
{
    (void)state;
    for (int n = 2; n <= 1000; n++) {
        const glint_reflectance quadratic = prepared(GLINT_REFLECTANCE_QUADRATIC, n);
        const double t = sqrt((n - 1.0) / n);
        assert_close(glint_reflectance_of_cosine(&quadratic, t), pow(t, n), 1e-12, "quadratic", n,
                     t);
    }
}

static void roughness_and_exponent_are_inverse(void **state)
{
    (void)state;
    assert_true(glint_roughness_of_exponent(0) == 1.0);
    assert_close(glint_roughness_of_exponent(6), 0.5, 1e-16, "m", 6, 0);
    for (int n = 0; n <= 1000; n++) {
        const double m = glint_roughness_of_exponent(n);
        assert_close(glint_exponent_of_roughness(m), n, 1e-12 * (n + 2), "n of m", n, m);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_table_is_what_bc_computes_today),
        cmocka_unit_test(lobes_have_the_values_of_their_formulas),
        cmocka_unit_test(microfacet_models_have_the_values_of_their_formulas),
        cmocka_unit_test(quadratic_table_is_that_of_2_8),
        cmocka_unit_test(quadratic_meets_the_power_at_its_inflection),
        cmocka_unit_test(roughness_and_exponent_are_inverse),
    };
    return cmocka_run_group_tests(tests, scratch_make, scratch_remove);
}
