/* Normals that no one gave: a surface of triangles gets one normal for each corner, whatever the
 * order in which its triangles come and however its vertices are shared. */
#ifndef GLINT_SIM_RENDER_SMOOTH_H
#define GLINT_SIM_RENDER_SMOOTH_H

#include <stdbool.h>

#include "render/mesh.h"

/* Of two triangles about one point, which are smooth over each other. */
typedef struct glint_smoothing {
    uint32_t *group;  /* for each triangle, bits: they have one in common; 0: with none, flat */
    uint32_t *object; /* for each triangle: they are of one object. NULL: all are */
    bool creased;     /* and at most 66 degrees from each other: a cube keeps its edges, a coarse
                         animal still looks round */
} glint_smoothing;

/* Replaces a mesh in which vertices may have no normal (0 0 0, all others of unit length) by one
 * where each has one. Vertices in exactly one place are one point. A corner without a normal gets
 * the mean of the planes' normals of those triangles about its point that are smooth over its own,
 * each by its angle there; that no triangle has a plane is left to any unit vector. Corners of one
 * point and one normal become one vertex; vertices of no triangle are dropped. The same picture
 * comes of the same triangles in any order, to the last bit. `what` names it in the error. */
glint_status glint_smooth(const char *what, const glint_smoothing *smoothing, glint_mesh **mesh,
                          glint_error *err);

#endif
