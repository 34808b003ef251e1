/* The receding rectangle. */
#include "render/mesh_build.h"

#define HALF_WIDTH  1.5
#define HALF_LENGTH 8.0

glint_status glint_mesh_quad(glint_mesh **mesh, glint_error *err)
{
    static const struct {
        double x, z;
        glint_vec3 lean; /* the normal, any length */
    } corner[4] = {
        {-HALF_WIDTH, HALF_LENGTH, {-0.3, 1.0, 0.8}},
        {HALF_WIDTH, HALF_LENGTH, {0.3, 1.0, 0.8}},
        {HALF_WIDTH, -HALF_LENGTH, {0.9, 0.2, -0.6}},
        {-HALF_WIDTH, -HALF_LENGTH, {0.9, 0.2, -0.6}},
    };
    glint_mesh *m = NULL;
    const glint_status status = glint_mesh_new("quad", 4, 2, &m, err);
    if (status != GLINT_OK)
        return status;
    for (int i = 0; i < 4; i++) {
        const glint_vec3 n = corner[i].lean;
        glint_mesh_add_vertex(m, (glint_vec3){corner[i].x, 0.0, corner[i].z},
                              glint_vec3_scale(n, 1.0 / glint_vec3_length(n)));
    }
    glint_mesh_add_triangle(m, 0, 1, 2);
    glint_mesh_add_triangle(m, 0, 2, 3);
    *mesh = m;
    return GLINT_OK;
}
