/* Section 3.4: what the formulas' errors come to in pictures, and how long the pictures take. */
#include "report/sections.h"

#include <limits.h>
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

/* ---- Table 3.2 ------------------------------------------------------------------------------- */

static void write_errors(FILE *out, const glint_frame_errors *errors)
{
    fprintf(
        out,
        "### Pictures against pictures by cos^n (Table 3.2)\n\n"
        "The largest NMSE (3.1) over %d exponents from 1 to 1000, and the n that has it. "
        "%dx%d, the object fills the\nframe, its colour 238,138,32, Ka = 0.2, Kd = Ks = 0.5, "
        "highlight white or of the object's colour, over\nthe object's pixels. The thesis "
        "reads up to 0.0001 as no visible difference, to 0.00025 as slight, to 0.001\nas "
        "visible, above as substantial. *c* and *rtl* are the device, by C and by Verilog.\n\n"
        "| method | against | sphere, white | n | sphere, object's colour | n | teapot, white | "
        "n | teapot, object's colour | n |\n|---|---|--:|--:|--:|--:|--:|--:|--:|--:|\n",
        errors->count, errors->width, errors->height);
    for (int method = 0; method < GLINT_FRAME_COUNT; method++) {
        fprintf(out, "| %s | %s |", glint_frame_names[method][0], glint_frame_names[method][1]);
        for (int figure = 0; figure < GLINT_FIGURE_COUNT; figure++)
            for (int color = 0; color < GLINT_HIGHLIGHT_COUNT; color++) {
                const glint_worst_frame worst = glint_worst_frame_of(
                    errors, (glint_test_figure)figure, (glint_highlight_color)color,
                    (glint_frame_method)method, 1, 1000);
                fprintf(out, " %.2g | %d |", worst.nmse, worst.n);
            }
        fputc('\n', out);
    }
}

static glint_status draw_errors(glint_report *report, frames *f, glint_error *err)
{
    static const glint_chart chart = {
        .name = "figure-nmse",
        .title = "NMSE of frames against cos^n, sphere, white highlight",
        .x_label = "n",
        .y_label = "NMSE",
        .settings = "set logscale xy\nset format y '%g'\nset key below\n",
        .curves = 7,
        .curve = {"Schlick (2.1)", "modified (2.2)", "Table 3.2's, best a", "quadratic",
                  "cosine-quadratic", "k = 4", "device"},
        .caption = "The frames' NMSE against n. Up to 0.0001 the thesis sees no difference."};
    const glint_frame_errors *errors = &f->errors;
    const int width = 1 + chart.curves;
    for (int i = 0; i < errors->count; i++) {
        f->values[i * width] = errors->n[i];
        for (int curve = 0; curve < chart.curves; curve++) {
            const double nmse = errors->nmse[GLINT_FIGURE_SPHERE][GLINT_HIGHLIGHT_WHITE][curve][i];
            f->values[i * width + 1 + curve] = nmse > 0.0 ? nmse : NAN; /* log scale */
        }
    }
    return glint_chart_draw(report, &chart, f->values, errors->count, err);
}

/* The largest over figures and colours. */
static glint_worst_frame worst_of(const glint_frame_errors *errors, glint_frame_method method,
                                  int n_from, int n_to, const char **figure, const char **color)
{
    glint_worst_frame worst = {.nmse = -1.0};
    for (int i = 0; i < GLINT_FIGURE_COUNT; i++)
        for (int j = 0; j < GLINT_HIGHLIGHT_COUNT; j++) {
            const glint_worst_frame found = glint_worst_frame_of(
                errors, (glint_test_figure)i, (glint_highlight_color)j, method, n_from, n_to);
            if (found.nmse > worst.nmse) {
                worst = found;
                *figure = glint_test_figure_names[i];
                *color = glint_highlight_color_names[j];
            }
        }
    return worst;
}

typedef struct frame_claim {
    const char *where, *claim;
    double at_most;
    glint_frame_method method;
    int n_from, n_to;
} frame_claim;

static const frame_claim claims[] = {
    {"Table 3.2", "Modified Schlick, (2.2) as printed: largest NMSE 0.00011", 0.00011,
     GLINT_FRAME_SCHLICK_MODIFIED, 1, INT_MAX},
    {"Table 3.2", "Modified Schlick, as Table 3.2 prints it, with the best a: largest NMSE 0.00011",
     0.00011, GLINT_FRAME_SCHLICK_POWER, 1, INT_MAX},
    {"Table 3.2", "Quadratic: largest NMSE 0.00026 for n < 170", 0.00026, GLINT_FRAME_QUADRATIC, 1,
     169},
    {"Table 3.2", "Quadratic: NMSE < 0.0002 for the other n", 0.0002, GLINT_FRAME_QUADRATIC, 170,
     INT_MAX},
    {"Table 3.2", "Cosine-quadratic: largest NMSE 0.00008", 0.00008, GLINT_FRAME_COSINE_QUADRATIC,
     1, INT_MAX},
    {"3.1, 3.4", "Cosine-quadratic: no visible difference, NMSE below 0.0001", 0.0001,
     GLINT_FRAME_COSINE_QUADRATIC, 1, INT_MAX},
    {"3.1", "The device: no visible difference, NMSE below 0.0001", 0.0001, GLINT_FRAME_VERILOG, 1,
     INT_MAX},
};

static void find_errors(glint_findings *findings, const glint_frame_errors *errors)
{
    for (size_t i = 0; i < sizeof claims / sizeof claims[0]; i++) {
        const frame_claim *claim = &claims[i];
        const char *figure = "", *color = "";
        const glint_worst_frame worst =
            worst_of(errors, claim->method, claim->n_from, claim->n_to, &figure, &color);
        glint_finding *finding = glint_findings_add(
            findings, worst.nmse <= claim->at_most ? GLINT_HOLDS : GLINT_DOES_NOT_HOLD,
            claim->where);
        SAY(finding->claim, "%s", claim->claim);
        SAY(finding->measured, "%.2g at n = %d, %s, highlight %s", worst.nmse, worst.n, figure,
            color);
        SAY(finding->conditions,
            "sphere and teapot, %dx%d, filling the frame, Ka = 0.2, Kd = Ks = 0.5, highlight white "
            "or of the object's colour 238,138,32; %d exponents; against cos^n",
            errors->width, errors->height, errors->count);
    }
}

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
    glint_frame_scene(GLINT_HIGHLIGHT_WHITE, &scene);
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
        .settings = "set logscale x\nset yrange [0:*]\nset key below\n",
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
            "exponents",
            threads, times->width, times->height, times->frames, times->count);
    }
}

/* ---- The section ----------------------------------------------------------------------------- */

static bool add_numbers(cJSON *numbers, const glint_frame_errors *errors)
{
    bool whole = true;
    cJSON *list = cJSON_AddArrayToObject(numbers, "nmse");
    for (int figure = 0; figure < GLINT_FIGURE_COUNT; figure++)
        for (int color = 0; color < GLINT_HIGHLIGHT_COUNT; color++)
            for (int method = 0; method < GLINT_FRAME_COUNT; method++) {
                const glint_worst_frame worst = glint_worst_frame_of(
                    errors, (glint_test_figure)figure, (glint_highlight_color)color,
                    (glint_frame_method)method, 1, 1000);
                cJSON *entry = cJSON_CreateObject();
                whole = whole && cJSON_AddItemToArray(list, entry) &&
                        cJSON_AddStringToObject(entry, "figure", glint_test_figure_names[figure]) &&
                        cJSON_AddStringToObject(entry, "highlight",
                                                glint_highlight_color_names[color]) &&
                        cJSON_AddStringToObject(entry, "method", glint_frame_names[method][0]) &&
                        cJSON_AddStringToObject(entry, "reference", glint_frame_names[method][1]) &&
                        cJSON_AddNumberToObject(entry, "largest", worst.nmse) &&
                        cJSON_AddNumberToObject(entry, "n", worst.n);
            }
    return whole;
}

static glint_status write_section(glint_report *report, frames *f, glint_error *err)
{
    glint_status status = glint_frame_errors_measure(report, &f->errors, err);
    if (status == GLINT_OK)
        status = glint_frame_times_measure(report, &f->times, err);
    if (status != GLINT_OK)
        return status;
    write_errors(report->markdown, &f->errors);
    find_errors(report->findings, &f->errors);
    status = draw_errors(report, f, err);
    if (status == GLINT_OK)
        status = render_figures(report, err);
    if (status == GLINT_OK)
        status = draw_times(report, f, err);
    if (status != GLINT_OK)
        return status;
    find_times(report->findings, &f->times, report->threads);
    return add_numbers(report->numbers, &f->errors)
               ? GLINT_OK
               : glint_fail(err, GLINT_NO_MEMORY, "no memory for the frames' numbers");
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
