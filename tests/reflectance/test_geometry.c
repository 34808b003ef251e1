/* The models by directions: cosines, the argument of each model, unlit points, reciprocity, and the
 * facets of the microfacet models. */
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>
#include <math.h>

#include "../seed.h"
#include "circuit/random.h"
#include "lobes.h"

#define PI 3.14159265358979323846

static glint_vec3 at(double from_normal, double around)
{
    return (glint_vec3){sin(from_normal) * cos(around), sin(from_normal) * sin(around),
                        cos(from_normal)};
}

static glint_vec3 reflected(glint_vec3 l, glint_vec3 n)
{
    return glint_vec3_sub(glint_vec3_scale(n, 2.0 * glint_vec3_dot(l, n)), l);
}

static double random_to(glint_random *random, double limit)
{
    return limit * glint_random_below(random, 1u << 24) / (double)(1u << 24);
}

static glint_geometry geometry(glint_vec3 n, glint_vec3 l, glint_vec3 v)
{
    glint_geometry g;
    assert_int_equal(glint_geometry_of(n, l, v, &g, NULL), GLINT_OK);
    return g;
}

static void cosines_are_those_of_the_vectors(void **state)
{
    (void)state;
    glint_random random = {seed_of_this_run()};
    for (int i = 0; i < 10000; i++) {
        const glint_vec3 n = at(random_to(&random, PI), random_to(&random, 2 * PI));
        const glint_vec3 l = at(random_to(&random, PI), random_to(&random, 2 * PI));
        const glint_vec3 v = at(random_to(&random, PI), random_to(&random, 2 * PI));
        const glint_vec3 sum = glint_vec3_add(l, v);
        if (glint_vec3_length(sum) < 1e-3)
            continue;
        const glint_vec3 h = glint_vec3_scale(sum, 1.0 / glint_vec3_length(sum));
        const glint_geometry g = geometry(n, l, v);
        assert_true(fabs(g.nl - glint_vec3_dot(n, l)) < 1e-12);
        assert_true(fabs(g.nv - glint_vec3_dot(n, v)) < 1e-12);
        assert_true(fabs(g.nh - glint_vec3_dot(n, h)) < 1e-12);
        assert_true(fabs(g.vh - glint_vec3_dot(v, h)) < 1e-12);
        assert_true(fabs(g.vh - glint_vec3_dot(l, h)) < 1e-12);
        assert_true(fabs(g.rv - glint_vec3_dot(reflected(l, n), v)) < 1e-12);
    }
}

static void directions_that_are_none_are_refused(void **state)
{
    (void)state;
    const glint_vec3 up = {0, 0, 1}, down = {0, 0, -1}, longer = {0, 0, 1.00001}, zero = {0, 0, 0},
                     none = {NAN, 0, 1};
    glint_geometry g;
    glint_error err;
    assert_int_equal(glint_geometry_of(longer, up, up, &g, &err), GLINT_BAD_ARGUMENT);
    assert_string_equal(err.text, "N, L or V does not have unit length");
    assert_int_equal(glint_geometry_of(up, zero, up, &g, NULL), GLINT_BAD_ARGUMENT);
    assert_int_equal(glint_geometry_of(up, up, none, &g, NULL), GLINT_BAD_ARGUMENT);
    assert_int_equal(glint_geometry_of(up, up, down, &g, &err), GLINT_BAD_ARGUMENT);
    assert_string_equal(err.text, "L is opposite to V, so H is undefined");
}

static void each_model_takes_the_cosine_it_says(void **state)
{
    (void)state;
    const glint_geometry g = geometry(at(0, 0), at(0.5, 0), at(0.4, 2.5));
    for (int model = 0; model < GLINT_REFLECTANCE_COUNT; model++) {
        const glint_reflectance r = prepared((glint_reflectance_model)model, 20);
        const double intensity = glint_reflectance_intensity(&r, &g);
        const double brdf = glint_reflectance_brdf(&r, &g);
        switch (glint_reflectance_describe(r.model)->cosine) {
        case GLINT_REFLECTANCE_OF_NL:
            assert_true(fabs(intensity - g.nl) < 1e-15 && fabs(brdf - 1.0 / PI) < 1e-15);
            break;
        case GLINT_REFLECTANCE_OF_RV:
            assert_true(intensity == glint_reflectance_of_cosine(&r, g.rv) && brdf == intensity);
            break;
        case GLINT_REFLECTANCE_OF_NH:
            assert_true(intensity == glint_reflectance_of_cosine(&r, g.nh) && brdf == intensity);
            break;
        case GLINT_REFLECTANCE_OF_GEOMETRY:
            assert_true(fabs(intensity - PI * brdf * g.nl) < 1e-15 * intensity + 1e-300);
            break;
        }
        assert_true(brdf > 0.0);
    }
}

static void a_surface_turned_from_light_or_viewer_is_dark(void **state)
{
    (void)state;
    const glint_geometry dark[] = {
        geometry(at(0, 0), at(2.0, 0), at(0.5, 3.0)),
        geometry(at(0, 0), at(0.5, 0), at(2.0, 3.0)),
        geometry(at(0, 0), at(2.0, 0), at(2.1, 1.0)),
        {.nl = 0.0, .nv = 0.5, .nh = 0.5, .vh = 0.5, .rv = 0.5},
        {.nl = 0.5, .nv = 0.0, .nh = 0.5, .vh = 0.5, .rv = 0.5},
    };
    for (int model = 0; model < GLINT_REFLECTANCE_COUNT; model++) {
        const glint_reflectance r = prepared((glint_reflectance_model)model, 3);
        for (size_t i = 0; i < sizeof dark / sizeof dark[0]; i++) {
            assert_true(glint_reflectance_intensity(&r, &dark[i]) == 0.0);
            assert_true(glint_reflectance_brdf(&r, &dark[i]) == 0.0);
        }
    }
}

/* (2.20) */
static void light_and_viewer_may_change_places(void **state)
{
    (void)state;
    glint_random random = {seed_of_this_run()};
    const glint_vec3 n = at(0, 0);
    for (int model = 0; model < GLINT_REFLECTANCE_COUNT; model++) {
        const glint_reflectance r = prepared((glint_reflectance_model)model, 12);
        for (int i = 0; i < 1000; i++) {
            const glint_vec3 l = at(random_to(&random, 1.57), random_to(&random, 2 * PI));
            const glint_vec3 v = at(random_to(&random, 1.57), random_to(&random, 2 * PI));
            const glint_geometry there = geometry(n, l, v), back = geometry(n, v, l);
            const double brdf = glint_reflectance_brdf(&r, &there);
            assert_true(brdf >= 0.0 && isfinite(brdf));
            /* The device's cosine may fall on either side of a step. */
            const double step = model == GLINT_REFLECTANCE_DEVICE ? 1e-4 : 1e-12;
            assert_true(fabs(brdf - glint_reflectance_brdf(&r, &back)) <= step * fmax(brdf, 1.0));
        }
    }
}

/* With F = 1 and L = V = H at an angle with cosine c the BRDF is D·G/(4c²), G = min(1, 2c²): so D
 * can be had from it, and its integral ∫ D cos α dω, by midpoints. */
static void facets_fill_the_surface(void **state)
{
    (void)state;
    static const glint_reflectance_model models[] = {GLINT_REFLECTANCE_TORRANCE_SPARROW,
                                                     GLINT_REFLECTANCE_COOK_TORRANCE};
    static const double exponents[] = {0, 1, 10, 100, 1000};
    enum { PIECES = 200000 };
    for (int i = 0; i < 2 * 5; i++) {
        const glint_reflectance_parameters mirror = {.n = exponents[i / 2], .f0 = 1.0};
        glint_reflectance r;
        assert_int_equal(glint_reflectance_prepare(models[i % 2], &mirror, &r, NULL), GLINT_OK);
        double sum = 0.0;
        for (int j = 0; j < PIECES; j++) {
            const double angle = (j + 0.5) * 0.5 * PI / PIECES;
            const double c = cos(angle);
            const glint_geometry g = {.nl = c, .nv = c, .nh = c, .vh = 1.0, .rv = 2 * c * c - 1};
            const double d = glint_reflectance_brdf(&r, &g) * 4.0 * c * c / fmin(1.0, 2.0 * c * c);
            sum += d * c * sin(angle);
        }
        assert_true(fabs(2.0 * PI * sum * 0.5 * PI / PIECES - 1.0) < 1e-6);
    }
}

static void fresnel_has_its_known_ends(void **state)
{
    (void)state;
    const glint_geometry normal = {.nl = 1, .nv = 1, .nh = 1, .vh = 1, .rv = 1};
    static const double reflectances[] = {0.0, 0.04, 0.5, 0.99, 1.0};
    glint_reflectance r;
    for (int i = 0; i < 5; i++) {
        const glint_reflectance_parameters parameters = {.n = 10, .f0 = reflectances[i]};
        assert_int_equal(
            glint_reflectance_prepare(GLINT_REFLECTANCE_COOK_TORRANCE, &parameters, &r, NULL),
            GLINT_OK);
        /* D = 1/(π m²), G = 1 */
        const double d = (10.0 + 2.0) / (2.0 * PI);
        assert_true(fabs(glint_reflectance_brdf(&r, &normal) - reflectances[i] * d / 4.0) < 1e-12);
    }
    /* Towards grazing incidence everything reflects: F → 1 for every F0. */
    const glint_reflectance_parameters glass = {.n = 10, .f0 = 0.04}, mirror = {.n = 10, .f0 = 1.0};
    glint_reflectance m;
    assert_int_equal(glint_reflectance_prepare(GLINT_REFLECTANCE_COOK_TORRANCE, &glass, &r, NULL),
                     GLINT_OK);
    assert_int_equal(glint_reflectance_prepare(GLINT_REFLECTANCE_COOK_TORRANCE, &mirror, &m, NULL),
                     GLINT_OK);
    const glint_geometry grazing = geometry(at(0, 0), at(PI / 2 - 1e-6, 0), at(PI / 2 - 1e-6, PI));
    const double f = glint_reflectance_brdf(&r, &grazing) / glint_reflectance_brdf(&m, &grazing);
    assert_true(f > 0.9999 && f <= 1.0);
    /* Brewster's angle of glass, tan = 1.5: half of the s part alone, ((1−η²)/(1+η²))²/2. */
    const double brewster = atan(1.5);
    const glint_geometry polarising = geometry(at(0, 0), at(brewster, 0), at(brewster, PI));
    const double at_brewster =
        glint_reflectance_brdf(&r, &polarising) / glint_reflectance_brdf(&m, &polarising);
    assert_true(fabs(at_brewster - 0.5 * pow(1.25 / 3.25, 2)) < 1e-12);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(cosines_are_those_of_the_vectors),
        cmocka_unit_test(directions_that_are_none_are_refused),
        cmocka_unit_test(each_model_takes_the_cosine_it_says),
        cmocka_unit_test(a_surface_turned_from_light_or_viewer_is_dark),
        cmocka_unit_test(light_and_viewer_may_change_places),
        cmocka_unit_test(facets_fill_the_surface),
        cmocka_unit_test(fresnel_has_its_known_ends),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
