/* Whether single precision, in which assimp reads all coordinates, can hold an object where it
 * lies. */
#ifndef GLINT_SIM_DETAIL_H
#define GLINT_SIM_DETAIL_H

#include <assimp/scene.h>

#include "glint_status.h"

/* GLINT_BAD_INPUT when a mesh of the scene, already of triangles, lies so far from the origin that
 * its triangles are lost in the rounding of their coordinates. `path` is for the message only. */
glint_status glint_detail_check(const char *path, const struct aiScene *scene, glint_error *err);

#endif
