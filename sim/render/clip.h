/* Clipping of one triangle against the near plane and the four sides of the guard square. */
#ifndef GLINT_SIM_RENDER_CLIP_H
#define GLINT_SIM_RENDER_CLIP_H

#include "render/camera.h"

/* A plane adds one corner to a convex polygon, so a triangle ends with 8. Rounding can put corners
 * that lie on a plane on alternate sides of it; then n corners become at most 3n/2: 4, 6, 9, 13,
 * 19. */
#define GLINT_CLIP_PLANES      5
#define GLINT_CLIP_CORNERS_MAX 19

/* A corner in the camera's coordinates, with normal and colour there. */
typedef struct glint_clip_corner {
    glint_view_point p;
    glint_vec3 n;
    double color[3];
} glint_clip_corner;

/* A bit for each plane that the point is beyond. */
uint32_t glint_clip_outside(const glint_camera *camera, glint_view_point p);

/* Clips polygon, which begins with three corners and has room for GLINT_CLIP_CORNERS_MAX, against
 * the planes whose bit is set. Returns how many corners are left, 0 or 3 and more. */
int glint_clip(const glint_camera *camera, uint32_t planes, glint_clip_corner *polygon);

#endif
