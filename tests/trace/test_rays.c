/* Embree against a brute force: every ray with every triangle, by Möller and Trumbore in double
 * precision, on meshes of the tree, a heap of random triangles, and degenerate ones. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "../seed.h"
#include "circuit/random.h"
#include "render/mesh_build.h"
#include "trace/rays.h"

#define RAYS 4000

/* A ray within this of a triangle's edge, in shares of its corners, or that sees a triangle at so
 * flat an angle, may go either way. */
#define CLOSE 1e-4
#define FLAT  1e-4

static glint_random random_state;

static double random_of(double low, double high)
{
    return low + (high - low) * (double)(glint_random_bits(&random_state) >> 11) * 0x1p-53;
}

static glint_vec3 random_vector(void)
{
    return (glint_vec3){random_of(-1, 1), random_of(-1, 1), random_of(-1, 1)};
}

static glint_camera camera_of(const glint_mesh *mesh)
{
    glint_scene scene = {.mesh = mesh};
    glint_scene_defaults(&scene);
    return glint_camera_of(&scene, 640, 480);
}

/* What a triangle is to a ray. */
typedef struct crossing {
    bool sure_hit, sure_miss; /* neither: too close to call */
    double distance;
} crossing;

static glint_vec3 corner_of(const glint_mesh *mesh, const glint_camera *camera, size_t at)
{
    const glint_vec3 p = glint_vec3_of(&mesh->position[3 * (size_t)mesh->index[at]]);
    return glint_camera_rotate(camera,
                               glint_vec3_scale(glint_vec3_sub(p, camera->centre), camera->scale));
}

/* Whether the line passes the triangle at more than its size. */
static bool is_far(glint_vec3 a, glint_vec3 ab, glint_vec3 ac, glint_vec3 from, glint_vec3 ray)
{
    const glint_vec3 way = glint_vec3_cross(glint_vec3_sub(a, from), ray);
    const double size = fmax(glint_vec3_length(ab), glint_vec3_length(ac));
    return glint_vec3_length(way) / glint_vec3_length(ray) > 1.1 * size + 1e-6;
}

static crossing cross(const glint_mesh *mesh, const glint_camera *camera, size_t triangle,
                      glint_vec3 from, glint_vec3 ray, bool both_sides)
{
    const glint_vec3 a = corner_of(mesh, camera, 3 * triangle);
    const glint_vec3 ab = glint_vec3_sub(corner_of(mesh, camera, 3 * triangle + 1), a);
    const glint_vec3 ac = glint_vec3_sub(corner_of(mesh, camera, 3 * triangle + 2), a);
    const glint_vec3 n = glint_vec3_cross(ab, ac);
    const double flat = glint_vec3_dot(n, ray) / (glint_vec3_length(n) * glint_vec3_length(ray));
    if (is_far(a, ab, ac, from, ray))
        return (crossing){.sure_miss = true};
    if (glint_vec3_length(n) < 1e-12)
        return (crossing){.sure_miss = glint_vec3_length(n) == 0.0};
    if (!both_sides && flat > FLAT)
        return (crossing){.sure_miss = true};
    const glint_vec3 p = glint_vec3_cross(ray, ac);
    const glint_vec3 q = glint_vec3_cross(glint_vec3_sub(from, a), ab);
    const double det = glint_vec3_dot(ab, p);
    const double u = glint_vec3_dot(glint_vec3_sub(from, a), p) / det;
    const double v = glint_vec3_dot(ray, q) / det;
    const double distance = glint_vec3_dot(ac, q) / det;
    const double inner = fmin(fmin(u, v), 1.0 - u - v);
    /* Single precision rounds corners by some 1e-7: more shares of a smaller triangle. */
    const double close = CLOSE * fmax(1.0, 1e-3 / sqrt(glint_vec3_length(n)));
    if (inner < -close || distance < -CLOSE)
        return (crossing){.sure_miss = fabs(flat) > FLAT};
    return (crossing){.sure_hit = inner > close && distance > CLOSE && fabs(flat) > FLAT,
                      .distance = distance};
}

/* The nearest sure hit, and the nearest that may be one. */
static void brute_force(const glint_mesh *mesh, const glint_camera *camera, glint_vec3 from,
                        glint_vec3 ray, bool both_sides, double *sure, double *maybe)
{
    *sure = INFINITY;
    *maybe = INFINITY;
    for (size_t t = 0; t < mesh->triangle_count; t++) {
        const crossing c = cross(mesh, camera, t, from, ray, both_sides);
        if (c.sure_hit)
            *sure = fmin(*sure, c.distance);
        if (!c.sure_miss)
            *maybe = fmin(*maybe, c.distance);
    }
}

/* The triangle named is one that may be hit, at its own distance, and nothing sure is nearer. */
static void check_hit(const glint_mesh *mesh, const glint_camera *camera, const glint_ray_hit *hit,
                      glint_vec3 from, glint_vec3 ray, double sure)
{
    const crossing c = cross(mesh, camera, hit->triangle, from, ray, false);
    assert_false(c.sure_miss);
    if (c.sure_hit)
        assert_true(fabs(hit->distance - c.distance) < 1e-9 * (1.0 + fabs(c.distance)));
    assert_true(hit->distance <= sure + 1e-4);
    const glint_vec3 place = glint_vec3_add(from, glint_vec3_scale(ray, hit->distance));
    assert_true(glint_vec3_length(glint_vec3_sub(place, hit->place)) < 1e-12);
}

/* Returns how many rays were decided without a doubt. */
static int compare(const glint_mesh *mesh, int rays)
{
    const glint_camera camera = camera_of(mesh);
    glint_rays *embree;
    glint_error err = {""};
    if (glint_rays_create(mesh, &camera, NULL, &embree, &err) != GLINT_OK)
        fail_msg("%s", err.text);
    int decided = 0;
    for (int i = 0; i < rays; i++) {
        const glint_vec3 from = glint_vec3_scale(random_vector(), 2.0);
        const glint_vec3 ray = glint_vec3_sub(glint_vec3_scale(random_vector(), 0.7), from);
        double sure, maybe;
        glint_ray_hit hit;
        brute_force(mesh, &camera, from, ray, false, &sure, &maybe);
        const bool met = glint_rays_meet(embree, from, ray, &hit);
        if (met)
            check_hit(mesh, &camera, &hit, from, ray, sure);
        else
            assert_true(sure == INFINITY);
        if (maybe == INFINITY)
            assert_false(met);
        decided += sure == maybe;
        brute_force(mesh, &camera, from, ray, true, &sure, &maybe);
        const bool blocked = glint_rays_blocked(embree, from, ray);
        assert_true(blocked ? maybe < INFINITY : sure == INFINITY);
    }
    glint_rays_destroy(embree);
    return decided;
}

static void check_mesh(glint_mesh *mesh, int rays)
{
    const int decided = compare(mesh, rays);
    print_message("%zu triangles: %d of %d rays decided\n", mesh->triangle_count, decided, rays);
    assert_true(decided > rays * 95 / 100);
    glint_mesh_destroy(mesh);
}

static void the_models(void **state)
{
    (void)state;
    glint_mesh *mesh;
    glint_error err;
    assert_int_equal(glint_mesh_teapot(4, &mesh, &err), GLINT_OK);
    check_mesh(mesh, RAYS);
    assert_int_equal(glint_mesh_sphere(16, &mesh, &err), GLINT_OK);
    check_mesh(mesh, RAYS);
    assert_int_equal(glint_mesh_quad(&mesh, &err), GLINT_OK);
    check_mesh(mesh, RAYS);
}

static glint_mesh *heap_of(size_t triangles, double size)
{
    glint_mesh *mesh;
    glint_error err;
    assert_int_equal(glint_mesh_new("heap", 3 * triangles, triangles, &mesh, &err), GLINT_OK);
    for (uint32_t i = 0; i < triangles; i++) {
        const glint_vec3 at = random_vector();
        for (int c = 0; c < 3; c++)
            glint_mesh_add_vertex(mesh, glint_vec3_add(at, glint_vec3_scale(random_vector(), size)),
                                  (glint_vec3){0, 0, 1});
        glint_mesh_add_triangle(mesh, 3 * i, 3 * i + 1, 3 * i + 2);
    }
    return mesh;
}

static void heaps_of_random_triangles(void **state)
{
    (void)state;
    check_mesh(heap_of(1000, 0.3), RAYS);
    check_mesh(heap_of(1000, 0.02), RAYS);
}

/* Points, lines and doubled triangles among good ones: nothing is hit that is not there. */
static void degenerate_triangles(void **state)
{
    (void)state;
    glint_mesh *mesh = heap_of(300, 0.3);
    for (size_t t = 0; t < mesh->triangle_count; t += 3) {
        uint32_t *corner = &mesh->index[3 * t];
        if (t % 2 == 0)
            corner[2] = corner[1]; /* a line */
        else
            corner[1] = corner[2] = corner[0]; /* a point */
    }
    check_mesh(mesh, RAYS);
}

static void a_mesh_without_triangles(void **state)
{
    (void)state;
    glint_mesh *mesh = heap_of(1, 0.3);
    mesh->triangle_count = 0;
    const glint_camera camera = camera_of(mesh);
    glint_rays *rays;
    glint_ray_hit hit;
    glint_error err = {""};
    assert_int_equal(glint_rays_create(mesh, &camera, NULL, &rays, &err), GLINT_OK);
    assert_false(glint_rays_meet(rays, (glint_vec3){0, 0, 2}, (glint_vec3){0, 0, -1}, &hit));
    assert_false(glint_rays_blocked(rays, (glint_vec3){0, 0, 2}, (glint_vec3){0, 0, -1}));
    glint_rays_destroy(rays);
    glint_mesh_destroy(mesh);
}

/* The interpolated normal of the sphere is its radius. */
static void normals_are_interpolated(void **state)
{
    (void)state;
    glint_mesh *mesh;
    glint_rays *rays;
    glint_error err = {""};
    assert_int_equal(glint_mesh_sphere(256, &mesh, &err), GLINT_OK);
    const glint_camera camera = camera_of(mesh);
    assert_int_equal(glint_rays_create(mesh, &camera, NULL, &rays, &err), GLINT_OK);
    for (int i = 0; i < RAYS; i++) {
        glint_ray_hit hit;
        const glint_vec3 from = glint_vec3_scale(random_vector(), 3.0);
        if (glint_vec3_length(from) < 1.1 ||
            !glint_rays_meet(rays, from, glint_vec3_scale(from, -1.0), &hit))
            continue;
        const double length = glint_vec3_length(hit.normal) * glint_vec3_length(from);
        assert_true(glint_vec3_dot(hit.normal, from) / length > 0.99999);
        assert_true(glint_vec3_dot(hit.plane, from) / glint_vec3_length(from) > 0.999);
    }
    glint_rays_destroy(rays);
    glint_mesh_destroy(mesh);
}

static void building_can_be_stopped(void **state)
{
    (void)state;
    glint_mesh *mesh;
    glint_rays *rays = NULL;
    glint_error err = {""};
    const bool stop = true;
    assert_int_equal(glint_mesh_sphere(512, &mesh, &err), GLINT_OK);
    const glint_camera camera = camera_of(mesh);
    assert_int_equal(glint_rays_create(mesh, &camera, &stop, &rays, &err), GLINT_INTERRUPTED);
    assert_string_equal(err.text, "tracing abandoned: interrupted");
    assert_null(rays);
    glint_mesh_destroy(mesh);
}

int main(void)
{
    random_state.state = seed_of_this_run();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_models),
        cmocka_unit_test(heaps_of_random_triangles),
        cmocka_unit_test(degenerate_triangles),
        cmocka_unit_test(a_mesh_without_triangles),
        cmocka_unit_test(normals_are_interpolated),
        cmocka_unit_test(building_can_be_stopped),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
