/* Traced frames, one thread, and how they differ from the full trace. */
#define _POSIX_C_SOURCE 200809L

#include "report/trace_runs.h"

#include <math.h>
#include <stdlib.h>
#include <time.h>

#include "report/frame_errors.h"
#include "report/grid_mesh.h"

/* A bar is about a pixel wide at 640x480, and some 20 pixels are between two. */
#define GRID_BARS  24
#define GRID_WIDTH 0.07

const char *const glint_trace_object_names[GLINT_TRACE_OBJECTS] = {"sphere", "teapot", "grid"};

static const glint_join every_pixel = {.centre = -1};

static double processor_seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/* Other load on the machine can only add to a time: the least counts. */
static glint_status time_it(glint_tracer *tracer, const glint_join *how, int repeats,
                            glint_image *image, glint_trace_stats *stats, double *seconds,
                            glint_error *err)
{
    glint_status status = GLINT_OK;
    *seconds = (double)INFINITY;
    for (int i = 0; i < repeats && status == GLINT_OK; i++) {
        const double start = processor_seconds();
        status = glint_trace(tracer, how, image, stats, err);
        *seconds = fmin(*seconds, processor_seconds() - start);
    }
    return status;
}

static glint_status make_mesh(glint_trace_object object, glint_mesh **mesh, glint_error *err)
{
    switch (object) {
    case GLINT_TRACE_SPHERE:
        return glint_frame_mesh(GLINT_FIGURE_SPHERE, mesh, err);
    case GLINT_TRACE_TEAPOT:
        return glint_frame_mesh(GLINT_FIGURE_TEAPOT, mesh, err);
    default:
        return glint_grid_mesh(GRID_BARS, GRID_WIDTH, mesh, err);
    }
}

glint_status glint_trace_subject_make(glint_report *report, glint_trace_object object,
                                      glint_trace_subject *subject, glint_error *err)
{
    glint_scene scene;
    glint_trace_stats stats;
    *subject = (glint_trace_subject){0};
    glint_scene_defaults(&scene);
    glint_status status = make_mesh(object, &subject->mesh, err);
    scene.mesh = subject->mesh;
    const glint_tracer_config config = {.width = 640, /* --quick or not: verdicts go by it */
                                        .height = 480,
                                        .threads = 1,
                                        .backend = {.pipeline = GLINT_PIPELINE_PIPELINED},
                                        .scene = scene,
                                        .stop = report->stop};
    if (status == GLINT_OK)
        status = glint_tracer_create(&config, &subject->tracer, err);
    if (status == GLINT_OK)
        status = glint_image_create(config.width, config.height, &subject->full, err);
    if (status == GLINT_OK)
        status = glint_image_create(config.width, config.height, &subject->image, err);
    subject->repeats = report->quick ? 2 : 3; /* the first one is cold */
    if (status == GLINT_OK)
        status = time_it(subject->tracer, &every_pixel, subject->repeats, subject->full, &stats,
                         &subject->full_seconds, err);
    return status;
}

void glint_trace_subject_destroy(glint_trace_subject *subject)
{
    glint_tracer_destroy(subject->tracer);
    glint_mesh_destroy(subject->mesh);
    glint_image_destroy(subject->full);
    glint_image_destroy(subject->image);
}

static double beyond(const glint_image *full, const glint_image *image, uint64_t filled)
{
    uint64_t count = 0;
    for (size_t i = 0; i < (size_t)full->width * (size_t)full->height; i++)
        count += glint_measure_of(GLINT_MEASURE_DELTA_E, &full->rgb[3 * i], &image->rgb[3 * i]) >
                 GLINT_LIMIT_DEFAULT;
    return filled > 0 ? (double)count / (double)filled : 0.0;
}

glint_status glint_trace_subject_run(glint_trace_subject *subject, const glint_join *how,
                                     bool timed, glint_trace_run *run, glint_error *err)
{
    double seconds;
    glint_trace_stats stats = {0};
    glint_image_difference difference;
    glint_status status = time_it(subject->tracer, how, timed ? subject->repeats : 1,
                                  subject->image, &stats, &seconds, err);
    if (status == GLINT_OK)
        status = glint_image_compare(subject->full, subject->image, &difference, err);
    if (status != GLINT_OK)
        return status;
    const uint64_t pixels = stats.join.traced + stats.join.filled;
    *run = (glint_trace_run){.rays = (double)stats.join.traced / (double)pixels,
                             .nmse = difference.nmse,
                             .gain = timed ? subject->full_seconds / seconds : 0.0,
                             .beyond = beyond(subject->full, subject->image, stats.join.filled),
                             .largest = difference.largest};
    return GLINT_OK;
}

/* The sum of a row's squared steps from pixel x to the next, over the components. */
static double step_at(const glint_image *image, int x, int y)
{
    const uint8_t *a = &image->rgb[3 * ((size_t)y * (size_t)image->width + (size_t)x)];
    double sum = 0.0;
    for (int c = 0; c < 3; c++)
        sum += (a[c] - a[c + 3]) * (a[c] - a[c + 3]);
    return sum;
}

double glint_trace_sharpness(const glint_image *image)
{
    double sum = 0.0;
    for (int y = 0; y < image->height; y++)
        for (int x = 0; x < image->width - 1; x++)
            sum += step_at(image, x, y);
    return sum / ((double)image->height * (image->width - 1));
}

double glint_trace_seams(const glint_image *image, int segment)
{
    double seams = 0.0, others = 0.0;
    int seam_count = 0, other_count = 0;
    for (int x = 0; x < image->width - 1; x++) {
        const bool is_seam = x % (segment + 1) == (segment + 1) / 2;
        for (int y = 0; y < image->height; y++)
            *(is_seam ? &seams : &others) += sqrt(step_at(image, x, y));
        seam_count += is_seam;
        other_count += !is_seam;
    }
    return seams / seam_count / (others / other_count);
}
