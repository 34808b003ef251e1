/* Affine transforms of the object beside the camera's, as the program of the thesis's section 3.3
 * has them. */
#ifndef GLINT_SIM_RENDER_TRANSFORM_H
#define GLINT_SIM_RENDER_TRANSFORM_H

#include "render/mesh.h"

#define GLINT_SCALE_MAX 1000.0 /* of a factor, either way */
#define GLINT_SCALE_MIN 1e-6   /* of its size: what is thinner is as good as flat */
#define GLINT_MOVE_MAX  1000.0

/* Turns, scales and moves the mesh, in this order of what acts on a point: scale along the object's
 * axes, rotate about x, then y, then z, move; all about the centre of the bounding box. A normal is
 * transformed by the inverse transpose, to unit length again; a mirrored mesh keeps its outside.
 *
 * The camera stays where it is for the mesh as it was: mesh->rest keeps those positions. A second
 * transform starts from the mesh as it is, and the camera stays with the first one's.
 *
 * GLINT_BAD_ARGUMENT for a factor about 0, which has no useful inverse, or a value out of range. */
glint_status glint_mesh_transform(glint_mesh *mesh, const glint_transform *transform,
                                  glint_error *err);

/* Whether it changes nothing. */
bool glint_transform_is_identity(const glint_transform *transform);

#endif
