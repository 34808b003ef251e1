/* Frames of spheres by three shadings; see quadratic_frames.h. */
#include "report/quadratic_frames.h"

#include <stdio.h>

#include "render/listing.h"
#include "render/render.h"

enum { SIDE = 480, EXPONENT = 20, SHOWN_EXPONENT = 10, SHOWN = 8, WITH_SLIPS = 16 };

static const int densities[] = {6, SHOWN, 12, WITH_SLIPS, 32, 64};

/* What all frames share. */
typedef struct studio {
    glint_report *report;
    glint_renderer *model, *verilog;
    glint_image *phong, *frame, *by_verilog;
    glint_scene scene;
    double verilog_pixels;
} studio;

static glint_status shoot(studio *s, glint_renderer *renderer, glint_shading shading,
                          glint_image *image, glint_error *err)
{
    s->scene.shading = shading;
    return glint_render(renderer, &s->scene, image, s->report->stop, NULL, err);
}

static glint_status compare(studio *s, glint_shading shading, const char *name, glint_error *err)
{
    glint_image_difference difference;
    glint_status status = shoot(s, s->model, shading, s->frame, err);
    if (status == GLINT_OK)
        status = glint_image_compare(s->phong, s->frame, &difference, err);
    if (status == GLINT_OK)
        glint_number_put(&s->report->numbers, difference.nmse, "divider.quadratic.%s", name);
    return status;
}

/* The frame that was shot last, again by the Verilog. */
static glint_status compare_verilog(studio *s, glint_error *err)
{
    glint_image_difference difference;
    glint_status status = shoot(s, s->verilog, s->scene.shading, s->by_verilog, err);
    if (status == GLINT_OK)
        status = glint_image_compare(s->frame, s->by_verilog, &difference, err);
    if (status == GLINT_OK)
        s->verilog_pixels += (double)(difference.differing_pixels + difference.mask_pixels);
    return status;
}

static glint_status show(studio *s, glint_error *err)
{
    static const struct {
        glint_shading shading;
        const char *file;
    } shown[] = {{GLINT_SHADING_GOURAUD, "quadratic-gouraud.png"},
                 {GLINT_SHADING_QUADRATIC, "quadratic.png"},
                 {GLINT_SHADING_PHONG, "quadratic-phong.png"}};
    glint_status status = GLINT_OK;
    s->scene.n = SHOWN_EXPONENT;
    for (size_t i = 0; status == GLINT_OK && i < sizeof shown / sizeof shown[0]; i++) {
        status = shoot(s, s->model, shown[i].shading, s->frame, err);
        if (status == GLINT_OK)
            status = glint_report_write_png(s->report, s->frame, shown[i].file, err);
    }
    s->scene.n = EXPONENT;
    return status;
}

/* Each slip alone against the corrected form, which is put in place of Phong's frame; and means
 * against Gouraud's. */
static glint_status measure_slips(studio *s, glint_error *err)
{
#define NAME(id, name, what) name,
    static const char *const names[] = {GLINT_LISTING_SLIPS(NAME)};
#undef NAME
    char name[64];
    glint_status status = shoot(s, s->model, GLINT_SHADING_QUADRATIC, s->phong, err);
    for (int slip = 0; status == GLINT_OK && slip < GLINT_SLIP_COUNT; slip++) {
        s->scene.slips = 1u << slip;
        (void)snprintf(name, sizeof name, "slip.%s", names[slip]);
        glint_number_add_word(&s->report->numbers, "divider.quadratic.slips", names[slip]);
        status = compare(s, GLINT_SHADING_QUADRATIC_LISTING, name, err);
    }
    s->scene.slips = 1u << GLINT_SLIP_MEANS;
    if (status == GLINT_OK)
        status = shoot(s, s->model, GLINT_SHADING_GOURAUD, s->phong, err);
    return status == GLINT_OK ? compare(s, GLINT_SHADING_QUADRATIC_LISTING, "means-gouraud", err)
                              : status;
}

static glint_status measure_sphere(studio *s, int density, glint_error *err)
{
    char name[64];
    (void)snprintf(name, sizeof name, "%d", density);
    glint_number_add_word(&s->report->numbers, "divider.quadratic.spheres", name);
    glint_number_put(&s->report->numbers, (double)s->scene.mesh->triangle_count,
                     "divider.quadratic.%d.triangles", density);
    glint_status status = shoot(s, s->model, GLINT_SHADING_PHONG, s->phong, err);
    (void)snprintf(name, sizeof name, "%d.gouraud", density);
    if (status == GLINT_OK)
        status = compare(s, GLINT_SHADING_GOURAUD, name, err);
    (void)snprintf(name, sizeof name, "%d.nmse", density);
    if (status == GLINT_OK)
        status = compare(s, GLINT_SHADING_QUADRATIC, name, err);
    if (status == GLINT_OK)
        status = compare_verilog(s, err);
    if (status == GLINT_OK && density == SHOWN)
        status = show(s, err);
    if (status == GLINT_OK && density == WITH_SLIPS)
        status = measure_slips(s, err);
    return status;
}

static glint_status open_studio(studio *s, glint_error *err)
{
    const glint_backend_config model = {.kind = GLINT_BACKEND_C,
                                        .pipeline = GLINT_PIPELINE_PIPELINED};
    const glint_backend_config verilog = {.kind = GLINT_BACKEND_RTL,
                                          .pipeline = GLINT_PIPELINE_PIPELINED};
    const int threads = s->report->threads;
    glint_scene_defaults(&s->scene);
    s->scene.n = EXPONENT;
    glint_status status = glint_renderer_create(SIDE, SIDE, threads, &model, &s->model, err);
    if (status == GLINT_OK)
        status = glint_renderer_create(SIDE, SIDE, threads, &verilog, &s->verilog, err);
    glint_image **const images[] = {&s->phong, &s->frame, &s->by_verilog};
    for (size_t i = 0; status == GLINT_OK && i < sizeof images / sizeof images[0]; i++)
        status = glint_image_create(SIDE, SIDE, images[i], err);
    return status;
}

glint_status glint_quadratic_measure_frames(glint_report *report, glint_error *err)
{
    studio s = {.report = report};
    glint_status status = open_studio(&s, err);
    for (size_t i = 0; status == GLINT_OK && i < sizeof densities / sizeof densities[0]; i++) {
        glint_mesh *mesh = NULL;
        status = glint_mesh_sphere(densities[i], &mesh, err);
        s.scene.mesh = mesh;
        if (status == GLINT_OK)
            status = measure_sphere(&s, densities[i], err);
        glint_mesh_destroy(mesh);
    }
    glint_number_put(&report->numbers, s.verilog_pixels, "divider.quadratic.verilog-differing");
    glint_image_destroy(s.phong);
    glint_image_destroy(s.frame);
    glint_image_destroy(s.by_verilog);
    glint_renderer_destroy(s.model);
    glint_renderer_destroy(s.verilog);
    return status;
}
