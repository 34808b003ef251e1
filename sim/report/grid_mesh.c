/* Bars along x and y about the plane z = 0. */
#include "report/grid_mesh.h"

#include "render/mesh_build.h"

/* A point of a bar along x, or along y. */
static glint_vec3 turned(bool upright, double along, double across, double z)
{
    return upright ? (glint_vec3){-across, along, z} : (glint_vec3){along, across, z};
}

/* A bar's side: its normal is (across, z) in the bar's cross section. */
static void add_side(glint_mesh *mesh, bool upright, double centre, double half, int side)
{
    static const double corner[4][2] = {{1, -1}, {1, 1}, {-1, 1}, {-1, -1}};
    static const double normal[4][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    const double *a = corner[side], *b = corner[(side + 1) % 4];
    const glint_vec3 n = turned(upright, 0.0, normal[side][0], normal[side][1]);
    const uint32_t first = (uint32_t)mesh->vertex_count;
    for (int i = 0; i < 4; i++) {
        const double *at = i == 0 || i == 3 ? a : b;
        const double along = i < 2 ? -1.0 : 1.0;
        glint_mesh_add_vertex(mesh, turned(upright, along, centre + half * at[0], half * at[1]), n);
    }
    glint_mesh_add_triangle(mesh, first, first + 1, first + 2);
    glint_mesh_add_triangle(mesh, first, first + 2, first + 3);
}

glint_status glint_grid_mesh(int bars, double width, glint_mesh **mesh, glint_error *err)
{
    const size_t sides = 2 * 4 * (size_t)bars;
    const double pitch = 2.0 / bars;
    const glint_status status = glint_mesh_new("grid", 4 * sides, 2 * sides, mesh, err);
    if (status != GLINT_OK)
        return status;
    for (int bar = 0; bar < bars; bar++)
        for (int side = 0; side < 4; side++) {
            const double centre = -1.0 + (bar + 0.5) * pitch;
            add_side(*mesh, false, centre, 0.5 * width * pitch, side);
            add_side(*mesh, true, centre, 0.5 * width * pitch, side);
        }
    return GLINT_OK;
}
