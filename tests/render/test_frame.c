/* Whole frames: fragments against analytic values in double precision, visibility, clipping at the
 * near plane, the same bits for any number of threads, and what is rejected. */
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

static glint_scene default_scene(const glint_mesh *mesh)
{
    glint_scene scene = {.mesh = mesh};
    glint_scene_defaults(&scene);
    assert_ptr_equal(scene.mesh, mesh);
    return scene;
}

static glint_mesh *teapot(int density)
{
    glint_mesh *mesh = NULL;
    assert_int_equal(glint_mesh_teapot(density, &mesh, NULL), GLINT_OK);
    return mesh;
}

static glint_mesh *sphere(int density)
{
    glint_mesh *mesh = NULL;
    assert_int_equal(glint_mesh_sphere(density, &mesh, NULL), GLINT_OK);
    return mesh;
}

static glint_vec3 unit(glint_vec3 v)
{
    return glint_vec3_scale(v, 1.0 / glint_vec3_length(v));
}

/* The ray through a pixel's centre, camera axes, z −1. */
static glint_vec3 ray(const glint_image *image, const glint_scene *scene, int x, int y)
{
    const double focal = 0.5 * image->height / tan(0.5 * (double)scene->fov * RADIANS);
    return (glint_vec3){(x + 0.5 - 0.5 * image->width) / focal,
                        (0.5 * image->height - y - 0.5) / focal, -1.0};
}

/* cos γ as the header has it: N·H with H half way between the light and the eye. */
static double analytic_cosine(const glint_scene *scene, glint_vec3 along, glint_vec3 n)
{
    const glint_vec3 v = glint_vec3_scale(unit(along), -1.0);
    const glint_vec3 h = glint_vec3_add(unit(glint_vec3_of(scene->light)), v);
    const double c = glint_vec3_dot(unit(n), unit(h));
    return c > 0.0 ? c : 0.0;
}

static bool fragment(const studio *s, int x, int y, uint32_t *code)
{
    glint_material material;
    const bool found = glint_renderer_fragment(s->renderer, x, y, code, &material);
    assert_int_equal(found, s->image->object[y * s->image->width + x]);
    return found;
}

/* Meshes of a few triangles, drawn with the camera on the z axis. */
typedef struct plain_mesh {
    float position[3 * 16], normal[3 * 16];
    uint32_t index[3 * 16];
    glint_mesh mesh;
} plain_mesh;

static uint32_t add_corner(plain_mesh *m, glint_vec3 p, glint_vec3 n)
{
    const size_t at = m->mesh.vertex_count++;
    glint_vec3_store(p, &m->position[3 * at]);
    glint_vec3_store(unit(n), &m->normal[3 * at]);
    return (uint32_t)at;
}

static void add_triangle(plain_mesh *m, uint32_t a, uint32_t b, uint32_t c)
{
    uint32_t *index = &m->index[3 * m->mesh.triangle_count++];
    index[0] = a;
    index[1] = b;
    index[2] = c;
}

static plain_mesh *new_mesh(void)
{
    plain_mesh *m = calloc(1, sizeof *m);
    assert_non_null(m);
    m->mesh = (glint_mesh){.position = m->position, .normal = m->normal, .index = m->index};
    return m;
}

/* A square across the view with corners (±half, ±half, z), normal n. */
static void add_square(plain_mesh *m, double half, double z, glint_vec3 n)
{
    const uint32_t a = add_corner(m, (glint_vec3){-half, -half, z}, n);
    const uint32_t b = add_corner(m, (glint_vec3){half, -half, z}, n);
    const uint32_t c = add_corner(m, (glint_vec3){half, half, z}, n);
    const uint32_t d = add_corner(m, (glint_vec3){-half, half, z}, n);
    add_triangle(m, a, b, c);
    add_triangle(m, a, c, d);
}

static glint_scene straight_scene(const plain_mesh *m, float distance)
{
    glint_scene scene = default_scene(&m->mesh);
    scene.yaw = 0.0f;
    scene.pitch = 0.0f;
    scene.distance = distance;
    return scene;
}

/* One triangle, steep against the view, with a different normal at each corner; its bounding sphere
 * is about the origin with radius 1. What the fragment must hold follows from the ray's meeting
 * with the plane and the barycentric coordinates there, without any perspective in between. */
static void interpolation_is_perspective_correct(void **state)
{
    (void)state;
    const glint_vec3 p[3] = {{-0.6, -0.6, 0.52915026221291817},
                             {0.6, -0.6, -0.52915026221291817},
                             {0.6, 0.6, -0.52915026221291817}};
    const glint_vec3 n[3] = {{-0.5, 0.2, 1.0}, {0.7, -0.3, 0.8}, {0.1, 0.9, 0.6}};
    plain_mesh *m = new_mesh();
    for (int i = 0; i < 3; i++)
        add_corner(m, p[i], n[i]);
    add_triangle(m, 0, 1, 2);
    const glint_scene scene = straight_scene(m, 1.6f);
    studio s = open_studio(640, 480, 2, GLINT_BACKEND_C);
    shoot(&s, &scene);
    assert_true(s.stats.fragments > 10000);
    const double distance = (double)scene.distance;
    for (int y = 0; y < 480; y++) {
        for (int x = 0; x < 640; x++) {
            uint32_t code;
            if (!fragment(&s, x, y, &code))
                continue;
            glint_vec3 q[3], c[3];
            for (int i = 0; i < 3; i++) {
                q[i] = glint_vec3_of(&m->position[3 * i]);
                q[i].z -= distance;
            }
            const glint_vec3 along = ray(s.image, &scene, x, y);
            double sum = 0.0;
            glint_vec3 normal = {0, 0, 0};
            for (int i = 0; i < 3; i++) { /* the tetrahedra between the ray and two corners */
                c[i] = glint_vec3_cross(q[(i + 1) % 3], q[(i + 2) % 3]);
                const double weight = glint_vec3_dot(along, c[i]);
                sum += weight;
                normal = glint_vec3_add(normal,
                                        glint_vec3_scale(glint_vec3_of(&m->normal[3 * i]), weight));
            }
            normal = glint_vec3_scale(normal, 1.0 / sum);
            const double expected = analytic_cosine(&scene, along, normal) * GLINT_COS_ONE;
            assert_true(fabs(expected - code) < 1.0);
        }
    }
    close_studio(&s);
    free(m);
}

/* On the sphere: the tessellation lies up to one sagitta of its chords within the true sphere,
 * which shifts where a slanted ray meets it. */
static void cosines_on_the_sphere(void **state)
{
    (void)state;
    const int density = 512;
    glint_mesh *mesh = sphere(density);
    glint_scene scene = default_scene(mesh);
    scene.distance = 4.0f;
    studio s = open_studio(640, 480, 2, GLINT_BACKEND_C);
    shoot(&s, &scene);
    const double sagitta = 2.0 * (1.0 - cos(2.0 * 180.0 / density * RADIANS / 2.0));
    uint64_t compared = 0;
    for (int y = 0; y < 480; y++) {
        for (int x = 0; x < 640; x++) {
            uint32_t code;
            const glint_vec3 along = unit(ray(s.image, &scene, x, y));
            const double distance = (double)scene.distance;
            const double towards = -distance * along.z;
            const double miss = distance * distance - towards * towards;
            if (!fragment(&s, x, y, &code) || miss > 0.9)
                continue;
            glint_vec3 n = glint_vec3_scale(along, towards - sqrt(1.0 - miss));
            n.z += distance;
            const double slope = sqrt(miss / (1.0 - miss));
            const double expected = analytic_cosine(&scene, along, n) * GLINT_COS_ONE;
            assert_true(fabs(expected - code) < 2.0 + sagitta * slope * GLINT_COS_ONE);
            compared++;
        }
    }
    assert_true(compared > 100000);
    close_studio(&s);
    glint_mesh_destroy(mesh);
}

/* What a closed convex mesh shows has no holes: every row one run, and all that lies well within
 * the true outline. */
static void a_closed_mesh_shows_no_holes(void **state)
{
    (void)state;
    glint_mesh *mesh = sphere(GLINT_SPHERE_DENSITY);
    studio s = open_studio(320, 240, 2, GLINT_BACKEND_C);
    for (int i = 0; i < 8; i++) {
        glint_scene scene = default_scene(mesh);
        scene.yaw = 11.0f * (float)i;
        scene.pitch = 90.0f - 25.0f * (float)i;
        shoot(&s, &scene);
        for (int y = 0; y < 240; y++) {
            int changes = 0;
            for (int x = 0; x < 320; x++) {
                const uint8_t *object = &s.image->object[y * 320 + x];
                changes += x > 0 && object[0] != object[-1];
                const double r = hypot(x + 0.5 - 160.0, y + 0.5 - 120.0);
                assert_true(r > 116.0 || object[0] == 1);
                assert_true(r < 120.0 || object[0] == 0);
            }
            assert_true(changes == 0 || changes == 2);
        }
    }
    close_studio(&s);
    glint_mesh_destroy(mesh);
}

static void the_fitted_object_touches_the_frame(void **state)
{
    (void)state;
    glint_mesh *mesh = teapot(8);
    const int sizes[][2] = {{640, 480}, {200, 600}, {600, 100}};
    for (size_t i = 0; i < sizeof sizes / sizeof sizes[0]; i++) {
        const int width = sizes[i][0];
        const int height = sizes[i][1];
        studio s = open_studio(width, height, 2, GLINT_BACKEND_C);
        const glint_scene scene = default_scene(mesh);
        shoot(&s, &scene);
        int left = width, right = -1, top = height, bottom = -1;
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                if (s.image->object[y * width + x] != 0) {
                    left = x < left ? x : left;
                    right = x > right ? x : right;
                    top = y < top ? y : top;
                    bottom = y;
                }
            }
        }
        const int beside = width - 1 - right;
        const int below = height - 1 - bottom;
        assert_true(left > 0 && beside > 0 && top > 0 && below > 0);
        const bool across = left < 0.02 * width + 2 && beside < 0.02 * width + 2;
        const bool upright = top < 0.02 * height + 2 && below < 0.02 * height + 2;
        assert_true(across || upright);
        close_studio(&s);
    }
    glint_mesh_destroy(mesh);
}

/* A floor that goes from far ahead to behind the camera, which stands over it: it crosses the near
 * plane and the guard square. Every ray that goes down meets it. */
static void a_floor_through_the_near_plane(void **state)
{
    (void)state;
    plain_mesh *m = new_mesh();
    const glint_vec3 up = {0.0, 1.0, 0.0};
    const uint32_t a = add_corner(m, (glint_vec3){-8.0, 0.0, 8.0}, up);
    const uint32_t b = add_corner(m, (glint_vec3){8.0, 0.0, 8.0}, up);
    const uint32_t c = add_corner(m, (glint_vec3){8.0, 0.0, -8.0}, up);
    const uint32_t d = add_corner(m, (glint_vec3){-8.0, 0.0, -8.0}, up);
    add_triangle(m, a, b, c);
    add_triangle(m, a, c, d);
    glint_scene scene = straight_scene(m, 0.05f);
    scene.pitch = 30.0f;
    scene.fov = 100.0f;
    studio s = open_studio(320, 240, 2, GLINT_BACKEND_C);
    shoot(&s, &scene);
    const double pitch = (double)scene.pitch * RADIANS;
    const double radius = 8.0 * sqrt(2.0);
    const double height = (double)scene.distance * radius * sin(pitch);
    const double back = (double)scene.distance * radius * cos(pitch);
    uint64_t on_floor = 0;
    for (int y = 0; y < 240; y++) {
        for (int x = 0; x < 320; x++) {
            const glint_vec3 r = ray(s.image, &scene, x, y);
            const double down = -(r.y * cos(pitch) + r.z * sin(pitch)); /* in the world's axes */
            const double ahead = -(r.z * cos(pitch) - r.y * sin(pitch));
            const double t = down > 0.0 ? height / down : 1e9;
            const double side = fabs(t * r.x);
            const double front = t * ahead - back;
            uint32_t code;
            const bool seen = fragment(&s, x, y, &code);
            if (side < 7.9 && front < 7.9) {
                assert_true(seen);
                const glint_vec3 n = {0.0, cos(pitch), sin(pitch)};
                assert_true(fabs(analytic_cosine(&scene, r, n) * GLINT_COS_ONE - code) < 1.0);
                on_floor++;
            } else if (side > 8.1 || front > 8.1) {
                assert_false(seen);
            }
        }
    }
    assert_true(on_floor > 20000);
    assert_int_equal(s.stats.drawn, 2); /* clipped or not */
    close_studio(&s);
    free(m);
}

/* From within a closed mesh only its back is seen: nothing; and the frame must survive vertices at
 * any depth before and behind the camera. */
static void a_camera_inside(void **state)
{
    (void)state;
    glint_mesh *mesh = sphere(64);
    studio s = open_studio(160, 120, 2, GLINT_BACKEND_C);
    glint_scene scene = default_scene(mesh);
    scene.distance = 0.5f;
    shoot(&s, &scene);
    assert_int_equal(s.stats.fragments, 0);
    glint_mesh_destroy(mesh);
    mesh = teapot(6);
    scene.mesh = mesh;
    for (int i = 1; i <= 40; i++) {
        scene.distance = 0.025f * (float)i;
        scene.yaw = 9.0f * (float)i;
        shoot(&s, &scene);
    }
    assert_true(s.stats.fragments > 0);
    close_studio(&s);
    glint_mesh_destroy(mesh);
}

static void the_nearer_is_seen(void **state)
{
    (void)state;
    const glint_vec3 facing = {0.0, 0.0, 1.0};
    const glint_vec3 leaning = {0.6, 0.0, 0.8};
    for (int order = 0; order < 2; order++) {
        plain_mesh *m = new_mesh();
        add_square(m, 1.0, order == 0 ? -0.5 : 0.5, order == 0 ? facing : leaning);
        add_square(m, 1.0, order == 0 ? 0.5 : -0.5, order == 0 ? leaning : facing);
        const glint_scene scene = straight_scene(m, 3.0f);
        studio s = open_studio(100, 100, 2, GLINT_BACKEND_C);
        shoot(&s, &scene);
        uint32_t code;
        assert_true(fragment(&s, 50, 50, &code));
        const glint_vec3 along = ray(s.image, &scene, 50, 50);
        assert_true(fabs(analytic_cosine(&scene, along, leaning) * GLINT_COS_ONE - code) < 1.0);
        close_studio(&s);
        free(m);
    }
}

/* Of two equally near triangles, the first one in the mesh wins. */
static void the_first_of_equals_is_seen(void **state)
{
    (void)state;
    const glint_vec3 facing = {0.0, 0.0, 1.0};
    const glint_vec3 leaning = {0.6, 0.0, 0.8};
    for (int order = 0; order < 2; order++) {
        plain_mesh *m = new_mesh();
        add_square(m, 1.0, 0.0, order == 0 ? facing : leaning);
        add_square(m, 1.0, 0.0, order == 0 ? leaning : facing);
        const glint_scene scene = straight_scene(m, 3.0f);
        studio s = open_studio(100, 100, 2, GLINT_BACKEND_C);
        shoot(&s, &scene);
        for (int x = 30; x < 70; x++) {
            uint32_t code;
            assert_true(fragment(&s, x, 50, &code));
            const glint_vec3 along = ray(s.image, &scene, x, 50);
            const double expected = analytic_cosine(&scene, along, order == 0 ? facing : leaning);
            assert_true(fabs(expected * GLINT_COS_ONE - code) < 1.0);
        }
        close_studio(&s);
        free(m);
    }
}

/* Two squares that cross on the line x = 0: left of it one is nearer, right of it the other. */
static void crossing_triangles_part_where_they_meet(void **state)
{
    (void)state;
    plain_mesh *m = new_mesh();
    const glint_vec3 normals[2] = {{0.6, 0.0, 0.8}, {-0.6, 0.0, 0.8}};
    for (int i = 0; i < 2; i++) {
        const double z = i == 0 ? 0.5 : -0.5; /* at x = −1 */
        const uint32_t a = add_corner(m, (glint_vec3){-1, -1, z}, normals[i]);
        const uint32_t b = add_corner(m, (glint_vec3){1, -1, -z}, normals[i]);
        const uint32_t c = add_corner(m, (glint_vec3){1, 1, -z}, normals[i]);
        const uint32_t d = add_corner(m, (glint_vec3){-1, 1, z}, normals[i]);
        add_triangle(m, a, b, c);
        add_triangle(m, a, c, d);
    }
    const glint_scene scene = straight_scene(m, 3.0f);
    studio s = open_studio(200, 200, 2, GLINT_BACKEND_C);
    shoot(&s, &scene);
    for (int x = 60; x < 140; x++) {
        uint32_t code;
        if (x == 99 || x == 100)
            continue;
        assert_true(fragment(&s, x, 100, &code));
        const glint_vec3 along = ray(s.image, &scene, x, 100);
        const double expected = analytic_cosine(&scene, along, normals[x < 100 ? 0 : 1]);
        assert_true(fabs(expected * GLINT_COS_ONE - code) < 1.0);
    }
    close_studio(&s);
    free(m);
}

static void a_square_seen_from_behind_is_not(void **state)
{
    (void)state;
    plain_mesh *m = new_mesh();
    add_square(m, 1.0, 0.0, (glint_vec3){0.0, 0.0, 1.0});
    studio s = open_studio(64, 64, 1, GLINT_BACKEND_C);
    glint_scene scene = straight_scene(m, 3.0f);
    shoot(&s, &scene);
    assert_int_equal(s.stats.triangles, 2);
    assert_int_equal(s.stats.drawn, 2);
    assert_true(s.stats.fragments > 100);
    scene.yaw = 180.0f;
    shoot(&s, &scene);
    assert_int_equal(s.stats.drawn, 0);
    assert_int_equal(s.stats.fragments, 0);
    close_studio(&s);
    free(m);
}

/* Pixel by pixel: base rounded half up, plus the backend's highlight where the light falls. */
static void the_picture_is_base_and_highlight(void **state)
{
    (void)state;
    plain_mesh *m = new_mesh();
    const glint_vec3 n = {0.2, 0.3, 0.9};
    add_square(m, 1.0, 0.0, n);
    glint_scene scene = straight_scene(m, 3.0f);
    scene.n = 40;
    for (int c = 0; c < 3; c++) {
        scene.ia[c] = 0.5f;
        scene.ie[c] = 0.75f;
    }
    studio s = open_studio(64, 64, 1, GLINT_BACKEND_C);
    glint_backend *backend = NULL;
    const glint_backend_config config = {.kind = GLINT_BACKEND_C};
    assert_int_equal(glint_backend_create(&config, &backend, NULL), GLINT_OK);
    for (int turn = 0; turn < 2; turn++) {
        shoot(&s, &scene);
        const double cosine = glint_vec3_dot(unit(n), unit(glint_vec3_of(scene.light)));
        const double diffuse = cosine > 0.0 ? cosine : 0.0;
        uint32_t code;
        glint_material material;
        assert_true(glint_renderer_fragment(s.renderer, 30, 30, &code, &material));
        assert_int_equal(material.n, scene.n);
        assert_int_equal(material.r, 153); /* 255 · 0.75 · 0.8 */
        uint8_t rgb[3];
        const glint_points point = {&code, 1, NULL, &rgb[0], &rgb[1], &rgb[2]};
        assert_int_equal(glint_backend_shade(backend, &material, &point, NULL), GLINT_OK);
        for (int i = 0; i < 3; i++) {
            const double base = scene.color[i] * (0.2 * 0.5 + 0.8 * 0.75 * diffuse);
            const int sum = (int)(base + 0.5) + (cosine > 0.0 ? rgb[i] : 0);
            assert_int_equal(s.image->rgb[3 * (30 * 64 + 30) + i], sum < 255 ? sum : 255);
        }
        /* A light from behind, with the half vector still near enough to the normal for a
         * highlight: it must not show. */
        scene.light[0] = -0.3f;
        scene.light[1] = -1.0f;
        scene.light[2] = 0.2f;
        scene.n = 2;
    }
    glint_backend_destroy(backend);
    close_studio(&s);
    free(m);
}

static void the_background_is_zero(void **state)
{
    (void)state;
    glint_mesh *mesh = teapot(4);
    studio s = open_studio(97, 61, 3, GLINT_BACKEND_C);
    memset(s.image->rgb, 0xAA, (size_t)97 * 61 * 3);
    memset(s.image->object, 0xAA, (size_t)97 * 61);
    const glint_scene scene = default_scene(mesh);
    shoot(&s, &scene);
    uint64_t covered = 0;
    for (int i = 0; i < 97 * 61; i++) {
        const uint8_t *rgb = &s.image->rgb[3 * i];
        uint32_t code;
        assert_true(s.image->object[i] <= 1);
        covered += fragment(&s, i % 97, i / 97, &code);
        assert_true(s.image->object[i] == 1 || (rgb[0] == 0 && rgb[1] == 0 && rgb[2] == 0));
    }
    assert_int_equal(covered, s.stats.fragments);
    close_studio(&s);
    glint_mesh_destroy(mesh);
}

static void any_number_of_threads_gives_the_same_bits(void **state)
{
    (void)state;
    const int width = 333;
    const int height = 217;
    const size_t pixels = (size_t)width * (size_t)height;
    glint_mesh *mesh = teapot(10);
    glint_scene scene = default_scene(mesh);
    for (int view = 0; view < 3; view++) {
        scene.distance = 0.7f * (float)view; /* fitted, within, near */
        studio one = open_studio(width, height, 1, GLINT_BACKEND_C);
        shoot(&one, &scene);
        assert_true(one.stats.fragments > 1000);
        const int threads[] = {2, 3, 7};
        for (size_t i = 0; i < sizeof threads / sizeof threads[0]; i++) {
            studio more = open_studio(width, height, threads[i], GLINT_BACKEND_C);
            for (int again = 0; again < 3; again++) {
                shoot(&more, &scene);
                assert_memory_equal(one.image->rgb, more.image->rgb, 3 * pixels);
                assert_memory_equal(one.image->object, more.image->object, pixels);
                assert_int_equal(one.stats.drawn, more.stats.drawn);
                assert_int_equal(one.stats.fragments, more.stats.fragments);
            }
            close_studio(&more);
        }
        close_studio(&one);
    }
    glint_mesh_destroy(mesh);
}

static void frames_of_any_shape(void **state)
{
    (void)state;
    glint_mesh *mesh = sphere(16);
    const int sizes[][2] = {{1, 1},   {1, 33},  {129, 1},
                            {16, 16}, {17, 15}, {GLINT_IMAGE_SIDE_MAX, 2}};
    for (size_t i = 0; i < sizeof sizes / sizeof sizes[0]; i++) {
        studio s = open_studio(sizes[i][0], sizes[i][1], 2, GLINT_BACKEND_C);
        const glint_scene scene = default_scene(mesh);
        shoot(&s, &scene);
        assert_true(s.stats.fragments > 0);
        close_studio(&s);
    }
    glint_mesh_destroy(mesh);
}

static void expect_refused(studio *s, const glint_scene *scene, const char *named)
{
    glint_error err = {""};
    assert_int_equal(glint_render(s->renderer, scene, s->image, NULL, NULL, &err),
                     GLINT_BAD_ARGUMENT);
    assert_non_null(strstr(err.text, named));
}

static void bad_scene_values_are_named(void **state)
{
    (void)state;
    glint_mesh *mesh = sphere(8);
    studio s = open_studio(16, 16, 1, GLINT_BACKEND_C);
    const glint_scene good = default_scene(mesh);
    glint_scene scene;
    const struct {
        const char *name;
        size_t offset;
        float low, high; /* the first values outside on either side */
    } ranged[] = {
        {"ia", offsetof(glint_scene, ia), -0.01f, 1.01f},
        {"ie", offsetof(glint_scene, ie), -0.01f, 1.01f},
        {"ka", offsetof(glint_scene, ka), -0.01f, 1.01f},
        {"kd", offsetof(glint_scene, kd), -0.01f, 1.01f},
        {"ks", offsetof(glint_scene, ks), -0.01f, 1.01f},
        {"yaw", offsetof(glint_scene, yaw), -36001.0f, 36001.0f},
        {"pitch", offsetof(glint_scene, pitch), -36001.0f, 36001.0f},
        {"fov", offsetof(glint_scene, fov), 0.9f, 170.1f},
        {"distance", offsetof(glint_scene, distance), -0.1f, 1000.5f},
    };
    for (size_t i = 0; i < sizeof ranged / sizeof ranged[0]; i++) {
        const float values[] = {ranged[i].low, ranged[i].high, NAN, INFINITY, -INFINITY};
        for (size_t k = 0; k < sizeof values / sizeof values[0]; k++) {
            scene = good;
            memcpy((char *)&scene + ranged[i].offset, &values[k], sizeof values[k]);
            expect_refused(&s, &scene, ranged[i].name);
        }
    }
    for (int axis = 0; axis < 3; axis++) {
        scene = good;
        scene.light[axis] = axis == 1 ? INFINITY : NAN;
        expect_refused(&s, &scene, "light");
    }
    scene = good;
    memset(scene.light, 0, sizeof scene.light);
    expect_refused(&s, &scene, "light");
    scene = good;
    scene.n = GLINT_N_MAX + 1;
    expect_refused(&s, &scene, "n is 1024");
    scene = good;
    scene.mesh = NULL;
    expect_refused(&s, &scene, "mesh");
    shoot(&s, &good); /* and none of it did any harm */
    close_studio(&s);
    glint_mesh_destroy(mesh);
}

static void extreme_scene_values_are_taken(void **state)
{
    (void)state;
    glint_mesh *mesh = sphere(32);
    studio s = open_studio(64, 48, 2, GLINT_BACKEND_C);
    glint_scene scene = default_scene(mesh);
    const float lights[][3] = {{0, 0, -1}, {0, 0, 3e38f}, {1e-44f, 0, 0}, {3e38f, 3e38f, 3e38f}};
    for (size_t i = 0; i < sizeof lights / sizeof lights[0]; i++) {
        memcpy(scene.light, lights[i], sizeof scene.light);
        for (int n = 0; n <= 1023; n += 1023) {
            scene.n = (uint16_t)n;
            shoot(&s, &scene);
            assert_true(s.stats.fragments > 0);
        }
    }
    scene.fov = 170.0f;
    shoot(&s, &scene);
    scene.fov = 1.0f;
    shoot(&s, &scene);
    scene.distance = 1000.0f;
    shoot(&s, &scene);
    assert_true(s.stats.fragments > 0);
    close_studio(&s);
    glint_mesh_destroy(mesh);
}

static void bad_renderers_are_refused(void **state)
{
    (void)state;
    const glint_backend_config config = {.kind = GLINT_BACKEND_C};
    const int bad[][3] = {{0, 8, 1},
                          {8, 0, 1},
                          {-1, 8, 1},
                          {GLINT_IMAGE_SIDE_MAX + 1, 8, 1},
                          {8, GLINT_IMAGE_SIDE_MAX + 1, 1},
                          {8, 8, 0},
                          {8, 8, -1},
                          {8, 8, 65}};
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        glint_renderer *renderer = NULL;
        glint_error err = {""};
        assert_int_equal(
            glint_renderer_create(bad[i][0], bad[i][1], bad[i][2], &config, &renderer, &err),
            GLINT_BAD_ARGUMENT);
        assert_null(renderer);
        assert_string_not_equal(err.text, "");
    }
    glint_renderer_destroy(NULL);
}

static void an_image_of_another_size_is_refused(void **state)
{
    (void)state;
    glint_mesh *mesh = sphere(8);
    studio s = open_studio(16, 16, 1, GLINT_BACKEND_C);
    const glint_scene scene = default_scene(mesh);
    glint_image *other = NULL;
    assert_int_equal(glint_image_create(16, 17, &other, NULL), GLINT_OK);
    glint_error err = {""};
    assert_int_equal(glint_render(s.renderer, &scene, other, NULL, NULL, &err), GLINT_BAD_ARGUMENT);
    assert_non_null(strstr(err.text, "16x17"));
    glint_image_destroy(other);
    close_studio(&s);
    glint_mesh_destroy(mesh);
}

static void a_raised_stop_flag_gives_the_frame_up(void **state)
{
    (void)state;
    glint_mesh *mesh = teapot(4);
    studio s = open_studio(64, 48, 3, GLINT_BACKEND_C);
    const glint_scene scene = default_scene(mesh);
    volatile bool stop = true;
    glint_error err = {""};
    assert_int_equal(glint_render(s.renderer, &scene, s.image, &stop, NULL, &err),
                     GLINT_INTERRUPTED);
    assert_string_not_equal(err.text, "");
    uint32_t code;
    glint_material material;
    assert_false(glint_renderer_fragment(s.renderer, 32, 24, &code, &material));
    stop = false;
    assert_int_equal(glint_render(s.renderer, &scene, s.image, &stop, NULL, &err), GLINT_OK);
    assert_true(glint_renderer_fragment(s.renderer, 32, 24, &code, &material));
    assert_false(glint_renderer_fragment(s.renderer, -1, 24, &code, &material));
    assert_false(glint_renderer_fragment(s.renderer, 32, 48, &code, &material));
    close_studio(&s);
    glint_mesh_destroy(mesh);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(interpolation_is_perspective_correct),
        cmocka_unit_test(cosines_on_the_sphere),
        cmocka_unit_test(a_closed_mesh_shows_no_holes),
        cmocka_unit_test(the_fitted_object_touches_the_frame),
        cmocka_unit_test(a_floor_through_the_near_plane),
        cmocka_unit_test(a_camera_inside),
        cmocka_unit_test(the_nearer_is_seen),
        cmocka_unit_test(the_first_of_equals_is_seen),
        cmocka_unit_test(crossing_triangles_part_where_they_meet),
        cmocka_unit_test(a_square_seen_from_behind_is_not),
        cmocka_unit_test(the_picture_is_base_and_highlight),
        cmocka_unit_test(the_background_is_zero),
        cmocka_unit_test(any_number_of_threads_gives_the_same_bits),
        cmocka_unit_test(frames_of_any_shape),
        cmocka_unit_test(bad_scene_values_are_named),
        cmocka_unit_test(extreme_scene_values_are_taken),
        cmocka_unit_test(bad_renderers_are_refused),
        cmocka_unit_test(an_image_of_another_size_is_refused),
        cmocka_unit_test(a_raised_stop_flag_gives_the_frame_up),
    };
    return cmocka_run_group_tests_name("frame", tests, NULL, NULL);
}
