/* Light by three intensities, exponents with a fraction, and the object's own transform: each
 * against frames or geometry that do without it. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "reflectance/vec3.h"
#include "render/transform.h"
#include "studio.h"

#define WIDTH  128
#define HEIGHT 96

static glint_mesh *teapot(void)
{
    glint_mesh *mesh = NULL;
    assert_int_equal(glint_mesh_teapot(6, &mesh, NULL), GLINT_OK);
    return mesh;
}

static glint_mesh *sphere(void)
{
    glint_mesh *mesh = NULL;
    assert_int_equal(glint_mesh_sphere(48, &mesh, NULL), GLINT_OK);
    return mesh;
}

static glint_scene default_scene(const glint_mesh *mesh)
{
    glint_scene scene = {.mesh = mesh};
    glint_scene_defaults(&scene);
    return scene;
}

static void set_light(glint_scene *scene, const float ia[3], const float ie[3])
{
    memcpy(scene->ia, ia, sizeof scene->ia);
    memcpy(scene->ie, ie, sizeof scene->ie);
}

/* The components do not mix: each is that of a frame in which all three lights have its value. */
static void expect_components_apart(studio *s, const glint_scene *scene)
{
    static const float ia[3] = {0.1f, 0.7f, 1.0f}, ie[3] = {238 / 255.0f, 138 / 255.0f, 0.0f};
    const size_t pixels = (size_t)WIDTH * HEIGHT;
    uint8_t *colored = malloc(3 * pixels);
    glint_scene lit = *scene;
    assert_non_null(colored);
    set_light(&lit, ia, ie);
    shoot(s, &lit);
    memcpy(colored, s->image->rgb, 3 * pixels);
    for (int c = 0; c < 3; c++) {
        set_light(&lit, (const float[]){ia[c], ia[c], ia[c]}, (const float[]){ie[c], ie[c], ie[c]});
        shoot(s, &lit);
        for (size_t i = 0; i < pixels; i++)
            assert_int_equal(colored[3 * i + (size_t)c], s->image->rgb[3 * i + (size_t)c]);
    }
    free(colored);
}

static void components_of_light_do_not_mix(void **state)
{
    (void)state;
    static const glint_backend_kind kinds[] = {GLINT_BACKEND_C, GLINT_BACKEND_RTL,
                                               GLINT_BACKEND_REAL};
    glint_mesh *mesh = teapot();
    for (int kind = 0; kind < 3; kind++) {
        studio s = open_studio(WIDTH, HEIGHT, 2, kinds[kind]);
        glint_scene scene = default_scene(mesh);
        for (int shading = 0; shading <= GLINT_SHADING_PHONG; shading++) {
            scene.shading = (glint_shading)shading;
            expect_components_apart(&s, &scene);
        }
        scene.shading = GLINT_SHADING_PHONG;
        scene.by_model = kinds[kind] == GLINT_BACKEND_REAL;
        scene.specular = GLINT_REFLECTANCE_BLINN;
        expect_components_apart(&s, &scene);
        close_studio(&s);
    }
    glint_mesh_destroy(mesh);
}

static void intensities_out_of_range_are_refused(void **state)
{
    (void)state;
    static const float bad[] = {-0.1f, 1.1f, NAN};
    glint_mesh *mesh = sphere();
    studio s = open_studio(WIDTH, HEIGHT, 1, GLINT_BACKEND_C);
    for (size_t i = 0; i < 3; i++) {
        for (int c = 0; c < 6; c++) {
            glint_scene scene = default_scene(mesh);
            glint_error err;
            (c < 3 ? scene.ia : scene.ie)[c % 3] = bad[i];
            assert_int_equal(glint_render(s.renderer, &scene, s.image, NULL, NULL, &err),
                             GLINT_BAD_ARGUMENT);
            assert_non_null(strstr(err.text, c < 3 ? "of ia is" : "of ie is"));
        }
    }
    close_studio(&s);
    glint_mesh_destroy(mesh);
}

/* cosⁿ falls with n: each pixel at n = 2.5 lies between those at 2 and at 3, and some lie apart
 * from both. */
static void an_exponent_may_have_a_fraction(void **state)
{
    (void)state;
    static const double n[] = {2.0, 2.5, 3.0};
    glint_mesh *mesh = sphere();
    studio s[3];
    uint64_t apart = 0;
    for (int i = 0; i < 3; i++) {
        glint_scene scene = default_scene(mesh);
        s[i] = open_studio(WIDTH, HEIGHT, 2, GLINT_BACKEND_REAL);
        scene.by_model = true;
        scene.specular = GLINT_REFLECTANCE_BLINN;
        scene.n = n[i];
        shoot(&s[i], &scene);
    }
    for (size_t i = 0; i < (size_t)3 * WIDTH * HEIGHT; i++) {
        const int above = s[0].image->rgb[i], at = s[1].image->rgb[i], below = s[2].image->rgb[i];
        assert_true(above >= at && at >= below);
        apart += above > at && at > below;
    }
    assert_true(apart > 100);
    for (int i = 0; i < 3; i++)
        close_studio(&s[i]);
    glint_mesh_destroy(mesh);
}

static void a_device_takes_whole_exponents_only(void **state)
{
    (void)state;
    glint_mesh *mesh = sphere();
    for (int kind = 0; kind < GLINT_BACKEND_COUNT; kind++) {
        studio s = open_studio(WIDTH, HEIGHT, 1, (glint_backend_kind)kind);
        glint_scene scene = default_scene(mesh);
        glint_error err;
        scene.n = 2.5;
        assert_int_equal(glint_render(s.renderer, &scene, s.image, NULL, NULL, &err),
                         GLINT_BAD_ARGUMENT);
        assert_string_equal(err.text, "scene: n is 2.5, but the device takes whole numbers only");
        close_studio(&s);
    }
    glint_mesh_destroy(mesh);
}

static glint_transform identity(void)
{
    return (glint_transform){.scale = {1.0, 1.0, 1.0}};
}

static void transform(glint_mesh *mesh, const glint_transform *t)
{
    glint_error err = {""};
    const glint_status status = glint_mesh_transform(mesh, t, &err);
    assert_string_equal(err.text, "");
    assert_int_equal(status, GLINT_OK);
}

/* An ellipsoid's normal is (x/a², y/b², z/c²): by its equation, not by a transform. */
static void expect_ellipsoid(const double scale[3])
{
    glint_mesh *mesh = sphere();
    glint_transform t = identity();
    memcpy(t.scale, scale, sizeof t.scale);
    transform(mesh, &t);
    for (size_t i = 0; i < mesh->vertex_count; i++) {
        const glint_vec3 p = glint_vec3_of(&mesh->position[3 * i]);
        const glint_vec3 n = {p.x / (scale[0] * scale[0]), p.y / (scale[1] * scale[1]),
                              p.z / (scale[2] * scale[2])};
        const glint_vec3 got = glint_vec3_of(&mesh->normal[3 * i]);
        assert_true(fabs(glint_vec3_length(got) - 1.0) < 1e-6);
        const double slip = glint_vec3_length(glint_vec3_cross(got, n)) / glint_vec3_length(n);
        if (!(slip < 2e-6))
            fail_msg("vertex %zu: the normal is off by %g", i, slip);
        assert_true(glint_vec3_dot(got, n) > 0.0);
    }
    for (size_t i = 0; i < mesh->triangle_count; i++) {
        glint_vec3 p[3];
        for (int k = 0; k < 3; k++)
            p[k] = glint_vec3_of(&mesh->position[3 * (size_t)mesh->index[3 * i + (size_t)k]]);
        const glint_vec3 out =
            glint_vec3_cross(glint_vec3_sub(p[1], p[0]), glint_vec3_sub(p[2], p[0]));
        assert_true(glint_vec3_dot(out, p[0]) > 0.0);
    }
    glint_mesh_destroy(mesh);
}

static void normals_stay_across_the_surface(void **state)
{
    (void)state;
    static const double scales[][3] = {
        {1.0, 0.25, 3.0}, {-1.0, 2.0, 2.0}, {-0.5, -4.0, -1.0}, {2.0, -3.0, -0.125}};
    for (size_t i = 0; i < sizeof scales / sizeof scales[0]; i++)
        expect_ellipsoid(scales[i]);
}

/* The object turned one way is the camera gone round it the other way. */
static void turning_the_object_is_going_round_it(void **state)
{
    (void)state;
    glint_mesh *still = teapot(), *turned = teapot();
    glint_transform t = identity();
    glint_image_difference difference;
    studio a = open_studio(WIDTH, HEIGHT, 2, GLINT_BACKEND_C);
    studio b = open_studio(WIDTH, HEIGHT, 2, GLINT_BACKEND_C);
    t.rotate[1] = -25.0;
    transform(turned, &t);
    glint_scene scene = default_scene(still);
    scene.distance = 4.0f;
    scene.yaw = 25.0f;
    shoot(&a, &scene);
    scene.mesh = turned;
    scene.yaw = 0.0f;
    shoot(&b, &scene);
    assert_int_equal(glint_image_compare(a.image, b.image, &difference, NULL), GLINT_OK);
    assert_true(difference.object_pixels > 1000);
    assert_true(difference.nmse < 1e-6);
    close_studio(&a);
    close_studio(&b);
    glint_mesh_destroy(still);
    glint_mesh_destroy(turned);
}

/* About x, then y, then z, each anticlockwise seen from the axis's tip. */
static void axes_turn_in_their_order(void **state)
{
    (void)state;
    glint_mesh *mesh = sphere();
    glint_transform t = identity();
    const double quarter[3] = {90.0, 90.0, 0.0};
    memcpy(t.rotate, quarter, sizeof t.rotate);
    size_t pole = 0; /* +y: to +z about x, then to +x about y */
    while (mesh->position[3 * pole + 1] < 1.0f - 1e-6f)
        pole++;
    transform(mesh, &t);
    assert_true(fabs((double)mesh->position[3 * pole] - 1.0) < 1e-6);
    assert_true(fabs((double)mesh->normal[3 * pole] - 1.0) < 1e-6);
    glint_mesh_destroy(mesh);
}

/* A move to the right by a radius, with the camera where it was: the picture of the object moves
 * and nothing is fitted anew. */
static void the_camera_stays(void **state)
{
    (void)state;
    glint_mesh *mesh = sphere();
    glint_transform t = identity();
    studio s = open_studio(WIDTH, HEIGHT, 2, GLINT_BACKEND_C);
    glint_scene scene = default_scene(mesh);
    scene.yaw = 0.0f;
    scene.pitch = 0.0f;
    shoot(&s, &scene);
    const uint64_t before = s.stats.fragments;
    for (int y = 0; y < HEIGHT; y++)
        assert_int_equal(s.image->object[y * WIDTH + WIDTH - 1], 0);
    t.move[0] = 1.0;
    transform(mesh, &t);
    shoot(&s, &scene);
    assert_true(s.stats.fragments > before / 2); /* none is cut off but the corner */
    assert_int_equal(s.image->object[HEIGHT / 2 * WIDTH + WIDTH / 4], 0);
    assert_int_equal(s.image->object[HEIGHT / 2 * WIDTH + WIDTH - 1], 1);
    t = identity();
    t.scale[0] = t.scale[1] = t.scale[2] = 0.5;
    t.move[0] = -1.0;
    transform(mesh, &t);
    shoot(&s, &scene);
    assert_true(s.stats.fragments * 3 < before);
    close_studio(&s);
    glint_mesh_destroy(mesh);
}

static void transforms_without_inverse_are_refused(void **state)
{
    (void)state;
    glint_mesh *mesh = sphere();
    const double bad[] = {0.0, NAN, -9e-7, INFINITY, -1001.0};
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        glint_transform t = identity();
        glint_error err;
        t.scale[2] = bad[i];
        assert_int_equal(glint_mesh_transform(mesh, &t, &err), GLINT_BAD_ARGUMENT);
        assert_int_equal(strstr(err.text, "flatten") != NULL, i < 3);
    }
    assert_null(mesh->rest);
    glint_mesh_destroy(mesh);
}

static void the_identity_changes_nothing(void **state)
{
    (void)state;
    glint_mesh *mesh = teapot(), *same = teapot();
    const glint_transform t = identity();
    transform(same, &t);
    assert_memory_equal(mesh->position, same->position,
                        3 * mesh->vertex_count * sizeof *mesh->position);
    assert_memory_equal(mesh->normal, same->normal, 3 * mesh->vertex_count * sizeof *mesh->normal);
    assert_null(same->rest);
    glint_mesh_destroy(mesh);
    glint_mesh_destroy(same);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(components_of_light_do_not_mix),
        cmocka_unit_test(intensities_out_of_range_are_refused),
        cmocka_unit_test(an_exponent_may_have_a_fraction),
        cmocka_unit_test(a_device_takes_whole_exponents_only),
        cmocka_unit_test(normals_stay_across_the_surface),
        cmocka_unit_test(turning_the_object_is_going_round_it),
        cmocka_unit_test(axes_turn_in_their_order),
        cmocka_unit_test(the_camera_stays),
        cmocka_unit_test(transforms_without_inverse_are_refused),
        cmocka_unit_test(the_identity_changes_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
