/* Skinned meshes of a glTF scene, in the pose that its joints have. */
#ifndef GLINT_SIM_RENDER_SKIN_H
#define GLINT_SIM_RENDER_SKIN_H

#include <assimp/scene.h>
#include <stdbool.h>

#include "glint_status.h"

/* Whether the joints alone say where the mesh is, and its node's transform is to be ignored: so
 * glTF's specification. Other formats give their meshes in the place of the node. */
bool glint_skin_places(const struct aiScene *scene, const struct aiMesh *mesh);

/* Moves vertices and normals of all such meshes to where the joints have them; then they are in
 * the scene's coordinates. GLINT_BAD_INPUT when a joint is not in the scene, or cannot be told from
 * another of its name. `path` is for the message only. */
glint_status glint_skin_pose(const char *path, const struct aiScene *scene, glint_error *err);

#endif
