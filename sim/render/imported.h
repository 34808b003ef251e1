/* What assimp has read becomes a mesh, where it can be one. */
#ifndef GLINT_SIM_IMPORTED_H
#define GLINT_SIM_IMPORTED_H

#include <assimp/scene.h>

#include "render/mesh.h"

/* Looks through the coordinates as they stand in the file. GLINT_BAD_INPUT names the first that is
 * not a number or beyond 1e18. `path` is for the message only. */
glint_status glint_imported_check(const char *path, const struct aiScene *scene, glint_error *err);

/* All meshes of the scene under the transforms of their nodes; see glint_mesh_load(). Only
 * triangles are taken. Nothing of the scene is believed but its counts and its pointers. */
glint_status glint_imported_mesh(const char *path, const struct aiScene *scene, glint_mesh **mesh,
                                 glint_error *err);

#endif
