/* The camera's place: around the object by yaw and pitch, and as far as asked or as fits. */
#include "render/camera.h"

#include <float.h>

#define RADIANS (3.14159265358979323846 / 180.0)

/* The fraction of half the frame that a fitted object fills; the rest is margin. */
#define FILL 0.98

/* A fitted camera keeps at least this far from the nearest vertex, in radii: it matters to an
 * object that has no extent across the view. */
#define CLEARANCE 0.05

static double least(double a, double b)
{
    return a < b ? a : b;
}

static double most(double a, double b)
{
    return a > b ? a : b;
}

static void place_axes(glint_camera *camera, const glint_scene *scene)
{
    const double yaw = (double)scene->yaw * RADIANS;
    const double pitch = (double)scene->pitch * RADIANS;
    camera->right = (glint_vec3){cos(yaw), 0.0, -sin(yaw)};
    camera->back = (glint_vec3){sin(yaw) * cos(pitch), sin(pitch), cos(yaw) * cos(pitch)};
    camera->up = glint_vec3_cross(camera->back, camera->right);
}

/* An object's own transform does not move the camera. */
static const float *placed_by(const glint_mesh *mesh)
{
    return mesh->rest != NULL ? mesh->rest : mesh->position;
}

static glint_vec3 bounding_box_centre(const glint_mesh *mesh)
{
    glint_vec3 low = {DBL_MAX, DBL_MAX, DBL_MAX};
    glint_vec3 high = {-DBL_MAX, -DBL_MAX, -DBL_MAX};
    for (size_t i = 0; i < mesh->vertex_count; i++) {
        const glint_vec3 p = glint_vec3_of(&placed_by(mesh)[3 * i]);
        low = (glint_vec3){least(low.x, p.x), least(low.y, p.y), least(low.z, p.z)};
        high = (glint_vec3){most(high.x, p.x), most(high.y, p.y), most(high.z, p.z)};
    }
    return glint_vec3_scale(glint_vec3_add(low, high), 0.5);
}

static double radius_about(const glint_mesh *mesh, glint_vec3 centre)
{
    double square = 0.0;
    for (size_t i = 0; i < mesh->vertex_count; i++) {
        const glint_vec3 p = glint_vec3_sub(glint_vec3_of(&placed_by(mesh)[3 * i]), centre);
        square = most(square, glint_vec3_dot(p, p));
    }
    return sqrt(square);
}

/* Along one axis of the frame, how far the camera must be and where it must aim so that every
 * vertex falls within the filled part and the outermost of both sides touch its border. With k =
 * focal length / half of the filled part, a vertex (x, z) does while k·|x − aim| ≤ distance − z:
 * two bounds on the distance, linear in the aim, that meet at the best one. */
typedef struct fit {
    double left, right; /* max(z − k·x), max(z + k·x) */
} fit;

static void widen(fit *f, double k, double x, double z)
{
    f->left = most(f->left, z - k * x);
    f->right = most(f->right, z + k * x);
}

static void fit_frame(glint_camera *camera, const glint_mesh *mesh)
{
    const double kx = camera->focal / (FILL * camera->half_width);
    const double ky = camera->focal / (FILL * camera->half_height);
    fit across = {-DBL_MAX, -DBL_MAX};
    fit upright = {-DBL_MAX, -DBL_MAX};
    double nearest = -DBL_MAX;
    for (size_t i = 0; i < mesh->vertex_count; i++) {
        const glint_view_point p = glint_camera_view(camera, &placed_by(mesh)[3 * i]);
        widen(&across, kx, p.x, -p.w); /* aim and distance are still 0: w is −z */
        widen(&upright, ky, p.y, -p.w);
        nearest = most(nearest, -p.w);
    }
    camera->aim_x = (across.right - across.left) / (2.0 * kx);
    camera->aim_y = (upright.right - upright.left) / (2.0 * ky);
    camera->distance =
        most(most((across.left + across.right) / 2.0, (upright.left + upright.right) / 2.0),
             nearest + CLEARANCE);
}

glint_camera glint_camera_of(const glint_scene *scene, int width, int height)
{
    glint_camera camera = {.half_width = 0.5 * width, .half_height = 0.5 * height};
    camera.focal = camera.half_height / tan(0.5 * (double)scene->fov * RADIANS);
    place_axes(&camera, scene);
    if (scene->mesh->vertex_count == 0) {
        camera.scale = 1.0;
        camera.distance = 1.0;
        return camera;
    }
    camera.centre = bounding_box_centre(scene->mesh);
    const double radius = radius_about(scene->mesh, camera.centre);
    camera.scale = radius > 0.0 ? 1.0 / radius : 1.0;
    if (scene->distance > 0.0f)
        camera.distance = (double)scene->distance;
    else
        fit_frame(&camera, scene->mesh);
    return camera;
}
