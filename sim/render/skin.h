/* Skinned meshes of a glTF scene, posed by their joints. */
#ifndef GLINT_SIM_RENDER_SKIN_H
#define GLINT_SIM_RENDER_SKIN_H

#include <assimp/scene.h>
#include <stdbool.h>

#include "glint_status.h"

/* Whether the joints alone place the mesh and its node's transform must be ignored, as glTF
 * specifies. In other formats, meshes are placed by their nodes. */
bool glint_skin_places(const struct aiScene *scene, const struct aiMesh *mesh);

/* Moves vertices and normals of all such meshes to their posed positions, in scene coordinates.
 * GLINT_BAD_INPUT if a joint is missing from the scene or its name is ambiguous. `path` is for the
 * message only. */
glint_status glint_skin_pose(const char *path, const struct aiScene *scene, glint_error *err);

#endif
