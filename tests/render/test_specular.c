/* Highlights by reflectance models: every pixel against the model's value for vectors found by
 * another way, relations between models, and what is refused. */
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "reflectance/vec3.h"
#include "render/pick.h"
#include "studio.h"

#define RADIANS (3.14159265358979323846 / 180.0)

static glint_mesh *sphere(int density)
{
    glint_mesh *mesh = NULL;
    assert_int_equal(glint_mesh_sphere(density, &mesh, NULL), GLINT_OK);
    return mesh;
}

static glint_scene scene_of(const glint_mesh *mesh, glint_reflectance_model model, uint16_t n)
{
    glint_scene scene = {.mesh = mesh};
    glint_scene_defaults(&scene);
    scene.by_model = true;
    scene.specular = model;
    scene.n = n;
    return scene;
}

/* A white highlight on black: a component is 255 times the value. */
static glint_scene white_on_black(const glint_mesh *mesh, glint_reflectance_model model, uint16_t n)
{
    glint_scene scene = scene_of(mesh, model, n);
    scene.ka = 0.0f;
    scene.kd = 0.0f;
    scene.ks = 1.0f;
    return scene;
}

static int largest_difference(const glint_image *a, const glint_image *b)
{
    glint_image_difference difference;
    assert_int_equal(glint_image_compare(a, b, &difference, NULL), GLINT_OK);
    assert_int_equal(difference.mask_pixels, 0);
    assert_true(difference.object_pixels > 1000);
    return difference.largest;
}

static const glint_reflectance_info *info_of(int model)
{
    return glint_reflectance_describe((glint_reflectance_model)model);
}

/* Values above 1 are the rule for these. */
static bool is_normalised(int model)
{
    return model == GLINT_REFLECTANCE_BLINN_NORMALIZED ||
           model == GLINT_REFLECTANCE_ENERGY_CONSERVING ||
           info_of(model)->cosine == GLINT_REFLECTANCE_OF_GEOMETRY;
}

/* ---- One triangle, every pixel -------------------------------------------------------------- */

#define FRAME_WIDTH  96
#define FRAME_HEIGHT 72
#define DISTANCE     1.6

/* Steep against the view, a different normal at each corner, its bounding sphere about the origin
 * with radius 1. */
typedef struct steep_triangle {
    float position[9], normal[9];
    uint32_t index[3];
    glint_mesh mesh;
} steep_triangle;

static void make_triangle(steep_triangle *t)
{
    *t = (steep_triangle){
        .position = {-0.6f, -0.6f, 0.52915026f, 0.6f, -0.6f, -0.52915026f, 0.6f, 0.6f,
                     -0.52915026f},
        .index = {0, 1, 2},
    };
    const glint_vec3 lean[3] = {{-0.9, 0.4, 1.0}, {0.3, 0.3, 0.8}, {-0.5, 0.9, 0.4}};
    for (int i = 0; i < 3; i++) {
        glint_vec3_store(glint_vec3_scale(lean[i], 1.0 / glint_vec3_length(lean[i])),
                         &t->normal[3 * i]);
    }
    t->mesh = (glint_mesh){.vertex_count = 3,
                           .position = t->position,
                           .normal = t->normal,
                           .triangle_count = 1,
                           .index = t->index};
}

static glint_vec3 unit(glint_vec3 v)
{
    return glint_vec3_scale(v, 1.0 / glint_vec3_length(v));
}

/* A corner from the eye, which looks along −z. */
static glint_vec3 from_eye(const steep_triangle *t, int corner)
{
    glint_vec3 p = glint_vec3_of(&t->position[3 * corner]);
    p.z -= DISTANCE;
    return p;
}

static glint_vec3 ray(const glint_scene *scene, int x, int y)
{
    const double focal = 0.5 * FRAME_HEIGHT / tan(0.5 * (double)scene->fov * RADIANS);
    return (glint_vec3){(x + 0.5 - 0.5 * FRAME_WIDTH) / focal,
                        (0.5 * FRAME_HEIGHT - y - 0.5) / focal, -1.0};
}

/* Where a ray meets the triangle, as shares of the corners: volumes of the tetrahedra between the
 * ray and two corners. No perspective in between. */
static void shares_of(const steep_triangle *t, glint_vec3 along, double share[3])
{
    double sum = 0.0;
    for (int i = 0; i < 3; i++) {
        share[i] = glint_vec3_dot(
            along, glint_vec3_cross(from_eye(t, (i + 1) % 3), from_eye(t, (i + 2) % 3)));
        sum += share[i];
    }
    for (int i = 0; i < 3; i++)
        share[i] /= sum;
}

static glint_geometry geometry_at(const glint_scene *scene, glint_vec3 normal, glint_vec3 to_point)
{
    glint_geometry geometry;
    glint_error err;
    if (glint_geometry_of(unit(normal), unit(glint_vec3_of(scene->light)),
                          glint_vec3_scale(unit(to_point), -1.0), &geometry, &err) != GLINT_OK)
        fail_msg("%s", err.text);
    return geometry;
}

/* The value by the library, in double precision and one by one. */
static double value_of(const glint_scene *scene, const glint_geometry *geometry)
{
    glint_reflectance prepared;
    const glint_reflectance_parameters parameters = {.n = scene->n, .f0 = (double)scene->f0};
    assert_int_equal(glint_reflectance_prepare(scene->specular, &parameters, &prepared, NULL),
                     GLINT_OK);
    if (geometry->nl <= 0.0)
        return 0.0;
    switch (info_of((int)scene->specular)->cosine) {
    case GLINT_REFLECTANCE_OF_NL:
        return 0.0; /* no highlight */
    case GLINT_REFLECTANCE_OF_RV:
        return glint_reflectance_of_cosine(&prepared, geometry->rv);
    case GLINT_REFLECTANCE_OF_NH:
        return glint_reflectance_of_cosine(&prepared, geometry->nh);
    default:
        return glint_reflectance_intensity(&prepared, geometry);
    }
}

static double level_of(double value)
{
    return value < 1.0 ? 255.0 * value : 255.0;
}

static glint_scene triangle_scene(const steep_triangle *t, int model, uint16_t n)
{
    glint_scene scene = white_on_black(&t->mesh, (glint_reflectance_model)model, n);
    scene.yaw = 0.0f;
    scene.pitch = 0.0f;
    scene.distance = (float)DISTANCE;
    scene.f0 = 0.6f;
    return scene;
}

/* A cosine in single precision is off by some 1e-7; a lobe is by n times that, and by its height
 * times more. Microfacet models here stay below 40. */
static double tolerance_of(int model, uint16_t n)
{
    return 0.5 + 255.0 * 1e-6 * n * (is_normalised(model) ? 40.0 : 1.0);
}

static void check_pixels(const steep_triangle *t, const studio *s, const glint_scene *scene,
                         double tolerance)
{
    int brightest = 0;
    for (int y = 0; y < FRAME_HEIGHT; y++) {
        for (int x = 0; x < FRAME_WIDTH; x++) {
            const int at = y * FRAME_WIDTH + x;
            if (!s->image->object[at])
                continue;
            double share[3];
            glint_vec3 normal = {0, 0, 0};
            shares_of(t, ray(scene, x, y), share);
            for (int i = 0; i < 3; i++) {
                normal = glint_vec3_add(
                    normal, glint_vec3_scale(glint_vec3_of(&t->normal[3 * i]), share[i]));
            }
            const glint_geometry geometry = geometry_at(scene, normal, ray(scene, x, y));
            const double expected = level_of(value_of(scene, &geometry));
            const int got = s->image->rgb[3 * at];
            brightest = got > brightest ? got : brightest;
            if (fabs(expected - got) > tolerance) {
                fail_msg("%s, n = %g, pixel %d,%d: %d instead of %.3f",
                         glint_reflectance_names[scene->specular], scene->n, x, y, got, expected);
            }
        }
    }
    if (brightest < 50 && info_of((int)scene->specular)->cosine != GLINT_REFLECTANCE_OF_NL) {
        fail_msg("%s, n = %g: the highlight is not in the frame (%d)",
                 glint_reflectance_names[scene->specular], scene->n, brightest);
    }
}

static void every_pixel_has_the_value_of_its_vectors(void **state)
{
    (void)state;
    static const uint16_t exponents[] = {1, 7, 80, 400};
    steep_triangle t;
    make_triangle(&t);
    studio s = open_studio(FRAME_WIDTH, FRAME_HEIGHT, 2, GLINT_BACKEND_REAL);
    for (int model = 0; model < GLINT_REFLECTANCE_COUNT; model++) {
        for (size_t i = 0; i < sizeof exponents / sizeof exponents[0]; i++) {
            const glint_scene scene = triangle_scene(&t, model, exponents[i]);
            shoot(&s, &scene);
            assert_true(s.stats.fragments > 500);
            assert_int_equal(s.stats.highlights, s.stats.fragments);
            check_pixels(&t, &s, &scene, tolerance_of(model, exponents[i]));
        }
    }
    close_studio(&s);
}

/* Flat: the centroid with the plane's normal. At vertices: their values, interpolated on the object
 * and rounded twice. */
static void flat_and_gouraud_light_points_by_the_model(void **state)
{
    (void)state;
    steep_triangle t;
    make_triangle(&t);
    studio s = open_studio(FRAME_WIDTH, FRAME_HEIGHT, 2, GLINT_BACKEND_REAL);
    for (int model = 0; model < GLINT_REFLECTANCE_COUNT; model++) {
        glint_scene scene = triangle_scene(&t, model, 3);
        const glint_vec3 a = from_eye(&t, 0), b = from_eye(&t, 1), c = from_eye(&t, 2);
        const glint_vec3 plane = glint_vec3_cross(glint_vec3_sub(b, a), glint_vec3_sub(c, a));
        const glint_vec3 centroid =
            glint_vec3_scale(glint_vec3_add(a, glint_vec3_add(b, c)), 1.0 / 3.0);
        const glint_geometry middle = geometry_at(&scene, plane, centroid);
        const double flat = level_of(value_of(&scene, &middle));
        double corner[3];
        for (int i = 0; i < 3; i++) {
            const glint_geometry at =
                geometry_at(&scene, glint_vec3_of(&t.normal[3 * i]), from_eye(&t, i));
            corner[i] = level_of(value_of(&scene, &at));
        }
        for (int shading = 0; shading < 2; shading++) {
            scene.shading = shading == 0 ? GLINT_SHADING_FLAT : GLINT_SHADING_GOURAUD_PERSPECTIVE;
            shoot(&s, &scene);
            assert_int_equal(s.stats.highlights, shading == 0 ? 1 : 3);
            for (int at = 0; at < FRAME_WIDTH * FRAME_HEIGHT; at++) {
                if (s.image->object[at]) {
                    double share[3];
                    shares_of(&t, ray(&scene, at % FRAME_WIDTH, at / FRAME_WIDTH), share);
                    const double expected =
                        shading == 0
                            ? flat
                            : share[0] * corner[0] + share[1] * corner[1] + share[2] * corner[2];
                    assert_true(fabs(expected - s.image->rgb[3 * at]) < 1.01);
                }
            }
        }
    }
    close_studio(&s);
}

/* ---- Between models -------------------------------------------------------------------------- */

/* The default backend real rounds the cosine to 18 bits: half a code, half a code in the light's
 * single precision, and the slope 2σ ≤ 2·1024/3 of W make 255·2·341.4·2^-18 = 0.67 of a level. */
static void the_cosine_quadratic_is_the_default_but_for_the_code(void **state)
{
    (void)state;
    static const uint16_t exponents[] = {0, 1, 2, 10, 80, 300, 1023};
    glint_mesh *mesh = sphere(64);
    studio plain = open_studio(320, 240, 2, GLINT_BACKEND_REAL);
    studio model = open_studio(320, 240, 2, GLINT_BACKEND_REAL);
    for (size_t i = 0; i < sizeof exponents / sizeof exponents[0]; i++) {
        glint_scene scene = scene_of(mesh, GLINT_REFLECTANCE_COSINE_QUADRATIC, exponents[i]);
        shoot(&model, &scene);
        scene.by_model = false;
        shoot(&plain, &scene);
        assert_in_range(largest_difference(plain.image, model.image), 0, 1);
    }
    close_studio(&plain);
    close_studio(&model);
    glint_mesh_destroy(mesh);
}

/* W is the C model's to the bit; W·Ks is rounded here, and by the device after its own product. */
static void the_device_is_the_c_backend(void **state)
{
    (void)state;
    glint_mesh *mesh = sphere(64);
    studio c = open_studio(320, 240, 2, GLINT_BACKEND_C);
    studio real = open_studio(320, 240, 2, GLINT_BACKEND_REAL);
    for (uint16_t n = 5; n < 1000; n = (uint16_t)(n * 3)) {
        glint_scene scene = scene_of(mesh, GLINT_REFLECTANCE_DEVICE, n);
        shoot(&real, &scene);
        scene.by_model = false;
        shoot(&c, &scene);
        assert_in_range(largest_difference(c.image, real.image), 0, 1);
    }
    close_studio(&c);
    close_studio(&real);
    glint_mesh_destroy(mesh);
}

/* With the light behind the eye R·V = cos 2θ and N·H = cos θ: cosⁿ2θ and cos⁴ⁿθ are alike up to
 * n·θ⁴·e^(−2nθ²), at most e^-2/n: 1.7 levels for n = 20. One more for each rounding, and for V,
 * which is half a degree off at the frame's rim. */
static void phong_is_blinn_with_four_times_the_exponent(void **state)
{
    (void)state;
    glint_mesh *mesh = sphere(128);
    studio a = open_studio(320, 240, 2, GLINT_BACKEND_REAL);
    studio b = open_studio(320, 240, 2, GLINT_BACKEND_REAL);
    glint_scene scene = white_on_black(mesh, GLINT_REFLECTANCE_PHONG, 20);
    scene.fov = 1.0f;
    scene.light[0] = scene.light[1] = 0.0f;
    shoot(&a, &scene);
    scene.specular = GLINT_REFLECTANCE_BLINN;
    shoot(&b, &scene);
    assert_true(largest_difference(a.image, b.image) > 60);
    scene.n = 80;
    shoot(&b, &scene);
    assert_in_range(largest_difference(a.image, b.image), 0, 4);
    close_studio(&a);
    close_studio(&b);
    glint_mesh_destroy(mesh);
}

static int pixels_above(const glint_image *image, int level)
{
    int count = 0;
    for (int i = 0; i < image->width * image->height; i++)
        count += image->rgb[3 * i] > level;
    return count;
}

static void a_larger_exponent_makes_a_smaller_highlight(void **state)
{
    (void)state;
    static const uint16_t exponents[] = {4, 10, 40, 150, 600, 1000};
    glint_mesh *mesh = sphere(64);
    studio s = open_studio(320, 240, 2, GLINT_BACKEND_REAL);
    for (int model = 0; model < GLINT_REFLECTANCE_COUNT; model++) {
        if (model == GLINT_REFLECTANCE_LAMBERT || is_normalised(model))
            continue;
        int before = INT32_MAX;
        for (size_t i = 0; i < sizeof exponents / sizeof exponents[0]; i++) {
            const glint_scene scene =
                white_on_black(mesh, (glint_reflectance_model)model, exponents[i]);
            shoot(&s, &scene);
            const int now = pixels_above(s.image, 127);
            assert_true(now > 0 && now < before);
            before = now;
        }
    }
    close_studio(&s);
    glint_mesh_destroy(mesh);
}

static void lambert_has_no_highlight(void **state)
{
    (void)state;
    glint_mesh *mesh = sphere(64);
    studio a = open_studio(160, 120, 2, GLINT_BACKEND_REAL);
    studio b = open_studio(160, 120, 2, GLINT_BACKEND_REAL);
    for (int shading = 0; shading <= GLINT_SHADING_PHONG; shading++) {
        glint_scene scene = scene_of(mesh, GLINT_REFLECTANCE_LAMBERT, 10);
        scene.shading = (glint_shading)shading;
        scene.slips = 0;
        shoot(&a, &scene);
        scene.specular = GLINT_REFLECTANCE_BLINN;
        shoot(&b, &scene);
        assert_true(largest_difference(a.image, b.image) > 50);
        scene.ks = 0.0f;
        shoot(&b, &scene);
        assert_int_equal(largest_difference(a.image, b.image), 0);
    }
    close_studio(&a);
    close_studio(&b);
    glint_mesh_destroy(mesh);
}

/* ---- The renderer ---------------------------------------------------------------------------- */

static void any_number_of_threads_gives_the_same_bits(void **state)
{
    (void)state;
    glint_mesh *mesh = NULL;
    assert_int_equal(glint_mesh_teapot(4, &mesh, NULL), GLINT_OK);
    studio one = open_studio(160, 120, 1, GLINT_BACKEND_REAL);
    studio many = open_studio(160, 120, 5, GLINT_BACKEND_REAL);
    for (int model = 0; model < GLINT_REFLECTANCE_COUNT; model++) {
        for (int shading = 0; shading <= GLINT_SHADING_PHONG; shading++) {
            glint_scene scene = scene_of(mesh, (glint_reflectance_model)model, 30);
            scene.shading = (glint_shading)shading;
            shoot(&one, &scene);
            shoot(&many, &scene);
            assert_int_equal(largest_difference(one.image, many.image), 0);
        }
    }
    close_studio(&one);
    close_studio(&many);
    glint_mesh_destroy(mesh);
}

/* What a renderer keeps of a model from one frame must not reach into the next. */
static void frames_do_not_remember_the_model_before(void **state)
{
    (void)state;
    glint_mesh *mesh = sphere(32);
    studio kept = open_studio(120, 90, 1, GLINT_BACKEND_REAL);
    for (int i = 0; i < 4; i++) {
        studio fresh = open_studio(120, 90, 1, GLINT_BACKEND_REAL);
        glint_scene scene = scene_of(mesh, GLINT_REFLECTANCE_COOK_TORRANCE, 40);
        scene.f0 = i == 1 ? 0.9f : 0.1f;
        scene.n = i == 2 ? 400 : 40;
        scene.specular = i == 3 ? GLINT_REFLECTANCE_SCHLICK : scene.specular;
        shoot(&kept, &scene);
        shoot(&fresh, &scene);
        assert_int_equal(largest_difference(kept.image, fresh.image), 0);
        close_studio(&fresh);
    }
    close_studio(&kept);
    glint_mesh_destroy(mesh);
}

static void expect_refusal(const studio *s, const glint_scene *scene, const char *says)
{
    glint_error err = {""};
    assert_int_equal(glint_render(s->renderer, scene, s->image, NULL, NULL, &err),
                     GLINT_BAD_ARGUMENT);
    if (strstr(err.text, says) == NULL)
        fail_msg("\"%s\" does not say \"%s\"", err.text, says);
}

static void what_cannot_be_is_refused(void **state)
{
    (void)state;
    glint_mesh *mesh = sphere(16);
    studio real = open_studio(32, 24, 1, GLINT_BACKEND_REAL);
    studio c = open_studio(32, 24, 1, GLINT_BACKEND_C);
    studio rtl = open_studio(32, 24, 1, GLINT_BACKEND_RTL);
    const glint_scene good = scene_of(mesh, GLINT_REFLECTANCE_BLINN, 10);
    expect_refusal(&c, &good, "backend real");
    expect_refusal(&rtl, &good, "backend real");
    glint_scene bad = good;
    bad.specular = GLINT_REFLECTANCE_COUNT;
    expect_refusal(&real, &bad, "model");
    bad = good;
    bad.specular = GLINT_REFLECTANCE_QUADRATIC;
    bad.n = 0;
    expect_refusal(&real, &bad, "model quadratic takes n from 1 to 1023 here, not 0");
    bad = good;
    bad.f0 = 1.5f;
    expect_refusal(&real, &bad, "f0");
    bad.f0 = NAN;
    expect_refusal(&real, &bad, "f0");
    shoot(&real, &good);
    uint32_t code;
    glint_material material;
    assert_false(glint_renderer_fragment(real.renderer, 16, 12, &code, &material));
    close_studio(&real);
    close_studio(&c);
    close_studio(&rtl);
    glint_mesh_destroy(mesh);
}

/* A mesh of one colour a triangle, by flat shading: where two neighbouring pixels of the picture
 * differ the triangles do; and pixels of a triangle are all of one colour. */
static void the_triangles_seen_are_those_of_the_picture(void **state)
{
    (void)state;
    glint_mesh *mesh = sphere(16);
    studio s = open_studio(160, 120, 3, GLINT_BACKEND_REAL);
    glint_scene scene = scene_of(mesh, GLINT_REFLECTANCE_BLINN, 10);
    scene.shading = GLINT_SHADING_FLAT;
    uint32_t *seen = malloc(160 * 120 * sizeof *seen);
    uint8_t(*color)[3] = calloc(mesh->triangle_count, sizeof *color);
    bool *met = calloc(mesh->triangle_count, sizeof *met);
    assert_true(seen != NULL && color != NULL && met != NULL);
    shoot(&s, &scene);
    glint_renderer_triangles(s.renderer, seen);
    uint64_t triangles = 0;
    for (int at = 0; at < 160 * 120; at++) {
        uint32_t one = GLINT_NO_TRIANGLE;
        assert_int_equal(glint_renderer_triangle(s.renderer, at % 160, at / 160, &one),
                         s.image->object[at]);
        assert_int_equal(seen[at], one);
        if (seen[at] == GLINT_NO_TRIANGLE)
            continue;
        assert_true(seen[at] < mesh->triangle_count);
        if (!met[seen[at]]) {
            memcpy(color[seen[at]], &s.image->rgb[3 * at], 3);
            met[seen[at]] = true;
            triangles++;
        }
        assert_memory_equal(color[seen[at]], &s.image->rgb[3 * at], 3);
    }
    /* A sphere hides none that faces the camera; a sliver's box may hold a sample, and it none. */
    assert_in_range(triangles, s.stats.drawn * 3 / 4, s.stats.drawn);
    free(seen);
    free(color);
    free(met);
    close_studio(&s);
    glint_mesh_destroy(mesh);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_pixel_has_the_value_of_its_vectors),
        cmocka_unit_test(flat_and_gouraud_light_points_by_the_model),
        cmocka_unit_test(the_cosine_quadratic_is_the_default_but_for_the_code),
        cmocka_unit_test(the_device_is_the_c_backend),
        cmocka_unit_test(phong_is_blinn_with_four_times_the_exponent),
        cmocka_unit_test(a_larger_exponent_makes_a_smaller_highlight),
        cmocka_unit_test(lambert_has_no_highlight),
        cmocka_unit_test(any_number_of_threads_gives_the_same_bits),
        cmocka_unit_test(frames_do_not_remember_the_model_before),
        cmocka_unit_test(what_cannot_be_is_refused),
        cmocka_unit_test(the_triangles_seen_are_those_of_the_picture),
    };
    return cmocka_run_group_tests_name("specular", tests, NULL, NULL);
}
