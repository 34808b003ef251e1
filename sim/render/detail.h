/* Whether single precision, which assimp uses for all coordinates, is enough for an object at its
 * position. */
#ifndef GLINT_SIM_RENDER_DETAIL_H
#define GLINT_SIM_RENDER_DETAIL_H

#include <assimp/scene.h>

#include "glint_status.h"
#include "render/remarks.h"

/* GLINT_BAD_INPUT if the scene's meshes, already triangulated, lie so far from the origin that most
 * of the scene's triangles are lost to coordinate rounding; a remark if that affects most of one
 * mesh but not of the scene. `path` is for the message only. */
glint_status glint_detail_check(const char *path, const struct aiScene *scene,
                                glint_remarks *remarks, glint_error *err);

#endif
