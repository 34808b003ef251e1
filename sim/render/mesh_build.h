/* Shared by everything that builds meshes: room for a mesh, filled one vertex and one triangle at a
 * time. */
#ifndef GLINT_SIM_RENDER_MESH_BUILD_H
#define GLINT_SIM_RENDER_MESH_BUILD_H

#include "reflectance/vec3.h"
#include "render/mesh.h"

/* An empty mesh with room for that many vertices and triangles. `what` names it in the error. */
glint_status glint_mesh_new(const char *what, size_t vertices, size_t triangles, glint_mesh **mesh,
                            glint_error *err);

/* Appends one vertex; the normal is stored as given. There must be room. */
void glint_mesh_add_vertex(glint_mesh *mesh, glint_vec3 position, glint_vec3 normal);

/* Appends one triangle, unless two of its corners coincide. There must be room. */
void glint_mesh_add_triangle(glint_mesh *mesh, uint32_t a, uint32_t b, uint32_t c);

#endif
