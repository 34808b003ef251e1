/* Section 3.4: the effect of the formulas' errors on pictures, and the time per picture. */
#include <limits.h>
#include <math.h>
#include <stdlib.h>

#include "report/chart.h"
#include "report/frame_times.h"

/* ---- Table 3.2 ------------------------------------------------------------------------------- */

static const char *const light_words[GLINT_LIGHT_COUNT] = {
    "figure 3.9, white", "figure 3.9, light's colour", "listing, white", "listing, light's colour"};

/* A method's worst frame over both figures in the most and the least favourable scene: a claim that
 * does not name its scene may refer to either. */
static void put_worst(glint_numbers *numbers, const glint_frame_errors *errors,
                      glint_frame_method method, int n_from, int n_to, const char *what)
{
    const char *name = glint_frame_names[method][0];
    double range[2] = {NAN, NAN};
    int harshest = 0;
    for (int light = 0; light < GLINT_LIGHT_COUNT; light++) {
        const glint_worst_frame worst =
            glint_worst_frame_of(errors, (glint_frame_light)light, method, n_from, n_to);
        glint_number_widen(range, worst.nmse);
        harshest = range[1] == worst.nmse ? light : harshest;
    }
    const glint_worst_frame worst =
        glint_worst_frame_of(errors, (glint_frame_light)harshest, method, n_from, n_to);
    glint_number_put_range(numbers, range[0], range[1], "frames.%s.%s", name, what);
    glint_number_put(numbers, worst.nmse, "frames.%s.%s.worst", name, what);
    glint_number_put(numbers, worst.n, "frames.%s.%s.worst.n", name, what);
    glint_number_put_text(numbers, glint_test_figure_names[worst.figure],
                          "frames.%s.%s.worst.figure", name, what);
    glint_number_put_text(numbers, light_words[harshest], "frames.%s.%s.worst.scene", name, what);
}

/* A row of the table: methods compared with another than cosⁿ are named by both. */
static void put_row(glint_numbers *numbers, const glint_frame_errors *errors,
                    glint_frame_method method)
{
    char name[64];
    snprintf(name, sizeof name, "%s", glint_frame_names[method][0]);
    if (method >= GLINT_FRAME_ROUNDING)
        snprintf(name, sizeof name, "%s-against-%s", glint_frame_names[method][0],
                 glint_frame_names[method][1]);
    glint_number_add_word(numbers, "frames.rows", name);
    for (int light = 0; light < GLINT_LIGHT_COUNT; light++) {
        const glint_worst_frame worst =
            glint_worst_frame_of(errors, (glint_frame_light)light, method, 0, INT_MAX);
        const char *scene = glint_frame_light_names[light];
        glint_number_put(numbers, worst.nmse, "frames.%s.%s", name, scene);
        glint_number_put(numbers, worst.n, "frames.%s.%s.n", name, scene);
        glint_number_put_text(numbers, glint_test_figure_names[worst.figure], "frames.%s.%s.figure",
                              name, scene);
    }
}

/* All the thesis's approximations of cosⁿ at once. */
static void put_all(glint_numbers *numbers, const glint_frame_errors *errors)
{
    double range[2] = {NAN, NAN};
    for (int light = 0; light < GLINT_LIGHT_COUNT; light++) {
        double largest = 0.0;
        for (int method = 0; method <= GLINT_FRAME_COSINE_QUADRATIC; method++)
            largest = fmax(largest, glint_worst_frame_of(errors, (glint_frame_light)light,
                                                         (glint_frame_method)method, 0, INT_MAX)
                                        .nmse);
        glint_number_widen(range, largest);
    }
    glint_number_put_range(numbers, range[0], range[1], "frames.all.nmse");
}

static void put_errors(glint_numbers *numbers, const glint_frame_errors *errors)
{
    for (int method = 0; method < GLINT_FRAME_COUNT; method++)
        put_row(numbers, errors, (glint_frame_method)method);
    for (int method = 0; method < GLINT_FRAME_ROUNDING; method++)
        put_worst(numbers, errors, (glint_frame_method)method, 1, INT_MAX, "nmse");
    put_worst(numbers, errors, GLINT_FRAME_QUADRATIC, 1, 169, "nmse-below-170");
    put_worst(numbers, errors, GLINT_FRAME_QUADRATIC, 170, INT_MAX, "nmse-from-170");
    put_all(numbers, errors);
    for (int i = 0; i < errors->count; i++) {
        char n[16];
        snprintf(n, sizeof n, "%d", errors->n[i]);
        glint_number_add_word(numbers, "frames.exponents", n);
    }
    glint_number_put(numbers, errors->width, "frames.width");
    glint_number_put(numbers, errors->height, "frames.height");
}

/* A logarithmic axis cannot show zero: the caption names what is missing. */
static void put_zeros(glint_numbers *numbers, const glint_chart *chart,
                      const glint_frame_errors *errors)
{
    char text[512] = "";
    size_t length = 0;
    for (int curve = 0; curve < chart->curves; curve++)
        for (int i = 0; i < errors->count && length < sizeof text; i++)
            if (errors->nmse[GLINT_FIGURE_SPHERE][GLINT_LIGHT_39_WHITE][curve][i] == 0.0)
                length += (size_t)snprintf(text + length, sizeof text - length, "%s%s at n = %d",
                                           length > 0 ? "; " : " Not shown, since the NMSE is 0: ",
                                           chart->curve[curve], errors->n[i]);
    if (length > 0 && length < sizeof text)
        snprintf(text + length, sizeof text - length, ".");
    glint_number_put_text(numbers, text, "frames.zeros");
}

static glint_status draw_errors(glint_report *report, const glint_frame_errors *errors,
                                glint_error *err)
{
    static const glint_chart chart = {
        .name = "figure-nmse",
        .title = "NMSE of frames against cos^n, sphere, figure 3.9, white highlight",
        .x_label = "n",
        .y_label = "NMSE",
        .settings = "set logscale xy\nset format y '%g'\n" GLINT_CHART_KEY_BELOW,
        .curves = 8,
        .curve = {"Schlick (2.1)", "modified (2.2) as printed", "Table 3.2's, best a",
                  "(2.2) read as 0.5(n(1 − c))^2", "quadratic", "cosine-quadratic", "k = 4",
                  "device"}};
    double values[GLINT_FRAME_EXPONENTS_MAX * (1 + GLINT_CHART_CURVES_MAX)], *value = values;
    put_zeros(&report->numbers, &chart, errors);
    for (int i = 0; i < errors->count; i++) {
        *value++ = errors->n[i];
        for (int curve = 0; curve < chart.curves; curve++) {
            const double nmse = errors->nmse[GLINT_FIGURE_SPHERE][GLINT_LIGHT_39_WHITE][curve][i];
            *value++ = nmse > 0.0 ? nmse : NAN;
        }
    }
    return glint_chart_draw(report, &chart, values, errors->count, err);
}

static glint_status measure_errors(glint_report *report, glint_error *err)
{
    glint_frame_errors *errors = calloc(1, sizeof *errors);
    if (errors == NULL)
        return glint_fail(err, GLINT_NO_MEMORY, "no memory for the frames");
    glint_status status = glint_frame_errors_measure(report, errors, err);
    if (status == GLINT_OK) {
        put_errors(&report->numbers, errors);
        status = draw_errors(report, errors, err);
    }
    free(errors);
    return status;
}

/* ---- Figure 3.12, and perspective ------------------------------------------------------------ */

static glint_status render_figure(glint_report *report, glint_test_figure figure,
                                  glint_renderer *renderer, glint_image *image, glint_error *err)
{
    glint_scene scene;
    glint_mesh *mesh;
    char name[64];
    glint_status status = glint_frame_mesh(figure, &mesh, err);
    if (status != GLINT_OK)
        return status;
    glint_frame_scene(GLINT_LIGHT_39_WHITE, &scene);
    scene.mesh = mesh;
    snprintf(name, sizeof name, "figure-3.12-%s.png", glint_test_figure_names[figure]);
    status = glint_render(renderer, &scene, image, report->stop, NULL, err);
    if (status == GLINT_OK)
        status = glint_report_write_png(report, image, name, err);
    glint_mesh_destroy(mesh);
    glint_number_put(&report->numbers, scene.n, "frames.%s.n", glint_test_figure_names[figure]);
    return status;
}

static glint_status render_figures(glint_report *report, glint_error *err)
{
    const glint_backend_config config = {
        .kind = GLINT_BACKEND_RTL, .gate = GLINT_GATE_COSINE, .pipeline = GLINT_PIPELINE_PIPELINED};
    const int width = report->quick ? 160 : 480, height = report->quick ? 120 : 360;
    glint_renderer *renderer = NULL;
    glint_image *image = NULL;
    glint_status status =
        glint_renderer_create(width, height, report->threads, &config, &renderer, err);
    if (status == GLINT_OK)
        status = glint_image_create(width, height, &image, err);
    for (int i = 0; i < GLINT_FIGURE_COUNT && status == GLINT_OK; i++)
        status = render_figure(report, (glint_test_figure)i, renderer, image, err);
    glint_image_destroy(image);
    glint_renderer_destroy(renderer);
    return status;
}

/* Gouraud's shading of few large triangles, near the camera, interpolated on the screen and on the
 * object, each against Phong's. */
static glint_status compare_perspective(glint_report *report, const char *name,
                                        const glint_mesh *mesh, glint_error *err)
{
    static const char *const methods[][2] = {{"screen", "blinn:gouraud"},
                                             {"object", "blinn:gouraud-perspective"}};
    glint_scene scene;
    glint_status status = GLINT_OK;
    glint_scene_defaults(&scene);
    scene.mesh = mesh;
    scene.fov = 90.0f;
    for (int i = 0; i < 2 && status == GLINT_OK; i++) {
        double nmse;
        status = glint_frame_nmse(report, &scene, 640, 480, "blinn", methods[i][1], 20, &nmse, err);
        if (status == GLINT_OK)
            glint_number_put(&report->numbers, nmse, "frames.perspective.%s.%s", name,
                             methods[i][0]);
    }
    return status;
}

static glint_status measure_perspective(glint_report *report, glint_error *err)
{
    const struct {
        const char *name;
        glint_status (*make)(int density, glint_mesh **mesh, glint_error *err);
        int density;
    } figures[] = {{"sphere", glint_mesh_sphere, 16}, {"teapot", glint_mesh_teapot, 3}};
    glint_status status = GLINT_OK;
    for (int i = 0; i < 2 && status == GLINT_OK; i++) {
        glint_mesh *mesh;
        status = figures[i].make(figures[i].density, &mesh, err);
        if (status != GLINT_OK)
            return status;
        status = compare_perspective(report, figures[i].name, mesh, err);
        glint_mesh_destroy(mesh);
    }
    return status;
}

glint_status glint_chapter_frames(glint_report *report, glint_error *err)
{
    glint_status status = measure_errors(report, err);
    if (status == GLINT_OK)
        status = render_figures(report, err);
    if (status == GLINT_OK)
        status = measure_perspective(report, err);
    return status == GLINT_OK ? glint_frame_times_measure(report, err) : status;
}
