/* The life of a mesh: room made, filled, given back. */
#include <stdbool.h>
#include <stdlib.h>

#include "render/mesh_build.h"

static void *new_array(size_t count, size_t size)
{
    return calloc(count > 0 ? count : 1, size);
}

glint_status glint_mesh_new(const char *what, size_t vertices, size_t triangles, glint_mesh **mesh,
                            glint_error *err)
{
    glint_mesh *m = calloc(1, sizeof *m);
    if (m != NULL) {
        m->position = new_array(vertices, 3 * sizeof *m->position);
        m->normal = new_array(vertices, 3 * sizeof *m->normal);
        m->index = new_array(triangles, 3 * sizeof *m->index);
    }
    if (m == NULL || m->position == NULL || m->normal == NULL || m->index == NULL) {
        glint_mesh_destroy(m);
        return glint_fail(err, GLINT_NO_MEMORY,
                          "%s: not enough memory for %zu vertices, %zu triangles", what, vertices,
                          triangles);
    }
    *mesh = m;
    return GLINT_OK;
}

void glint_mesh_destroy(glint_mesh *mesh)
{
    if (mesh == NULL)
        return;
    free(mesh->position);
    free(mesh->normal);
    free(mesh->index);
    free(mesh->rest);
    free(mesh);
}

void glint_mesh_add_vertex(glint_mesh *mesh, glint_vec3 position, glint_vec3 normal)
{
    glint_vec3_store(position, &mesh->position[3 * mesh->vertex_count]);
    glint_vec3_store(normal, &mesh->normal[3 * mesh->vertex_count]);
    mesh->vertex_count++;
}

static bool coincide(const glint_mesh *mesh, uint32_t a, uint32_t b)
{
    const float *p = &mesh->position[3 * (size_t)a];
    const float *q = &mesh->position[3 * (size_t)b];
    return p[0] == q[0] && p[1] == q[1] && p[2] == q[2];
}

void glint_mesh_add_triangle(glint_mesh *mesh, uint32_t a, uint32_t b, uint32_t c)
{
    if (coincide(mesh, a, b) || coincide(mesh, b, c) || coincide(mesh, c, a))
        return;
    uint32_t *corner = &mesh->index[3 * mesh->triangle_count];
    corner[0] = a;
    corner[1] = b;
    corner[2] = c;
    mesh->triangle_count++;
}
