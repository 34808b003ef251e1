/* See frame_errors.h. Table 3.2 does not specify its scene fully: glint_frame_scene() has the
 * assumptions, and text/frames.md states them. */
#include "report/frame_errors.h"

#include <math.h>
#include <string.h>

const char *const glint_test_figure_names[GLINT_FIGURE_COUNT] = {"sphere", "teapot"};

const char *const glint_frame_light_names[GLINT_LIGHT_COUNT] = {"3.9-white", "3.9-own",
                                                                "listing-white", "listing-own"};

const char *const glint_frame_names[GLINT_FRAME_COUNT][2] = {
    [GLINT_FRAME_SCHLICK] = {"schlick", "blinn"},
    [GLINT_FRAME_SCHLICK_MODIFIED] = {"schlick-modified", "blinn"},
    [GLINT_FRAME_SCHLICK_POWER] = {"schlick-modified-power", "blinn"},
    [GLINT_FRAME_SCHLICK_SQUARED] = {"schlick-modified-squared", "blinn"},
    [GLINT_FRAME_QUADRATIC] = {"quadratic", "blinn"},
    [GLINT_FRAME_COSINE_QUADRATIC] = {"cosine-quadratic", "blinn"},
    [GLINT_FRAME_LYON_4] = {"lyon-4", "blinn"},
    [GLINT_FRAME_DEVICE] = {"c", "blinn"},
    [GLINT_FRAME_VERILOG] = {"rtl", "blinn"},
    [GLINT_FRAME_ROUNDING] = {"c", "cosine-quadratic"},
    [GLINT_FRAME_IMPLEMENTATION] = {"rtl", "c"},
};

static const int many_exponents[] = {1,  2,  3,  5,   8,   10,  12,  13,  14,  16,  20,
                                     30, 50, 80, 120, 169, 170, 250, 350, 500, 700, 1000};
static const int few_exponents[] = {2, 13, 169, 170, 1000};

void glint_frame_scene(glint_frame_light light, glint_scene *scene)
{
    static const uint8_t color[] = {238, 138, 32};
    const bool listing = light == GLINT_LIGHT_LISTING_WHITE || light == GLINT_LIGHT_LISTING_OWN;
    glint_scene_defaults(scene);
    memcpy(scene->color, color, sizeof color);
    if (light == GLINT_LIGHT_39_OWN || light == GLINT_LIGHT_LISTING_OWN)
        memcpy(scene->highlight, color, sizeof color);
    memset(scene->ia, 0, sizeof scene->ia);
    scene->kd = scene->ks = listing ? 1.0f : 0.5f;
}

glint_status glint_frame_mesh(glint_test_figure figure, glint_mesh **mesh, glint_error *err)
{
    return figure == GLINT_FIGURE_SPHERE ? glint_mesh_sphere(GLINT_SPHERE_DENSITY, mesh, err)
                                         : glint_mesh_teapot(GLINT_TEAPOT_DENSITY, mesh, err);
}

static glint_status create_study(const glint_report *report, const glint_scene *scene, int width,
                                 int height, const char *reference, const char *method,
                                 glint_study **study, glint_error *err)
{
    glint_study_setup setup = {
        .scene = *scene, .width = width, .height = height, .threads = report->threads};
    glint_status status = glint_study_method_parse(reference, &setup.method[0], err);
    if (status == GLINT_OK)
        status = glint_study_method_parse(method, &setup.method[1], err);
    return status == GLINT_OK ? glint_study_create(&setup, study, err) : status;
}

glint_status glint_frame_nmse(const glint_report *report, const glint_scene *scene, int width,
                              int height, const char *reference, const char *method, int n,
                              double *nmse, glint_error *err)
{
    glint_study *study;
    glint_image_difference difference;
    glint_status status =
        create_study(report, scene, width, height, reference, method, &study, err);
    if (status != GLINT_OK)
        return status;
    status = glint_study_compare(study, n, report->stop, &difference, err);
    if (status == GLINT_OK)
        *nmse = difference.nmse;
    glint_study_destroy(study);
    return status;
}

static glint_status measure_method(const glint_report *report, const glint_scene *scene,
                                   const glint_frame_errors *errors, glint_frame_method method,
                                   double *nmse, glint_error *err)
{
    glint_study *study;
    glint_status status =
        create_study(report, scene, errors->width, errors->height, glint_frame_names[method][1],
                     glint_frame_names[method][0], &study, err);
    if (status != GLINT_OK)
        return status;
    for (int i = 0; i < errors->count && status == GLINT_OK; i++) {
        glint_image_difference difference;
        status = glint_study_compare(study, errors->n[i], report->stop, &difference, err);
        if (status == GLINT_OK)
            nmse[i] = difference.nmse;
    }
    glint_study_destroy(study);
    return status;
}

static glint_status measure_figure(const glint_report *report, const glint_mesh *mesh,
                                   glint_test_figure figure, glint_frame_errors *errors,
                                   glint_error *err)
{
    glint_status status = GLINT_OK;
    for (int light = 0; light < GLINT_LIGHT_COUNT; light++) {
        glint_scene scene;
        glint_frame_scene((glint_frame_light)light, &scene);
        scene.mesh = mesh;
        for (int method = 0; method < GLINT_FRAME_COUNT && status == GLINT_OK; method++)
            status = measure_method(report, &scene, errors, (glint_frame_method)method,
                                    errors->nmse[figure][light][method], err);
    }
    return status;
}

glint_status glint_frame_errors_measure(const glint_report *report, glint_frame_errors *errors,
                                        glint_error *err)
{
    glint_status status = GLINT_OK;
    errors->width = report->quick ? 160 : 640;
    errors->height = report->quick ? 120 : 480;
    const int *chosen = report->quick ? few_exponents : many_exponents;
    const size_t size = report->quick ? sizeof few_exponents : sizeof many_exponents;
    memcpy(errors->n, chosen, size);
    errors->count = (int)(size / sizeof *chosen);
    for (int figure = 0; figure < GLINT_FIGURE_COUNT && status == GLINT_OK; figure++) {
        glint_mesh *mesh;
        status = glint_frame_mesh((glint_test_figure)figure, &mesh, err);
        if (status != GLINT_OK)
            return status;
        status = measure_figure(report, mesh, (glint_test_figure)figure, errors, err);
        glint_mesh_destroy(mesh);
    }
    return status;
}

glint_worst_frame glint_worst_frame_of(const glint_frame_errors *errors, glint_frame_light light,
                                       glint_frame_method method, int n_from, int n_to)
{
    glint_worst_frame worst = {NAN, 0, GLINT_FIGURE_SPHERE};
    for (int figure = 0; figure < GLINT_FIGURE_COUNT; figure++)
        for (int i = 0; i < errors->count; i++) {
            const double nmse = errors->nmse[figure][light][method][i];
            const bool in = errors->n[i] >= n_from && errors->n[i] <= n_to;
            if (in && !(nmse <= worst.nmse))
                worst = (glint_worst_frame){nmse, errors->n[i], (glint_test_figure)figure};
        }
    return worst;
}
