/* Backward ray tracing of the rasterizer's scene: same mesh, camera, normals, formula and backend,
 * so that without shadows and reflections the picture is the rasterizer's with Phong shading, but
 * for rounding and the pixels at an edge (docs/tracing.md states the bound). Identical for any
 * number of threads. */
#ifndef GLINT_SIM_TRACE_TRACE_H
#define GLINT_SIM_TRACE_TRACE_H

#include "render/render.h"
#include "trace/join.h"

typedef struct glint_tracer_config {
    int width, height, threads;
    glint_backend_config backend; /* each thread has its own */
    glint_scene scene;            /* Phong shading; its mesh must outlive the tracer */
    bool shadows;                 /* hard ones: what the light does not reach has ambient light */
    double reflect;               /* 0…1: this much of what a mirror would show is added, once */
    const volatile bool *stop;    /* GLINT_INTERRUPTED when it becomes true; may be NULL */
    glint_backend_watch *watch;   /* of one thread's circuit; or NULL */
    glint_render_progress *progress; /* called with the pixels traced so far; or NULL */
    void *context;
} glint_tracer_config;

/* Of one image. */
typedef struct glint_trace_stats {
    glint_join_stats join;
    uint64_t hits;                     /* primary rays that met the object */
    uint64_t shadow_rays, mirror_rays; /* secondary */
    uint64_t highlights;               /* computed by the backend or the model */
    double seconds;                    /* without the tree's */
} glint_trace_stats;

typedef struct glint_tracer glint_tracer;

/* Builds the tree over the mesh. Errors as of glint_rays_create() (rays.h), glint_backend_create()
 * and for a scene or a setting out of range. */
glint_status glint_tracer_create(const glint_tracer_config *config, glint_tracer **tracer,
                                 glint_error *err);
void glint_tracer_destroy(glint_tracer *tracer); /* NULL is allowed */

/* Seconds that the tree took. */
double glint_tracer_build_seconds(const glint_tracer *tracer);

/* Traces one image of the size given. */
glint_status glint_trace(glint_tracer *tracer, const glint_join *how, glint_image *image,
                         glint_trace_stats *stats, glint_error *err);

#endif
