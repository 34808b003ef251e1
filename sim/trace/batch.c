/* Primary, shadow and mirror rays of a run of pixels. All points that are seen go to the backend
 * together, then all that are seen in the mirror. */
#include "trace/batch.h"

#include <string.h>

/* How far ahead of the object rays start. */
#define AHEAD 1e-3

static glint_vec3 light_of(const glint_trace_view *view)
{
    return glint_vec3_of(view->lighting.light);
}

/* The ray through the middle of a pixel, one unit of depth long. It begins where the object may,
 * and at the near plane at the earliest, so that single precision loses nothing over the way. */
static glint_vec3 ray_of(const glint_trace_view *view, int x, int y, glint_vec3 *from)
{
    const glint_camera *camera = &view->camera;
    const glint_vec3 eye = {camera->aim_x, camera->aim_y, camera->distance};
    const glint_vec3 ray = {(x + 0.5 - camera->half_width) / camera->focal,
                            (camera->half_height - y - 0.5) / camera->focal, -1.0};
    const double begin = camera->distance - glint_rays_front(view->rays) - AHEAD;
    *from = glint_vec3_add(eye, glint_vec3_scale(ray, begin > GLINT_NEAR ? begin : GLINT_NEAR));
    return ray;
}

/* Adds the point that a ray has met to those to be lit. */
static void add_point(glint_trace_batch *batch, const glint_trace_view *view,
                      glint_lit_points *points, const glint_ray_hit *hit, glint_vec3 ray)
{
    const size_t at = points->count;
    glint_lit_points_add(points, &view->lighting, glint_vec3_scale(ray, -1.0), hit->normal);
    if (!view->shadows || !points->lit[at])
        return;
    batch->shadow_rays++;
    if (glint_rays_blocked(view->rays, glint_rays_just_outside(view->rays, hit), light_of(view)))
        glint_lit_points_shadow(points, &view->lighting);
}

/* The ray back off a mirror in the surface: ray − 2(N·ray)N. Nothing where it would go into the
 * object. */
static bool add_mirrored(glint_trace_batch *batch, const glint_trace_view *view,
                         const glint_ray_hit *hit, glint_vec3 ray)
{
    const double nn = glint_vec3_dot(hit->normal, hit->normal);
    const double nr = glint_vec3_dot(hit->normal, ray);
    if (view->reflect <= 0.0 || nn <= 0.0)
        return false;
    const glint_vec3 back = glint_vec3_sub(ray, glint_vec3_scale(hit->normal, 2.0 * nr / nn));
    glint_ray_hit seen;
    if (glint_vec3_dot(back, hit->plane) <= 0.0)
        return false;
    batch->mirror_rays++;
    if (!glint_rays_meet(view->rays, glint_rays_just_outside(view->rays, hit), back, &seen))
        return false;
    add_point(batch, view, &batch->mirrored, &seen, back);
    return true;
}

static void cast(glint_trace_batch *batch, const glint_trace_view *view, uint32_t pixel,
                 glint_image *image)
{
    glint_vec3 from;
    glint_ray_hit hit;
    const int width = image->width;
    const glint_vec3 ray =
        ray_of(view, (int)(pixel % (uint32_t)width), (int)(pixel / (uint32_t)width), &from);
    const bool met = glint_rays_meet(view->rays, from, ray, &hit);
    image->object[pixel] = met;
    if (!met) {
        memset(&image->rgb[3 * (size_t)pixel], 0, 3);
        return;
    }
    batch->hits++;
    const size_t at = batch->seen.count;
    batch->pixel[at] = pixel;
    add_point(batch, view, &batch->seen, &hit, ray);
    batch->has_mirrored[at] = add_mirrored(batch, view, &hit, ray);
}

static uint8_t sum_of(uint8_t own, uint8_t mirrored, double share)
{
    const double sum = own + share * mirrored + 0.5;
    return sum < 255.0 ? (uint8_t)sum : 255;
}

static void write(const glint_trace_batch *batch, const glint_trace_view *view, glint_image *image)
{
    size_t mirrored = 0;
    for (size_t i = 0; i < batch->seen.count; i++) {
        uint8_t *rgb = &image->rgb[3 * (size_t)batch->pixel[i]];
        for (int c = 0; c < 3; c++) {
            const uint8_t own = batch->seen.base[c][i];
            rgb[c] = batch->has_mirrored[i]
                         ? sum_of(own, batch->mirrored.base[c][mirrored], view->reflect)
                         : own;
        }
        mirrored += batch->has_mirrored[i];
    }
}

glint_status glint_trace_pixels(glint_trace_batch *batch, const glint_trace_view *view,
                                glint_backend *backend, const uint32_t *pixel, size_t count,
                                glint_image *image, glint_error *err)
{
    batch->seen.count = 0;
    batch->mirrored.count = 0;
    for (size_t i = 0; i < count; i++)
        cast(batch, view, pixel[i], image);
    glint_status status = glint_lit_points_light(&batch->seen, &view->lighting, backend, err);
    if (status == GLINT_OK)
        status = glint_lit_points_light(&batch->mirrored, &view->lighting, backend, err);
    if (status != GLINT_OK)
        return status;
    batch->highlights += batch->seen.count + batch->mirrored.count;
    write(batch, view, image);
    return GLINT_OK;
}
