/* The rasterizers of the thesis's list, measured against Phong's shading: how far their pictures
 * are from it, what their shading costs, and what they do about Gouraud's drawbacks. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "render/reflection_map.h"
#include "report/chart.h"
#include "report/rasterizers.h"

const glint_rasterizer glint_rasterizers[GLINT_RASTERIZERS] = {
    {"phong", GLINT_SHADING_PHONG, GLINT_REFLECTANCE_BLINN},
    {"gouraud", GLINT_SHADING_GOURAUD, GLINT_REFLECTANCE_BLINN},
    {"gouraud-perspective", GLINT_SHADING_GOURAUD_PERSPECTIVE, GLINT_REFLECTANCE_BLINN},
    {"gouraud-4", GLINT_SHADING_GOURAUD_4, GLINT_REFLECTANCE_BLINN},
    {"mixed", GLINT_SHADING_MIXED, GLINT_REFLECTANCE_BLINN},
    {"cosine-linear", GLINT_SHADING_COSINE_LINEAR, GLINT_REFLECTANCE_BLINN},
    {"phong-unnormalised", GLINT_SHADING_PHONG_UNNORMALISED, GLINT_REFLECTANCE_BLINN},
    {"phong-newton", GLINT_SHADING_PHONG_NEWTON, GLINT_REFLECTANCE_BLINN},
    {"log2-n", GLINT_SHADING_PHONG, GLINT_REFLECTANCE_LOG2_N},
    {"reflection-map", GLINT_SHADING_REFLECTION_MAP, GLINT_REFLECTANCE_BLINN},
    {"flat", GLINT_SHADING_FLAT, GLINT_REFLECTANCE_BLINN},
};

glint_status glint_easel_create(const glint_report *report, int width, int height,
                                glint_easel *easel, glint_error *err)
{
    const glint_backend_config config = {.kind = GLINT_BACKEND_REAL,
                                         .pipeline = GLINT_PIPELINE_PIPELINED};
    *easel = (glint_easel){.report = report};
    const glint_status status =
        glint_renderer_create(width, height, 1, &config, &easel->renderer, err);
    return status == GLINT_OK ? glint_image_create(width, height, &easel->image, err) : status;
}

void glint_easel_destroy(glint_easel *easel)
{
    glint_renderer_destroy(easel->renderer);
    glint_image_destroy(easel->image);
}

glint_status glint_easel_paint(glint_easel *easel, const glint_scene *scene, int rasterizer,
                               glint_error *err)
{
    glint_scene painted = *scene;
    painted.shading = glint_rasterizers[rasterizer].shading;
    painted.by_model = true;
    painted.specular = glint_rasterizers[rasterizer].model;
    return glint_render(easel->renderer, &painted, easel->image, easel->report->stop, &easel->stats,
                        err);
}

/* ---- Errors and times ------------------------------------------------------------------------ */

#define EXPONENT 20

static const struct {
    const char *name;
    glint_status (*make)(int density, glint_mesh **mesh, glint_error *err);
    int density;
} figures[] = {{"sphere-coarse", glint_mesh_sphere, 16},
               {"sphere", glint_mesh_sphere, GLINT_SPHERE_DENSITY},
               {"teapot-coarse", glint_mesh_teapot, 4},
               {"teapot", glint_mesh_teapot, GLINT_TEAPOT_DENSITY}};

#define FIGURES ((int)(sizeof figures / sizeof figures[0]))

/* The shading's least processor time, and that of Phong's; by turns, so that what else the machine
 * does falls on both. The first frame fills what a renderer keeps. */
static glint_status time_shading(glint_easel *easel, const glint_scene *scene, int rasterizer,
                                 double seconds[2], glint_error *err)
{
    const int frames = easel->report->quick ? 3 : 15;
    glint_status status = glint_easel_paint(easel, scene, rasterizer, err);
    seconds[0] = seconds[1] = INFINITY;
    for (int i = 0; i < 2 * frames && status == GLINT_OK; i++) {
        const int which = i % 2;
        status =
            glint_easel_paint(easel, scene, which == 0 ? GLINT_RASTERIZER_PHONG : rasterizer, err);
        seconds[which] = fmin(seconds[which], easel->stats.shading_seconds);
    }
    return status;
}

static glint_status compare(glint_easel *easel, const glint_scene *scene, int rasterizer,
                            const glint_image *phong, double *nmse, glint_error *err)
{
    glint_image_difference difference;
    glint_status status = glint_easel_paint(easel, scene, rasterizer, err);
    if (status == GLINT_OK)
        status = glint_image_compare(phong, easel->image, &difference, err);
    *nmse = status == GLINT_OK ? difference.nmse : NAN;
    return status;
}

static glint_status measure_rasterizer(glint_report *report, glint_easel *easel,
                                       const glint_scene *scene, const char *figure, int rasterizer,
                                       const glint_image *phong, double *phong_seconds,
                                       glint_error *err)
{
    const char *name = glint_rasterizers[rasterizer].name;
    double nmse, seconds[2];
    glint_status status = compare(easel, scene, rasterizer, phong, &nmse, err);
    if (status == GLINT_OK)
        status = time_shading(easel, scene, rasterizer, seconds, err);
    if (status != GLINT_OK)
        return status;
    glint_number_put(&report->numbers, nmse, "rasterizers.%s.%s.nmse", name, figure);
    *phong_seconds = fmin(*phong_seconds, seconds[0]);
    glint_number_put(&report->numbers, seconds[1] / seconds[0], "rasterizers.%s.%s.time", name,
                     figure);
    return GLINT_OK;
}

/* The map's error by its size: against Phong's shading seen from the same place, and from so far
 * that the viewer might be at infinity, as for the map. */
static glint_status measure_map(glint_report *report, glint_easel *easel, const glint_scene *scene,
                                const char *view, glint_image *phong, glint_error *err)
{
    static const int sizes[] = {16, 32, 64, 128, 256, 512, 1024};
    glint_scene seen = *scene;
    glint_status status = glint_easel_paint(easel, &seen, GLINT_RASTERIZER_PHONG, err);
    memcpy(phong->rgb, easel->image->rgb, (size_t)3 * (size_t)phong->width * (size_t)phong->height);
    memcpy(phong->object, easel->image->object, (size_t)phong->width * (size_t)phong->height);
    for (size_t i = 0; i < sizeof sizes / sizeof sizes[0] && status == GLINT_OK; i++) {
        double nmse;
        char size[16];
        snprintf(size, sizeof size, "%d", sizes[i]);
        seen.map_size = sizes[i];
        status = compare(easel, &seen, 9, phong, &nmse, err);
        if (status != GLINT_OK)
            return status;
        if (view[0] == 'n')
            glint_number_add_word(&report->numbers, "rasterizers.maps", size);
        glint_number_put(&report->numbers, nmse, "rasterizers.map.%s.%s", size, view);
    }
    return status;
}

static glint_status measure_figure(glint_report *report, glint_easel *easel, int figure,
                                   glint_image *phong, glint_error *err)
{
    glint_scene scene;
    glint_mesh *mesh;
    double seconds = INFINITY;
    glint_status status = figures[figure].make(figures[figure].density, &mesh, err);
    if (status != GLINT_OK)
        return status;
    glint_scene_defaults(&scene);
    scene.mesh = mesh;
    scene.n = EXPONENT;
    status = glint_easel_paint(easel, &scene, GLINT_RASTERIZER_PHONG, err);
    const size_t pixels = (size_t)phong->width * (size_t)phong->height;
    memcpy(phong->rgb, easel->image->rgb, 3 * pixels);
    memcpy(phong->object, easel->image->object, pixels);
    for (int i = 1; i < GLINT_RASTERIZERS && status == GLINT_OK; i++)
        status = measure_rasterizer(report, easel, &scene, figures[figure].name, i, phong, &seconds,
                                    err);
    glint_number_put(&report->numbers, 1e3 * seconds, "rasterizers.phong.%s.ms",
                     figures[figure].name);
    if (status == GLINT_OK && figure == 1) { /* the fine sphere */
        status = measure_map(report, easel, &scene, "near", phong, err);
        scene.fov = GLINT_FOV_MIN;
        if (status == GLINT_OK)
            status = measure_map(report, easel, &scene, "far", phong, err);
    }
    glint_mesh_destroy(mesh);
    return status;
}

static glint_status measure_figures(glint_report *report, glint_error *err)
{
    const int width = report->quick ? 160 : 640, height = report->quick ? 120 : 480;
    glint_easel easel;
    glint_image *phong = NULL;
    glint_status status = glint_easel_create(report, width, height, &easel, err);
    if (status == GLINT_OK)
        status = glint_image_create(width, height, &phong, err);
    for (int i = 0; i < FIGURES && status == GLINT_OK; i++)
        status = measure_figure(report, &easel, i, phong, err);
    glint_image_destroy(phong);
    glint_easel_destroy(&easel);
    return status;
}

/* ---- Drawbacks ------------------------------------------------------------------------------- */

/* It has a drawback where it is more than twice as far from the best as Phong's shading, and does
 * better than Gouraud's where it is less than half as far as that. */
static void put_drawbacks(glint_numbers *numbers, double found[GLINT_RASTERIZERS][GLINT_DRAWBACKS])
{
    const double *phong = found[GLINT_RASTERIZER_PHONG], *gouraud = found[GLINT_RASTERIZER_GOURAUD];
    int has = 0;
    for (int k = 0; k < GLINT_DRAWBACKS; k++)
        has += gouraud[k] > 2.0 * phong[k] && gouraud[k] > 0.0;
    glint_number_put(numbers, has, "rasterizers.drawbacks");
    for (int i = 0; i < GLINT_RASTERIZERS; i++) {
        const char *name = glint_rasterizers[i].name;
        char better[32] = "";
        glint_number_add_word(numbers, "rasterizers.all", name);
        if (i > 0)
            glint_number_add_word(numbers, "rasterizers.rows", name);
        for (int k = 0; k < GLINT_DRAWBACKS; k++) {
            const size_t used = strlen(better);
            glint_number_put(numbers, found[i][k], "rasterizers.%s.%s", name,
                             glint_drawback_names[k]);
            if (found[i][k] < 0.5 * gouraud[k])
                snprintf(better + used, sizeof better - used, "%s%c", used > 0 ? " " : "",
                         "abcdef"[k]);
        }
        glint_number_put_text(numbers, better[0] != '\0' ? better : "–", "rasterizers.%s.better",
                              name);
    }
}

glint_status glint_chapter_rasterizers(glint_report *report, glint_error *err)
{
    double found[GLINT_RASTERIZERS][GLINT_DRAWBACKS], ratio = NAN;
    glint_status status = measure_figures(report, err);
    if (status == GLINT_OK)
        status = glint_drawbacks_measure(report, found, err);
    if (status == GLINT_OK)
        status = glint_right_triangles_measure(report, &ratio, err);
    if (status != GLINT_OK)
        return status;
    put_drawbacks(&report->numbers, found);
    glint_number_put(&report->numbers, EXPONENT, "rasterizers.n");
    glint_number_put(&report->numbers, ratio, "rasterizers.right");
    return glint_rasterizer_figures(report, err);
}
