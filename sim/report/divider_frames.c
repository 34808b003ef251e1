/* Gouraud frames by numbers of shifts; see divider_frames.h. */
#include "report/divider_frames.h"

#include <stdio.h>

#include "report/place.h"

/* For triangles of about 100 pixels, the thesis's average; the report says how many they have. */
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
    const char *directory;
    const volatile bool *stop;
    glint_renderer *renderer, *verilog;
    glint_scene scene;
    glint_image *exact, *frame, *by_verilog;
} studio;

static glint_status write_picture(const studio *s, const glint_image *image, const char *name,
                                  glint_error *err)
{
    glint_place path;
    const glint_status status = glint_place_in(s->directory, name, &path, err);
    return status == GLINT_OK ? glint_image_write_png(image, path.path, err) : status;
}

static glint_status write_difference(const studio *s, const char *name, glint_error *err)
{
    glint_image *picture = NULL;
    glint_status status = glint_image_difference_picture(s->exact, s->frame, &picture, err);
    if (status == GLINT_OK)
        status = write_picture(s, picture, name, err);
    glint_image_destroy(picture);
    return status;
}

static glint_status render(studio *s, int shifts, glint_image *image, glint_render_stats *stats,
                           glint_error *err)
{
    s->scene.shifts = shifts;
    return glint_render(s->renderer, &s->scene, image, s->stop, stats, err);
}

static glint_status make_exact(studio *s, glint_divider_scene *scene, glint_error *err)
{
    glint_render_stats stats;
    snprintf(scene->exact_picture, sizeof scene->exact_picture, "%s-%d-exact.png", scene->model,
             scene->density);
    const glint_status status = render(s, GLINT_SHIFTS_EXACT, s->exact, &stats, err);
    scene->drawn = stats.drawn;
    return status == GLINT_OK ? write_picture(s, s->exact, scene->exact_picture, err) : status;
}

/* Whether the circuit draws what its C model draws. */
static glint_status compare_verilog(studio *s, glint_divider_frame *frame, glint_error *err)
{
    glint_image_difference difference;
    glint_status status = glint_render(s->verilog, &s->scene, s->by_verilog, s->stop, NULL, err);
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
    snprintf(frame->picture, sizeof frame->picture, "%s-%d-shifts-%d.png", scene->model,
             scene->density, frame->shifts);
    snprintf(frame->difference_picture, sizeof frame->difference_picture,
             "%s-%d-shifts-%d-difference.png", scene->model, scene->density, frame->shifts);
    glint_status status = render(s, frame->shifts, s->frame, &stats, err);
    scene->divisions = stats.divisions;
    if (status == GLINT_OK)
        status = glint_image_compare(s->exact, s->frame, &frame->difference, err);
    if (status == GLINT_OK)
        status = compare_verilog(s, frame, err);
    if (status == GLINT_OK)
        status = write_picture(s, s->frame, frame->picture, err);
    return status == GLINT_OK ? write_difference(s, frame->difference_picture, err) : status;
}

static glint_status make_scene(studio *s, glint_divider_scene *scene, glint_error *err)
{
    glint_status status = make_exact(s, scene, err);
    for (int i = 0; status == GLINT_OK && i < GLINT_DIVIDER_FRAMES; i++) {
        scene->frames[i].shifts = glint_divider_frame_shifts[i];
        status = make_frame(s, scene, &scene->frames[i], err);
    }
    return status;
}

static glint_status open_studio(studio *s, int threads, glint_error *err)
{
    const glint_backend_config model = {.kind = GLINT_BACKEND_C,
                                        .pipeline = GLINT_PIPELINE_PIPELINED};
    const glint_backend_config verilog = {.kind = GLINT_BACKEND_RTL,
                                          .pipeline = GLINT_PIPELINE_PIPELINED};
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

glint_status glint_divider_render_scenes(const char *directory, int threads,
                                         const volatile bool *stop,
                                         glint_divider_scene scenes[GLINT_DIVIDER_SCENES],
                                         glint_error *err)
{
    studio s = {.directory = directory, .stop = stop};
    glint_status status = open_studio(&s, threads, err);
    for (int i = 0; status == GLINT_OK && i < GLINT_DIVIDER_SCENES; i++) {
        glint_mesh *mesh = NULL;
        scenes[i].model = subjects[i].model;
        scenes[i].density = subjects[i].density;
        status = subjects[i].make(subjects[i].density, &mesh, err);
        s.scene.mesh = mesh;
        if (status == GLINT_OK)
            status = make_scene(&s, &scenes[i], err);
        glint_mesh_destroy(mesh);
    }
    glint_image_destroy(s.exact);
    glint_image_destroy(s.frame);
    glint_image_destroy(s.by_verilog);
    glint_renderer_destroy(s.renderer);
    glint_renderer_destroy(s.verilog);
    return status;
}
