/* Figures 2.17 to 2.19 again, and crops of traced frames. Figure 2.19 is a run of the code: a row
 * of nine pixels with an edge in it, and which of them each level traced. */
#include <math.h>
#include <string.h>

#include "report/frame_errors.h"
#include "report/trace_runs.h"

/* ---- Figure 2.17 ----------------------------------------------------------------------------- */

static glint_status trace_2_17(glint_report *report, const glint_scene *scene, glint_error *err)
{
    const glint_tracer_config config = {.width = report->quick ? 160 : 480,
                                        .height = report->quick ? 120 : 360,
                                        .threads = report->threads,
                                        .backend = {.kind = GLINT_BACKEND_REAL},
                                        .scene = *scene,
                                        .shadows = true,
                                        .reflect = 0.2,
                                        .stop = report->stop};
    static const glint_join every_pixel = {.centre = -1};
    glint_tracer *tracer = NULL;
    glint_image *image = NULL;
    glint_status status = glint_tracer_create(&config, &tracer, err);
    if (status == GLINT_OK)
        status = glint_image_create(config.width, config.height, &image, err);
    if (status == GLINT_OK)
        status = glint_trace(tracer, &every_pixel, image, NULL, err);
    if (status == GLINT_OK)
        status = glint_report_write_png(report, image, "figure-2.17.png", err);
    glint_tracer_destroy(tracer);
    glint_image_destroy(image);
    return status;
}

static glint_status draw_2_17(glint_report *report, glint_error *err)
{
    glint_scene scene;
    glint_mesh *mesh;
    glint_status status = glint_frame_mesh(GLINT_FIGURE_TEAPOT, &mesh, err);
    if (status != GLINT_OK)
        return status;
    glint_scene_defaults(&scene);
    scene.mesh = mesh;
    scene.n = 50;
    scene.by_model = true;
    scene.specular = GLINT_REFLECTANCE_ENERGY_CONSERVING;
    glint_number_put(&report->numbers, scene.n, "trace.2-17.n");
    status = trace_2_17(report, &scene, err);
    glint_mesh_destroy(mesh);
    return status;
}

/* ---- Drawings -------------------------------------------------------------------------------- */

#define CELL 40

static glint_status begin_drawing(const glint_report *report, const char *name, int width,
                                  int height, glint_new_file **file, glint_error *err)
{
    const glint_status status = glint_report_open(report, name, file, err);
    if (status == GLINT_OK)
        fprintf(glint_new_file_stream(*file),
                "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%d\" height=\"%d\" "
                "viewBox=\"0 0 %d %d\" font-family=\"sans-serif\" font-size=\"14\">\n"
                "<rect width=\"100%%\" height=\"100%%\" fill=\"#ffffff\"/>\n",
                width, height, width, height);
    return status;
}

static glint_status end_drawing(glint_new_file *file, glint_error *err)
{
    fprintf(glint_new_file_stream(file), "</svg>\n");
    return glint_new_file_commit(file, err);
}

/* A grid of points of the kernel, the place to interpolate between the middle ones. */
static void draw_points(FILE *out, int left, int columns, int rows)
{
    const int top = CELL;
    for (int y = 0; y < rows; y++)
        fprintf(out, "<path d=\"M%d %dh%d\" stroke=\"#a0a0a0\"/>\n", left, top + y * CELL,
                (columns - 1) * CELL);
    for (int x = 0; x < columns && rows > 1; x++)
        fprintf(out, "<path d=\"M%d %dv%d\" stroke=\"#a0a0a0\"/>\n", left + x * CELL, top,
                (rows - 1) * CELL);
    for (int y = 0; y < rows; y++)
        for (int x = 0; x < columns; x++)
            fprintf(out, "<circle cx=\"%d\" cy=\"%d\" r=\"7\" fill=\"#1f5fa8\"/>\n",
                    left + x * CELL, top + y * CELL);
    fprintf(out,
            "<circle cx=\"%d\" cy=\"%d\" r=\"6\" fill=\"#ffffff\" stroke=\"#c03020\" "
            "stroke-width=\"3\"/>\n",
            left + CELL + CELL * 5 / 8, top + (rows > 1 ? CELL + CELL * 3 / 8 : 0));
}

static glint_status draw_2_18(const glint_report *report, glint_error *err)
{
    glint_new_file *file;
    const glint_status status =
        begin_drawing(report, "figure-2.18.svg", 10 * CELL, 5 * CELL, &file, err);
    if (status != GLINT_OK)
        return status;
    draw_points(glint_new_file_stream(file), CELL, 4, 1);
    draw_points(glint_new_file_stream(file), 6 * CELL, 4, 4);
    return end_drawing(file, err);
}

/* ---- Figure 2.19 ----------------------------------------------------------------------------- */

#define PIXELS 9
#define EDGE   6 /* the first bright pixel */
#define DARK   40
#define BRIGHT 200

/* Which call traced each pixel, from 1; 0: none. */
typedef struct steps {
    int call[PIXELS];
    int calls;
} steps;

static glint_status step(void *context, const uint32_t *pixel, size_t count, glint_image *image,
                         glint_error *err)
{
    steps *s = context;
    (void)err;
    s->calls++;
    for (size_t i = 0; i < count; i++) {
        s->call[pixel[i]] = s->calls;
        memset(&image->rgb[3 * pixel[i]], pixel[i] < EDGE ? DARK : BRIGHT, 3);
    }
    return GLINT_OK;
}

static void draw_pixel(FILE *out, int x, int y, const char *color, const char *word)
{
    fprintf(out,
            "<rect x=\"%d\" y=\"%d\" width=\"%d\" height=\"%d\" fill=\"%s\" stroke=\"#404040\"/>\n"
            "<text x=\"%d\" y=\"%d\" text-anchor=\"middle\">%s</text>\n",
            x, y, CELL, CELL, color, x + CELL / 2, y + CELL / 2 + 5, word);
}

/* The last row has what was interpolated. */
static void draw_step(FILE *out, const steps *s, int number)
{
    const int y = CELL / 2 + (number - 1) * (CELL + CELL / 2);
    fprintf(out, "<text x=\"10\" y=\"%d\">%s %d</text>\n", y + CELL / 2 + 5, "step", number);
    for (int x = 0; x < PIXELS; x++) {
        const bool known = s->call[x] > 0 && s->call[x] <= number;
        const bool last = number > s->calls;
        draw_pixel(out, 2 * CELL + x * CELL, y,
                   known && s->call[x] == number ? "#f0a030"
                   : known                       ? "#c8c8c8"
                   : last                        ? "#a8d0f0"
                                                 : "#ffffff",
                   known  ? "T"
                   : last ? "I"
                          : "");
    }
}

static glint_status draw_2_19(glint_report *report, glint_error *err)
{
    const glint_join how = {
        .segment = PIXELS - 2, .centre = -1, .fill = GLINT_FILL_MEAN, .limit = GLINT_LIMIT_DEFAULT};
    steps s = {0};
    glint_new_file *file;
    glint_image *row;
    glint_join_stats stats;
    glint_status status = glint_image_create(PIXELS, 1, &row, err);
    if (status != GLINT_OK)
        return status;
    status = glint_join_image(&how, step, &s, row, &stats, err);
    glint_image_destroy(row);
    if (status == GLINT_OK)
        status = begin_drawing(report, "figure-2.19.svg", (PIXELS + 3) * CELL,
                               CELL / 2 + (s.calls + 1) * (CELL + CELL / 2), &file, err);
    if (status != GLINT_OK)
        return status;
    for (int number = 1; number <= s.calls + 1; number++)
        draw_step(glint_new_file_stream(file), &s, number);
    glint_number_put(&report->numbers, (double)stats.traced, "trace.2-19.traced");
    glint_number_put(&report->numbers, PIXELS, "trace.2-19.pixels");
    return end_drawing(file, err);
}

glint_status glint_trace_figures(glint_report *report, glint_error *err)
{
    glint_status status = draw_2_17(report, err);
    if (status == GLINT_OK)
        status = draw_2_18(report, err);
    return status == GLINT_OK ? draw_2_19(report, err) : status;
}

/* ---- Crops ----------------------------------------------------------------------------------- */

#define SIDE   96
#define FACTOR 3

static glint_status write_crop(const glint_report *report, const glint_image *image, int x, int y,
                               const char *name, glint_error *err)
{
    glint_image *crop;
    glint_status status = glint_image_crop(image, x, y, SIDE, FACTOR, &crop, err);
    if (status != GLINT_OK)
        return status;
    status = glint_report_write_png(report, crop, name, err);
    glint_image_destroy(crop);
    return status;
}

typedef struct crop {
    glint_join how;
    const char *name;
} crop;

glint_status glint_trace_pictures(glint_report *report, glint_trace_object object,
                                  glint_trace_subject *subject, glint_error *err)
{
    static const crop grid[] = {
        {{7, -1, GLINT_FILL_LINEAR, GLINT_MEASURE_DELTA_E, GLINT_LIMIT_DEFAULT}, "segments"},
        {{7, -1, GLINT_FILL_LINEAR, GLINT_MEASURE_DELTA_E, 0.0}, "limit-0"},
    };
    static const crop teapot[] = {
        {{7, -1, GLINT_FILL_NEAREST, GLINT_MEASURE_DELTA_E, (double)INFINITY}, "nearest"},
        {{7, -1, GLINT_FILL_BILINEAR, GLINT_MEASURE_DELTA_E, (double)INFINITY}, "bilinear"},
        {{7, -1, GLINT_FILL_BICUBIC, GLINT_MEASURE_DELTA_E, (double)INFINITY}, "bicubic"},
    };
    const bool is_grid = object == GLINT_TRACE_GRID;
    const crop *crops = is_grid ? grid : teapot;
    const int count = is_grid ? 2 : 3;
    const int x = subject->full->width * (is_grid ? 50 : 30) / 100; /* the teapot's highlight */
    const int y = subject->full->height * (is_grid ? 50 : 37) / 100;
    const char *of = glint_trace_object_names[object];
    char name[64];
    if (object == GLINT_TRACE_SPHERE)
        return GLINT_OK;
    snprintf(name, sizeof name, "trace-%s-full.png", of);
    glint_status status = write_crop(report, subject->full, x, y, name, err);
    for (int i = 0; i < count && status == GLINT_OK; i++) {
        glint_trace_run run;
        status = glint_trace_subject_run(subject, &crops[i].how, false, &run, err);
        snprintf(name, sizeof name, "trace-%s-%s.png", of, crops[i].name);
        if (status == GLINT_OK)
            status = write_crop(report, subject->image, x, y, name, err);
    }
    return status;
}
