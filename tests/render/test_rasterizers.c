/* The rasterizers of the thesis's list, each against a computation of its own: ISC and `mixed`
 * against whole frames, cheaper cosines against vectors found another way, quarters against a mesh
 * cut by hand, the reflection map against Phong's shading with the viewer far away. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "circuit/circuits.h"
#include "reflectance/vec3.h"
#include "render/mesh_build.h"
#include "render/pick.h"
#include "render/reflection_map.h"
#include "render/shadings.h"
#include "studio.h"

#define WIDTH  144
#define HEIGHT 108

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

static glint_mesh *quad(void)
{
    glint_mesh *mesh = NULL;
    assert_int_equal(glint_mesh_quad(&mesh, NULL), GLINT_OK);
    return mesh;
}

/* Three corners with normals that lean apart; by `lean` 0 all alike. degenerate: no area. */
static glint_mesh *triangle(double lean, bool degenerate)
{
    glint_mesh *mesh = NULL;
    const glint_vec3 place[3] = {
        {-1, -1, 0}, {1, -1, 0}, {degenerate ? 0 : -0.2, degenerate ? -1 : 1, 0}};
    assert_int_equal(glint_mesh_new("triangle", 3, 1, &mesh, NULL), GLINT_OK);
    for (int i = 0; i < 3; i++) {
        const glint_vec3 n = {lean * place[i].x - 0.3, lean * place[i].y + 0.35, 1.0};
        glint_mesh_add_vertex(mesh, place[i], glint_vec3_scale(n, 1.0 / glint_vec3_length(n)));
    }
    glint_mesh_add_triangle(mesh, 0, 1, 2);
    return mesh;
}

static glint_scene default_scene(const glint_mesh *mesh, glint_shading shading, double n)
{
    glint_scene scene = {.mesh = mesh};
    glint_scene_defaults(&scene);
    scene.shading = shading;
    scene.n = n;
    return scene;
}

static uint64_t differing(const studio *a, const studio *b)
{
    glint_image_difference difference;
    assert_int_equal(glint_image_compare(a->image, b->image, &difference, NULL), GLINT_OK);
    return difference.differing_pixels + difference.mask_pixels;
}

static double nmse(const studio *a, const studio *b)
{
    glint_image_difference difference;
    assert_int_equal(glint_image_compare(a->image, b->image, &difference, NULL), GLINT_OK);
    return difference.nmse;
}

/* ---- ISC ------------------------------------------------------------------------------------- */

static studio open_device(glint_backend_kind kind, const glint_circuit *device, glint_gate gate,
                          int threads)
{
    const glint_backend_config config = {
        .kind = kind, .device = device, .gate = gate, .pipeline = GLINT_PIPELINE_PIPELINED};
    studio s = {0};
    glint_error err = {""};
    assert_int_equal(glint_renderer_create(WIDTH, HEIGHT, threads, &config, &s.renderer, &err),
                     GLINT_OK);
    assert_int_equal(glint_image_create(WIDTH, HEIGHT, &s.image, &err), GLINT_OK);
    return s;
}

typedef struct saving {
    uint64_t skipped, frames_with_less;
} saving;

/* The same picture; counts what was saved. */
static void expect_same_with_isc(studio *with, studio *without, const glint_scene *scene,
                                 saving *saved)
{
    glint_scene isc = *scene;
    isc.isc = true;
    shoot(without, scene);
    shoot(with, &isc);
    if (differing(with, without) != 0)
        fail_msg("n = %g, light %g,%g,%g: %d pixels differ", scene->n, (double)scene->light[0],
                 (double)scene->light[1], (double)scene->light[2], (int)differing(with, without));
    assert_true(with->stats.highlights <= without->stats.highlights);
    assert_true(with->stats.sheen <= with->stats.drawn);
    assert_int_equal(with->stats.fragments, without->stats.fragments);
    saved->skipped += without->stats.highlights - with->stats.highlights;
    saved->frames_with_less += without->stats.highlights > with->stats.highlights;
}

static void over_scenes(studio *with, studio *without, saving *saved)
{
    static const float lights[][3] = {{-1, 1.2f, 1.6f}, {1, 0, 0}, {0, 0, -1}, {0.3f, 1, -2}};
    static const double exponents[] = {0, 1, 2, 5, 20, 80, 300, 1023};
    glint_mesh *const meshes[] = {
        teapot(3),          teapot(8),         sphere(8), sphere(40), quad(), triangle(0.4, false),
        triangle(0, false), triangle(2, false)};
    for (size_t m = 0; m < sizeof meshes / sizeof meshes[0]; m++) {
        for (size_t l = 0; l < 4; l++) {
            for (size_t i = 0; i < 8; i++) {
                glint_scene scene = default_scene(meshes[m], GLINT_SHADING_PHONG, exponents[i]);
                memcpy(scene.light, lights[l], sizeof scene.light);
                scene.distance = l == 1 ? 0.9f : 0.0f; /* so near that triangles are clipped */
                scene.fov = l == 2 ? 120.0f : 35.0f;
                expect_same_with_isc(with, without, &scene, saved);
            }
        }
        glint_mesh_destroy(meshes[m]);
    }
}

static void isc_does_not_change_the_picture(void **state)
{
    (void)state;
    const struct {
        const glint_circuit *device;
        glint_gate gate;
        bool saves; /* the gates as printed light what lies outside the highlight */
    } devices[] = {{NULL, GLINT_GATE_COSINE, true},
                   {NULL, GLINT_GATE_SIGN, true},
                   {NULL, GLINT_GATE_DRAWN, false},
                   {glint_circuit_named("power"), GLINT_GATE_COSINE, true}};
    for (size_t i = 0; i < sizeof devices / sizeof devices[0]; i++) {
        for (int kind = 0; kind < GLINT_BACKEND_COUNT; kind += 2) { /* c, real */
            saving saved = {0};
            studio with =
                open_device((glint_backend_kind)kind, devices[i].device, devices[i].gate, 2);
            studio without =
                open_device((glint_backend_kind)kind, devices[i].device, devices[i].gate, 2);
            over_scenes(&with, &without, &saved);
            if (devices[i].saves)
                assert_true(saved.skipped > 100000 && saved.frames_with_less > 100);
            close_studio(&with);
            close_studio(&without);
        }
    }
}

static void isc_does_not_change_the_pictures_of_models(void **state)
{
    (void)state;
    glint_mesh *mesh = teapot(6);
    studio with = open_studio(WIDTH, HEIGHT, 2, GLINT_BACKEND_REAL);
    studio without = open_studio(WIDTH, HEIGHT, 2, GLINT_BACKEND_REAL);
    saving saved = {0};
    for (int model = 0; model < GLINT_REFLECTANCE_COUNT; model++) {
        for (int n = 2; n <= 400; n *= 10) {
            glint_scene scene = default_scene(mesh, GLINT_SHADING_PHONG, n);
            scene.by_model = true;
            scene.specular = (glint_reflectance_model)model;
            expect_same_with_isc(&with, &without, &scene, &saved);
        }
    }
    assert_true(saved.frames_with_less > GLINT_REFLECTANCE_COUNT);
    close_studio(&with);
    close_studio(&without);
    glint_mesh_destroy(mesh);
}

/* A renderer keeps what it knows of a material no longer than it is true. */
static void isc_follows_the_material(void **state)
{
    (void)state;
    glint_mesh *mesh = teapot(6);
    studio with = open_studio(WIDTH, HEIGHT, 1, GLINT_BACKEND_C);
    studio without = open_studio(WIDTH, HEIGHT, 1, GLINT_BACKEND_C);
    saving saved = {0};
    for (int turn = 0; turn < 3; turn++) {
        glint_scene scene = default_scene(mesh, GLINT_SHADING_PHONG, turn == 1 ? 3 : 300);
        expect_same_with_isc(&with, &without, &scene, &saved);
        scene.ks = 0.1f;
        expect_same_with_isc(&with, &without, &scene, &saved);
    }
    close_studio(&with);
    close_studio(&without);
    glint_mesh_destroy(mesh);
}

/* ---- Mixed ----------------------------------------------------------------------------------- */

/* Every pixel is that of gouraud or of phong, whole triangles of one or the other; with a threshold
 * above everything all of them are gouraud's, and where every triangle has a highlight, phong's. */
static void mixed_is_gouraud_or_phong(void **state)
{
    (void)state;
    glint_mesh *mesh = teapot(6);
    studio s[3]; /* mixed, gouraud, phong */
    static const glint_shading shadings[] = {GLINT_SHADING_MIXED, GLINT_SHADING_GOURAUD,
                                             GLINT_SHADING_PHONG};
    for (int i = 0; i < 3; i++) {
        const glint_scene scene = default_scene(mesh, shadings[i], 60);
        s[i] = open_studio(WIDTH, HEIGHT, 2, GLINT_BACKEND_C);
        shoot(&s[i], &scene);
    }
    uint64_t as_gouraud = 0, as_phong = 0;
    for (size_t i = 0; i < (size_t)WIDTH * HEIGHT; i++) {
        const uint8_t *mixed = &s[0].image->rgb[3 * i];
        const bool gouraud = memcmp(mixed, &s[1].image->rgb[3 * i], 3) == 0;
        const bool phong = memcmp(mixed, &s[2].image->rgb[3 * i], 3) == 0;
        assert_true(gouraud || phong);
        as_gouraud += gouraud && !phong;
        as_phong += phong && !gouraud;
    }
    assert_true(as_gouraud > 100 && as_phong > 100);
    assert_true(nmse(&s[2], &s[0]) < 0.2 * nmse(&s[2], &s[1]));
    glint_scene scene = default_scene(mesh, GLINT_SHADING_MIXED, 60);
    scene.delta = 255;
    shoot(&s[0], &scene);
    assert_int_equal(differing(&s[0], &s[1]), 0);
    scene.delta = 0;
    scene.n = 0; /* W is not 0 anywhere in the light */
    shoot(&s[0], &scene);
    scene.shading = GLINT_SHADING_PHONG;
    shoot(&s[2], &scene);
    assert_true(nmse(&s[2], &s[0]) < 1e-3);
    for (int i = 0; i < 3; i++)
        close_studio(&s[i]);
    glint_mesh_destroy(mesh);
}

/* ---- Quarters -------------------------------------------------------------------------------- */

/* The same triangles cut by hand: a mesh of its own, vertex by vertex. */
static glint_mesh *cut_by_hand(const glint_mesh *whole)
{
    static const int quarters[4][3] = {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}, {4, 5, 3}};
    glint_mesh *mesh = NULL;
    assert_int_equal(
        glint_mesh_new("cut", 6 * whole->triangle_count, 4 * whole->triangle_count, &mesh, NULL),
        GLINT_OK);
    for (size_t t = 0; t < whole->triangle_count; t++) {
        const uint32_t first = (uint32_t)mesh->vertex_count;
        glint_vec3 p[3], n[3];
        for (size_t i = 0; i < 3; i++) {
            p[i] = glint_vec3_of(&whole->position[3 * (size_t)whole->index[3 * t + i]]);
            n[i] = glint_vec3_of(&whole->normal[3 * (size_t)whole->index[3 * t + i]]);
            glint_mesh_add_vertex(mesh, p[i], n[i]);
        }
        for (size_t i = 0; i < 3; i++) {
            const glint_vec3 sum = glint_vec3_add(n[i], n[(i + 1) % 3]);
            glint_mesh_add_vertex(mesh, glint_vec3_scale(glint_vec3_add(p[i], p[(i + 1) % 3]), 0.5),
                                  glint_vec3_scale(sum, 1.0 / glint_vec3_length(sum)));
        }
        for (int q = 0; q < 4; q++)
            glint_mesh_add_triangle(mesh, first + (uint32_t)quarters[q][0],
                                    first + (uint32_t)quarters[q][1],
                                    first + (uint32_t)quarters[q][2]);
    }
    return mesh;
}

static void expect_quarters(glint_mesh *whole, float distance)
{
    glint_mesh *cut = cut_by_hand(whole);
    studio a = open_studio(WIDTH, HEIGHT, 2, GLINT_BACKEND_C);
    studio b = open_studio(WIDTH, HEIGHT, 2, GLINT_BACKEND_C);
    glint_scene scene = default_scene(whole, GLINT_SHADING_GOURAUD_4, 20);
    scene.distance = distance;
    shoot(&a, &scene);
    assert_true(a.stats.fragments > 500);
    assert_in_range(a.stats.drawn, 1, whole->triangle_count);
    uint32_t source;
    bool found = false;
    for (int x = 0; x < WIDTH; x++)
        if (glint_renderer_triangle(a.renderer, x, HEIGHT / 2, &source)) {
            assert_true(source < whole->triangle_count);
            found = true;
        }
    assert_true(found);
    scene.mesh = cut;
    scene.shading = GLINT_SHADING_GOURAUD;
    shoot(&b, &scene);
    assert_int_equal(differing(&a, &b), 0);
    close_studio(&a);
    close_studio(&b);
    glint_mesh_destroy(cut);
    glint_mesh_destroy(whole);
}

static void quarters_are_a_mesh_cut_in_four(void **state)
{
    (void)state;
    expect_quarters(teapot(4), 0.0f);
    expect_quarters(sphere(16), 0.0f);
    expect_quarters(quad(), 0.5f); /* clipped at the near plane */
    expect_quarters(triangle(0.5, false), 0.0f);
}

/* ---- Cheaper cosines ------------------------------------------------------------------------- */

/* Weights of the corners at a pixel's centre, on the screen, of a triangle in the plane z = 0 seen
 * straight on from `distance` radii: there the screen and the plane differ by a scale. */
typedef struct view {
    double scale, half_width, half_height, distance, radius;
    glint_vec3 centre;
} view;

static view view_of(const glint_scene *scene)
{
    view v = {.half_width = WIDTH / 2.0, .half_height = HEIGHT / 2.0};
    const double focal =
        v.half_height / tan(0.5 * (double)scene->fov * 3.14159265358979323846 / 180);
    glint_vec3 p[3], low, high;
    for (int i = 0; i < 3; i++)
        p[i] = glint_vec3_of(&scene->mesh->position[3 * i]);
    low = high = p[0];
    for (int i = 1; i < 3; i++) {
        low = (glint_vec3){fmin(low.x, p[i].x), fmin(low.y, p[i].y), 0};
        high = (glint_vec3){fmax(high.x, p[i].x), fmax(high.y, p[i].y), 0};
    }
    v.centre = glint_vec3_scale(glint_vec3_add(low, high), 0.5);
    for (int i = 0; i < 3; i++)
        v.radius = fmax(v.radius, glint_vec3_length(glint_vec3_sub(p[i], v.centre)));
    v.distance = (double)scene->distance;
    v.scale = focal / (v.distance * v.radius);
    return v;
}

static double cross2(glint_vec3 a, glint_vec3 b, glint_vec3 c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

static glint_vec3 unit(glint_vec3 v)
{
    return glint_vec3_scale(v, 1.0 / glint_vec3_length(v));
}

static double cosine_at(const glint_scene *scene, const view *v, glint_vec3 place, glint_vec3 n)
{
    const glint_vec3 from = glint_vec3_scale(glint_vec3_sub(place, v->centre), 1.0 / v->radius);
    const glint_vec3 eye = unit((glint_vec3){-from.x, -from.y, v->distance});
    return glint_vec3_dot(n, unit(glint_vec3_add(unit(glint_vec3_of(scene->light)), eye)));
}

/* What the shading's cosine must be at a pixel. */
static double expected_cosine(const glint_scene *scene, const view *v, int x, int y)
{
    const glint_vec3 at = {v->centre.x + (x + 0.5 - v->half_width) / v->scale,
                           v->centre.y - (y + 0.5 - v->half_height) / v->scale, 0};
    glint_vec3 p[3], n[3], sum = {0, 0, 0};
    double share[3], linear = 0.0;
    for (int i = 0; i < 3; i++) {
        p[i] = glint_vec3_of(&scene->mesh->position[3 * i]);
        n[i] = glint_vec3_of(&scene->mesh->normal[3 * i]);
    }
    for (int i = 0; i < 3; i++) {
        share[i] = cross2(at, p[(i + 1) % 3], p[(i + 2) % 3]) / cross2(p[0], p[1], p[2]);
        sum = glint_vec3_add(sum, glint_vec3_scale(n[i], share[i]));
        linear += share[i] * cosine_at(scene, v, p[i], n[i]);
    }
    switch (scene->shading) {
    case GLINT_SHADING_COSINE_LINEAR:
        return linear;
    case GLINT_SHADING_PHONG_UNNORMALISED:
        return cosine_at(scene, v, at, sum);
    case GLINT_SHADING_PHONG_NEWTON:
        return cosine_at(scene, v, at,
                         glint_vec3_scale(sum, 0.5 * (3.0 - glint_vec3_dot(sum, sum))));
    default:
        return cosine_at(scene, v, at, unit(sum));
    }
}

static void cosines_are_what_they_are_called(void **state)
{
    (void)state;
    static const glint_shading shadings[] = {GLINT_SHADING_PHONG, GLINT_SHADING_COSINE_LINEAR,
                                             GLINT_SHADING_PHONG_UNNORMALISED,
                                             GLINT_SHADING_PHONG_NEWTON};
    glint_mesh *mesh = triangle(0.5, false);
    studio s = open_studio(WIDTH, HEIGHT, 2, GLINT_BACKEND_C);
    for (size_t i = 0; i < sizeof shadings / sizeof shadings[0]; i++) {
        glint_scene scene = default_scene(mesh, shadings[i], 10);
        scene.yaw = scene.pitch = 0.0f;
        scene.distance = 4.0f;
        const view v = view_of(&scene);
        shoot(&s, &scene);
        uint64_t pixels = 0;
        for (int y = 0; y < HEIGHT; y++)
            for (int x = 0; x < WIDTH; x++) {
                uint32_t code;
                glint_material material;
                if (!glint_renderer_fragment(s.renderer, x, y, &code, &material))
                    continue;
                const double expected = expected_cosine(&scene, &v, x, y) * GLINT_COS_ONE;
                /* a corner is rounded to 1/4096 pixel, some 2e-6 of this triangle's height */
                if (fabs(code - expected) > 4.0)
                    fail_msg("%s, pixel %d,%d: code %d, not %.2f", glint_shading_names[shadings[i]],
                             x, y, (int)code, expected);
                pixels++;
            }
        assert_true(pixels > 1000);
    }
    close_studio(&s);
    glint_mesh_destroy(mesh);
}

/* Where all normals are alike, interpolating or normalising them makes no difference. */
static void alike_normals_are_alike_in_all(void **state)
{
    (void)state;
    glint_mesh *mesh = triangle(0.0, false);
    studio a = open_studio(WIDTH, HEIGHT, 1, GLINT_BACKEND_C);
    studio b = open_studio(WIDTH, HEIGHT, 1, GLINT_BACKEND_C);
    for (int n = 1; n <= 1000; n *= 10) {
        glint_scene scene = default_scene(mesh, GLINT_SHADING_PHONG, n);
        shoot(&a, &scene);
        scene.shading = GLINT_SHADING_PHONG_UNNORMALISED;
        shoot(&b, &scene);
        assert_true(nmse(&a, &b) < 1e-6);
        scene.shading = GLINT_SHADING_PHONG_NEWTON;
        shoot(&b, &scene);
        assert_true(nmse(&a, &b) < 1e-6);
    }
    close_studio(&a);
    close_studio(&b);
    glint_mesh_destroy(mesh);
}

/* ---- The reflection map ---------------------------------------------------------------------- */

/* With the viewer as good as at infinity the only error is the table's; it falls with its size. */
static void the_maps_error_falls_with_its_size(void **state)
{
    (void)state;
    static const int sizes[] = {16, 64, 256, 1024};
    glint_mesh *mesh = sphere(64);
    studio a = open_studio(WIDTH, HEIGHT, 2, GLINT_BACKEND_C);
    studio b = open_studio(WIDTH, HEIGHT, 2, GLINT_BACKEND_C);
    double last = 1.0;
    for (int i = 0; i < 4; i++) {
        glint_scene scene = default_scene(mesh, GLINT_SHADING_PHONG, 20);
        scene.fov = 1.0f;
        shoot(&a, &scene);
        scene.shading = GLINT_SHADING_REFLECTION_MAP;
        scene.map_size = sizes[i];
        shoot(&b, &scene);
        assert_true(nmse(&a, &b) < last / 3.0);
        assert_int_equal(b.stats.highlights, (uint64_t)sizes[i] * (uint64_t)sizes[i]);
        last = nmse(&a, &b);
        shoot(&b, &scene); /* the table is kept */
        assert_int_equal(b.stats.highlights, 0);
        assert_true(nmse(&a, &b) == last);
    }
    assert_true(last < 1e-4);
    close_studio(&a);
    close_studio(&b);
    glint_mesh_destroy(mesh);
}

static void the_map_follows_light_and_material(void **state)
{
    (void)state;
    glint_mesh *mesh = sphere(32);
    studio kept = open_studio(WIDTH, HEIGHT, 2, GLINT_BACKEND_C);
    for (int turn = 0; turn < 6; turn++) {
        glint_scene scene = default_scene(mesh, GLINT_SHADING_REFLECTION_MAP, turn == 1 ? 5 : 50);
        studio fresh = open_studio(WIDTH, HEIGHT, 2, GLINT_BACKEND_C);
        scene.light[0] = turn == 2 ? 1.0f : -1.0f;
        scene.color[2] = turn == 3 ? 255 : 40;
        scene.ks = turn == 4 ? 0.1f : 0.8f;
        scene.map_size = turn == 5 ? 20 : 100;
        shoot(&kept, &scene);
        shoot(&fresh, &scene);
        assert_int_equal(differing(&kept, &fresh), 0);
        close_studio(&fresh);
    }
    close_studio(&kept);
    glint_mesh_destroy(mesh);
}

/* ---- Wires and normals ----------------------------------------------------------------------- */

/* A triangle seen straight on: black inside, the object's colour where an edge is near. */
static void wires_are_along_the_edges(void **state)
{
    (void)state;
    glint_mesh *mesh = triangle(0.0, false);
    studio s = open_studio(WIDTH, HEIGHT, 2, GLINT_BACKEND_REAL);
    glint_scene scene = default_scene(mesh, GLINT_SHADING_WIRES, 10);
    scene.yaw = scene.pitch = 0.0f;
    scene.distance = 4.0f;
    const view v = view_of(&scene);
    shoot(&s, &scene);
    uint64_t wires = 0, black = 0;
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++) {
            const size_t i = (size_t)y * WIDTH + (size_t)x;
            const glint_vec3 at = {v.centre.x + (x + 0.5 - v.half_width) / v.scale,
                                   v.centre.y - (y + 0.5 - v.half_height) / v.scale, 0};
            double least = 1e9;
            for (int k = 0; k < 3; k++) {
                const glint_vec3 a = glint_vec3_of(&mesh->position[3 * k]);
                const glint_vec3 b = glint_vec3_of(&mesh->position[3 * ((k + 1) % 3)]);
                least = fmin(least, fabs(cross2(a, b, at)) /
                                        glint_vec3_length(glint_vec3_sub(b, a)) * v.scale);
            }
            if (!s.image->object[i] || fabs(least - 0.5) < 0.01)
                continue;
            const bool is_wire = memcmp(&s.image->rgb[3 * i], scene.color, 3) == 0;
            assert_int_equal(is_wire, least < 0.5);
            wires += is_wire;
            black += s.image->rgb[3 * i] == 0;
        }
    assert_true(wires > 50 && black > 1000);
    close_studio(&s);
    glint_mesh_destroy(mesh);
}

static void normals_are_colors(void **state)
{
    (void)state;
    glint_mesh *mesh = triangle(0.0, false);
    studio s = open_studio(WIDTH, HEIGHT, 2, GLINT_BACKEND_REAL);
    glint_scene scene = default_scene(mesh, GLINT_SHADING_NORMALS, 10);
    scene.yaw = scene.pitch = 0.0f;
    shoot(&s, &scene);
    for (size_t i = 0; i < (size_t)WIDTH * HEIGHT; i++)
        for (int c = 0; c < 3 && s.image->object[i]; c++)
            assert_true(fabs(127.5 * ((double)mesh->normal[c] + 1.0) -
                             s.image->rgb[3 * i + (size_t)c]) <= 0.501);
    assert_true(s.stats.fragments > 1000);
    close_studio(&s);
    glint_mesh_destroy(mesh);
}

/* ---- All of them ----------------------------------------------------------------------------- */

static void expect_alike(const glint_scene *scene, glint_backend_kind one, int threads_of_one,
                         glint_backend_kind other, int threads_of_other)
{
    studio a = open_studio(WIDTH, HEIGHT, threads_of_one, one);
    studio b = open_studio(WIDTH, HEIGHT, threads_of_other, other);
    shoot(&a, scene);
    shoot(&b, scene);
    if (differing(&a, &b) != 0)
        fail_msg("%s: %d pixels differ", glint_shading_names[scene->shading],
                 (int)differing(&a, &b));
    close_studio(&a);
    close_studio(&b);
}

static void frames_do_not_depend_on_threads_nor_circuits_on_models(void **state)
{
    (void)state;
    glint_mesh *mesh = teapot(5);
    for (int i = GLINT_SHADING_PHONG; i < GLINT_SHADING_COUNT; i++) {
        const glint_shading shading = (glint_shading)i;
        const glint_backend_kind kind =
            glint_shading_uses_circuit(shading) ? GLINT_BACKEND_C : GLINT_BACKEND_REAL;
        glint_scene scene = default_scene(mesh, shading, 30);
        expect_alike(&scene, kind, 1, kind, 5);
        if (kind == GLINT_BACKEND_C)
            expect_alike(&scene, GLINT_BACKEND_C, 2, GLINT_BACKEND_RTL, 2);
        scene.isc = shading == GLINT_SHADING_PHONG;
        expect_alike(&scene, kind, 3, kind, 1);
    }
    glint_mesh_destroy(mesh);
}

/* All cover what Phong's shading covers; a triangle without area covers nothing. */
static void all_cover_the_same(void **state)
{
    (void)state;
    glint_mesh *mesh = sphere(24), *flat = triangle(0.3, true), *small = triangle(0.3, false);
    studio phong = open_studio(WIDTH, HEIGHT, 1, GLINT_BACKEND_REAL);
    studio s = open_studio(WIDTH, HEIGHT, 1, GLINT_BACKEND_REAL);
    glint_scene scene = default_scene(mesh, GLINT_SHADING_PHONG, 1);
    for (int i = 0; i < GLINT_SHADING_COUNT; i++) {
        uint64_t other = 0;
        scene.mesh = mesh;
        scene.shading = GLINT_SHADING_PHONG;
        shoot(&phong, &scene);
        scene.shading = (glint_shading)i;
        shoot(&s, &scene);
        for (size_t k = 0; k < (size_t)WIDTH * HEIGHT; k++)
            other += s.image->object[k] != phong.image->object[k];
        /* quarters round the middles of their edges to the screen's units */
        assert_true(other <= (i == GLINT_SHADING_GOURAUD_4 ? 3u : 0u));
        scene.mesh = flat;
        shoot(&s, &scene);
        assert_int_equal(s.stats.fragments, 0);
        scene.mesh = small;
        shoot(&s, &scene);
        assert_true(s.stats.fragments > 1000);
    }
    close_studio(&phong);
    close_studio(&s);
    glint_mesh_destroy(mesh);
    glint_mesh_destroy(flat);
    glint_mesh_destroy(small);
}

static void expect_refused(studio *s, const glint_scene *scene, const char *why)
{
    glint_error err;
    assert_int_equal(glint_render(s->renderer, scene, s->image, NULL, NULL, &err),
                     GLINT_BAD_ARGUMENT);
    assert_string_equal(err.text, why);
}

static void what_does_not_fit_is_refused(void **state)
{
    (void)state;
    glint_mesh *mesh = sphere(8);
    studio c = open_studio(WIDTH, HEIGHT, 1, GLINT_BACKEND_C);
    studio real = open_studio(WIDTH, HEIGHT, 1, GLINT_BACKEND_REAL);
    glint_scene scene = default_scene(mesh, GLINT_SHADING_WIRES, 10);
    expect_refused(&c, &scene,
                   "shading wires needs backend real: nothing in it comes from a circuit");
    scene.shading = GLINT_SHADING_COSINE_LINEAR;
    scene.by_model = true;
    scene.specular = GLINT_REFLECTANCE_PHONG;
    expect_refused(
        &real, &scene,
        "shading cosine-linear has N·L and N·H only, and model phong needs other cosines");
    scene.by_model = false;
    scene.isc = true;
    expect_refused(&real, &scene,
                   "ISC is for shading phong: cosine-linear does not compute a highlight for each "
                   "pixel");
    scene.isc = false;
    scene.map_size = 1025;
    expect_refused(&c, &scene, "scene: map_size is 1025, not from 2 to 1024");
    scene.map_size = 2;
    scene.delta = 256;
    expect_refused(&c, &scene, "scene: delta is 256, not from 0 to 255");
    scene.delta = 0;
    shoot(&c, &scene);
    close_studio(&c);
    close_studio(&real);
    glint_mesh_destroy(mesh);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(isc_does_not_change_the_picture),
        cmocka_unit_test(isc_does_not_change_the_pictures_of_models),
        cmocka_unit_test(isc_follows_the_material),
        cmocka_unit_test(mixed_is_gouraud_or_phong),
        cmocka_unit_test(quarters_are_a_mesh_cut_in_four),
        cmocka_unit_test(cosines_are_what_they_are_called),
        cmocka_unit_test(alike_normals_are_alike_in_all),
        cmocka_unit_test(the_maps_error_falls_with_its_size),
        cmocka_unit_test(the_map_follows_light_and_material),
        cmocka_unit_test(wires_are_along_the_edges),
        cmocka_unit_test(normals_are_colors),
        cmocka_unit_test(frames_do_not_depend_on_threads_nor_circuits_on_models),
        cmocka_unit_test(all_cover_the_same),
        cmocka_unit_test(what_does_not_fit_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
