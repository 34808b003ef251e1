/* Frames a second: the whole way from mesh to picture. */
#define _POSIX_C_SOURCE 200809L

#include <time.h>

#include "bench/bench.h"
#include "render/render.h"

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* Renders until `seconds` have passed, the first frame not counted: it warms the caches. */
static glint_status time_frames(glint_renderer *renderer, const glint_scene *scene,
                                glint_image *image, double seconds, const volatile bool *stop,
                                glint_bench_frame *frame, glint_error *err)
{
    glint_render_stats stats;
    glint_status status = glint_render(renderer, scene, image, stop, &stats, err);
    uint64_t count = 0;
    double start = now(), end = start;
    while (status == GLINT_OK && end - start < seconds) {
        status = glint_render(renderer, scene, image, stop, &stats, err);
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
    const char *verilog;
    int threads;
    double seconds; /* of each */
    const volatile bool *stop;
} effort;

static glint_status bench_frame(const glint_mesh *mesh, const effort *effort,
                                glint_bench_frame *frame, glint_error *err)
{
    const glint_backend_config config = {.kind = frame->backend,
                                         .gate = GLINT_GATE_COSINE,
                                         .pipeline = GLINT_PIPELINE_PIPELINED,
                                         .verilog = effort->verilog};
    glint_scene scene;
    glint_renderer *renderer = NULL;
    glint_image *image = NULL;
    glint_scene_defaults(&scene);
    scene.mesh = mesh;
    glint_status status = glint_renderer_create(frame->width, frame->height, effort->threads,
                                                &config, &renderer, err);
    if (status == GLINT_OK)
        status = glint_image_create(frame->width, frame->height, &image, err);
    if (status == GLINT_OK)
        status = time_frames(renderer, &scene, image, effort->seconds, effort->stop, frame, err);
    glint_image_destroy(image);
    glint_renderer_destroy(renderer);
    return status;
}

static glint_status bench_mesh(const char *model, const glint_mesh *mesh, const effort *effort,
                               glint_bench_frame *frames, glint_error *err)
{
    static const int sizes[2][2] = {{640, 480}, {1920, 1080}};
    glint_status status = GLINT_OK;
    for (int size = 0; size < 2; size++)
        for (int kind = 0; status == GLINT_OK && kind < GLINT_BACKEND_COUNT; kind++) {
            glint_bench_frame *frame = frames++;
            frame->model = model;
            frame->width = sizes[size][0];
            frame->height = sizes[size][1];
            frame->backend = (glint_backend_kind)kind;
            status = bench_frame(mesh, effort, frame, err);
        }
    return status;
}

glint_status glint_bench_frames(const char *verilog, int threads, double seconds,
                                const volatile bool *stop,
                                glint_bench_frame frames[GLINT_BENCH_FRAMES], glint_error *err)
{
    const effort effort = {verilog, threads, seconds, stop};
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
