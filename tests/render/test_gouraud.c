/* Whole frames with flat and Gouraud's shading: the same pixels as Phong's, colours against values
 * computed otherwise, the same bits by the C model and by the Verilog and for any number of
 * threads. */
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

/* Third-party meshes, from Debian's assimp-testmodels. */
#define SPIDER "/usr/share/assimp/models/OBJ/spider.obj"
#define FELS   "/usr/share/assimp/models/3DS/fels.3ds"

static glint_image_difference compare(const studio *a, const studio *b)
{
    glint_image_difference difference;
    assert_int_equal(glint_image_compare(a->image, b->image, &difference, NULL), GLINT_OK);
    return difference;
}

static void expect_equal(const studio *a, const studio *b)
{
    const glint_image_difference difference = compare(a, b);
    assert_int_equal(difference.differing_pixels, 0);
    assert_int_equal(difference.mask_pixels, 0);
    assert_true(difference.object_pixels > 0);
}

static glint_scene scene_of(const glint_mesh *mesh, glint_shading shading)
{
    glint_scene scene = {.mesh = mesh};
    glint_scene_defaults(&scene);
    assert_int_equal(scene.shading, GLINT_SHADING_PHONG);
    assert_int_equal(scene.shifts, GLINT_DIVIDER_SHIFTS_DEFAULT);
    scene.shading = shading;
    return scene;
}

enum { TEAPOT, COARSE_TEAPOT, SPHERE, COARSE_SPHERE, QUAD, SPIDER_MESH, FELS_MESH, MESHES };

static glint_mesh *mesh_of(int which)
{
    glint_mesh *mesh = NULL;
    glint_error err = {""};
    glint_status status = GLINT_OK;
    switch (which) {
    case TEAPOT:
        status = glint_mesh_teapot(12, &mesh, &err);
        break;
    case COARSE_TEAPOT:
        status = glint_mesh_teapot(2, &mesh, &err);
        break;
    case SPHERE:
        status = glint_mesh_sphere(64, &mesh, &err);
        break;
    case COARSE_SPHERE:
        status = glint_mesh_sphere(8, &mesh, &err);
        break;
    case QUAD:
        status = glint_mesh_quad(&mesh, &err);
        break;
    default:
        status = glint_mesh_load(which == SPIDER_MESH ? SPIDER : FELS, NULL, &mesh, &err);
    }
    assert_string_equal(err.text, "");
    assert_int_equal(status, GLINT_OK);
    return mesh;
}

static void every_shading_covers_the_same_pixels(void **state)
{
    (void)state;
    studio phong = open_studio(211, 157, 2, GLINT_BACKEND_C);
    studio other = open_studio(211, 157, 2, GLINT_BACKEND_C);
    for (int which = 0; which < MESHES; which++) {
        glint_mesh *mesh = mesh_of(which);
        for (int near = 0; near < 2; near++) { /* once from so near that the near plane cuts */
            for (int shading = 0; shading < GLINT_SHADING_PHONG; shading++) {
                glint_scene scene = scene_of(mesh, GLINT_SHADING_PHONG);
                scene.distance = near ? 0.6f : 0.0f;
                shoot(&phong, &scene);
                scene.shading = (glint_shading)shading;
                shoot(&other, &scene);
                assert_int_equal(compare(&phong, &other).mask_pixels, 0);
                assert_int_equal(phong.stats.fragments, other.stats.fragments);
                assert_int_equal(phong.stats.drawn, other.stats.drawn);
            }
        }
        glint_mesh_destroy(mesh);
    }
    close_studio(&other);
    close_studio(&phong);
}

static void any_number_of_threads_gives_the_same(void **state)
{
    (void)state;
    static const int threads[] = {2, 3, 7};
    glint_mesh *mesh = mesh_of(TEAPOT);
    for (int shading = 0; shading <= GLINT_SHADING_PHONG; shading++) {
        const glint_scene scene = scene_of(mesh, (glint_shading)shading);
        studio one = open_studio(300, 210, 1, GLINT_BACKEND_C);
        shoot(&one, &scene);
        for (size_t i = 0; i < sizeof threads / sizeof threads[0]; i++) {
            studio more = open_studio(300, 210, threads[i], GLINT_BACKEND_C);
            shoot(&more, &scene);
            shoot(&more, &scene); /* nor does what was drawn before matter */
            expect_equal(&one, &more);
            assert_memory_equal(&one.stats.operations, &more.stats.operations,
                                sizeof one.stats.operations);
            assert_int_equal(one.stats.highlights, more.stats.highlights);
            close_studio(&more);
        }
        close_studio(&one);
    }
    glint_mesh_destroy(mesh);
}

static void c_and_rtl_give_the_same_bits(void **state)
{
    (void)state;
    static const int shifts[] = {6, 7, 8, GLINT_DIVIDER_SHIFTS_DEFAULT, 16};
    studio c = open_studio(320, 240, 2, GLINT_BACKEND_C);
    studio rtl = open_studio(320, 240, 2, GLINT_BACKEND_RTL);
    for (int which = 0; which < MESHES; which++) {
        glint_mesh *mesh = mesh_of(which);
        for (size_t i = 0; i < sizeof shifts / sizeof shifts[0]; i++) {
            glint_scene scene = scene_of(mesh, GLINT_SHADING_GOURAUD);
            scene.shifts = shifts[i];
            shoot(&c, &scene);
            shoot(&rtl, &scene);
            expect_equal(&c, &rtl);
            assert_int_equal(c.stats.divisions, rtl.stats.divisions);
            assert_true(rtl.stats.divisions > 0);
            assert_true(rtl.stats.divider_clocks >= rtl.stats.divisions);
            assert_int_equal(c.stats.divider_clocks, 0);
        }
        for (int shading = 0; shading < GLINT_SHADING_PHONG; shading++) {
            const glint_scene scene = scene_of(mesh, (glint_shading)shading);
            shoot(&c, &scene);
            shoot(&rtl, &scene);
            expect_equal(&c, &rtl);
        }
        glint_mesh_destroy(mesh);
    }
    close_studio(&rtl);
    close_studio(&c);
}

/* An end of a row may be one level off the exact one, and the row once more. */
static void the_default_shifts_are_near_exact_division(void **state)
{
    (void)state;
    studio exact = open_studio(320, 240, 2, GLINT_BACKEND_C);
    studio divided = open_studio(320, 240, 2, GLINT_BACKEND_C);
    for (int which = 0; which < MESHES; which++) {
        glint_mesh *mesh = mesh_of(which);
        glint_scene scene = scene_of(mesh, GLINT_SHADING_GOURAUD);
        shoot(&divided, &scene);
        scene.shifts = GLINT_SHIFTS_EXACT;
        shoot(&exact, &scene);
        assert_int_equal(exact.stats.divisions, 0);
        const glint_image_difference near = compare(&exact, &divided);
        assert_true(near.largest <= 2);
        scene.shifts = 6;
        shoot(&divided, &scene);
        assert_true(compare(&exact, &divided).nmse > near.nmse);
        glint_mesh_destroy(mesh);
    }
    close_studio(&divided);
    close_studio(&exact);
}

/* Backend real interpolates exactly for any number of shifts. */
static void backend_real_divides_exactly(void **state)
{
    (void)state;
    glint_mesh *mesh = mesh_of(TEAPOT);
    studio a = open_studio(160, 120, 2, GLINT_BACKEND_REAL);
    studio b = open_studio(160, 120, 2, GLINT_BACKEND_REAL);
    glint_scene scene = scene_of(mesh, GLINT_SHADING_GOURAUD);
    scene.shifts = 6;
    shoot(&a, &scene);
    scene.shifts = GLINT_SHIFTS_EXACT;
    shoot(&b, &scene);
    expect_equal(&a, &b);
    close_studio(&b);
    close_studio(&a);
    glint_mesh_destroy(mesh);
}

/* A mesh of a few triangles. */
typedef struct plain_mesh {
    float position[3 * 128], normal[3 * 128];
    uint32_t index[3 * 128];
    glint_mesh mesh;
} plain_mesh;

static plain_mesh *new_mesh(void)
{
    plain_mesh *m = calloc(1, sizeof *m);
    assert_non_null(m);
    m->mesh = (glint_mesh){.position = m->position, .normal = m->normal, .index = m->index};
    return m;
}

static void add_corner(plain_mesh *m, glint_vec3 p, glint_vec3 n)
{
    const size_t at = m->mesh.vertex_count++;
    assert_true(at < 128);
    glint_vec3_store(p, &m->position[3 * at]);
    glint_vec3_store(glint_vec3_scale(n, 1.0 / glint_vec3_length(n)), &m->normal[3 * at]);
}

/* The triangle of the three corners added last. */
static void add_triangle(plain_mesh *m)
{
    uint32_t *index = &m->index[3 * m->mesh.triangle_count++];
    for (uint32_t i = 0; i < 3; i++)
        index[i] = (uint32_t)m->mesh.vertex_count - 3 + i;
}

static glint_scene straight_scene(const glint_mesh *mesh, glint_shading shading, float distance)
{
    glint_scene scene = scene_of(mesh, shading);
    scene.yaw = 0.0f;
    scene.pitch = 0.0f;
    scene.distance = distance;
    return scene;
}

/* Ambient and Lambert light with normal n, as a real number. */
static double base_light(const glint_scene *scene, glint_vec3 n, int c)
{
    const glint_vec3 l = glint_vec3_of(scene->light);
    const double cosine = glint_vec3_dot(n, l) / (glint_vec3_length(n) * glint_vec3_length(l));
    return scene->color[c] * ((double)scene->ka * (double)scene->ia[c] +
                              (double)scene->kd * (double)scene->ie[c] * fmax(cosine, 0.0));
}

/* The pure formula's highlight at the point p (camera axes, the eye in the origin). */
static double highlight(const glint_scene *scene, glint_vec3 p, glint_vec3 n, int c)
{
    const glint_vec3 l = glint_vec3_of(scene->light);
    const glint_vec3 h = glint_vec3_add(glint_vec3_scale(l, 1.0 / glint_vec3_length(l)),
                                        glint_vec3_scale(p, -1.0 / glint_vec3_length(p)));
    const double cosine = glint_vec3_dot(n, h) / (glint_vec3_length(n) * glint_vec3_length(h));
    const double sigma = (scene->n + 1.0) / 3.0;
    const double t = sigma * (cosine - 1.0) + 1.0;
    const double register_value =
        floor(scene->highlight[c] * (double)scene->ie[c] * (double)scene->ks + 0.5);
    return t > 0.0 && glint_vec3_dot(n, l) > 0.0 ? t * t * register_value : 0.0;
}

static const glint_vec3 triangle_at[3] = {{-0.8, -0.5, 0.1}, {0.7, -0.6, -0.2}, {0.1, 0.8, 0.3}};

/* One triangle with three normals, about the centre of its bounding box and with its radius. */
static plain_mesh *single_triangle(const glint_vec3 n[3], glint_vec3 seen_at[3], double distance)
{
    plain_mesh *m = new_mesh();
    glint_vec3 low = triangle_at[0];
    glint_vec3 high = triangle_at[0];
    for (int i = 0; i < 3; i++) {
        add_corner(m, triangle_at[i], n[i]);
        const glint_vec3 p = glint_vec3_of(&m->position[3 * i]);
        low = (glint_vec3){fmin(low.x, p.x), fmin(low.y, p.y), fmin(low.z, p.z)};
        high = (glint_vec3){fmax(high.x, p.x), fmax(high.y, p.y), fmax(high.z, p.z)};
    }
    add_triangle(m);
    const glint_vec3 centre = glint_vec3_scale(glint_vec3_add(low, high), 0.5);
    double radius = 0.0;
    for (int i = 0; i < 3; i++) {
        seen_at[i] = glint_vec3_sub(glint_vec3_of(&m->position[3 * i]), centre);
        radius = fmax(radius, glint_vec3_length(seen_at[i]));
    }
    for (int i = 0; i < 3; i++) {
        seen_at[i] = glint_vec3_scale(seen_at[i], 1.0 / radius);
        seen_at[i].z -= distance;
    }
    return m;
}

static void expect_one_color(const studio *s, const double expected[3], double within)
{
    assert_true(s->stats.fragments > 1000);
    for (int i = 0; i < s->image->width * s->image->height; i++) {
        for (int c = 0; s->image->object[i] && c < 3; c++) {
            const double held = fmin(expected[c], 255.0);
            assert_true(fabs(s->image->rgb[3 * i + c] - held) < within);
        }
    }
}

/* Flat: light on the centroid with the plane's normal, whatever the normals at the corners are. */
static void flat_is_light_on_the_centroid(void **state)
{
    (void)state;
    const glint_vec3 n[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, -1}};
    glint_vec3 p[3];
    plain_mesh *m = single_triangle(n, p, 3.0);
    const glint_vec3 plane =
        glint_vec3_cross(glint_vec3_sub(p[1], p[0]), glint_vec3_sub(p[2], p[0]));
    const glint_vec3 centroid =
        glint_vec3_scale(glint_vec3_add(glint_vec3_add(p[0], p[1]), p[2]), 1.0 / 3.0);
    studio s = open_studio(160, 120, 2, GLINT_BACKEND_C);
    glint_scene scene = straight_scene(&m->mesh, GLINT_SHADING_FLAT, 3.0f);
    scene.n = 5; /* so wide a highlight that the triangle is within it */
    shoot(&s, &scene);
    double expected[3];
    double bright = 0.0;
    for (int c = 0; c < 3; c++) {
        const double shine = highlight(&scene, centroid, plane, c);
        expected[c] = base_light(&scene, plane, c) + shine;
        bright += shine;
    }
    assert_true(bright > 30.0);
    expect_one_color(&s, expected, 1.03); /* two roundings */
    assert_int_equal(s.stats.highlights, 1);
    close_studio(&s);
    free(m);
}

static int compare_colors(const void *a, const void *b)
{
    return memcmp(a, b, 3);
}

static size_t count_colors(const studio *s)
{
    const size_t pixels = (size_t)s->image->width * (size_t)s->image->height;
    uint8_t *sorted = malloc(3 * pixels);
    assert_non_null(sorted);
    size_t count = 0;
    for (size_t i = 0; i < pixels; i++)
        if (s->image->object[i])
            memcpy(sorted + 3 * count++, s->image->rgb + 3 * i, 3);
    qsort(sorted, count, 3, compare_colors);
    size_t colors = count > 0;
    for (size_t i = 1; i < count; i++)
        colors += memcmp(sorted + 3 * i, sorted + 3 * (i - 1), 3) != 0;
    free(sorted);
    return colors;
}

static void flat_has_one_color_a_triangle(void **state)
{
    (void)state;
    glint_mesh *mesh = mesh_of(COARSE_SPHERE);
    studio s = open_studio(320, 240, 2, GLINT_BACKEND_C);
    glint_scene scene = scene_of(mesh, GLINT_SHADING_FLAT);
    shoot(&s, &scene);
    const size_t colors = count_colors(&s);
    assert_true(colors <= s.stats.drawn);
    assert_true(colors > 5);
    assert_int_equal(s.stats.highlights, s.stats.drawn);
    scene.distance = 1.02f; /* cut into several parts by the near plane or not: still one colour */
    shoot(&s, &scene);
    assert_true(count_colors(&s) <= s.stats.highlights);
    close_studio(&s);
    glint_mesh_destroy(mesh);
}

/* A vertex has the formula's light; with the same normal everywhere and no highlight, so has every
 * pixel, by every shading between vertices. */
static void equal_vertices_give_one_color(void **state)
{
    (void)state;
    const glint_vec3 n[3] = {{-0.4, 0.5, 0.7}, {-0.4, 0.5, 0.7}, {-0.4, 0.5, 0.7}};
    glint_vec3 p[3];
    plain_mesh *m = single_triangle(n, p, 3.0);
    studio s = open_studio(160, 120, 2, GLINT_BACKEND_C);
    for (int shading = GLINT_SHADING_GOURAUD; shading < GLINT_SHADING_PHONG; shading++) {
        glint_scene scene = straight_scene(&m->mesh, (glint_shading)shading, 3.0f);
        scene.ks = 0.0f;
        scene.slips = 0;
        shoot(&s, &scene);
        double expected[3];
        for (int c = 0; c < 3; c++)
            expected[c] = base_light(&scene, n[0], c);
        expect_one_color(&s, expected, 0.501);
        assert_int_equal(count_colors(&s), 1);
        assert_int_equal(s.stats.highlights, shading <= GLINT_SHADING_GOURAUD_PERSPECTIVE ? 3 : 6);
    }
    close_studio(&s);
    free(m);
}

/* Slivers and crumbs of one colour, cut by the frame too: nothing else may come out. */
static void thin_triangles_keep_their_color(void **state)
{
    (void)state;
    const glint_vec3 n = {0.0, 0.6, 0.8};
    uint64_t random = 12345;
    studio s = open_studio(200, 150, 2, GLINT_BACKEND_C);
    for (int round = 0; round < 60; round++) {
        plain_mesh *m = new_mesh();
        for (int i = 0; i < 40; i++) {
            double v[4];
            for (int k = 0; k < 4; k++) {
                random = random * 6364136223846793005u + 1442695040888963407u;
                v[k] = (double)(random >> 40) / 8388608.0 - 1.0;
            }
            const double thin = i % 2 == 0 ? 0.003 : 0.02;
            add_corner(m, (glint_vec3){v[0], v[1], 0.0}, n);
            add_corner(m, (glint_vec3){v[2], v[3], 0.0}, n);
            add_corner(m, (glint_vec3){v[0] - thin * (v[3] - v[1]), v[1] + thin * (v[2] - v[0]), 0},
                       n);
            add_triangle(m);
        }
        glint_scene scene =
            straight_scene(&m->mesh, GLINT_SHADING_GOURAUD, round % 2 == 0 ? 4.0f : 1.0f);
        scene.shifts = 6 + round % 11;
        scene.ks = 0.0f;
        shoot(&s, &scene);
        assert_true(s.stats.fragments > 100);
        assert_int_equal(count_colors(&s), 1);
        free(m);
    }
    close_studio(&s);
}

/* Intensities as the renderer holds them at vertices, 8 bits each, without a highlight. */
static void vertex_intensities(const glint_scene *scene, const glint_vec3 n[3], double color[3][3])
{
    for (int i = 0; i < 3; i++)
        for (int c = 0; c < 3; c++)
            color[i][c] = floor(base_light(scene, n[i], c) + 0.5);
}

/* The colour of the point of the triangle p that lies on the ray: tetrahedra between the ray and
 * two corners each are the weights. */
static bool meet(const glint_vec3 p[3], const double color[3][3], glint_vec3 along, double value[3])
{
    double weight[3];
    double sum = 0.0;
    for (int i = 0; i < 3; i++) {
        weight[i] = glint_vec3_dot(along, glint_vec3_cross(p[(i + 1) % 3], p[(i + 2) % 3]));
        sum += weight[i];
    }
    if (weight[0] * sum < 0.0 || weight[1] * sum < 0.0 || weight[2] * sum < 0.0)
        return false;
    for (int c = 0; c < 3; c++) {
        value[c] = 0.0;
        for (int i = 0; i < 3; i++)
            value[c] += weight[i] / sum * color[i][c];
    }
    return true;
}

static glint_vec3 ray(const glint_image *image, const glint_scene *scene, int x, int y)
{
    const double focal = 0.5 * image->height / tan(0.5 * (double)scene->fov * RADIANS);
    return (glint_vec3){(x + 0.5 - 0.5 * image->width) / focal,
                        (0.5 * image->height - y - 0.5) / focal, -1.0};
}

/* The quad in double precision, seen along the ground: its corners in camera coordinates follow
 * from the mesh and the scene alone. */
static void the_perspective_form_is_right_on_the_quad(void **state)
{
    (void)state;
    const double distance = 1.3;
    glint_mesh *mesh = mesh_of(QUAD);
    glint_scene scene = scene_of(mesh, GLINT_SHADING_GOURAUD_PERSPECTIVE);
    scene.ks = 0.0f;
    scene.yaw = 0.0f;
    scene.pitch = 30.0f;
    scene.distance = (float)distance;
    studio s = open_studio(320, 240, 2, GLINT_BACKEND_C);
    shoot(&s, &scene);
    assert_true(s.stats.fragments > 10000);
    const double sine = sin(30.0 * RADIANS);
    const double cosine = cos(30.0 * RADIANS);
    glint_vec3 at[4], n[4];
    double radius = 0.0;
    for (int i = 0; i < 4; i++) {
        const glint_vec3 p = glint_vec3_of(&mesh->position[3 * i]);
        const glint_vec3 v = glint_vec3_of(&mesh->normal[3 * i]);
        radius = fmax(radius, glint_vec3_length(p));
        at[i] = (glint_vec3){p.x, cosine * p.y - sine * p.z, sine * p.y + cosine * p.z};
        n[i] = (glint_vec3){v.x, cosine * v.y - sine * v.z, sine * v.y + cosine * v.z};
    }
    glint_vec3 p[2][3];
    double color[2][3][3];
    for (int t = 0; t < 2; t++) {
        glint_vec3 normal[3];
        for (int i = 0; i < 3; i++) {
            const uint32_t corner = mesh->index[3 * t + i];
            p[t][i] = glint_vec3_scale(at[corner], 1.0 / radius);
            p[t][i].z -= (double)(float)distance;
            normal[i] = n[corner];
        }
        vertex_intensities(&scene, (const glint_vec3 *)normal, color[t]);
    }
    for (int y = 0; y < 240; y++) {
        for (int x = 0; x < 320; x++) {
            double value[3] = {0};
            const glint_vec3 along = ray(s.image, &scene, x, y);
            if (!s.image->object[320 * y + x] ||
                (!meet((const glint_vec3 *)p[0], (const double(*)[3])color[0], along, value) &&
                 !meet((const glint_vec3 *)p[1], (const double(*)[3])color[1], along, value)))
                continue; /* the border may be a snapped coordinate off */
            for (int c = 0; c < 3; c++)
                assert_true(fabs(s.image->rgb[3 * (320 * y + x) + c] - value[c]) < 0.55);
        }
    }
    close_studio(&s);
    glint_mesh_destroy(mesh);
}

static void gouraud_is_wrong_on_the_receding_quad(void **state)
{
    (void)state;
    glint_mesh *mesh = mesh_of(QUAD);
    studio truth = open_studio(640, 480, 2, GLINT_BACKEND_C);
    studio plain = open_studio(640, 480, 2, GLINT_BACKEND_C);
    glint_scene scene = scene_of(mesh, GLINT_SHADING_GOURAUD_PERSPECTIVE);
    shoot(&truth, &scene);
    scene.shading = GLINT_SHADING_GOURAUD;
    shoot(&plain, &scene);
    const glint_image_difference difference = compare(&truth, &plain);
    assert_int_equal(difference.mask_pixels, 0);
    assert_true(difference.nmse > 0.03);
    assert_true(difference.largest > 45);
    close_studio(&plain);
    close_studio(&truth);
    glint_mesh_destroy(mesh);
}

/* Without perspective both forms are one: from far away they differ by roundings, and by the ends
 * of edges being taken to whole pixels. */
static void far_away_both_forms_agree(void **state)
{
    (void)state;
    const glint_vec3 n[3] = {{-0.9, 0.3, 0.5}, {0.8, 0.1, 0.6}, {0.0, 1.0, 0.1}};
    glint_vec3 p[3];
    plain_mesh *m = single_triangle(n, p, 900.0);
    glint_scene scene = straight_scene(&m->mesh, GLINT_SHADING_GOURAUD_PERSPECTIVE, 900.0f);
    scene.ks = 0.0f;
    scene.fov = 1.0f;
    studio truth = open_studio(4000, 3000, 2, GLINT_BACKEND_C);
    studio plain = open_studio(4000, 3000, 2, GLINT_BACKEND_C);
    shoot(&truth, &scene);
    scene.shading = GLINT_SHADING_GOURAUD;
    shoot(&plain, &scene);
    const glint_image_difference difference = compare(&truth, &plain);
    assert_true(difference.object_pixels > 10000);
    assert_true(difference.largest <= 3);
    close_studio(&plain);
    close_studio(&truth);
    free(m);
}

/* What reaches out of the frame has the colours within it that it has in a wider frame. */
static void the_frame_cuts_without_a_trace(void **state)
{
    (void)state;
    enum { WIDE = 400, NARROW = 200, TALL = 300 };
    for (int which = 0; which < MESHES; which++) {
        glint_mesh *mesh = mesh_of(which);
        for (int exact = 0; exact < 2; exact++) {
            glint_scene scene = scene_of(mesh, GLINT_SHADING_GOURAUD);
            scene.distance = 1.7f;
            scene.shifts = exact ? GLINT_SHIFTS_EXACT : 7;
            studio wide = open_studio(WIDE, TALL, 2, GLINT_BACKEND_C);
            studio narrow = open_studio(NARROW, TALL, 2, GLINT_BACKEND_C);
            shoot(&wide, &scene);
            shoot(&narrow, &scene);
            assert_true(narrow.stats.fragments > 1000);
            for (int y = 0; y < TALL; y++) {
                const size_t at = (size_t)y * WIDE + (WIDE - NARROW) / 2;
                assert_memory_equal(&narrow.image->rgb[3 * NARROW * y], &wide.image->rgb[3 * at],
                                    3 * NARROW);
            }
            close_studio(&narrow);
            close_studio(&wide);
        }
        glint_mesh_destroy(mesh);
    }
}

static void bad_values_are_refused(void **state)
{
    (void)state;
    static const int bad[] = {-1, 1, 5, 17};
    glint_mesh *mesh = mesh_of(COARSE_SPHERE);
    studio s = open_studio(16, 16, 1, GLINT_BACKEND_C);
    glint_scene scene = scene_of(mesh, GLINT_SHADING_GOURAUD);
    glint_error err = {""};
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        scene.shifts = bad[i];
        assert_int_equal(glint_render(s.renderer, &scene, s.image, NULL, NULL, &err),
                         GLINT_BAD_ARGUMENT);
        assert_non_null(strstr(err.text, "shifts"));
    }
    scene.shifts = 8;
    scene.shading = GLINT_SHADING_COUNT;
    assert_int_equal(glint_render(s.renderer, &scene, s.image, NULL, NULL, &err),
                     GLINT_BAD_ARGUMENT);
    assert_non_null(strstr(err.text, "shading"));
    close_studio(&s);
    glint_mesh_destroy(mesh);
}

/* Only Phong's shading has cosines at pixels. */
static void of_these_phong_alone_records_fragments(void **state)
{
    (void)state;
    glint_mesh *mesh = mesh_of(COARSE_SPHERE);
    studio s = open_studio(32, 32, 1, GLINT_BACKEND_C);
    uint32_t code;
    glint_material material;
    for (int shading = 0; shading <= GLINT_SHADING_PHONG; shading++) {
        const glint_scene scene = scene_of(mesh, (glint_shading)shading);
        shoot(&s, &scene);
        assert_true(s.image->object[16 * 32 + 16]);
        assert_int_equal(glint_renderer_fragment(s.renderer, 16, 16, &code, &material),
                         shading == GLINT_SHADING_PHONG);
    }
    close_studio(&s);
    glint_mesh_destroy(mesh);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_shading_covers_the_same_pixels),
        cmocka_unit_test(any_number_of_threads_gives_the_same),
        cmocka_unit_test(c_and_rtl_give_the_same_bits),
        cmocka_unit_test(the_default_shifts_are_near_exact_division),
        cmocka_unit_test(backend_real_divides_exactly),
        cmocka_unit_test(flat_is_light_on_the_centroid),
        cmocka_unit_test(flat_has_one_color_a_triangle),
        cmocka_unit_test(equal_vertices_give_one_color),
        cmocka_unit_test(thin_triangles_keep_their_color),
        cmocka_unit_test(the_perspective_form_is_right_on_the_quad),
        cmocka_unit_test(gouraud_is_wrong_on_the_receding_quad),
        cmocka_unit_test(far_away_both_forms_agree),
        cmocka_unit_test(the_frame_cuts_without_a_trace),
        cmocka_unit_test(bad_values_are_refused),
        cmocka_unit_test(of_these_phong_alone_records_fragments),
    };
    return cmocka_run_group_tests_name("gouraud", tests, NULL, NULL);
}
