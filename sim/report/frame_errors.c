/* See frame_errors.h. Table 3.2's scene is not given in full: what is taken for it stands in
 * glint_frame_scene(), and the report says so. */
#include "report/frame_errors.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

const char *const glint_test_figure_names[GLINT_FIGURE_COUNT] = {"sphere", "teapot"};

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

static const int many_exponents[] = {1,  2,  3,   5,   7,   10,  13,  17,  20,  30,
                                     50, 80, 120, 169, 170, 250, 350, 500, 700, 1000};
static const int few_exponents[] = {2, 13, 169, 170, 1000};

int glint_frame_exponents(bool quick, int n[GLINT_FRAME_EXPONENTS_MAX])
{
    const int *chosen = quick ? few_exponents : many_exponents;
    const size_t size = quick ? sizeof few_exponents : sizeof many_exponents;
    memcpy(n, chosen, size);
    return (int)(size / sizeof *chosen);
}

void glint_frame_scene(glint_frame_light light, glint_scene *scene)
{
    static const uint8_t color[] = {238, 138, 32};
    glint_scene_defaults(scene);
    memcpy(scene->color, color, sizeof color);
    if (light == GLINT_LIGHT_COLORED || light == GLINT_LIGHT_COLORED_AMBIENT)
        memcpy(scene->highlight, color, sizeof color);
    scene->ka = light == GLINT_LIGHT_WHITE || light == GLINT_LIGHT_COLORED ? 0.2f : 1.0f;
    scene->kd = 0.5f;
    scene->ks = 0.5f;
}

/* A colour's name, or its numbers. */
static const char *color_of(const glint_scene *scene, const uint8_t color[3], char *text,
                            size_t room)
{
    static const uint8_t white[3] = {255, 255, 255};
    if (memcmp(color, white, sizeof white) == 0)
        return "white";
    if (color != scene->color && memcmp(color, scene->color, sizeof scene->color) == 0)
        return "of the object's colour";
    snprintf(text, room, "%d,%d,%d", color[0], color[1], color[2]);
    return text;
}

void glint_frame_light_say(glint_frame_light light, char *text, size_t room)
{
    char numbers[16];
    glint_scene scene = {0};
    glint_frame_scene(light, &scene);
    snprintf(text, room, "highlight %s, Ka = %g",
             color_of(&scene, scene.highlight, numbers, sizeof numbers), (double)scene.ka);
}

void glint_frame_scene_say(const glint_scene *scene, char *text, size_t room)
{
    char object[16], highlight[16];
    snprintf(text, room,
             "object's colour %s, highlight %s, Ia = %g, Ie = %g, Ka = %g, Kd = %g, Ks = %g, light "
             "from %g,%g,%g, yaw %g°, pitch %g°, field of view %g°, %s",
             color_of(scene, scene->color, object, sizeof object),
             color_of(scene, scene->highlight, highlight, sizeof highlight), (double)scene->ia,
             (double)scene->ie, (double)scene->ka, (double)scene->kd, (double)scene->ks,
             (double)scene->light[0], (double)scene->light[1], (double)scene->light[2],
             (double)scene->yaw, (double)scene->pitch, (double)scene->fov,
             scene->distance == 0.0f ? "filling the frame" : "at a set distance");
}

void glint_frame_exponents_say(const int *n, int count, int n_from, int n_to, char *text,
                               size_t room)
{
    int found = 0, first = 0, last = 0;
    for (int i = 0; i < count; i++)
        if (n[i] >= n_from && n[i] <= n_to) {
            first = found++ == 0 ? n[i] : first;
            last = n[i];
        }
    if (found == 0)
        snprintf(text, room, "no exponent");
    else if (found == 1)
        snprintf(text, room, "n = %d", first);
    else
        snprintf(text, room, "%d exponents n = %d…%d", found, first, last);
}

glint_status glint_frame_mesh(glint_test_figure figure, glint_mesh **mesh, glint_error *err)
{
    return figure == GLINT_FIGURE_SPHERE ? glint_mesh_sphere(GLINT_SPHERE_DENSITY, mesh, err)
                                         : glint_mesh_teapot(GLINT_TEAPOT_DENSITY, mesh, err);
}

glint_status glint_frame_study_create(const glint_report *report, const glint_scene *scene,
                                      int width, int height, const char *reference,
                                      const char *method, glint_study **study, glint_error *err)
{
    glint_study_setup setup = {
        .scene = *scene, .width = width, .height = height, .threads = report->threads};
    glint_status status = glint_study_method_parse(reference, &setup.method[0], err);
    if (status == GLINT_OK)
        status = glint_study_method_parse(method, &setup.method[1], err);
    return status == GLINT_OK ? glint_study_create(&setup, study, err) : status;
}

static glint_status measure_method(const glint_report *report, const glint_scene *scene,
                                   const glint_frame_errors *errors, glint_frame_method method,
                                   double *nmse, glint_error *err)
{
    glint_study *study;
    glint_status status = glint_frame_study_create(report, scene, errors->width, errors->height,
                                                   glint_frame_names[method][1],
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
    errors->count = glint_frame_exponents(report->quick, errors->n);
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

glint_worst_frame glint_worst_frame_of(const glint_frame_errors *errors, glint_test_figure figure,
                                       glint_frame_light light, glint_frame_method method,
                                       int n_from, int n_to)
{
    glint_worst_frame worst = {NAN, 0};
    for (int i = 0; i < errors->count; i++) {
        const double nmse = errors->nmse[figure][light][method][i];
        if (errors->n[i] >= n_from && errors->n[i] <= n_to && !(nmse < worst.nmse))
            worst = (glint_worst_frame){nmse, errors->n[i]};
    }
    return worst;
}
