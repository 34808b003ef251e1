/* Albedos by quadrature against closed forms, against themselves with more nodes and in other
 * coordinates, and against Monte Carlo. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

#include "../seed.h"
#include "energy/table.h"

#define PI     3.14159265358979323846
#define DEGREE (PI / 180.0)

static const double some_n[] = {1, 2, 3, 5, 17, 60, 250, 1000};
static const double some_angle[] = {0, 1, 30, 45, 60, 80, 89};

#define COUNT(array) ((int)(sizeof(array) / sizeof(array)[0]))

static void assert_near(double found, double expected, double tolerance)
{
    if (!(fabs(found - expected) <= tolerance))
        fail_msg("%.12g is more than %g from %.12g", found, tolerance, expected);
}

static glint_reflectance model_of(glint_reflectance_model model, double n, double f0)
{
    glint_reflectance prepared;
    const glint_reflectance_parameters parameters = {.n = n, .f0 = f0};
    assert_int_equal(glint_reflectance_prepare(model, &parameters, &prepared, NULL), GLINT_OK);
    return prepared;
}

static double albedo_of(const glint_reflectance *reflectance, int fineness, double degrees)
{
    glint_albedo_rules rules;
    glint_albedo albedo;
    glint_albedo_rules_make(fineness, &rules);
    glint_albedo_prepare(reflectance, &rules, &albedo);
    return glint_albedo_at(&albedo, degrees * DEGREE);
}

static void gauss_is_exact_for_polynomials(void **state)
{
    (void)state;
    for (int order = 1; order <= GLINT_GAUSS_ORDER_MAX; order++) {
        glint_gauss rule;
        glint_gauss_make(order, &rule);
        for (int power = 0; power < 2 * order; power++) {
            double sum = 0.0;
            for (int i = 0; i < order; i++)
                sum += rule.weight[i] * pow(rule.node[i], power);
            assert_near(sum, power % 2 == 0 ? 2.0 / (power + 1) : 0.0, 1e-13);
        }
    }
}

static void lamberts_is_one(void **state)
{
    (void)state;
    const glint_reflectance lambert = model_of(GLINT_REFLECTANCE_LAMBERT, 1, 0);
    for (int i = 0; i < COUNT(some_angle); i++)
        assert_near(albedo_of(&lambert, 1, some_angle[i]), 1.0, GLINT_ALBEDO_ERROR_LOBE);
}

/* ∫ cosⁿθ cos θ dω = 2π/(n+2). */
static void phongs_at_normal_incidence(void **state)
{
    (void)state;
    for (int i = 0; i < COUNT(some_n); i++) {
        const glint_reflectance phong = model_of(GLINT_REFLECTANCE_PHONG, some_n[i], 0);
        assert_near(albedo_of(&phong, 1, 0), 2.0 * PI / (some_n[i] + 2.0), 1e-12);
    }
}

/* With c = cos(θ/2): 8π ∫ cⁿ (2c²−1) c dc from 1/√2 to 1. */
static void blinns_at_normal_incidence(void **state)
{
    (void)state;
    for (int i = 0; i < COUNT(some_n); i++) {
        const double n = some_n[i], h = sqrt(0.5);
        const double exact =
            8.0 * PI * (2.0 * (1.0 - pow(h, n + 4)) / (n + 4) - (1.0 - pow(h, n + 2)) / (n + 2));
        const glint_reflectance blinn = model_of(GLINT_REFLECTANCE_BLINN, n, 0);
        assert_near(albedo_of(&blinn, 1, 0), exact, 1e-12);
        const glint_reflectance normal = model_of(GLINT_REFLECTANCE_BLINN_NORMALIZED, n, 0);
        assert_near(albedo_of(&normal, 1, 0), exact * (n + 6) / (8 * PI), 1e-12);
    }
}

/* The same integral of (1 + σ(c−1))², a polynomial, from its zero or 1/√2 to 1: with x = 1−c,
 * 8π ∫ (1 − σx)² (1 − 4x + 2x²)(1 − x) dx. */
static double cosine_quadratic_exact(double n)
{
    const double s = (n + 1) / 3, x = fmin(1 / s, 1 - sqrt(0.5));
    const double lobe[] = {1, -2 * s, s * s}, rest[] = {1, -5, 6, -2};
    double product[6] = {0}, sum = 0;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 4; j++)
            product[i + j] += lobe[i] * rest[j];
    for (int i = 0; i < 6; i++)
        sum += product[i] * pow(x, i + 1) / (i + 1);
    return 8 * PI * sum;
}

static void the_cosine_quadratics_at_normal_incidence(void **state)
{
    (void)state;
    for (int n = 1; n <= 1000; n++) {
        const double exact = cosine_quadratic_exact(n);
        const glint_reflectance w = model_of(GLINT_REFLECTANCE_COSINE_QUADRATIC, n, 0);
        assert_near(albedo_of(&w, 1, 0), exact, 1e-12);
        const glint_reflectance claimed = model_of(GLINT_REFLECTANCE_ENERGY_CONSERVING, n, 0);
        assert_near(albedo_of(&claimed, 1, 0), exact * (n + 6) / 24.55, 1e-12);
    }
    /* The limit for large n, 8π/(n+1). */
    assert_near(cosine_quadratic_exact(1e6) * (1e6 + 1) / (8 * PI), 1.0, 1e-5);
}

/* A plane mirror of microfacets: as m goes to 0, the albedo goes to F. */
static void smooth_microfacets_reflect_as_fresnel_says(void **state)
{
    (void)state;
    for (int model = GLINT_REFLECTANCE_TORRANCE_SPARROW; model <= GLINT_REFLECTANCE_COOK_TORRANCE;
         model++) {
        const glint_reflectance smooth = model_of((glint_reflectance_model)model, 1e6, 0.04);
        assert_near(albedo_of(&smooth, 1, 0), 0.04, 1e-6);
        /* Refractive index 1.5 at 60°; t is the cosine of the refracted ray. */
        const double c = 0.5, t = sqrt(1.0 - 0.75 / 2.25);
        const double rs = (c - 1.5 * t) / (c + 1.5 * t), rp = (t - 1.5 * c) / (t + 1.5 * c);
        assert_near(albedo_of(&smooth, 1, 60), 0.5 * (rs * rs + rp * rp), 1e-5);
    }
}

static double error_of(glint_reflectance_model model)
{
    if (model == GLINT_REFLECTANCE_DEVICE)
        return GLINT_ALBEDO_ERROR_DEVICE;
    return glint_reflectance_describe(model)->cosine == GLINT_REFLECTANCE_OF_GEOMETRY
               ? GLINT_ALBEDO_ERROR_MICROFACET
               : GLINT_ALBEDO_ERROR_LOBE;
}

static void finer_is_the_same(void **state)
{
    (void)state;
    for (int model = 0; model < GLINT_REFLECTANCE_COUNT; model++)
        for (int i = 0; i < COUNT(some_n); i++) {
            const glint_reflectance reflectance =
                model_of((glint_reflectance_model)model, some_n[i], 1.0);
            for (int j = 0; j < COUNT(some_angle); j++)
                assert_near(albedo_of(&reflectance, 1, some_angle[j]),
                            albedo_of(&reflectance, 2, some_angle[j]),
                            error_of((glint_reflectance_model)model));
        }
}

/* Lobes over φ too, from the BRDF instead of the elementary integral. */
static void other_coordinates_are_the_same(void **state)
{
    (void)state;
    static const glint_reflectance_model models[] = {
        GLINT_REFLECTANCE_PHONG, GLINT_REFLECTANCE_BLINN, GLINT_REFLECTANCE_SCHLICK,
        GLINT_REFLECTANCE_COSINE_QUADRATIC};
    glint_albedo_rules rules;
    glint_albedo_rules_make(4, &rules);
    for (int i = 0; i < COUNT(models) * COUNT(some_angle); i++) {
        const double angle = some_angle[i % COUNT(some_angle)] * DEGREE;
        const glint_reflectance reflectance = model_of(models[i / COUNT(some_angle)], 40, 0);
        glint_albedo albedo;
        glint_albedo_prepare(&reflectance, &rules, &albedo);
        assert_near(glint_albedo_over_sphere(&albedo, angle), glint_albedo_at(&albedo, angle),
                    1e-6);
    }
}

static glint_energy_plan every_model(glint_reflectance_model *model, int samples, uint64_t seed)
{
    for (int i = 0; i < GLINT_REFLECTANCE_COUNT; i++)
        model[i] = (glint_reflectance_model)i;
    return (glint_energy_plan){.model = model,
                               .model_count = GLINT_REFLECTANCE_COUNT,
                               .n = some_n,
                               .n_count = COUNT(some_n),
                               .angle = some_angle,
                               .angle_count = COUNT(some_angle),
                               .f0 = 1.0,
                               .quadrature = true,
                               .samples = samples,
                               .seed = seed,
                               .threads = 2};
}

/* Of 1288 cells, 3.5 are expected beyond 3 standard errors; more than 20, or one beyond 8, would be
 * a fault of one of the methods. The errors themselves are checked by the share within one. */
static void monte_carlo_agrees(void **state)
{
    (void)state;
    glint_reflectance_model model[GLINT_REFLECTANCE_COUNT];
    const glint_energy_plan plan = every_model(model, 2000, seed_of_this_run());
    glint_energy_table *table;
    uint64_t cells = 0, within_1 = 0, within_3 = 0;
    assert_int_equal(glint_energy_table_make(&plan, &table, NULL), GLINT_OK);
    for (int i = 1; i < GLINT_REFLECTANCE_COUNT; i++) { /* Lambert's has no spread */
        glint_energy_summary summary;
        glint_energy_summarize(table, i, &summary);
        assert_int_equal(summary.cells, COUNT(some_n) * COUNT(some_angle));
        assert_true(summary.farthest < 8.0);
        cells += summary.cells;
        within_1 += summary.within_1;
        within_3 += summary.within_3;
    }
    glint_energy_table_destroy(table);
    assert_true(cells - within_3 <= 20);
    assert_near((double)within_1 / (double)cells, 0.69, 0.07);
}

static void the_table_does_not_depend_on_threads(void **state)
{
    (void)state;
    glint_reflectance_model model[GLINT_REFLECTANCE_COUNT];
    glint_energy_plan plan = every_model(model, 20, 5);
    glint_energy_table *two, *one;
    assert_int_equal(glint_energy_table_make(&plan, &two, NULL), GLINT_OK);
    plan.threads = 1;
    assert_int_equal(glint_energy_table_make(&plan, &one, NULL), GLINT_OK);
    assert_memory_equal(one->cell, two->cell,
                        sizeof *one->cell * GLINT_REFLECTANCE_COUNT * COUNT(some_n) *
                            COUNT(some_angle));
    /* Each cell has its own samples, different from its neighbour's, and the seed matters. */
    plan.seed = 6;
    glint_energy_table_destroy(two);
    assert_int_equal(glint_energy_table_make(&plan, &two, NULL), GLINT_OK);
    assert_true(glint_energy_at(one, GLINT_REFLECTANCE_BLINN, 3, 3)->monte_carlo.mean !=
                glint_energy_at(two, GLINT_REFLECTANCE_BLINN, 3, 3)->monte_carlo.mean);
    glint_energy_table_destroy(two);
    glint_energy_table_destroy(one);
}

static void the_summary_finds_what_is_above_one(void **state)
{
    (void)state;
    static const glint_reflectance_model model[] = {GLINT_REFLECTANCE_ENERGY_CONSERVING};
    double n[40];
    for (int i = 0; i < 40; i++)
        n[i] = i + 1;
    const glint_energy_plan plan = {.model = model,
                                    .model_count = 1,
                                    .n = n,
                                    .n_count = 40,
                                    .angle = some_angle,
                                    .angle_count = COUNT(some_angle),
                                    .quadrature = true,
                                    .threads = 1};
    glint_energy_table *table;
    glint_energy_summary summary;
    assert_int_equal(glint_energy_table_make(&plan, &table, NULL), GLINT_OK);
    glint_energy_summarize(table, 0, &summary);
    glint_energy_table_destroy(table);
    int above = 0, first = 0;
    for (int i = 40; i >= 1; i--)
        if (cosine_quadratic_exact(i) * (i + 6) / 24.55 > 1) {
            above++;
            first = i;
        }
    assert_int_equal(summary.n_above, above);
    assert_true(summary.first_above == first && summary.last_above == 40);
    assert_true(summary.largest_n == 17 && summary.largest_angle == 0);
    assert_int_equal(summary.cells, 0);
}

static void what_cannot_be_is_refused(void **state)
{
    (void)state;
    static const glint_reflectance_model device[] = {GLINT_REFLECTANCE_DEVICE};
    static const double fraction[] = {1.5}, horizon[] = {90};
    static volatile bool stop = true;
    glint_energy_plan plan = {.model = device,
                              .model_count = 1,
                              .n = fraction,
                              .n_count = 1,
                              .angle = some_angle,
                              .angle_count = 1,
                              .quadrature = true,
                              .threads = 1};
    glint_energy_table *table = NULL;
    glint_error err;
    assert_int_equal(glint_energy_table_make(&plan, &table, &err), GLINT_BAD_ARGUMENT);
    assert_string_equal(err.text, "model device: n = 1.5 is not an integer");
    plan.n = some_n;
    plan.angle = horizon;
    assert_int_equal(glint_energy_table_make(&plan, &table, &err), GLINT_BAD_ARGUMENT);
    plan.angle = some_angle;
    plan.samples = 1;
    assert_int_equal(glint_energy_table_make(&plan, &table, &err), GLINT_BAD_ARGUMENT);
    plan.samples = 0;
    plan.stop = &stop;
    assert_int_equal(glint_energy_table_make(&plan, &table, &err), GLINT_INTERRUPTED);
    assert_null(table);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(gauss_is_exact_for_polynomials),
        cmocka_unit_test(lamberts_is_one),
        cmocka_unit_test(phongs_at_normal_incidence),
        cmocka_unit_test(blinns_at_normal_incidence),
        cmocka_unit_test(the_cosine_quadratics_at_normal_incidence),
        cmocka_unit_test(smooth_microfacets_reflect_as_fresnel_says),
        cmocka_unit_test(finer_is_the_same),
        cmocka_unit_test(other_coordinates_are_the_same),
        cmocka_unit_test(monte_carlo_agrees),
        cmocka_unit_test(the_table_does_not_depend_on_threads),
        cmocka_unit_test(the_summary_finds_what_is_above_one),
        cmocka_unit_test(what_cannot_be_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
