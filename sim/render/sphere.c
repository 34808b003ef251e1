/* The unit sphere by meridians and parallels: its normals are its positions. */
#include "render/mesh_build.h"

#define PI 3.14159265358979323846

/* The first vertex of parallel `ring`, 1 … rings−1; vertex 0 is the north pole, the last one the
 * south pole. */
static uint32_t ring_start(uint32_t ring, uint32_t meridians)
{
    return 1 + (ring - 1) * meridians;
}

static void add_vertices(glint_mesh *mesh, uint32_t meridians, uint32_t rings)
{
    const glint_vec3 north = {0.0, 1.0, 0.0};
    const glint_vec3 south = {0.0, -1.0, 0.0};
    glint_mesh_add_vertex(mesh, north, north);
    for (uint32_t ring = 1; ring < rings; ring++) {
        const double polar = PI * ring / rings;
        for (uint32_t i = 0; i < meridians; i++) {
            const double azimuth = 2.0 * PI * i / meridians;
            const glint_vec3 p = {sin(polar) * sin(azimuth), cos(polar), sin(polar) * cos(azimuth)};
            glint_mesh_add_vertex(mesh, p, p);
        }
    }
    glint_mesh_add_vertex(mesh, south, south);
}

static void add_triangles(glint_mesh *mesh, uint32_t meridians, uint32_t rings)
{
    const uint32_t south = (uint32_t)mesh->vertex_count - 1;
    for (uint32_t ring = 0; ring < rings; ring++) {
        for (uint32_t i = 0; i < meridians; i++) {
            const uint32_t next = (i + 1) % meridians;
            const uint32_t above = ring > 0 ? ring_start(ring, meridians) : 0;
            const uint32_t below = ring + 1 < rings ? ring_start(ring + 1, meridians) : south;
            if (ring == 0) {
                glint_mesh_add_triangle(mesh, 0, below + i, below + next);
            } else if (ring + 1 == rings) {
                glint_mesh_add_triangle(mesh, above + i, south, above + next);
            } else {
                glint_mesh_add_triangle(mesh, above + i, below + i, below + next);
                glint_mesh_add_triangle(mesh, above + i, below + next, above + next);
            }
        }
    }
}

glint_status glint_mesh_sphere(int density, glint_mesh **mesh, glint_error *err)
{
    if (density < 4 || density > GLINT_SPHERE_DENSITY_MAX || density % 2 != 0) {
        return glint_fail(err, GLINT_BAD_ARGUMENT,
                          "sphere: density %d is not an even number from 4 to %d", density,
                          GLINT_SPHERE_DENSITY_MAX);
    }
    const uint32_t meridians = (uint32_t)density;
    const uint32_t rings = meridians / 2;
    glint_mesh *m = NULL;
    const size_t vertices = (size_t)meridians * (rings - 1) + 2;
    const size_t triangles = 2 * (size_t)meridians * (rings - 1);
    const glint_status status = glint_mesh_new("sphere", vertices, triangles, &m, err);
    if (status != GLINT_OK)
        return status;
    add_vertices(m, meridians, rings);
    add_triangles(m, meridians, rings);
    *mesh = m;
    return GLINT_OK;
}
