/* The viewpoint: from object coordinates to camera coordinates to the frame. */
#ifndef GLINT_SIM_RENDER_CAMERA_H
#define GLINT_SIM_RENDER_CAMERA_H

#include "reflectance/vec3.h"
#include "render/render.h"

/* Nothing closer to the camera than this many object radii is drawn. */
#define GLINT_NEAR (1.0 / 1024.0)

typedef struct glint_camera {
    glint_vec3 right, up, back;     /* the camera's axes in the object's */
    glint_vec3 centre;              /* of the object's bounding box */
    double scale;                   /* 1 / radius of the bounding sphere */
    double aim_x, aim_y;            /* what the camera looks at, off the centre, in radii */
    double distance;                /* of the camera from there, in radii */
    double focal;                   /* distance of the frame from the eye, in pixels */
    double half_width, half_height; /* of the frame, in pixels */
} glint_camera;

/* A point as the camera sees it: x right, y up, w the depth ahead of the camera, in radii. */
typedef struct glint_view_point {
    double x, y, w;
} glint_view_point;

/* The camera of a checked scene for frames of that size. */
glint_camera glint_camera_of(const glint_scene *scene, int width, int height);

static inline glint_vec3 glint_camera_rotate(const glint_camera *camera, glint_vec3 v)
{
    return (glint_vec3){glint_vec3_dot(camera->right, v), glint_vec3_dot(camera->up, v),
                        glint_vec3_dot(camera->back, v)};
}

static inline glint_view_point glint_camera_view(const glint_camera *camera,
                                                 const float position[3])
{
    const glint_vec3 p = glint_camera_rotate(
        camera,
        glint_vec3_scale(glint_vec3_sub(glint_vec3_of(position), camera->centre), camera->scale));
    return (glint_view_point){p.x - camera->aim_x, p.y - camera->aim_y, camera->distance - p.z};
}

#endif
