/* Smoothing groups for a mesh that has normals: what a format without normals can keep of them.
 *
 * A group is one of 32 bits of a triangle. Readers of such a format smooth two triangles that meet
 * if they have a group in common, and give a triangle of no group its plane's normal (groups.h). So
 * two triangles along an edge get a common group if their normals agree at both of its ends, and
 * triangles whose normals differ at a point where they meet get none. Where the normals of an edge
 * agree at one end only (the tip of a cone, the end of a crease), it is smooth if they are within
 * 30 degrees of each other at the other. */
#ifndef GLINT_SIM_CONVERT_SMOOTHING_H
#define GLINT_SIM_CONVERT_SMOOTHING_H

#include <stdbool.h>

#include "glint_status.h"
#include "render/places.h"

typedef struct glint_smoothing_groups {
    uint32_t *group; /* of each triangle: bits */
    int count;       /* bits in use */
    size_t smooth;   /* edges between two triangles that should be smooth */
    size_t unmarked; /* of these, the ones that no bit could be found for: they become sharp */
} glint_smoothing_groups;

/* places: of the mesh. GLINT_INTERRUPTED soon after *stop becomes true; stop may be NULL. */
glint_status glint_smoothing_groups_find(const glint_mesh *mesh, const glint_places *places,
                                         const volatile bool *stop, glint_smoothing_groups *groups,
                                         glint_error *err);
void glint_smoothing_groups_clear(glint_smoothing_groups *groups);

#endif
