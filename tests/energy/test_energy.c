/* The factor of (2.26), reciprocity and the white furnace. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

#include "../seed.h"
#include "energy/furnace.h"
#include "energy/normalization.h"
#include "energy/reciprocity.h"

#define PI 3.14159265358979323846

static void assert_near(double found, double expected, double tolerance)
{
    if (!(fabs(found - expected) <= tolerance))
        fail_msg("%.12g is more than %g from %.12g", found, tolerance, expected);
}

/* ---- (2.25) and (2.26) -------------------------------------------------------------------------
 */

/* By Simpson's rule, from the formula as it stands. */
static double printed_by_steps(double n, double limit)
{
    const int steps = 20000;
    double sum = 0.0;
    for (int i = 0; i <= steps; i++) {
        const double t = limit * i / steps;
        const double line = (n + 1) / 3 * (cos(t / 2) - 1) + 1;
        const double weight = i == 0 || i == steps ? 1 : i % 2 == 1 ? 4 : 2;
        sum += weight * line * line * cos(t) * sin(t);
    }
    return 2 * PI * sum * limit / steps / 3;
}

static void the_printed_integral_is_as_printed(void **state)
{
    (void)state;
    static const double n[] = {1, 2, 13, 17, 1000};
    for (size_t i = 0; i < sizeof n / sizeof n[0]; i++) {
        const double limit = glint_printed_limit(n[i]);
        assert_near(limit * limit * n[i], 5.8 * 5.8, 1e-12);
        assert_near(glint_printed_albedo(n[i], limit), printed_by_steps(n[i], limit), 1e-10);
    }
}

/* Where the integrals are elementary: W of n = 2 is cos²(θ/2) = (1 + cos θ)/2; with (cos θ)/2 the
 * parabola of n = 1 is (1 + cos θ)²/9, that of n = 5 (cos θ − 1)². */
static void the_misprints_are_as_printed(void **state)
{
    (void)state;
    assert_near(glint_printed_albedo_by_solid_angle(2, PI / 2), PI / 3 + PI * PI / 16, 1e-12);
    assert_near(glint_misprinted_albedo(1), 17 * PI / 54, 1e-12);
    assert_near(glint_misprinted_albedo(5), PI / 6, 1e-12);
}

static void normal_albedos(double *albedo)
{
    glint_albedo_rules rules;
    glint_albedo_rules_make(1, &rules);
    for (int i = 0; i < 1000; i++) {
        const glint_reflectance_parameters parameters = {.n = i + 1};
        glint_reflectance w;
        glint_albedo prepared;
        assert_int_equal(
            glint_reflectance_prepare(GLINT_REFLECTANCE_COSINE_QUADRATIC, &parameters, &w, NULL),
            GLINT_OK);
        glint_albedo_prepare(&w, &rules, &prepared);
        albedo[i] = glint_albedo_at(&prepared, 0.0);
    }
}

static void the_smallest_b_is_tight(void **state)
{
    (void)state;
    double albedo[1000];
    glint_normalization found;
    normal_albedos(albedo);
    glint_normalization_for(6.0, albedo, 1000, &found);
    assert_near(found.b, 25.944, 1e-4);
    assert_int_equal(found.tight_n, 17);
    double largest = 0.0, lost = 0.0, least = 2.0;
    for (int i = 0; i < 1000; i++) {
        const double r = (i + 1 + 6.0) / found.b * albedo[i];
        largest = fmax(largest, r);
        least = fmin(least, r);
        lost += 1.0 - r;
    }
    assert_near(largest, 1.0, 1e-15);
    assert_near(found.mean_loss, lost / 1000, 1e-13);
    assert_near(found.largest_loss, 1.0 - least, 1e-13);
}

/* No A of a dense scan, and none close by, does better. */
static void no_other_factor_loses_less(void **state)
{
    (void)state;
    double albedo[1000];
    normal_albedos(albedo);
    for (int loss = GLINT_LOSS_MEAN; loss <= GLINT_LOSS_LARGEST; loss++) {
        glint_normalization best, other;
        glint_normalization_best((glint_loss)loss, albedo, 1000, &best);
        const double least = loss == GLINT_LOSS_MEAN ? best.mean_loss : best.largest_loss;
        for (int i = -20; i <= 20000; i++) {
            const double a = i <= 20 ? best.a + i * 1e-6 : -0.9 + i * 1e-3;
            glint_normalization_for(a, albedo, 1000, &other);
            const double compared = loss == GLINT_LOSS_MEAN ? other.mean_loss : other.largest_loss;
            assert_true(compared >= least - 1e-12);
        }
    }
}

/* ---- Reciprocity
 * --------------------------------------------------------------------------------- */

static double skewed(const void *context, const glint_geometry *g)
{
    const double by = *(const double *)context;
    return g->nh * g->nh * (1.0 + by * g->nl);
}

static void an_asymmetry_is_found(void **state)
{
    (void)state;
    glint_reciprocity found;
    const double none = 0.0, slight = 1e-6, strong = 1.0;
    const uint64_t seed = seed_of_this_run();
    glint_reciprocity_measure(skewed, &none, 1000, seed, &found);
    assert_true(found.largest == 0.0);
    glint_reciprocity_measure(skewed, &slight, 1000, seed, &found);
    assert_near(found.largest, 1e-6, 1e-7); /* N·L = 1, N·V = 0 */
    glint_reciprocity_measure(skewed, &strong, 1000, seed, &found);
    assert_near(found.largest, 0.5, 0.01);
    assert_true(fmax(found.light.z, found.viewer.z) > 0.99);
    assert_true(fmin(found.light.z, found.viewer.z) < 0.01);
}

static void every_model_is_reciprocal(void **state)
{
    (void)state;
    const uint64_t seed = seed_of_this_run();
    for (int model = 0; model < GLINT_REFLECTANCE_COUNT; model++)
        for (int n = 1; n <= 1000; n = 7 * n + 1) {
            const glint_reflectance_parameters parameters = {.n = n, .f0 = GLINT_F0_DEFAULT};
            glint_reflectance prepared;
            glint_reciprocity found;
            assert_int_equal(glint_reflectance_prepare((glint_reflectance_model)model, &parameters,
                                                       &prepared, NULL),
                             GLINT_OK);
            glint_reciprocity_measure(glint_reciprocity_of_model, &prepared, 2000, seed, &found);
            assert_true(found.largest <= 1e-12);
            assert_true(found.pairs >= 2000 && found.dark < found.pairs * 9 / 10);
        }
}

/* ---- The furnace -------------------------------------------------------------------------------
 */

static void colors_tell_loss_from_gain(void **state)
{
    (void)state;
    uint8_t rgb[3], before = 0;
    for (int i = 0; i <= 100; i++) {
        glint_furnace_color(i / 100.0, rgb);
        assert_true(rgb[0] == rgb[1] && rgb[1] == rgb[2] && rgb[0] >= before);
        before = rgb[0];
    }
    assert_int_equal(before, 255);
    for (double value = 1.001; value < 2.9; value += 0.01) {
        glint_furnace_color(value, rgb);
        assert_true(rgb[0] > rgb[2] + 10);
    }
    glint_furnace_color(7.0, rgb);
    assert_true(rgb[0] == 0 && rgb[1] == 0 && rgb[2] == 0);
}

/* A white sphere is not to be seen; plain Blinn at n = 1 gains, most at its centre; at n = 1000 it
 * is dark. */
static void spheres_in_the_furnace(void **state)
{
    (void)state;
    static const glint_reflectance_model model[] = {GLINT_REFLECTANCE_LAMBERT,
                                                    GLINT_REFLECTANCE_BLINN};
    static const double n[] = {1, 1000}, angle[] = {0, 20, 40, 60, 80, 89};
    const glint_energy_plan plan = {.model = model,
                                    .model_count = 2,
                                    .n = n,
                                    .n_count = 2,
                                    .angle = angle,
                                    .angle_count = 6,
                                    .quadrature = true,
                                    .threads = 1};
    glint_energy_table *table;
    glint_image *image;
    assert_int_equal(glint_energy_table_make(&plan, &table, NULL), GLINT_OK);
    assert_int_equal(glint_furnace_picture(table, 0, 1, 50, &image, NULL), GLINT_OK);
    assert_int_equal(image->width, 112);
    assert_int_equal(image->height, 58);
    for (int i = 0; i < 3 * image->width * image->height; i++)
        assert_int_equal(image->rgb[i], 255);
    glint_image_destroy(image);
    assert_int_equal(glint_furnace_picture(table, 1, 1, 50, &image, NULL), GLINT_OK);
    glint_energy_table_destroy(table);
    const uint8_t *row = image->rgb + 3 * 29 * image->width;
    assert_true(row[3 * 29] > row[3 * 29 + 2] || row[3 * 29] < 40); /* the centre of n = 1 */
    assert_true(row[3 * 87] < 128 && row[3 * 87] == row[3 * 87 + 2]);
    assert_int_equal(row[3 * 1], 255); /* between them: white */
    assert_int_equal(image->object[0], 1);
    glint_image_destroy(image);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_printed_integral_is_as_printed),
        cmocka_unit_test(the_misprints_are_as_printed),
        cmocka_unit_test(the_smallest_b_is_tight),
        cmocka_unit_test(no_other_factor_loses_less),
        cmocka_unit_test(an_asymmetry_is_found),
        cmocka_unit_test(every_model_is_reciprocal),
        cmocka_unit_test(colors_tell_loss_from_gain),
        cmocka_unit_test(spheres_in_the_furnace),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
