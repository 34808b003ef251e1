/* The sphere: on the unit sphere, closed, turned outwards. */
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

static glint_mesh *sphere(int density)
{
    glint_mesh *mesh = NULL;
    glint_error err = {""};
    assert_int_equal(glint_mesh_sphere(density, &mesh, &err), GLINT_OK);
    assert_non_null(mesh);
    return mesh;
}

static void counts(void **state)
{
    (void)state;
    for (int d = 4; d <= 64; d += 6) {
        glint_mesh *mesh = sphere(d);
        assert_int_equal(mesh->vertex_count, d * (d / 2 - 1) + 2);
        assert_int_equal(mesh->triangle_count, d * (d - 2));
        glint_mesh_destroy(mesh);
    }
}

static void normals_are_the_positions(void **state)
{
    (void)state;
    glint_mesh *mesh = sphere(GLINT_SPHERE_DENSITY);
    for (size_t v = 0; v < mesh->vertex_count; v++) {
        const glint_vec3 n = glint_vec3_of(&mesh->normal[3 * v]);
        assert_true(fabs(glint_vec3_length(n) - 1.0) < 1e-6);
        assert_memory_equal(&mesh->normal[3 * v], &mesh->position[3 * v], 3 * sizeof(float));
    }
    glint_mesh_destroy(mesh);
}

static void triangles_face_outwards(void **state)
{
    (void)state;
    for (int d = 4; d <= 64; d *= 2) {
        glint_mesh *mesh = sphere(d);
        for (size_t i = 0; i < mesh->triangle_count; i++) {
            const uint32_t *c = &mesh->index[3 * i];
            const glint_vec3 a = glint_vec3_of(&mesh->position[3 * (size_t)c[0]]);
            const glint_vec3 b = glint_vec3_of(&mesh->position[3 * (size_t)c[1]]);
            const glint_vec3 e = glint_vec3_of(&mesh->position[3 * (size_t)c[2]]);
            const glint_vec3 face = glint_vec3_cross(glint_vec3_sub(b, a), glint_vec3_sub(e, a));
            assert_true(glint_vec3_dot(face, a) > 0.0);
        }
        glint_mesh_destroy(mesh);
    }
}

static int compare_u64(const void *a, const void *b)
{
    const uint64_t x = *(const uint64_t *)a;
    const uint64_t y = *(const uint64_t *)b;
    return (x > y) - (x < y);
}

static void every_edge_has_its_opposite(void **state)
{
    (void)state;
    glint_mesh *mesh = sphere(32);
    const size_t count = 3 * mesh->triangle_count;
    uint64_t *edges = calloc(count, sizeof *edges);
    assert_non_null(edges);
    for (size_t i = 0; i < count; i++) {
        const size_t next = i % 3 == 2 ? i - 2 : i + 1;
        edges[i] = (uint64_t)mesh->index[i] << 32 | mesh->index[next];
    }
    qsort(edges, count, sizeof *edges, compare_u64);
    for (size_t i = 0; i < count; i++) {
        const uint64_t opposite = edges[i] << 32 | edges[i] >> 32;
        assert_true(i == 0 || edges[i - 1] != edges[i]);
        assert_non_null(bsearch(&opposite, edges, count, sizeof *edges, compare_u64));
    }
    free(edges);
    glint_mesh_destroy(mesh);
}

static void bad_densities_are_refused(void **state)
{
    (void)state;
    const int bad[] = {-4, 0, 2, 3, 7, 4097, 4098};
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        glint_mesh *mesh = NULL;
        glint_error err = {""};
        assert_int_equal(glint_mesh_sphere(bad[i], &mesh, &err), GLINT_BAD_ARGUMENT);
        assert_null(mesh);
        assert_non_null(strstr(err.text, "density"));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(counts),
        cmocka_unit_test(normals_are_the_positions),
        cmocka_unit_test(triangles_face_outwards),
        cmocka_unit_test(every_edge_has_its_opposite),
        cmocka_unit_test(bad_densities_are_refused),
    };
    return cmocka_run_group_tests_name("sphere", tests, NULL, NULL);
}
