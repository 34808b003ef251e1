/* What assimp has read becomes a mesh, where it can be one. */
#ifndef GLINT_SIM_RENDER_IMPORTED_H
#define GLINT_SIM_RENDER_IMPORTED_H

#include <assimp/scene.h>

#include "render/groups.h"
#include "render/mesh.h"
#include "render/smooth.h"

/* What is left to do when the scene is no longer needed: glint_smooth(). */
typedef struct glint_imported {
    glint_mesh *mesh; /* with normals of 0 where the file has no usable ones */
    glint_smoothing smoothing;
} glint_imported;

void glint_imported_clear(glint_imported *imported);

/* Looks through the coordinates as they stand in the file. GLINT_BAD_INPUT names the first that is
 * not a number or beyond 1e18. `path` is for the message only. */
glint_status glint_imported_check(const char *path, const struct aiScene *scene, glint_error *err);

/* Which of assimp's importers has read the scene, by its name; "" when it does not say. */
const char *glint_imported_from(const struct aiScene *scene);

/* All meshes of the scene under the transforms of their nodes; see glint_mesh_load(). Only
 * triangles are taken. They are centred and scaled in double precision before a coordinate is
 * rounded or two are compared: an object is the same whatever its size and place. Nothing of the
 * scene is believed but its counts and its pointers. `groups` is the same file's; NULL for what is
 * no .3ds file. */
glint_status glint_imported_mesh(const char *path, const struct aiScene *scene,
                                 const glint_groups *groups, glint_imported *imported,
                                 glint_error *err);

#endif
