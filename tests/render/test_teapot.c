/* The teapot against its own definition: the published patches, evaluated here by de Casteljau's
 * construction, and notions of "outside" and "closed" that owe nothing to the code under test. */
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "reflectance/vec3.h"
#include "render/mesh.h"
#include "render/teapot_data.h"

#define RIM      0
#define BODY     4
#define HANDLE   12
#define SPOUT    16
#define LID      20
#define LID_EDGE 24
#define BOTTOM   28

static glint_mesh *teapot(int density)
{
    glint_mesh *mesh = NULL;
    glint_error err = {""};
    assert_int_equal(glint_mesh_teapot(density, &mesh, &err), GLINT_OK);
    assert_non_null(mesh);
    return mesh;
}

static glint_vec3 lerp(glint_vec3 a, glint_vec3 b, double t)
{
    return glint_vec3_add(glint_vec3_scale(a, 1.0 - t), glint_vec3_scale(b, t));
}

static glint_vec3 casteljau(const glint_vec3 p[4], double t)
{
    const glint_vec3 a = lerp(p[0], p[1], t);
    const glint_vec3 b = lerp(p[1], p[2], t);
    const glint_vec3 c = lerp(p[2], p[3], t);
    return lerp(lerp(a, b, t), lerp(b, c, t), t);
}

/* A point of a patch, y up. */
static glint_vec3 surface(int patch, double u, double v)
{
    glint_vec3 row[4];
    for (int i = 0; i < 4; i++) {
        glint_vec3 p[4];
        for (int k = 0; k < 4; k++) {
            const double *c = glint_teapot_vertices[glint_teapot_patches[patch][4 * i + k] - 1];
            p[k] = (glint_vec3){c[0], c[2], -c[1]};
        }
        row[i] = casteljau(p, v);
    }
    return casteljau(row, u);
}

static size_t vertex(int density, int patch, int i, int k)
{
    const size_t side = (size_t)density + 1;
    return ((size_t)patch * side + (size_t)i) * side + (size_t)k;
}

static glint_vec3 position(const glint_mesh *mesh, size_t v)
{
    return glint_vec3_of(&mesh->position[3 * v]);
}

static glint_vec3 normal(const glint_mesh *mesh, size_t v)
{
    return glint_vec3_of(&mesh->normal[3 * v]);
}

static void the_data_is_the_published_one(void **state)
{
    (void)state;
    bool used[GLINT_TEAPOT_VERTICES] = {false};
    for (int p = 0; p < GLINT_TEAPOT_PATCHES; p++) {
        for (int k = 0; k < 16; k++) {
            const unsigned at = glint_teapot_patches[p][k];
            assert_in_range(at, 1, GLINT_TEAPOT_VERTICES);
            used[at - 1] = true;
        }
    }
    int unused = 0;
    for (int i = 0; i < GLINT_TEAPOT_VERTICES; i++)
        unused += !used[i];
    assert_int_equal(unused, 4);
    assert_false(used[204] || used[205] || used[215] || used[222]);
    /* Every control point has its mirror image across the plane y = 0 of the data. */
    for (int i = 0; i < GLINT_TEAPOT_VERTICES; i++) {
        const double *a = glint_teapot_vertices[i];
        bool mirrored = false;
        for (int k = 0; k < GLINT_TEAPOT_VERTICES; k++) {
            const double *b = glint_teapot_vertices[k];
            mirrored = mirrored || (a[0] == b[0] && a[1] == -b[1] && a[2] == b[2]);
        }
        assert_true(mirrored);
    }
}

static void counts_and_extents(void **state)
{
    (void)state;
    for (int d = 1; d <= 24; d += d < 4 ? 1 : 5) {
        glint_mesh *mesh = teapot(d);
        const size_t n = (size_t)d;
        assert_int_equal(mesh->vertex_count, 32 * (n + 1) * (n + 1));
        assert_int_equal(mesh->triangle_count, 64 * n * n - 8 * n);
        glint_mesh_destroy(mesh);
    }
    glint_mesh *mesh = teapot(32);
    glint_vec3 low = position(mesh, 0);
    glint_vec3 high = low;
    for (size_t v = 0; v < mesh->vertex_count; v++) {
        const glint_vec3 p = position(mesh, v);
        low = (glint_vec3){fmin(low.x, p.x), fmin(low.y, p.y), fmin(low.z, p.z)};
        high = (glint_vec3){fmax(high.x, p.x), fmax(high.y, p.y), fmax(high.z, p.z)};
    }
    assert_true(fabs(low.x + 3.0) < 0.005 && fabs(high.x - 3.4340) < 0.005); /* handle, spout */
    assert_true(low.y == 0.0 && fabs(high.y - 3.15) < 1e-6);                 /* bottom, lid */
    assert_true(fabs(low.z + 2.0) < 1e-6 && fabs(high.z - 2.0) < 1e-6);      /* body */
    glint_mesh_destroy(mesh);
}

static void vertices_lie_on_the_patches(void **state)
{
    (void)state;
    const int d = 7;
    glint_mesh *mesh = teapot(d);
    for (int patch = 0; patch < GLINT_TEAPOT_PATCHES; patch++) {
        for (int i = 0; i <= d; i++) {
            for (int k = 0; k <= d; k++) {
                const glint_vec3 s = surface(patch, (double)i / d, (double)k / d);
                const glint_vec3 p = position(mesh, vertex(d, patch, i, k));
                assert_true(glint_vec3_length(glint_vec3_sub(s, p)) < 1e-6);
            }
        }
    }
    glint_mesh_destroy(mesh);
}

static void normals_are_of_unit_length(void **state)
{
    (void)state;
    for (int d = 1; d <= 16; d *= 2) {
        glint_mesh *mesh = teapot(d);
        for (size_t v = 0; v < mesh->vertex_count; v++)
            assert_true(fabs(glint_vec3_length(normal(mesh, v)) - 1.0) < 1e-6);
        glint_mesh_destroy(mesh);
    }
}

static double inner(double t, double h)
{
    return t < h ? h : t > 1.0 - h ? 1.0 - h : t;
}

/* Central differences, moved off the border where there is no patch on one side of it. */
static glint_vec3 normal_by_differences(int patch, double u, double v)
{
    const double h = 1e-5;
    u = inner(u, h);
    v = inner(v, h);
    const glint_vec3 du = glint_vec3_sub(surface(patch, u + h, v), surface(patch, u - h, v));
    const glint_vec3 dv = glint_vec3_sub(surface(patch, u, v + h), surface(patch, u, v - h));
    const glint_vec3 n = glint_vec3_cross(dv, du);
    return glint_vec3_scale(n, 1.0 / glint_vec3_length(n));
}

static void normals_equal_finite_differences(void **state)
{
    (void)state;
    const int d = 9;
    glint_mesh *mesh = teapot(d);
    for (int patch = 0; patch < GLINT_TEAPOT_PATCHES; patch++) {
        for (int i = 0; i <= d; i++) {
            for (int k = 0; k <= d; k++) {
                const glint_vec3 expected =
                    normal_by_differences(patch, (double)i / d, (double)k / d);
                const glint_vec3 n = normal(mesh, vertex(d, patch, i, k));
                assert_true(glint_vec3_length(glint_vec3_sub(expected, n)) < 1e-3);
            }
        }
    }
    glint_mesh_destroy(mesh);
}

static void degenerate_points_have_their_limit(void **state)
{
    (void)state;
    for (int d = 1; d <= 16; d *= 2) {
        glint_mesh *mesh = teapot(d);
        for (int quarter = 0; quarter < 4; quarter++) {
            for (int k = 0; k <= d; k++) {
                const size_t tip = vertex(d, LID + quarter, 0, k);
                const size_t foot = vertex(d, BOTTOM + quarter, 0, k);
                const glint_vec3 up = normal(mesh, tip);
                const glint_vec3 down = normal(mesh, foot);
                assert_true(fabs(position(mesh, tip).y - 3.15) < 1e-6);
                assert_true(up.y == 1.0 && hypot(up.x, up.z) < 1e-12);
                assert_true(glint_vec3_length(position(mesh, foot)) == 0.0);
                assert_true(down.y == -1.0 && hypot(down.x, down.z) < 1e-12);
            }
        }
        glint_mesh_destroy(mesh);
    }
}

/* A closed outline in the half plane (radius, height), for the parts that are turned. */
#define STEPS 64
typedef struct outline {
    double r[4 * STEPS + 8], y[4 * STEPS + 8];
    int count;
} outline;

static void extend(outline *o, double r, double y)
{
    o->r[o->count] = r;
    o->y[o->count] = y;
    o->count++;
}

/* Adds the profile of a patch at v = 0, downwards in u or upwards. */
static void extend_by_profile(outline *o, int patch, bool forwards)
{
    for (int i = 0; i <= STEPS; i++) {
        const double u = (double)(forwards ? i : STEPS - i) / STEPS;
        const glint_vec3 p = surface(patch, u, 0.0);
        extend(o, hypot(p.x, p.z), p.y);
    }
}

static bool inside(const outline *o, double r, double y)
{
    bool in = false;
    for (int i = 0, k = o->count - 1; i < o->count; k = i++) {
        const bool crosses = (o->y[i] > y) != (o->y[k] > y);
        if (crosses && r < o->r[k] + (y - o->y[k]) / (o->y[i] - o->y[k]) * (o->r[i] - o->r[k]))
            in = !in;
    }
    return in;
}

/* By how much the quarter turn of the patches, which is no true circle, is off at v. */
static double swelling(double v)
{
    const glint_vec3 quarter[4] = {{1, 0, 0}, {1, 0.56, 0}, {0.56, 1, 0}, {0, 1, 0}};
    return glint_vec3_length(casteljau(quarter, v));
}

static void expect_outward(const glint_mesh *mesh, int d, int patch, const outline *o)
{
    for (int i = 1; i < d; i++) {
        for (int k = 0; k <= d; k++) {
            const size_t at = vertex(d, patch, i, k);
            const glint_vec3 p = position(mesh, at);
            const glint_vec3 n = glint_vec3_scale(normal(mesh, at), 0.004);
            const double g = swelling((double)k / d);
            assert_true(inside(o, hypot(p.x - n.x, p.z - n.z) / g, p.y - n.y));
            assert_false(inside(o, hypot(p.x + n.x, p.z + n.z) / g, p.y + n.y));
        }
    }
}

static void turned_parts_face_outwards(void **state)
{
    (void)state;
    const int d = 12;
    glint_mesh *mesh = teapot(d);
    outline pot = {.count = 0};
    extend_by_profile(&pot, BOTTOM, true);
    extend_by_profile(&pot, BODY + 4, false);
    extend_by_profile(&pot, BODY, false);
    extend_by_profile(&pot, RIM, false);
    extend(&pot, 0.0, 2.4);
    outline lid = {.count = 0};
    extend_by_profile(&lid, LID, true);
    extend_by_profile(&lid, LID_EDGE, true);
    extend(&lid, 0.0, 2.4);
    for (int patch = 0; patch < HANDLE; patch++)
        expect_outward(mesh, d, patch, &pot);
    for (int patch = LID; patch < BOTTOM; patch++)
        expect_outward(mesh, d, patch, &lid);
    for (int patch = BOTTOM; patch < GLINT_TEAPOT_PATCHES; patch++)
        expect_outward(mesh, d, patch, &pot);
    glint_mesh_destroy(mesh);
}

/* The middle of the ring that row i of the two half tubes makes. */
static glint_vec3 ring_centre(const glint_mesh *mesh, int d, int patch, int i)
{
    glint_vec3 sum = {0.0, 0.0, 0.0};
    for (int half = 0; half < 2; half++)
        for (int k = 0; k < d; k++)
            sum = glint_vec3_add(sum, position(mesh, vertex(d, patch + half, i, k)));
    return glint_vec3_scale(sum, 1.0 / (2 * d));
}

static void tubes_face_outwards(void **state)
{
    (void)state;
    const int d = 12;
    glint_mesh *mesh = teapot(d);
    for (int patch = HANDLE; patch < LID; patch++) {
        const bool lip = patch >= SPOUT + 2; /* it flares, then turns into the spout */
        for (int i = 0; i <= (lip ? d / 3 : d); i++) {
            const glint_vec3 centre = ring_centre(mesh, d, patch - patch % 2, i);
            for (int k = 0; k <= d; k++) {
                const size_t at = vertex(d, patch, i, k);
                const glint_vec3 out = glint_vec3_sub(position(mesh, at), centre);
                assert_true(glint_vec3_dot(normal(mesh, at), out) > 0.0);
            }
        }
        for (int i = 1; lip && i <= d; i++) {
            for (int k = 0; k <= d; k++) {
                const glint_vec3 a = normal(mesh, vertex(d, patch, i - 1, k));
                const glint_vec3 b = normal(mesh, vertex(d, patch, i, k));
                assert_true(glint_vec3_dot(a, b) > 0.0);
            }
        }
    }
    glint_mesh_destroy(mesh);
}

static void triangles_are_wound_with_their_normals(void **state)
{
    (void)state;
    glint_mesh *mesh = teapot(16);
    for (size_t i = 0; i < mesh->triangle_count; i++) {
        const uint32_t *c = &mesh->index[3 * i];
        const glint_vec3 a = position(mesh, c[0]);
        const glint_vec3 face = glint_vec3_cross(glint_vec3_sub(position(mesh, c[1]), a),
                                                 glint_vec3_sub(position(mesh, c[2]), a));
        assert_true(glint_vec3_length(face) > 0.0);
        for (int k = 0; k < 3; k++)
            assert_true(glint_vec3_dot(face, normal(mesh, c[k])) > 0.0);
    }
    glint_mesh_destroy(mesh);
}

typedef struct half_edge {
    float from[3], to[3];
} half_edge;

static int compare_edges(const void *a, const void *b)
{
    return memcmp(a, b, sizeof(half_edge));
}

static void store_point(const glint_mesh *mesh, uint32_t v, float out[3])
{
    for (int i = 0; i < 3; i++)
        out[i] = mesh->position[3 * (size_t)v + (size_t)i] + 0.0f; /* −0 becomes 0 */
}

/* Every edge has its opposite, joined by equal positions to the last bit, but for the rims where
 * the published surface ends: opening and lid (4 patches each), both ends of handle and spout (2).
 */
static void closed_but_for_its_openings(void **state)
{
    (void)state;
    for (int d = 3; d <= 16; d++) {
        glint_mesh *mesh = teapot(d);
        const size_t count = 3 * mesh->triangle_count;
        half_edge *edges = calloc(count, sizeof *edges);
        assert_non_null(edges);
        for (size_t i = 0; i < count; i++) {
            const size_t next = i % 3 == 2 ? i - 2 : i + 1;
            store_point(mesh, mesh->index[i], edges[i].from);
            store_point(mesh, mesh->index[next], edges[i].to);
        }
        qsort(edges, count, sizeof *edges, compare_edges);
        size_t open = 0;
        for (size_t i = 0; i < count; i++) {
            half_edge opposite;
            memcpy(opposite.from, edges[i].to, sizeof opposite.from);
            memcpy(opposite.to, edges[i].from, sizeof opposite.to);
            open += bsearch(&opposite, edges, count, sizeof *edges, compare_edges) == NULL;
            assert_true(i == 0 || compare_edges(&edges[i - 1], &edges[i]) != 0);
        }
        assert_int_equal(open, 16 * d);
        free(edges);
        glint_mesh_destroy(mesh);
    }
}

static void bad_densities_are_refused(void **state)
{
    (void)state;
    const int bad[] = {0, -1, 257, 1 << 30};
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        glint_mesh *mesh = NULL;
        glint_error err = {""};
        assert_int_equal(glint_mesh_teapot(bad[i], &mesh, &err), GLINT_BAD_ARGUMENT);
        assert_null(mesh);
        assert_non_null(strstr(err.text, "density"));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_data_is_the_published_one),
        cmocka_unit_test(counts_and_extents),
        cmocka_unit_test(vertices_lie_on_the_patches),
        cmocka_unit_test(normals_are_of_unit_length),
        cmocka_unit_test(normals_equal_finite_differences),
        cmocka_unit_test(degenerate_points_have_their_limit),
        cmocka_unit_test(turned_parts_face_outwards),
        cmocka_unit_test(tubes_face_outwards),
        cmocka_unit_test(triangles_are_wound_with_their_normals),
        cmocka_unit_test(closed_but_for_its_openings),
        cmocka_unit_test(bad_densities_are_refused),
    };
    return cmocka_run_group_tests_name("teapot", tests, NULL, NULL);
}
