/* Embree's scene of one mesh, and the exact place where a ray meets the triangle that Embree names.
 * The build is the caller's thread's alone; one thread makes the same tree on every machine. */
#include "trace/rays.h"

#include <float.h>
#include <stdlib.h>

#include "trace/embree.h"

/* Secondary rays start this far outside the triangle, in radii of the mesh about its own centre:
 * far above what single precision loses there, far below a pixel. */
#define OUTSIDE 1e-4

/* And at least this many steps of single precision at the largest coordinate, which count where a
 * small mesh lies far from the camera's centre. */
#define STEPS 8.0

struct glint_rays {
    const glint_embree *embree;
    const glint_mesh *mesh;
    glint_camera camera;
    RTCDevice device;
    RTCScene scene;
    double front, outside;
    const volatile bool *stop; /* of the build */
};

static glint_vec3 corner_of(const glint_rays *rays, size_t vertex)
{
    const glint_vec3 p = glint_vec3_of(&rays->mesh->position[3 * vertex]);
    return glint_camera_rotate(
        &rays->camera,
        glint_vec3_scale(glint_vec3_sub(p, rays->camera.centre), rays->camera.scale));
}

/* Embree's callback: a triangle that faces away is passed through. Rays come one at a time, so the
 * structures of N rays are those of one. */
static void pass_back_faces(const struct RTCFilterFunctionNArguments *args)
{
    const struct RTCRay *ray = (const struct RTCRay *)(const void *)args->ray;
    const struct RTCHit *hit = (const struct RTCHit *)(const void *)args->hit;
    if (ray->dir_x * hit->Ng_x + ray->dir_y * hit->Ng_y + ray->dir_z * hit->Ng_z >= 0.0f)
        args->valid[0] = 0;
}

static bool go_on(void *context, double done)
{
    const glint_rays *rays = context;
    (void)done;
    return rays->stop == NULL || !*rays->stop;
}

/* How the positions lie, as Embree has them. */
typedef struct reach {
    glint_vec3 low, high; /* corners of the bounding box */
    double largest;       /* coordinate */
} reach;

static reach reach_of(const float *position, size_t count)
{
    reach r = {{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}, 0.0};
    for (size_t i = 0; i < count; i++) {
        const glint_vec3 p = glint_vec3_of(&position[3 * i]);
        r.low = (glint_vec3){fmin(r.low.x, p.x), fmin(r.low.y, p.y), fmin(r.low.z, p.z)};
        r.high = (glint_vec3){fmax(r.high.x, p.x), fmax(r.high.y, p.y), fmax(r.high.z, p.z)};
        r.largest = fmax(r.largest, fmax(fabs(p.x), fmax(fabs(p.y), fabs(p.z))));
    }
    return r;
}

static void measure(glint_rays *rays, const float *position)
{
    const size_t count = rays->mesh->vertex_count;
    const reach r = reach_of(position, count);
    const glint_vec3 centre = glint_vec3_scale(glint_vec3_add(r.low, r.high), 0.5);
    double radius = 0.0;
    for (size_t i = 0; i < count; i++) {
        const glint_vec3 p = glint_vec3_of(&position[3 * i]);
        radius = fmax(radius, glint_vec3_length(glint_vec3_sub(p, centre)));
    }
    rays->front = r.high.z;
    rays->outside = fmax(OUTSIDE * radius, STEPS * (double)FLT_EPSILON * r.largest);
}

static bool fill(glint_rays *rays, RTCGeometry geometry)
{
    const glint_mesh *mesh = rays->mesh;
    float *position = rays->embree->rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0,
                                                            RTC_FORMAT_FLOAT3, 3 * sizeof(float),
                                                            mesh->vertex_count);
    uint32_t *index =
        rays->embree->rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                              3 * sizeof(uint32_t), mesh->triangle_count);
    if (position == NULL || index == NULL)
        return false;
    for (size_t i = 0; i < mesh->vertex_count; i++)
        glint_vec3_store(corner_of(rays, i), &position[3 * i]);
    measure(rays, position);
    for (size_t i = 0; i < 3 * mesh->triangle_count; i++)
        index[i] = mesh->index[i];
    return true;
}

static glint_status fail(const glint_rays *rays, enum RTCError why, glint_error *err)
{
    if (why == RTC_ERROR_CANCELLED)
        return glint_fail(err, GLINT_INTERRUPTED, "tracing abandoned: interrupted");
    if (why == RTC_ERROR_OUT_OF_MEMORY) {
        return glint_fail(err, GLINT_NO_MEMORY,
                          "not enough memory for Embree's tree of %zu triangles",
                          rays->mesh->triangle_count);
    }
    return glint_fail(err, GLINT_IO_ERROR, "Embree cannot be used here: its error %d", (int)why);
}

/* One geometry in the scene. A mesh without triangles is a scene that no ray meets. */
static enum RTCError build(glint_rays *rays)
{
    const glint_embree *e = rays->embree;
    RTCGeometry geometry = e->rtcNewGeometry(rays->device, RTC_GEOMETRY_TYPE_TRIANGLE);
    if (geometry == NULL)
        return e->rtcGetDeviceError(rays->device);
    e->rtcSetGeometryIntersectFilterFunction(geometry, pass_back_faces);
    const bool filled = rays->mesh->triangle_count == 0 || fill(rays, geometry);
    if (filled && rays->mesh->triangle_count > 0) {
        e->rtcCommitGeometry(geometry);
        (void)e->rtcAttachGeometry(rays->scene, geometry);
    }
    e->rtcReleaseGeometry(geometry);
    if (filled)
        e->rtcCommitScene(rays->scene);
    return filled ? e->rtcGetDeviceError(rays->device) : RTC_ERROR_OUT_OF_MEMORY;
}

static glint_status prepare(glint_rays *rays, glint_error *err)
{
    const glint_embree *e = rays->embree;
    rays->device = e->rtcNewDevice("threads=1");
    if (rays->device == NULL)
        return fail(rays, e->rtcGetDeviceError(NULL), err);
    rays->scene = e->rtcNewScene(rays->device);
    if (rays->scene == NULL)
        return fail(rays, e->rtcGetDeviceError(rays->device), err);
    e->rtcSetSceneFlags(rays->scene, RTC_SCENE_FLAG_ROBUST); /* no ray slips between triangles */
    e->rtcSetSceneProgressMonitorFunction(rays->scene, go_on, rays);
    const enum RTCError why = build(rays);
    return why == RTC_ERROR_NONE ? GLINT_OK : fail(rays, why, err);
}

glint_status glint_rays_create(const glint_mesh *mesh, const glint_camera *camera,
                               const volatile bool *stop, glint_rays **rays, glint_error *err)
{
    const glint_embree *embree;
    glint_status status = glint_embree_open(&embree, err);
    if (status != GLINT_OK)
        return status;
    glint_rays *r = malloc(sizeof *r);
    if (r == NULL)
        return glint_fail(err, GLINT_NO_MEMORY, "not enough memory for a ray tracer");
    *r = (glint_rays){.embree = embree, .mesh = mesh, .camera = *camera, .stop = stop};
    status = prepare(r, err);
    if (status == GLINT_OK)
        *rays = r;
    else
        glint_rays_destroy(r);
    return status;
}

void glint_rays_destroy(glint_rays *rays)
{
    if (rays == NULL)
        return;
    if (rays->scene != NULL)
        rays->embree->rtcReleaseScene(rays->scene);
    if (rays->device != NULL)
        rays->embree->rtcReleaseDevice(rays->device);
    free(rays);
}

double glint_rays_front(const glint_rays *rays)
{
    return rays->front;
}

glint_vec3 glint_rays_just_outside(const glint_rays *rays, const glint_ray_hit *hit)
{
    return glint_vec3_add(hit->place, glint_vec3_scale(hit->plane, rays->outside));
}

static struct RTCRay ray_of(glint_vec3 from, glint_vec3 direction)
{
    return (struct RTCRay){
        .org_x = (float)from.x,
        .org_y = (float)from.y,
        .org_z = (float)from.z,
        .dir_x = (float)direction.x,
        .dir_y = (float)direction.y,
        .dir_z = (float)direction.z,
        .tfar = INFINITY,
        .mask = UINT32_MAX,
    };
}

static double held(double share)
{
    return share < 0.0 ? 0.0 : share > 1.0 ? 1.0 : share;
}

/* Möller and Trumbore's: distance and the shares of corners 1 and 2. Embree's own answer stands
 * where the triangle is seen so exactly from its edge that nothing can be divided. */
static void place_hit(const glint_rays *rays, glint_vec3 from, glint_vec3 direction,
                      const struct RTCRayHit *found, glint_ray_hit *hit)
{
    const uint32_t *index = &rays->mesh->index[3 * (size_t)found->hit.primID];
    const glint_vec3 a = corner_of(rays, index[0]);
    const glint_vec3 ab = glint_vec3_sub(corner_of(rays, index[1]), a);
    const glint_vec3 ac = glint_vec3_sub(corner_of(rays, index[2]), a);
    const glint_vec3 p = glint_vec3_cross(direction, ac);
    const glint_vec3 q = glint_vec3_cross(glint_vec3_sub(from, a), ab);
    const double det = glint_vec3_dot(ab, p);
    double share1 = (double)found->hit.u;
    double share2 = (double)found->hit.v;
    hit->distance = (double)found->ray.tfar;
    if (det != 0.0) {
        share1 = held(glint_vec3_dot(glint_vec3_sub(from, a), p) / det);
        share2 = held(glint_vec3_dot(direction, q) / det);
        hit->distance = glint_vec3_dot(ac, q) / det;
    }
    const glint_vec3 across = glint_vec3_cross(ab, ac);
    const double length = glint_vec3_length(across);
    hit->triangle = found->hit.primID;
    hit->plane = glint_vec3_scale(across, length > 0.0 ? 1.0 / length : 0.0);
    hit->place = glint_vec3_add(from, glint_vec3_scale(direction, hit->distance));
    const double share[3] = {1.0 - share1 - share2, share1, share2};
    glint_vec3 normal = {0.0, 0.0, 0.0};
    for (int i = 0; i < 3; i++) {
        normal = glint_vec3_add(
            normal,
            glint_vec3_scale(glint_vec3_of(&rays->mesh->normal[3 * (size_t)index[i]]), share[i]));
    }
    hit->normal = glint_camera_rotate(&rays->camera, normal);
}

bool glint_rays_meet(const glint_rays *rays, glint_vec3 from, glint_vec3 direction,
                     glint_ray_hit *hit)
{
    struct RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    struct RTCRayHit found = {
        .ray = ray_of(from, direction),
        .hit = {.geomID = RTC_INVALID_GEOMETRY_ID, .primID = RTC_INVALID_GEOMETRY_ID}};
    rays->embree->rtcIntersect1(rays->scene, &context, &found);
    if (found.hit.geomID == RTC_INVALID_GEOMETRY_ID)
        return false;
    place_hit(rays, from, direction, &found, hit);
    return true;
}

bool glint_rays_blocked(const glint_rays *rays, glint_vec3 from, glint_vec3 direction)
{
    struct RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    struct RTCRay ray = ray_of(from, direction);
    rays->embree->rtcOccluded1(rays->scene, &context, &ray);
    return ray.tfar < 0.0f;
}
