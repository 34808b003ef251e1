/* Frames with ISC and without; see render_isc.h. */
#include "cli/render_isc.h"

#include <math.h>

#include "cli/output.h"

#define PAIRS 5

static glint_status shoot(const glint_render_frame *frame, const glint_scene *scene,
                          glint_image *image, double *least, glint_error *err)
{
    glint_render_stats stats;
    const glint_status status =
        glint_render(frame->renderer, scene, image, glint_stop_flag(), &stats, err);
    if (status == GLINT_OK)
        *least = fmin(*least, stats.shading_seconds);
    return status;
}

static glint_status shoot_pairs(const glint_scene *scene, glint_render_result *result,
                                glint_image *image, glint_error *err)
{
    glint_render_isc *isc = &result->isc;
    glint_scene without = *scene;
    glint_status status = GLINT_OK;
    without.isc = false;
    for (int i = 0; i < PAIRS && status == GLINT_OK; i++) {
        status = shoot(&result->frame[0], scene, image, &isc->seconds_with, err);
        if (status == GLINT_OK)
            status = shoot(&result->frame[0], &without, image, &isc->seconds_without, err);
    }
    return status == GLINT_OK
               ? glint_image_compare(image, result->frame[0].image, &isc->difference, err)
               : status;
}

glint_status glint_render_measure_isc(const glint_scene *scene, glint_render_result *result,
                                      glint_error *err)
{
    const glint_image *frame = result->frame[0].image;
    glint_image *image;
    glint_status status = glint_image_create(frame->width, frame->height, &image, err);
    if (status != GLINT_OK)
        return status;
    result->isc =
        (glint_render_isc){.measured = true, .seconds_with = INFINITY, .seconds_without = INFINITY};
    status = shoot_pairs(scene, result, image, err);
    glint_image_destroy(image);
    return status;
}
