/* Section 3.4: what the formulas' errors come to in pictures, and how long the pictures take. */
#include "report/sections.h"

#include <stdlib.h>

#include "report/frame_times.h"
#include "report/place.h"

#define SAY(text, ...) snprintf(text, sizeof text, __VA_ARGS__)

typedef struct frames {
    glint_frame_errors errors;
    glint_frame_times times;
} frames;

/* ---- Figure 3.12 -------------------------------------------------------------------------- */

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

static void write_figures_head(FILE *out)
{
    char text[256];
    glint_scene scene = {0};
    glint_frame_scene(GLINT_LIGHT_WHITE, &scene);
    glint_frame_scene_say(&scene, text, sizeof text);
    fprintf(
        out,
        "\n### The test figures (figure 3.12)\n\nThe highlights by the Verilog, n = %d; %s.\n\n",
        scene.n, text);
}

static glint_status render_figures(glint_report *report, glint_error *err)
{
    const glint_backend_config config = {
        .kind = GLINT_BACKEND_RTL, .gate = GLINT_GATE_COSINE, .pipeline = GLINT_PIPELINE_PIPELINED};
    const int width = report->quick ? 160 : 640, height = report->quick ? 120 : 480;
    glint_renderer *renderer = NULL;
    glint_image *image = NULL;
    write_figures_head(report->markdown);
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
        status = glint_frame_times_write(report, &f->times, err);
    return status;
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
