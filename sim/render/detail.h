/* Whether single precision, in which assimp reads all coordinates, can hold an object where it
 * lies. */
#ifndef GLINT_SIM_RENDER_DETAIL_H
#define GLINT_SIM_RENDER_DETAIL_H

#include <assimp/scene.h>

#include "glint_status.h"
#include "render/remarks.h"

/* GLINT_BAD_INPUT when meshes of the scene, already of triangles, lie so far from the origin that
 * most of the scene's triangles are lost in the rounding of their coordinates; a remark when it is
 * most of a mesh, but not of the scene. `path` is for the message only. */
glint_status glint_detail_check(const char *path, const struct aiScene *scene,
                                glint_remarks *remarks, glint_error *err);

#endif
