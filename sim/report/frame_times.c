/* See frame_times.h. Other load can only add to a frame's time, so this is the processor time on
 * one thread, the least of many frames, with the methods taking turns. */
#define _POSIX_C_SOURCE 200809L

#include "report/frame_times.h"

#include <math.h>
#include <time.h>

#include "bench/formulas.h"
#include "report/chart.h"

#define WIDTH  640
#define HEIGHT 480

typedef enum method { COS_N, COSINE_QUADRATIC, DEVICE, VERILOG, METHODS } method;

static const struct {
    const char *name, *title;
    glint_backend_kind backend;
    bool by_model;
    glint_reflectance_model model;
} methods[METHODS] = {
    [COS_N] = {"blinn", "cos^n", GLINT_BACKEND_REAL, true, GLINT_REFLECTANCE_BLINN},
    [COSINE_QUADRATIC] = {"cosine-quadratic", "cosine-quadratic", GLINT_BACKEND_REAL, true,
                          GLINT_REFLECTANCE_COSINE_QUADRATIC},
    [DEVICE] = {"c", "device, C model", GLINT_BACKEND_C, false, GLINT_REFLECTANCE_DEVICE},
    [VERILOG] = {"rtl", "device, Verilog", GLINT_BACKEND_RTL, false, GLINT_REFLECTANCE_DEVICE},
};

static const uint16_t exponents[] = {10, 100, 1000, 1, 30, 300};

#define EXPONENTS       6
#define EXPONENTS_QUICK 3 /* the first of them */
#define FRAMES          25
#define FRAMES_QUICK    9

/* One figure's frames. */
typedef struct timing {
    const glint_report *report;
    int count, frames;
    glint_scene scene;
    glint_renderer *renderer[METHODS];
    glint_image *image;
    double seconds[EXPONENTS][METHODS]; /* the least */
} timing;

static glint_status open_timing(timing *t, glint_error *err)
{
    glint_status status = glint_image_create(WIDTH, HEIGHT, &t->image, err);
    for (int i = 0; i < METHODS && status == GLINT_OK; i++) {
        const glint_backend_config config = {.kind = methods[i].backend,
                                             .gate = GLINT_GATE_COSINE,
                                             .pipeline = GLINT_PIPELINE_PIPELINED};
        status = glint_renderer_create(WIDTH, HEIGHT, 1, &config, &t->renderer[i], err);
    }
    return status;
}

static void close_timing(timing *t)
{
    for (int i = 0; i < METHODS; i++)
        glint_renderer_destroy(t->renderer[i]);
    glint_image_destroy(t->image);
}

static double processor_seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return (double)now.tv_sec + (double)now.tv_nsec * 1e-9;
}

static glint_status time_frame(timing *t, int exponent, int i, glint_error *err)
{
    t->scene.n = exponents[exponent];
    t->scene.by_model = methods[i].by_model;
    t->scene.specular = methods[i].model;
    double *least = &t->seconds[exponent][i];
    const double begin = processor_seconds();
    const glint_status status =
        glint_render(t->renderer[i], &t->scene, t->image, t->report->stop, NULL, err);
    *least = fmin(*least, processor_seconds() - begin);
    return status;
}

static glint_status time_frames(timing *t, glint_error *err)
{
    glint_status status = GLINT_OK;
    for (int i = 0; i < EXPONENTS; i++)
        for (int method = 0; method < METHODS; method++)
            t->seconds[i][method] = INFINITY;
    for (int frame = 0; frame < t->frames; frame++)
        for (int i = 0; i < t->count; i++)
            for (int method = 0; method < METHODS && status == GLINT_OK; method++)
                status = time_frame(t, i, method, err);
    return status;
}

/* ---- Numbers and the figure ------------------------------------------------------------------ */

/* Gain in frames per second over cosⁿ. */
static double gain_of(const timing *t, int exponent, int method)
{
    return t->seconds[exponent][COS_N] / t->seconds[exponent][method] - 1.0;
}

static void put(glint_numbers *numbers, const timing *t, const char *figure)
{
    for (int method = 0; method < METHODS; method++) {
        const char *name = methods[method].name;
        double milliseconds[2] = {NAN, NAN}, gain[2] = {NAN, NAN};
        for (int i = 0; i < t->count; i++) {
            glint_number_widen(milliseconds, 1e3 * t->seconds[i][method]);
            glint_number_widen(gain, gain_of(t, i, method));
            glint_number_put(numbers, 1e3 * t->seconds[i][method], "frames.time.%s.%s.%d", figure,
                             name, exponents[i]);
        }
        glint_number_put_range(numbers, milliseconds[0], milliseconds[1], "frames.time.%s.%s.ms",
                               figure, name);
        glint_number_put_range(numbers, gain[0], gain[1], "frames.time.%s.%s.gain", figure, name);
    }
}

/* The exponents of the list in ascending order. */
static glint_status draw(glint_report *report, const timing *t, const char *figure,
                         glint_error *err)
{
    char name[64], title[64];
    glint_chart chart = {.name = name,
                         .title = title,
                         .x_label = "n",
                         .y_label = "ms",
                         .settings = "set logscale x\nset yrange [0:*]\n" GLINT_CHART_KEY_BELOW,
                         .style = "linespoints",
                         .curves = METHODS};
    double values[EXPONENTS * (1 + METHODS)], *value = values;
    snprintf(name, sizeof name, "figure-3.13-%s", figure);
    snprintf(title, sizeof title, "Time of a frame against n, %s", figure);
    for (int n = 1; n <= 1000; n++)
        for (int i = 0; i < t->count; i++) {
            if (exponents[i] != n)
                continue;
            *value++ = n;
            for (int method = 0; method < METHODS; method++)
                *value++ = 1e3 * t->seconds[i][method];
        }
    for (int method = 0; method < METHODS; method++)
        chart.curve[method] = methods[method].title;
    return glint_chart_draw(report, &chart, values, t->count, err);
}

static glint_status measure(glint_report *report, glint_test_figure figure, timing *t,
                            glint_error *err)
{
    const char *name = glint_test_figure_names[figure];
    glint_mesh *mesh;
    glint_status status = glint_frame_mesh(figure, &mesh, err);
    if (status != GLINT_OK)
        return status;
    *t = (timing){.report = report,
                  .count = report->quick ? EXPONENTS_QUICK : EXPONENTS,
                  .frames = report->quick ? FRAMES_QUICK : FRAMES};
    glint_frame_scene(GLINT_LIGHT_39_WHITE, &t->scene);
    t->scene.mesh = mesh;
    status = open_timing(t, err);
    if (status == GLINT_OK)
        status = time_frames(t, err);
    close_timing(t);
    glint_mesh_destroy(mesh);
    if (status != GLINT_OK)
        return status;
    put(&report->numbers, t, name);
    return draw(report, t, name, err);
}

glint_status glint_frame_times_measure(glint_report *report, glint_error *err)
{
    glint_numbers *numbers = &report->numbers;
    double best[2] = {NAN, NAN};
    glint_status status = GLINT_OK;
    for (int figure = 0; figure < GLINT_FIGURE_COUNT && status == GLINT_OK; figure++) {
        timing t;
        status = measure(report, (glint_test_figure)figure, &t, err);
        for (int i = 0; status == GLINT_OK && i < t.count; i++)
            glint_number_widen(best, gain_of(&t, i, COSINE_QUADRATIC));
    }
    glint_number_put(numbers, best[1], "frames.time.gain");
    glint_number_put(numbers, 1.0 - 1.0 / (1.0 + best[1]), "frames.time.less");
    glint_number_put(numbers, report->quick ? FRAMES_QUICK : FRAMES, "frames.time.frames");
    glint_number_put_text(numbers, glint_formula_compiler(), "frames.time.compiler");
    return status;
}
