/* Figures of the thesis that are pictures of shaded objects, and the curves of figure 2.9. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "render/mesh_build.h"
#include "report/chart.h"
#include "report/rasterizers.h"

#define WIDTH  320
#define HEIGHT 240

static glint_status paint(glint_report *report, glint_easel *easel, const glint_scene *scene,
                          const char *name, glint_error *err)
{
    glint_status status =
        glint_render(easel->renderer, scene, easel->image, report->stop, NULL, err);
    return status == GLINT_OK ? glint_report_write_png(report, easel->image, name, err) : status;
}

/* 2.1: a highlight by Schlick's formula, beside cosⁿ. 2.8: objects by the quadratic. */
static glint_status paint_models(glint_report *report, glint_easel *easel, glint_error *err)
{
    static const struct {
        const char *file;
        bool teapot;
        glint_reflectance_model model;
    } pictures[] = {{"figure-2.1-schlick.png", false, GLINT_REFLECTANCE_SCHLICK},
                    {"figure-2.1-blinn.png", false, GLINT_REFLECTANCE_BLINN},
                    {"figure-2.8-sphere.png", false, GLINT_REFLECTANCE_QUADRATIC},
                    {"figure-2.8-teapot.png", true, GLINT_REFLECTANCE_QUADRATIC}};
    glint_status status = GLINT_OK;
    for (size_t i = 0; i < sizeof pictures / sizeof pictures[0] && status == GLINT_OK; i++) {
        glint_scene scene;
        glint_mesh *mesh = NULL;
        status = pictures[i].teapot ? glint_mesh_teapot(GLINT_TEAPOT_DENSITY, &mesh, err)
                                    : glint_mesh_sphere(GLINT_SPHERE_DENSITY, &mesh, err);
        glint_scene_defaults(&scene);
        scene.mesh = mesh;
        scene.by_model = true;
        scene.specular = pictures[i].model;
        scene.n = 20;
        if (status == GLINT_OK)
            status = paint(report, easel, &scene, pictures[i].file, err);
        glint_mesh_destroy(mesh);
    }
    return status;
}

/* 2.11: intensities at three corners, interpolated along edges and rows. */
static glint_status paint_triangle(glint_report *report, glint_easel *easel, glint_error *err)
{
    static const double corners[3][2] = {{-1.0, -0.6}, {1.0, -0.3}, {0.1, 0.9}};
    static const double lean[3] = {-1.2, 0.1, 1.4};
    glint_scene scene;
    glint_mesh *mesh = NULL;
    glint_status status = glint_mesh_new("triangle", 3, 1, &mesh, err);
    if (status != GLINT_OK)
        return status;
    for (int i = 0; i < 3; i++) {
        const glint_vec3 n = {lean[i], 0.0, 1.0};
        glint_mesh_add_vertex(mesh, (glint_vec3){corners[i][0], corners[i][1], 0.0},
                              glint_vec3_scale(n, 1.0 / glint_vec3_length(n)));
    }
    glint_mesh_add_triangle(mesh, 0, 1, 2);
    glint_scene_defaults(&scene);
    scene.mesh = mesh;
    scene.yaw = scene.pitch = 0.0f;
    scene.shading = GLINT_SHADING_GOURAUD;
    scene.ks = 0.0f;
    status = paint(report, easel, &scene, "figure-2.11.png", err);
    glint_mesh_destroy(mesh);
    return status;
}

/* 2.14: perspective left out and taken in. */
static glint_status paint_perspective(glint_report *report, glint_easel *easel, glint_error *err)
{
    glint_scene scene;
    glint_mesh *mesh = NULL;
    glint_status status = glint_mesh_quad(&mesh, err);
    glint_scene_defaults(&scene);
    scene.mesh = mesh;
    scene.shading = GLINT_SHADING_GOURAUD;
    if (status == GLINT_OK)
        status = paint(report, easel, &scene, "figure-2.14-screen.png", err);
    scene.shading = GLINT_SHADING_GOURAUD_PERSPECTIVE;
    if (status == GLINT_OK)
        status = paint(report, easel, &scene, "figure-2.14-object.png", err);
    glint_mesh_destroy(mesh);
    return status;
}

/* The rasterizers side by side, on a mesh so coarse that they differ. */
static glint_status paint_rasterizers(glint_report *report, glint_easel *easel, glint_error *err)
{
    glint_scene scene;
    glint_mesh *mesh = NULL;
    glint_status status = glint_mesh_sphere(16, &mesh, err);
    glint_scene_defaults(&scene);
    scene.mesh = mesh;
    scene.n = 60;
    for (int i = 0; i < GLINT_RASTERIZERS && status == GLINT_OK; i++) {
        char name[64];
        snprintf(name, sizeof name, "rasterizer-%s.png", glint_rasterizers[i].name);
        status = glint_easel_paint(easel, &scene, i, err);
        if (status == GLINT_OK)
            status = glint_report_write_png(report, easel->image, name, err);
    }
    glint_mesh_destroy(mesh);
    return status;
}

/* 2.9: cosⁿα over the angle between V and R. */
static glint_status draw_angle(glint_report *report, glint_error *err)
{
    static const double n[] = {1, 5, 10, 50, 200};
    static const glint_chart chart = {.name = "figure-2.9",
                                      .title = "Phong's highlight by the angle between V and R",
                                      .x_label = "angle, degrees",
                                      .y_label = "brightness",
                                      .curves = 5,
                                      .curve = {"n = 1", "n = 5", "n = 10", "n = 50", "n = 200"}};
    double values[181 * 6], *value = values;
    for (int degrees = -90; degrees <= 90; degrees++) {
        *value++ = degrees;
        for (int i = 0; i < 5; i++)
            *value++ = pow(fmax(cos(degrees * 3.14159265358979323846 / 180.0), 0.0), n[i]);
    }
    return glint_chart_draw(report, &chart, values, 181, err);
}

glint_status glint_rasterizer_figures(glint_report *report, glint_error *err)
{
    glint_easel easel;
    glint_status status = glint_easel_create(report, WIDTH, HEIGHT, &easel, err);
    if (status == GLINT_OK)
        status = paint_models(report, &easel, err);
    if (status == GLINT_OK)
        status = paint_triangle(report, &easel, err);
    if (status == GLINT_OK)
        status = paint_perspective(report, &easel, err);
    if (status == GLINT_OK)
        status = paint_rasterizers(report, &easel, err);
    glint_easel_destroy(&easel);
    return status == GLINT_OK ? draw_angle(report, err) : status;
}
