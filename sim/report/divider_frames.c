/* Gouraud frames by numbers of shifts; see divider_frames.h. */
#include "report/divider_frames.h"

#include <stdlib.h>

#include "render/pick.h"

/* The thesis's average triangle has 100 pixels; these count as average here. */
#define AVERAGE_LEAST 90
#define AVERAGE_MOST  110

/* For triangles of about this size; the report states their actual size. */
#define TEAPOT_AVERAGE 6
#define SPHERE_AVERAGE 72

const int glint_divider_frame_shifts[GLINT_DIVIDER_FRAMES] = {6, 7, 8, GLINT_DIVIDER_SHIFTS_DEFAULT,
                                                              GLINT_DIVIDER_SHIFTS_MAX};

typedef glint_status mesh_maker(int density, glint_mesh **mesh, glint_error *err);

static const struct {
    const char *model;
    mesh_maker *make;
    int density;
} subjects[GLINT_DIVIDER_SCENES] = {
    {"teapot", glint_mesh_teapot, GLINT_TEAPOT_DENSITY},
    {"teapot", glint_mesh_teapot, TEAPOT_AVERAGE},
    {"sphere", glint_mesh_sphere, GLINT_SPHERE_DENSITY},
    {"sphere", glint_mesh_sphere, SPHERE_AVERAGE},
};

/* What all frames of one scene share. */
typedef struct studio {
    const glint_report *report;
    glint_renderer *renderer, *verilog;
    glint_scene scene;
    glint_image *exact, *frame, *by_verilog;
} studio;

static glint_status write_pictures(const studio *s, glint_error *err)
{
    glint_image *picture = NULL;
    glint_status status = glint_image_difference_picture(s->exact, s->frame, &picture, err);
    if (status == GLINT_OK)
        status = glint_report_write_png(s->report, picture, "divider-difference.png", err);
    if (status == GLINT_OK)
        status = glint_report_write_png(s->report, s->exact, "divider-exact.png", err);
    if (status == GLINT_OK)
        status = glint_report_write_png(s->report, s->frame, "divider-frame.png", err);
    glint_image_destroy(picture);
    return status;
}

static glint_status render(studio *s, int shifts, glint_image *image, glint_render_stats *stats,
                           glint_error *err)
{
    s->scene.shifts = shifts;
    return glint_render(s->renderer, &s->scene, image, s->report->stop, stats, err);
}

/* A row of a triangle begins at each pixel with another one on its left. */
static void measure_row(const uint32_t *row, const uint32_t *pixels, uint8_t *longer,
                        glint_divider_rows *rows)
{
    int begin = 0;
    for (int x = 1; x <= GLINT_DIVIDER_FRAME_WIDTH; x++) {
        if (x < GLINT_DIVIDER_FRAME_WIDTH && row[x] == row[begin])
            continue;
        const uint32_t triangle = row[begin];
        const int steps = x - begin - 1;
        begin = x;
        if (triangle == GLINT_NO_TRIANGLE || pixels[triangle] < AVERAGE_LEAST ||
            pixels[triangle] > AVERAGE_MOST)
            continue;
        rows->longest = steps > rows->longest ? steps : rows->longest;
        rows->with_longer += steps > GLINT_DIVIDER_K_MAX && longer[triangle] == 0;
        longer[triangle] |= steps > GLINT_DIVIDER_K_MAX;
    }
}

/* For the visible triangles of the last rendered frame. */
static glint_status measure_rows(const studio *s, uint64_t triangles, glint_divider_rows *rows,
                                 glint_error *err)
{
    enum { WIDTH = GLINT_DIVIDER_FRAME_WIDTH, HEIGHT = GLINT_DIVIDER_FRAME_HEIGHT };
    uint32_t *seen = malloc((size_t)WIDTH * HEIGHT * sizeof *seen);
    uint32_t *pixels = calloc(triangles, sizeof *pixels);
    uint8_t *longer = calloc(triangles, sizeof *longer);
    const bool room = seen != NULL && pixels != NULL && longer != NULL;
    if (room)
        glint_renderer_triangles(s->renderer, seen);
    for (int i = 0; room && i < WIDTH * HEIGHT; i++)
        if (seen[i] != GLINT_NO_TRIANGLE)
            pixels[seen[i]]++;
    for (uint64_t i = 0; room && i < triangles; i++)
        rows->triangles += pixels[i] >= AVERAGE_LEAST && pixels[i] <= AVERAGE_MOST;
    for (int y = 0; room && y < HEIGHT; y++)
        measure_row(seen + (ptrdiff_t)y * WIDTH, pixels, longer, rows);
    free(seen);
    free(pixels);
    free(longer);
    return room ? GLINT_OK : glint_fail(err, GLINT_NO_MEMORY, "no memory for the triangles' rows");
}

static glint_status make_exact(studio *s, glint_divider_scene *scene, glint_error *err)
{
    glint_render_stats stats;
    const glint_status status = render(s, GLINT_SHIFTS_EXACT, s->exact, &stats, err);
    scene->drawn = stats.drawn;
    return status == GLINT_OK ? measure_rows(s, stats.triangles, &scene->rows, err) : status;
}

/* Whether the circuit draws what its C model draws. */
static glint_status compare_verilog(studio *s, glint_divider_frame *frame, glint_error *err)
{
    glint_image_difference difference;
    glint_status status =
        glint_render(s->verilog, &s->scene, s->by_verilog, s->report->stop, NULL, err);
    if (status == GLINT_OK)
        status = glint_image_compare(s->frame, s->by_verilog, &difference, err);
    if (status == GLINT_OK)
        frame->verilog_pixels = difference.differing_pixels + difference.mask_pixels;
    return status;
}

static glint_status make_frame(studio *s, glint_divider_scene *scene, glint_divider_frame *frame,
                               glint_error *err)
{
    glint_render_stats stats;
    glint_status status = render(s, frame->shifts, s->frame, &stats, err);
    scene->divisions = stats.divisions;
    if (status == GLINT_OK)
        status = glint_image_compare(s->exact, s->frame, &frame->difference, err);
    return status == GLINT_OK ? compare_verilog(s, frame, err) : status;
}

static glint_status make_scene(studio *s, glint_divider_scene *scene, bool shown, glint_error *err)
{
    glint_status status = make_exact(s, scene, err);
    for (int i = 0; status == GLINT_OK && i < GLINT_DIVIDER_FRAMES; i++) {
        scene->frames[i].shifts = glint_divider_frame_shifts[i];
        status = make_frame(s, scene, &scene->frames[i], err);
        if (status == GLINT_OK && shown && i == 0)
            status = write_pictures(s, err);
    }
    return status;
}

static glint_status open_studio(studio *s, glint_error *err)
{
    const glint_backend_config model = {.kind = GLINT_BACKEND_C,
                                        .pipeline = GLINT_PIPELINE_PIPELINED};
    const glint_backend_config verilog = {.kind = GLINT_BACKEND_RTL,
                                          .pipeline = GLINT_PIPELINE_PIPELINED};
    const int threads = s->report->threads;
    const int width = GLINT_DIVIDER_FRAME_WIDTH, height = GLINT_DIVIDER_FRAME_HEIGHT;
    glint_scene_defaults(&s->scene);
    s->scene.shading = GLINT_SHADING_GOURAUD;
    glint_status status = glint_renderer_create(width, height, threads, &model, &s->renderer, err);
    if (status == GLINT_OK)
        status = glint_renderer_create(width, height, threads, &verilog, &s->verilog, err);
    if (status == GLINT_OK)
        status = glint_image_create(width, height, &s->exact, err);
    if (status == GLINT_OK)
        status = glint_image_create(width, height, &s->by_verilog, err);
    return status == GLINT_OK ? glint_image_create(width, height, &s->frame, err) : status;
}

glint_status glint_divider_render_scenes(const glint_report *report,
                                         glint_divider_scene scenes[GLINT_DIVIDER_SCENES],
                                         glint_error *err)
{
    studio s = {.report = report};
    glint_status status = open_studio(&s, err);
    for (int i = 0; status == GLINT_OK && i < GLINT_DIVIDER_SCENES; i++) {
        glint_mesh *mesh = NULL;
        scenes[i] =
            (glint_divider_scene){.model = subjects[i].model, .density = subjects[i].density};
        status = subjects[i].make(subjects[i].density, &mesh, err);
        s.scene.mesh = mesh;
        if (status == GLINT_OK)
            status = make_scene(&s, &scenes[i], i == 0, err);
        glint_mesh_destroy(mesh);
    }
    glint_image_destroy(s.exact);
    glint_image_destroy(s.frame);
    glint_image_destroy(s.by_verilog);
    glint_renderer_destroy(s.renderer);
    glint_renderer_destroy(s.verilog);
    return status;
}
