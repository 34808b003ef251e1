/* A mesh made ready for rays, in the camera's axes about the object's centre, its bounding sphere
 * of radius 1: the coordinates of glint_camera_view() but for the camera's place. */
#ifndef GLINT_SIM_TRACE_RAYS_H
#define GLINT_SIM_TRACE_RAYS_H

#include <stdbool.h>

#include "render/camera.h"
#include "render/mesh.h"

typedef struct glint_rays glint_rays;

/* Where a ray meets the mesh first. */
typedef struct glint_ray_hit {
    uint32_t triangle;
    double distance;   /* in lengths of the ray's direction */
    glint_vec3 place;  /* of the hit */
    glint_vec3 plane;  /* the triangle's normal, outwards, of unit length */
    glint_vec3 normal; /* the vertices' normals interpolated there, any length */
} glint_ray_hit;

/* mesh must outlive it. GLINT_IO_ERROR without Embree, GLINT_INTERRUPTED when *stop becomes true
 * (stop may be NULL), GLINT_NO_MEMORY. */
glint_status glint_rays_create(const glint_mesh *mesh, const glint_camera *camera,
                               const volatile bool *stop, glint_rays **rays, glint_error *err);
void glint_rays_destroy(glint_rays *rays); /* NULL is allowed */

/* How far the mesh reaches from the centre towards the viewer. */
double glint_rays_front(const glint_rays *rays);

/* The first triangle that faces the ray: the others are not there, as for the rasterizer. Embree
 * finds the triangle, in single precision; where the ray meets its plane is then computed in
 * double. Any number of threads may ask at once. */
bool glint_rays_meet(const glint_rays *rays, glint_vec3 from, glint_vec3 direction,
                     glint_ray_hit *hit);

/* Where a ray from the place of a hit begins so that it does not meet the triangle it leaves. */
glint_vec3 glint_rays_just_outside(const glint_rays *rays, const glint_ray_hit *hit);

/* Whether anything, whichever way it faces, is in the way. */
bool glint_rays_blocked(const glint_rays *rays, glint_vec3 from, glint_vec3 direction);

#endif
