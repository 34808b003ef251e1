/* Turns what assimp has read into a mesh, if possible. */
#ifndef GLINT_SIM_RENDER_IMPORTED_H
#define GLINT_SIM_RENDER_IMPORTED_H

#include <assimp/scene.h>

#include "render/groups.h"
#include "render/mesh.h"
#include "render/smooth.h"

/* What remains to be done after the scene is released: glint_smooth(). */
typedef struct glint_imported {
    glint_mesh *mesh; /* with normals of 0 where the file has no usable ones */
    glint_smoothing smoothing;
} glint_imported;

void glint_imported_clear(glint_imported *imported);

/* Checks the coordinates as stored in the file. GLINT_BAD_INPUT names the first that is not a
 * number or beyond 1e18. `path` is for the message only. */
glint_status glint_imported_check(const char *path, const struct aiScene *scene, glint_error *err);

/* Which of assimp's importers has read the scene, by its name; "" when it does not say. */
const char *glint_imported_from(const struct aiScene *scene);

/* All meshes of the scene under the transforms of their nodes; see glint_mesh_load(). Only
 * triangles are taken. They are centred and scaled in double precision before any coordinate is
 * rounded or compared, so size and position do not affect an object. Nothing in the scene is
 * trusted except counts and pointers. `groups` is from the same file; NULL if it has no smoothing
 * groups. */
glint_status glint_imported_mesh(const char *path, const struct aiScene *scene,
                                 const glint_groups *groups, glint_imported *imported,
                                 glint_error *err);

#endif
