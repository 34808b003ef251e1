/* Quadratic interpolation of intensity: the polynomial against one found by exact rationals, its
 * limits, whole frames, by the span unit too, and the listing's slips. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>
#include <gmp.h>

#include "../seed.h"
#include "circuit/random.h"
#include "render/listing.h"
#include "render/quadratic_band.h"
#include "studio.h"

enum { TRIANGLES = 2000, COORDINATES = 6 };

static uint64_t seed;

static int draw_seed(void **state)
{
    (void)state;
    seed = seed_of_this_run();
    return 0;
}

/* A triangle on a lattice of 1/16 pixel, and its six values, corners first; in the order of
 * quadratic.h. */
typedef struct lit_triangle {
    int x[3], y[3]; /* sixteenths */
    double value[6];
} lit_triangle;

static int among(glint_random *random, int count)
{
    return (int)glint_random_below(random, (uint32_t)count);
}

static int doubled_area(const lit_triangle *t)
{
    return (t->x[1] - t->x[0]) * (t->y[2] - t->y[0]) - (t->y[1] - t->y[0]) * (t->x[2] - t->x[0]);
}

/* From the top down, not degenerate. Some have a flat top. */
static lit_triangle draw(glint_random *random)
{
    lit_triangle t;
    do {
        for (int i = 0; i < 3; i++) {
            t.x[i] = among(random, 4000);
            t.y[i] = i == 1 && among(random, 8) == 0 ? t.y[0] : among(random, 4000);
        }
    } while (doubled_area(&t) == 0 || t.y[0] > t.y[1] || t.y[1] > t.y[2]);
    for (int i = 0; i < 6; i++)
        t.value[i] = among(random, 4) == 0 ? 255 * among(random, 2) : among(random, 256);
    return t;
}

/* ---- The polynomial by elimination, in rationals ---- */

typedef mpq_t row_of_six[COORDINATES + 1];

/* 1, y, x, y², xy, x² of a place given in 1/32 pixel from corner 1. */
static void set_row(row_of_six row, int x, int y)
{
    const long terms[COORDINATES] = {1024, 32L * y, 32L * x, (long)y * y, (long)x * y, (long)x * x};
    for (int i = 0; i < COORDINATES; i++) {
        mpq_set_si(row[i], terms[i], 1024);
        mpq_canonicalize(row[i]);
    }
}

/* Gauss and Jordan: the last column becomes P0 … P5. */
static void eliminate(row_of_six row[COORDINATES])
{
    mpq_t factor;
    mpq_init(factor);
    for (int i = 0; i < COORDINATES; i++) {
        int pivot = i;
        while (mpq_sgn(row[pivot][i]) == 0)
            pivot++;
        for (int k = 0; k <= COORDINATES; k++)
            mpq_swap(row[i][k], row[pivot][k]);
        for (int k = COORDINATES; k >= i; k--)
            mpq_div(row[i][k], row[i][k], row[i][i]);
        for (int other = 0; other < COORDINATES; other++)
            for (int k = COORDINATES; other != i && k >= i; k--) {
                mpq_mul(factor, row[other][i], row[i][k]);
                mpq_sub(row[other][k], row[other][k], factor);
            }
    }
    mpq_clear(factor);
}

static void solve(const lit_triangle *t, mpq_t p[COORDINATES])
{
    row_of_six row[COORDINATES];
    for (int i = 0; i < COORDINATES; i++)
        for (int k = 0; k <= COORDINATES; k++)
            mpq_init(row[i][k]);
    for (int i = 0; i < COORDINATES; i++) {
        const int a = i < 3 ? i : glint_edge_ends[i - 3][0];
        const int b = i < 3 ? i : glint_edge_ends[i - 3][1];
        set_row(row[i], t->x[a] + t->x[b] - 2 * t->x[0], t->y[a] + t->y[b] - 2 * t->y[0]);
        mpq_set_d(row[i][COORDINATES], t->value[i]);
    }
    eliminate(row);
    for (int i = 0; i < COORDINATES; i++)
        mpq_set(p[i], row[i][COORDINATES]);
    for (int i = 0; i < COORDINATES; i++)
        for (int k = 0; k <= COORDINATES; k++)
            mpq_clear(row[i][k]);
}

/* p at a place in 1/32 pixel from corner 1. */
static double value_at(mpq_t p[COORDINATES], int x, int y)
{
    row_of_six row;
    mpq_t sum;
    mpq_init(sum);
    for (int i = 0; i <= COORDINATES; i++)
        mpq_init(row[i]);
    set_row(row, x, y);
    for (int i = 0; i < COORDINATES; i++) {
        mpq_mul(row[i], row[i], p[i]);
        mpq_add(sum, sum, row[i]);
    }
    const double value = mpq_get_d(sum);
    for (int i = 0; i <= COORDINATES; i++)
        mpq_clear(row[i]);
    mpq_clear(sum);
    return value;
}

static void pixels_of(const lit_triangle *t, double x[3], double y[3])
{
    for (int i = 0; i < 3; i++) {
        x[i] = t->x[i] / 16.0;
        y[i] = t->y[i] / 16.0;
    }
}

/* Relative to the largest of the values that go in, and to how thin the triangle is. */
static double close_to(double value, double scale)
{
    return 1e-9 * (fabs(value) + scale);
}

static void check_triangle(const lit_triangle *t, glint_random *random, mpq_t p[COORDINATES])
{
    double x[3], y[3];
    pixels_of(t, x, y);
    const double area = doubled_area(t);
    const glint_quadratic q = glint_quadratic_of(t->value, t->value + 3);
    const glint_listing l =
        glint_listing_of(x, y, t->value, t->value + 3, 0, among(random, 2) != 0);
    for (int i = 0; i < COORDINATES; i++) {
        const double exact = mpq_get_d(p[i]);
        assert_true(fabs(l.p[i] - exact) <= close_to(exact, 1e-3));
    }
    for (int k = 0; k < 8; k++) { /* anywhere near the triangle */
        const int px = among(random, 4000) - t->x[0];
        const int py = among(random, 4000) - t->y[0];
        const int x2 = t->x[1] - t->x[0], y2 = t->y[1] - t->y[0];
        const int x3 = t->x[2] - t->x[0], y3 = t->y[2] - t->y[0];
        const double u = (px * y3 - py * x3) / area;
        const double v = (x2 * py - y2 * px) / area;
        const double exact = value_at(p, 2 * px, 2 * py);
        assert_true(fabs(glint_quadratic_at(&q, u, v) - exact) <=
                    close_to(exact, 1e4 * (1.0 + u * u + v * v)));
    }
}

static void the_polynomial_is_that_of_the_rationals(void **state)
{
    (void)state;
    glint_random random;
    mpq_t p[COORDINATES];
    int flat = 0;
    random.state = seed;
    for (int i = 0; i < COORDINATES; i++)
        mpq_init(p[i]);
    for (int n = 0; n < TRIANGLES; n++) {
        const lit_triangle t = draw(&random);
        flat += t.y[0] == t.y[1];
        solve(&t, p);
        check_triangle(&t, &random, p);
    }
    for (int i = 0; i < COORDINATES; i++)
        mpq_clear(p[i]);
    assert_true(flat > 0);
}

/* ---- Limits ---- */

static void the_six_values_come_out_exactly(void **state)
{
    (void)state;
    static const double weight[6][2] = {{0, 0}, {1, 0}, {0, 1}, {0.5, 0}, {0, 0.5}, {0.5, 0.5}};
    glint_random random;
    random.state = seed;
    for (int n = 0; n < TRIANGLES; n++) {
        const lit_triangle t = draw(&random);
        const glint_quadratic q = glint_quadratic_of(t.value, t.value + 3);
        for (int i = 0; i < 6; i++)
            assert_true(glint_quadratic_at(&q, weight[i][0], weight[i][1]) == t.value[i]);
    }
}

/* What slip `means` does: the curvature is exactly 0, and the rest is Gouraud's plane. */
static void means_in_the_middles_make_a_plane(void **state)
{
    (void)state;
    glint_random random;
    random.state = seed;
    for (int n = 0; n < TRIANGLES; n++) {
        const lit_triangle t = draw(&random);
        double middle[3], x[3], y[3];
        for (int i = 0; i < 3; i++)
            middle[i] = (t.value[glint_edge_ends[i][0]] + t.value[glint_edge_ends[i][1]]) / 2.0;
        const glint_quadratic q = glint_quadratic_of(t.value, middle);
        assert_true(q.c12 == 0.0 && q.c13 == 0.0 && q.c23 == 0.0);
        assert_true(q.c2 == t.value[1] - t.value[0] && q.c3 == t.value[2] - t.value[0]);
        pixels_of(&t, x, y);
        const glint_listing l =
            glint_listing_of(x, y, t.value, t.value + 3, 1u << GLINT_SLIP_MEANS, true);
        assert_true(l.p[3] == 0.0 && l.p[4] == 0.0 && l.p[5] == 0.0);
    }
}

/* −1/3 … 4/3 of the range of the values, on a lattice of the triangle with all 64 choices of ends;
 * both ends are reached, at the centroid. */
static void the_range_on_the_triangle_is_limited(void **state)
{
    (void)state;
    enum { STEPS = 60 };
    double least = 0.0, most = 0.0;
    for (int choice = 0; choice < 64; choice++) {
        double value[6];
        for (int i = 0; i < 6; i++)
            value[i] = (choice >> i & 1) * 255.0;
        const glint_quadratic q = glint_quadratic_of(value, value + 3);
        for (int i = 0; i <= STEPS; i++)
            for (int k = 0; k <= STEPS - i; k++) {
                const double at = glint_quadratic_at(&q, (double)i / STEPS, (double)k / STEPS);
                least = fmin(least, at);
                most = fmax(most, at);
            }
    }
    assert_true(fabs(least + 85.0) < 1e-9);
    assert_true(fabs(most - 340.0) < 1e-9);
}

static void levels_are_rounded_and_held(void **state)
{
    (void)state;
    assert_int_equal(glint_quadratic_level(-0.0), 0);
    assert_int_equal(glint_quadratic_level(-85.0), 0);
    assert_int_equal(glint_quadratic_level(0.49), 0);
    assert_int_equal(glint_quadratic_level(0.5), 1);
    assert_int_equal(glint_quadratic_level(254.49), 254);
    assert_int_equal(glint_quadratic_level(254.5), 255);
    assert_int_equal(glint_quadratic_level(1e300), 255);
    assert_int_equal(glint_quadratic_level((double)INFINITY), 255);
    assert_int_equal(glint_quadratic_level((double)NAN), 0);
}

/* ---- Whole frames ---- */

static glint_scene scene_of(const glint_mesh *mesh, glint_shading shading)
{
    glint_scene scene = {.mesh = mesh};
    glint_scene_defaults(&scene);
    scene.shading = shading;
    return scene;
}

static glint_mesh *sphere(int density)
{
    glint_mesh *mesh = NULL;
    glint_error err = {""};
    assert_int_equal(glint_mesh_sphere(density, &mesh, &err), GLINT_OK);
    return mesh;
}

static double nmse(const studio *a, const studio *b)
{
    glint_image_difference difference;
    assert_int_equal(glint_image_compare(a->image, b->image, &difference, NULL), GLINT_OK);
    assert_int_equal(difference.mask_pixels, 0);
    return difference.nmse;
}

/* An error of the third order where Gouraud's is of the second: with triangles half as large it
 * falls to less than a quarter, as far as eight bits of the six values allow. */
static void it_is_nearer_to_phong_than_gouraud(void **state)
{
    (void)state;
    double before = 1.0;
    for (int density = 16; density <= 64; density *= 2) {
        glint_mesh *mesh = sphere(density);
        studio phong = open_studio(240, 240, 2, GLINT_BACKEND_REAL);
        studio other = open_studio(240, 240, 2, GLINT_BACKEND_REAL);
        glint_scene scene = scene_of(mesh, GLINT_SHADING_PHONG);
        scene.n = 10;
        shoot(&phong, &scene);
        scene.shading = GLINT_SHADING_GOURAUD;
        shoot(&other, &scene);
        const double gouraud = nmse(&phong, &other);
        scene.shading = GLINT_SHADING_QUADRATIC;
        shoot(&other, &scene);
        assert_int_equal(other.stats.highlights, 6 * other.stats.drawn);
        const double quadratic = nmse(&phong, &other);
        assert_true(quadratic < gouraud / 4.0);
        assert_true(quadratic < before / 4.0 || quadratic < 4e-5);
        before = quadratic;
        close_studio(&other);
        close_studio(&phong);
        glint_mesh_destroy(mesh);
    }
}

/* ---- By the span unit ---- */

/* Within its bound the unit's value is half a level from the polynomial's, so rounded one level at
 * most; with any number of fraction bits, as longer spans are cut. */
static void the_unit_is_within_a_level(void **state)
{
    (void)state;
    static const int fractions[] = {8, 12, GLINT_QUADRATIC_SPAN_FRACTION_DEFAULT, 26};
    static const int densities[] = {4, 8, 64, 512};
    studio exact = open_studio(400, 300, 2, GLINT_BACKEND_C);
    studio unit = open_studio(400, 300, 2, GLINT_BACKEND_C);
    for (size_t d = 0; d < sizeof densities / sizeof densities[0]; d++) {
        glint_mesh *mesh = sphere(densities[d]);
        glint_scene scene = scene_of(mesh, GLINT_SHADING_QUADRATIC);
        scene.fraction = GLINT_FRACTION_EXACT;
        shoot(&exact, &scene);
        assert_int_equal(exact.stats.spans, 0);
        for (size_t i = 0; i < sizeof fractions / sizeof fractions[0]; i++) {
            glint_image_difference difference;
            scene.fraction = fractions[i];
            shoot(&unit, &scene);
            assert_true(unit.stats.spans > 0);
            assert_int_equal(unit.stats.span_clocks, 0);
            assert_int_equal(glint_image_compare(exact.image, unit.image, &difference, NULL),
                             GLINT_OK);
            assert_int_equal(difference.mask_pixels, 0);
            assert_true(difference.largest <= 1);
        }
        glint_mesh_destroy(mesh);
    }
    close_studio(&unit);
    close_studio(&exact);
}

/* From near and from within, cut by the near plane and by the frame; with triangles smaller than a
 * pixel. A pixel a clock, and one more for each run. */
static void c_and_rtl_give_the_same_bits(void **state)
{
    (void)state;
    static const int fractions[] = {8, GLINT_QUADRATIC_SPAN_FRACTION_DEFAULT, 26};
    static const int densities[] = {4, 16, 512};
    studio c = open_studio(300, 200, 2, GLINT_BACKEND_C);
    studio rtl = open_studio(300, 200, 2, GLINT_BACKEND_RTL);
    for (size_t d = 0; d < sizeof densities / sizeof densities[0]; d++) {
        glint_mesh *mesh = sphere(densities[d]);
        for (int i = 0; i < 6; i++) {
            glint_image_difference difference;
            glint_scene scene = scene_of(mesh, GLINT_SHADING_QUADRATIC);
            scene.fraction = fractions[i % 3];
            scene.distance = i < 3 ? 0.0f : 1.05f;
            shoot(&c, &scene);
            shoot(&rtl, &scene);
            assert_int_equal(glint_image_compare(c.image, rtl.image, &difference, NULL), GLINT_OK);
            assert_int_equal(difference.differing_pixels + difference.mask_pixels, 0);
            assert_true(difference.object_pixels > 0);
            assert_int_equal(c.stats.spans, rtl.stats.spans);
            assert_true(rtl.stats.span_clocks >= rtl.stats.fragments);
        }
        glint_mesh_destroy(mesh);
    }
    close_studio(&rtl);
    close_studio(&c);
}

/* Numbers that a short span does not use are 0, however steep it is across the triangle. */
static void short_spans_have_no_unused_numbers(void **state)
{
    (void)state;
    const double value[6] = {0.0, 255.0, 0.0, 255.0, 0.0, 255.0};
    const glint_quadratic q[3] = {glint_quadratic_of(value, value + 3),
                                  glint_quadratic_of(value, value + 3),
                                  glint_quadratic_of(value, value + 3)};
    const glint_weights w = {0.25, 0.25, 300.0, -500.0};
    const glint_quadratic_walk one = glint_quadratic_walk_of(q, &w, 1, 18);
    const glint_quadratic_walk two = glint_quadratic_walk_of(q, &w, 2, 18);
    const glint_quadratic_walk three = glint_quadratic_walk_of(q, &w, 3, 18);
    for (int c = 0; c < 3; c++) {
        assert_true(one.start[c] == three.start[c] && two.start[c] == three.start[c]);
        assert_true(one.first[c] == 0 && one.second[c] == 0);
        assert_true(two.first[c] == three.first[c] && two.first[c] != 0);
        assert_true(two.second[c] == 0 && three.second[c] != 0);
    }
}

/* The set-up's three numbers against the polynomial's values at the first three pixels. */
static void the_three_numbers_are_differences(void **state)
{
    (void)state;
    glint_random random = {seed};
    for (int n = 0; n < TRIANGLES; n++) {
        const lit_triangle t = draw(&random);
        const glint_quadratic one = glint_quadratic_of(t.value, t.value + 3);
        const glint_quadratic q[3] = {one, one, one};
        const glint_weights w = {among(&random, 100) / 250.0, among(&random, 100) / 250.0,
                                 among(&random, 101) / 5000.0 - 0.01,
                                 among(&random, 101) / 5000.0 - 0.01};
        const glint_quadratic_walk walk = glint_quadratic_walk_of(q, &w, 3, 26);
        double value[3];
        for (int i = 0; i < 3; i++)
            value[i] = glint_quadratic_at(&one, w.at1 + i * w.step1, w.at2 + i * w.step2);
        const double code = ldexp(1.0, -26);
        assert_true(fabs((double)walk.start[0] * code - value[0]) <= 0.51 * code);
        assert_true(fabs((double)walk.first[0] * code - (value[1] - value[0])) <= 0.51 * code);
        assert_true(fabs((double)walk.second[0] * code - (value[2] - 2 * value[1] + value[0])) <=
                    0.51 * code);
    }
}

static studio shot_with_slips(const glint_mesh *mesh, unsigned slips)
{
    studio s = open_studio(200, 200, 2, GLINT_BACKEND_REAL);
    glint_scene scene = scene_of(mesh, GLINT_SHADING_QUADRATIC_LISTING);
    scene.n = 20;
    scene.slips = slips;
    shoot(&s, &scene);
    return s;
}

static glint_image_difference difference_of(const studio *a, const studio *b)
{
    glint_image_difference difference;
    assert_int_equal(glint_image_compare(a->image, b->image, &difference, NULL), GLINT_OK);
    return difference;
}

/* Without slips the listing is the corrected form. Each slip alone is seen, and so it is with the
 * others but those that hide it: a grey picture shows no other slip; means leave no curvature for a
 * wrong factor. */
static void every_slip_is_seen(void **state)
{
    (void)state;
    glint_mesh *mesh = sphere(8);
    studio none = shot_with_slips(mesh, 0);
    studio exact = open_studio(200, 200, 2, GLINT_BACKEND_REAL);
    glint_scene scene = scene_of(mesh, GLINT_SHADING_QUADRATIC);
    scene.n = 20;
    shoot(&exact, &scene);
    assert_int_equal(difference_of(&none, &exact).mask_pixels, 0);
    assert_true(difference_of(&none, &exact).largest <= 1); /* exactly half-way between levels */
    for (int slip = 0; slip < GLINT_SLIP_COUNT; slip++) {
        studio one = shot_with_slips(mesh, 1u << slip);
        assert_true(difference_of(&none, &one).largest > 20);
        assert_int_equal(difference_of(&none, &one).mask_pixels, 0);
        close_studio(&one);
    }
    close_studio(&exact);
    close_studio(&none);
    glint_mesh_destroy(mesh);
}

/* With means in the middles, nothing is seen of a wrong factor, and Gouraud's picture is the
 * listing's but for what its unit's runs from pixel to pixel do, which take a corner for the
 * nearest pixel's centre. */
static void means_make_it_gouraud(void **state)
{
    (void)state;
    glint_mesh *mesh = sphere(8);
    studio means = shot_with_slips(mesh, 1u << GLINT_SLIP_MEANS);
    studio factor = shot_with_slips(mesh, 1u << GLINT_SLIP_MEANS | 1u << GLINT_SLIP_FACTOR);
    studio gouraud = open_studio(200, 200, 2, GLINT_BACKEND_REAL);
    glint_scene scene = scene_of(mesh, GLINT_SHADING_GOURAUD);
    scene.n = 20;
    shoot(&gouraud, &scene);
    assert_int_equal(difference_of(&means, &factor).differing_pixels, 0);
    assert_true(difference_of(&means, &gouraud).nmse < 1e-4); /* "no visible difference" */
    close_studio(&gouraud);
    close_studio(&factor);
    close_studio(&means);
    glint_mesh_destroy(mesh);
}

/* A triangle seen from its edge, or shrunk to a point, is not drawn: Δ = 0 never gets as far as a
 * division. */
static void degenerate_triangles_are_not_drawn(void **state)
{
    (void)state;
    glint_mesh *mesh = sphere(8);
    for (size_t i = 0; i < mesh->triangle_count; i++)
        if (i % 2 == 0)
            mesh->index[3 * i + 1] = mesh->index[3 * i];
    for (int shading = GLINT_SHADING_QUADRATIC; shading <= GLINT_SHADING_QUADRATIC_LISTING;
         shading++) {
        studio s = open_studio(100, 100, 1, GLINT_BACKEND_REAL);
        const glint_scene scene = scene_of(mesh, (glint_shading)shading);
        shoot(&s, &scene);
        assert_true(s.stats.drawn > 0 && s.stats.drawn <= mesh->triangle_count / 2);
        close_studio(&s);
    }
    glint_mesh_destroy(mesh);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_polynomial_is_that_of_the_rationals),
        cmocka_unit_test(the_six_values_come_out_exactly),
        cmocka_unit_test(means_in_the_middles_make_a_plane),
        cmocka_unit_test(the_range_on_the_triangle_is_limited),
        cmocka_unit_test(levels_are_rounded_and_held),
        cmocka_unit_test(it_is_nearer_to_phong_than_gouraud),
        cmocka_unit_test(the_unit_is_within_a_level),
        cmocka_unit_test(c_and_rtl_give_the_same_bits),
        cmocka_unit_test(short_spans_have_no_unused_numbers),
        cmocka_unit_test(the_three_numbers_are_differences),
        cmocka_unit_test(every_slip_is_seen),
        cmocka_unit_test(means_make_it_gouraud),
        cmocka_unit_test(degenerate_triangles_are_not_drawn),
    };
    return cmocka_run_group_tests(tests, draw_seed, NULL);
}
