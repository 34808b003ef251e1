/* Generated normals: one per triangle corner, independent of the order of triangles and the sharing
 * of vertices. */
#ifndef GLINT_SIM_RENDER_SMOOTH_H
#define GLINT_SIM_RENDER_SMOOTH_H

#include <stdbool.h>

#include "render/mesh.h"

/* Which pairs of triangles at a point are smoothed together. */
typedef struct glint_smoothing {
    uint32_t *group;  /* for each triangle, bits: they have one in common; 0: with none, flat */
    uint32_t *object; /* for each triangle: they are of one object. NULL: all are */
    bool creased;     /* and at most 66 degrees from each other: a cube keeps its edges, a coarse
                         animal still looks round */
} glint_smoothing;

/* Replaces a mesh in which vertices may have no normal (0 0 0, all others of unit length) by one
 * where each has one. Vertices at exactly the same position are one point. A corner without a
 * normal gets the mean normal of the triangles at its point that are smoothed with its own,
 * weighted by their angles there; if none of them has a plane, any unit vector. Corners of one
 * point and one normal become one vertex; vertices of no triangle are dropped. The same triangles
 * in any order give the same picture to the last bit. `what` names it in the error. */
glint_status glint_smooth(const char *what, const glint_smoothing *smoothing, glint_mesh **mesh,
                          glint_error *err);

#endif
