/* Frames a second: the whole way from mesh to picture. */
#define _POSIX_C_SOURCE 200809L

#include <stdio.h>
#include <time.h>

#include "bench/bench.h"
#include "gl/renderer.h"
#include "render/render.h"

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* One of the two draws. */
typedef struct renderer {
    glint_renderer *own;
    glint_gl_renderer *gl;
} renderer;

static glint_status render(const renderer *r, const glint_scene *scene, glint_image *image,
                           const volatile bool *stop, glint_render_stats *stats, glint_error *err)
{
    return r->gl != NULL ? glint_gl_render(r->gl, scene, image, stop, stats, err)
                         : glint_render(r->own, scene, image, stop, stats, err);
}

/* Renders until `seconds` have passed, the first frame not counted: it warms the caches. */
static glint_status time_frames(const renderer *r, const glint_scene *scene, glint_image *image,
                                double seconds, const volatile bool *stop, glint_bench_frame *frame,
                                glint_error *err)
{
    glint_render_stats stats;
    glint_status status = render(r, scene, image, stop, &stats, err);
    uint64_t count = 0;
    double start = now(), end = start;
    while (status == GLINT_OK && end - start < seconds) {
        status = render(r, scene, image, stop, &stats, err);
        count++;
        end = now();
    }
    if (status == GLINT_OK) {
        frame->fragments = stats.fragments;
        frame->frames = (double)count / (end - start);
    }
    return status;
}

/* What all frames share. */
typedef struct effort {
    const glint_setting *device;
    int threads;
    double seconds; /* of each */
    const volatile bool *stop;
} effort;

static glint_status open_renderer(const glint_mesh *mesh, const effort *effort,
                                  glint_bench_frame *frame, renderer *r, glint_error *err)
{
    if (frame->backend != GLINT_BENCH_GL) {
        const glint_backend_config config = {.kind = (glint_backend_kind)frame->backend,
                                             .gate = GLINT_GATE_COSINE,
                                             .pipeline = GLINT_PIPELINE_PIPELINED,
                                             .device = effort->device->circuit,
                                             .verilog = effort->device->verilog};
        return glint_renderer_create(frame->width, frame->height, effort->threads, &config, &r->own,
                                     err);
    }
    glint_error why;
    const glint_status status =
        glint_gl_renderer_create(mesh, frame->width, frame->height, effort->threads, &r->gl, &why);
    if (status == GLINT_IO_ERROR) { /* there is no OpenGL here: the others are measured still */
        (void)snprintf(frame->missing, sizeof frame->missing, "%.150s", why.text);
        return GLINT_OK;
    }
    return status == GLINT_OK ? GLINT_OK : glint_fail(err, status, "%s", why.text);
}

static glint_status bench_frame(const glint_mesh *mesh, const effort *effort,
                                glint_bench_frame *frame, glint_error *err)
{
    glint_scene scene;
    renderer r = {NULL, NULL};
    glint_image *image = NULL;
    glint_scene_defaults(&scene);
    scene.mesh = mesh;
    glint_status status = open_renderer(mesh, effort, frame, &r, err);
    if (status == GLINT_OK)
        status = glint_image_create(frame->width, frame->height, &image, err);
    if (status == GLINT_OK && frame->missing[0] == '\0')
        status = time_frames(&r, &scene, image, effort->seconds, effort->stop, frame, err);
    glint_image_destroy(image);
    glint_gl_renderer_destroy(r.gl);
    glint_renderer_destroy(r.own);
    return status;
}

static glint_status bench_mesh(const char *model, const glint_mesh *mesh, const effort *effort,
                               glint_bench_frame *frames, glint_error *err)
{
    static const int sizes[2][2] = {{640, 480}, {1920, 1080}};
    glint_status status = GLINT_OK;
    for (int size = 0; size < 2; size++)
        for (int kind = 0; status == GLINT_OK && kind < GLINT_BENCH_BACKENDS; kind++) {
            glint_bench_frame *frame = frames++;
            *frame = (glint_bench_frame){
                .model = model,
                .width = sizes[size][0],
                .height = sizes[size][1],
                .backend = kind,
            };
            status = bench_frame(mesh, effort, frame, err);
        }
    return status;
}

glint_status glint_bench_frames(const glint_setting *device, int threads, double seconds,
                                const volatile bool *stop,
                                glint_bench_frame frames[GLINT_BENCH_FRAMES], glint_error *err)
{
    const effort effort = {device, threads, seconds, stop};
    glint_mesh *teapot = NULL, *sphere = NULL;
    glint_status status = glint_mesh_teapot(GLINT_TEAPOT_DENSITY, &teapot, err);
    if (status == GLINT_OK)
        status = glint_mesh_sphere(GLINT_SPHERE_DENSITY, &sphere, err);
    if (status == GLINT_OK)
        status = bench_mesh("teapot", teapot, &effort, frames, err);
    if (status == GLINT_OK)
        status = bench_mesh("sphere", sphere, &effort, frames + GLINT_BENCH_FRAMES / 2, err);
    glint_mesh_destroy(teapot);
    glint_mesh_destroy(sphere);
    return status;
}
