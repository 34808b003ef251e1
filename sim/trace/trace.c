/* A tracer: the tree, and threads that take runs of the pixels asked for. A run's result depends
 * only on its pixels, and so does the image. */
#define _POSIX_C_SOURCE 200809L

#include "trace/trace.h"

#include <stdatomic.h>
#include <stdlib.h>
#include <time.h>

#include "render/scene.h"
#include "thread/crew.h"
#include "trace/batch.h"

/* One thread's own things. */
typedef struct worker {
    glint_backend *backend;
    glint_trace_batch batch;
    glint_status status;
    glint_error error;
} worker;

struct glint_tracer {
    glint_tracer_config config;
    glint_rays *rays;
    glint_reflectance specular;
    glint_trace_view view;
    glint_crew *crew;
    worker *workers;
    double build_seconds;
    uint64_t traced; /* of the image in the making, before this call */
};

/* What the join asks for at once. */
typedef struct call {
    glint_tracer *tracer;
    const uint32_t *pixel;
    size_t count;
    glint_image *image;
    atomic_size_t next;
    atomic_bool failed;
} call;

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static bool stopped(const glint_tracer *tracer)
{
    return tracer->config.stop != NULL && *tracer->config.stop;
}

/* Takes the next run; false if none is left or the image is abandoned. */
static bool take(call *c, worker *w, size_t *start)
{
    if (atomic_load_explicit(&c->failed, memory_order_relaxed))
        return false;
    if (stopped(c->tracer)) {
        w->status = glint_fail(&w->error, GLINT_INTERRUPTED, "tracing abandoned: interrupted");
        atomic_store(&c->failed, true);
        return false;
    }
    *start = atomic_fetch_add_explicit(&c->next, GLINT_POINTS_RUN, memory_order_relaxed);
    return *start < c->count;
}

static void trace_runs(void *context, int index)
{
    call *c = context;
    const glint_tracer_config *config = &c->tracer->config;
    worker *w = &c->tracer->workers[index];
    size_t start;
    while (take(c, w, &start)) {
        const size_t left = c->count - start;
        if (index == 0 && config->progress != NULL) /* the caller's own thread */
            config->progress(config->context, c->tracer->traced + start,
                             (uint64_t)config->width * (uint64_t)config->height);
        w->status = glint_trace_pixels(&w->batch, &c->tracer->view, w->backend, &c->pixel[start],
                                       left < GLINT_POINTS_RUN ? left : GLINT_POINTS_RUN, c->image,
                                       &w->error);
        if (w->status != GLINT_OK)
            atomic_store(&c->failed, true);
    }
}

static glint_status trace_all(void *context, const uint32_t *pixel, size_t count,
                              glint_image *image, glint_error *err)
{
    glint_tracer *t = context;
    call c = {.tracer = t, .pixel = pixel, .count = count, .image = image};
    atomic_init(&c.next, 0);
    atomic_init(&c.failed, false);
    glint_crew_run(t->crew, trace_runs, &c);
    t->traced += count;
    for (int i = 0; i < t->config.threads; i++)
        if (t->workers[i].status != GLINT_OK)
            return glint_fail(err, t->workers[i].status, "%s", t->workers[i].error.text);
    return GLINT_OK;
}

static void begin(glint_tracer *tracer)
{
    tracer->traced = 0;
    for (int i = 0; i < tracer->config.threads; i++) {
        worker *w = &tracer->workers[i];
        w->status = GLINT_OK;
        w->batch.hits = 0;
        w->batch.shadow_rays = 0;
        w->batch.mirror_rays = 0;
        w->batch.highlights = 0;
    }
}

static void collect(const glint_tracer *tracer, glint_trace_stats *stats)
{
    for (int i = 0; i < tracer->config.threads; i++) {
        const glint_trace_batch *batch = &tracer->workers[i].batch;
        stats->hits += batch->hits;
        stats->shadow_rays += batch->shadow_rays;
        stats->mirror_rays += batch->mirror_rays;
        stats->highlights += batch->highlights;
    }
}

glint_status glint_trace(glint_tracer *tracer, const glint_join *how, glint_image *image,
                         glint_trace_stats *stats, glint_error *err)
{
    const double start = now();
    glint_trace_stats found = {0};
    if (image->width != tracer->config.width || image->height != tracer->config.height) {
        return glint_fail(err, GLINT_BAD_ARGUMENT,
                          "the image is %dx%d but the tracer's frame is %dx%d", image->width,
                          image->height, tracer->config.width, tracer->config.height);
    }
    begin(tracer);
    const glint_status status = glint_join_image(how, trace_all, tracer, image, &found.join, err);
    collect(tracer, &found);
    found.seconds = now() - start;
    if (stats != NULL)
        *stats = found;
    return status;
}

/* ---- Creating one ---------------------------------------------------------------------------- */

static glint_status check(const glint_tracer_config *c, glint_error *err)
{
    if (c->width < 1 || c->width > GLINT_IMAGE_SIDE_MAX || c->height < 1 ||
        c->height > GLINT_IMAGE_SIDE_MAX) {
        return glint_fail(err, GLINT_BAD_ARGUMENT,
                          "frame size %dx%d: each side must be from 1 to %d", c->width, c->height,
                          GLINT_IMAGE_SIDE_MAX);
    }
    if (c->threads < 1 || c->threads > GLINT_THREADS_MAX) {
        return glint_fail(err, GLINT_BAD_ARGUMENT, "threads is %d, not from 1 to %d", c->threads,
                          GLINT_THREADS_MAX);
    }
    if (c->watch != NULL && c->threads != 1)
        return glint_fail(err, GLINT_BAD_ARGUMENT, "%d threads cannot share one watch", c->threads);
    if (!(c->reflect >= 0.0 && c->reflect <= 1.0))
        return glint_fail(err, GLINT_BAD_ARGUMENT, "reflect is %g, not from 0 to 1", c->reflect);
    if (c->scene.shading != GLINT_SHADING_PHONG) {
        return glint_fail(err, GLINT_BAD_ARGUMENT,
                          "rays are lit at every point: only Phong's shading can be traced");
    }
    return glint_scene_check(&c->scene, err);
}

/* *specular stays NULL where the backend computes the highlights. */
static glint_status prepare_specular(glint_tracer *t, const glint_reflectance **specular,
                                     glint_error *err)
{
    const glint_scene *scene = &t->config.scene;
    const glint_reflectance_parameters parameters = {.n = scene->n, .f0 = (double)scene->f0};
    *specular = NULL;
    if (!scene->by_model)
        return GLINT_OK;
    if (t->config.backend.kind != GLINT_BACKEND_REAL) {
        return glint_fail(err, GLINT_BAD_ARGUMENT,
                          "highlights from a reflectance model need backend real");
    }
    *specular = &t->specular;
    const glint_status status = glint_scene_check_exponent(scene->specular, scene->n, err);
    return status == GLINT_OK
               ? glint_reflectance_prepare(scene->specular, &parameters, &t->specular, err)
               : status;
}

static glint_status create_workers(glint_tracer *t, glint_error *err)
{
    t->workers = calloc((size_t)t->config.threads, sizeof *t->workers);
    if (t->workers == NULL)
        return glint_fail(err, GLINT_NO_MEMORY, "not enough memory for %d threads",
                          t->config.threads);
    for (int i = 0; i < t->config.threads; i++) {
        const glint_status status =
            glint_backend_create(&t->config.backend, &t->workers[i].backend, err);
        if (status != GLINT_OK)
            return status;
        glint_backend_set_watch(t->workers[i].backend, t->config.watch);
    }
    return glint_crew_create(t->config.threads, &t->crew, err);
}

static glint_status create(glint_tracer *t, glint_error *err)
{
    const glint_reflectance *specular;
    glint_status status = check(&t->config, err);
    if (status == GLINT_OK)
        status = prepare_specular(t, &specular, err);
    if (status != GLINT_OK)
        return status;
    t->view.camera = glint_camera_of(&t->config.scene, t->config.width, t->config.height);
    t->view.lighting = glint_lighting_of(&t->config.scene, &t->view.camera, specular);
    t->view.shadows = t->config.shadows;
    t->view.reflect = t->config.reflect;
    const double start = now();
    status =
        glint_rays_create(t->config.scene.mesh, &t->view.camera, t->config.stop, &t->rays, err);
    t->view.rays = t->rays;
    t->build_seconds = now() - start;
    return status == GLINT_OK ? create_workers(t, err) : status;
}

glint_status glint_tracer_create(const glint_tracer_config *config, glint_tracer **tracer,
                                 glint_error *err)
{
    glint_tracer *t = calloc(1, sizeof *t);
    if (t == NULL)
        return glint_fail(err, GLINT_NO_MEMORY, "not enough memory for a ray tracer");
    t->config = *config;
    const glint_status status = create(t, err);
    if (status == GLINT_OK)
        *tracer = t;
    else
        glint_tracer_destroy(t);
    return status;
}

void glint_tracer_destroy(glint_tracer *tracer)
{
    if (tracer == NULL)
        return;
    glint_crew_destroy(tracer->crew);
    for (int i = 0; tracer->workers != NULL && i < tracer->config.threads; i++)
        glint_backend_destroy(tracer->workers[i].backend);
    free(tracer->workers);
    glint_rays_destroy(tracer->rays);
    free(tracer);
}

double glint_tracer_build_seconds(const glint_tracer *tracer)
{
    return tracer->build_seconds;
}
