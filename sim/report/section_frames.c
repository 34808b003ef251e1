/* Section 3.4: what the formulas' errors come to in pictures, and how long the pictures take. */
#include "report/sections.h"

#include <math.h>
#include <stdlib.h>

#include "report/chart.h"
#include "report/frame_errors.h"
#include "report/place.h"

#define SAY(text, ...) snprintf(text, sizeof text, __VA_ARGS__)

typedef struct frames {
    glint_frame_errors errors;
    glint_frame_times times;
    double values[GLINT_FRAME_EXPONENTS_MAX * (1 + GLINT_CHART_CURVES_MAX)];
} frames;

/* ---- Figures 3.12 and 3.13 ------------------------------------------------------------------- */

static glint_status render_figure(glint_report *report, glint_test_figure figure,
                                  glint_renderer *renderer, glint_image *image, glint_error *err)
{
    glint_scene scene;
    glint_mesh *mesh;
    glint_place place;
    char name[64];
    glint_status status = glint_frame_mesh(figure, &mesh, err);
    if (status != GLINT_OK)
        return status;
    glint_frame_scene(GLINT_LIGHT_WHITE, &scene);
    scene.mesh = mesh;
    SAY(name, "figure-3.12-%s.png", glint_test_figure_names[figure]);
    status = glint_place_in(report->directory, name, &place, err);
    if (status == GLINT_OK)
        status = glint_render(renderer, &scene, image, report->stop, NULL, err);
    if (status == GLINT_OK)
        status = glint_image_write_png(image, place.path, err);
    glint_mesh_destroy(mesh);
    if (status == GLINT_OK)
        fprintf(report->markdown, "![%s by the Verilog](%s) ", glint_test_figure_names[figure],
                name);
    return status;
}

static glint_status render_figures(glint_report *report, glint_error *err)
{
    const glint_backend_config config = {
        .kind = GLINT_BACKEND_RTL, .gate = GLINT_GATE_COSINE, .pipeline = GLINT_PIPELINE_PIPELINED};
    const int width = report->quick ? 160 : 640, height = report->quick ? 120 : 480;
    glint_renderer *renderer = NULL;
    glint_image *image = NULL;
    fputs("\n### The test figures (figure 3.12)\n\nEvery highlight by the Verilog, n = 80.\n\n",
          report->markdown);
    glint_status status =
        glint_renderer_create(width, height, report->threads, &config, &renderer, err);
    if (status == GLINT_OK)
        status = glint_image_create(width, height, &image, err);
    for (int i = 0; i < GLINT_FIGURE_COUNT && status == GLINT_OK; i++)
        status = render_figure(report, (glint_test_figure)i, renderer, image, err);
    fputs("\n", report->markdown);
    glint_image_destroy(image);
    glint_renderer_destroy(renderer);
    return status;
}

static glint_status draw_times(glint_report *report, frames *f, glint_error *err)
{
    static const glint_chart chart = {
        .name = "figure-3.13",
        .title = "Time of a frame against n",
        .x_label = "n",
        .y_label = "ms",
        .settings = "set logscale x\nset yrange [0:*]\n" GLINT_CHART_KEY_BELOW,
        .curves = 4,
        .curve = {"sphere, cos^n", "sphere, cosine-quadratic", "teapot, cos^n",
                  "teapot, cosine-quadratic"},
        .caption = "Figure 3.13: the time of a frame, from mesh to picture, median."};
    const glint_frame_times *times = &f->times;
    for (int i = 0; i < times->count; i++) {
        double *row = &f->values[5 * i];
        row[0] = times->n[i];
        for (int j = 0; j < 4; j++)
            row[1 + j] = 1e3 * times->row[j / 2][i].seconds[j % 2];
    }
    fprintf(report->markdown,
            "\n### Time of a frame (figure 3.13)\n\n%dx%d, %d threads, %d frames of each by turns, "
            "backend *real*: cos^n by powf, (2.15) as vectorised by\nthe compiler. gcc %s -O3; "
            "machine-dependent, as all times are.\n",
            times->width, times->height, report->threads, times->frames, __VERSION__);
    return glint_chart_draw(report, &chart, f->values, times->count, err);
}

static void find_times(glint_findings *findings, const glint_frame_times *times, int threads)
{
    for (int figure = 0; figure < GLINT_FIGURE_COUNT; figure++) {
        double least = INFINITY, most = -INFINITY;
        for (int i = 0; i < times->count; i++) {
            const double gain = 100.0 * (1.0 - times->row[figure][i].ratio);
            least = fmin(least, gain);
            most = fmax(most, gain);
        }
        glint_finding *finding =
            glint_findings_add(findings, most >= 19.5 ? GLINT_HOLDS : GLINT_DOES_NOT_HOLD, "3.4");
        SAY(finding->claim, "Frame time up to 20 %% better than with cos^n (figure 3.13): %s",
            glint_test_figure_names[figure]);
        SAY(finding->measured, "%.0f to %.0f %% less time (below 0: more)", least, most);
        SAY(finding->conditions,
            "this machine and renderer, %d threads, %dx%d, median of %d pairs for each of %d "
            "exponents; it holds where 20 %% are reached at one of them",
            threads, times->width, times->height, times->frames, times->count);
    }
}

/* ---- The section ----------------------------------------------------------------------------- */

static glint_status write_section(glint_report *report, frames *f, glint_error *err)
{
    glint_status status = glint_frame_errors_measure(report, &f->errors, err);
    if (status == GLINT_OK)
        status = glint_frame_times_measure(report, &f->times, err);
    if (status != GLINT_OK)
        return status;
    status = glint_frame_errors_write(report, &f->errors, err);
    if (status == GLINT_OK)
        status = render_figures(report, err);
    if (status == GLINT_OK)
        status = draw_times(report, f, err);
    if (status != GLINT_OK)
        return status;
    find_times(report->findings, &f->times, report->threads);
    return GLINT_OK;
}

glint_status glint_section_frames(glint_report *report, glint_error *err)
{
    frames *f = calloc(1, sizeof *f);
    if (f == NULL)
        return glint_fail(err, GLINT_NO_MEMORY, "no memory for the frames");
    const glint_status status = write_section(report, f, err);
    free(f);
    return status;
}
