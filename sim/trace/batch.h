/* One thread's run of pixels: rays through them, the light where they end. */
#ifndef GLINT_SIM_TRACE_BATCH_H
#define GLINT_SIM_TRACE_BATCH_H

#include "render/points.h"
#include "trace/rays.h"
#include "trace/trace.h"

/* What all pixels of an image have in common. */
typedef struct glint_trace_view {
    const glint_rays *rays;
    glint_camera camera;
    glint_lighting lighting;
    bool shadows;
    double reflect;
} glint_trace_view;

/* One thread's room, and what it has counted since it was emptied. */
typedef struct glint_trace_batch {
    glint_lit_points seen, mirrored;
    uint32_t pixel[GLINT_POINTS_RUN]; /* that shows the point seen */
    bool has_mirrored[GLINT_POINTS_RUN];
    uint64_t hits, shadow_rays, mirror_rays, highlights;
} glint_trace_batch;

/* Gives count pixels, at most GLINT_POINTS_RUN, their colours. */
glint_status glint_trace_pixels(glint_trace_batch *batch, const glint_trace_view *view,
                                glint_backend *backend, const uint32_t *pixel, size_t count,
                                glint_image *image, glint_error *err);

#endif
