/* The specular-colour device: section 3.1, figure 3.1. The effect of its gates, in pictures and at
 * every cosine code, its latency, and its deviation from the formula. */
#include "report/device_errors.h"

#include "render/render.h"
#include "report/texts.h"

#define WIDTH  640
#define HEIGHT 480

/* What is compared with the picture of the first: other gates, and the formula (2.15) itself. */
static const struct {
    const char *name;
    glint_gate gate;
    glint_backend_kind backend;
} pictures[] = {{"cosine", GLINT_GATE_COSINE, GLINT_BACKEND_RTL},
                {"sign", GLINT_GATE_SIGN, GLINT_BACKEND_RTL},
                {"drawn", GLINT_GATE_DRAWN, GLINT_BACKEND_RTL},
                {"formula", GLINT_GATE_COSINE, GLINT_BACKEND_REAL}};

#define PICTURES ((int)(sizeof pictures / sizeof pictures[0]))
#define N        100

static glint_status render(const glint_report *report, const glint_mesh *mesh, int picture,
                           glint_image *image, glint_error *err)
{
    const glint_backend_config config = {.kind = pictures[picture].backend,
                                         .gate = pictures[picture].gate,
                                         .pipeline = GLINT_PIPELINE_PIPELINED};
    glint_renderer *renderer;
    glint_scene scene;
    glint_status status =
        glint_renderer_create(WIDTH, HEIGHT, report->threads, &config, &renderer, err);
    if (status != GLINT_OK)
        return status;
    glint_scene_defaults(&scene);
    scene.mesh = mesh;
    scene.n = N;
    status = glint_render(renderer, &scene, image, report->stop, NULL, err);
    glint_renderer_destroy(renderer);
    return status;
}

/* image: of the first picture, then of each. */
static glint_status compare(glint_report *report, const glint_mesh *mesh, glint_image *const *image,
                            glint_error *err)
{
    glint_status status = GLINT_OK;
    for (int i = 0; i < PICTURES && status == GLINT_OK; i++) {
        const char *name = pictures[i].name;
        glint_image *own = image[i == 0 ? 0 : 1];
        glint_image_difference difference;
        char file[64];
        snprintf(file, sizeof file, "device-%s.png", name);
        status = render(report, mesh, i, own, err);
        if (status == GLINT_OK)
            status = glint_image_compare(image[0], own, &difference, err);
        if (status == GLINT_OK && (i == 0 || pictures[i].gate == GLINT_GATE_DRAWN))
            status = glint_report_write_png(report, own, file, err);
        if (status != GLINT_OK)
            return status;
        glint_number_put(&report->numbers, difference.nmse, "device.%s.nmse", name);
        glint_number_put(&report->numbers, (double)difference.differing_pixels, "device.%s.pixels",
                         name);
    }
    return status;
}

static glint_status render_pictures(glint_report *report, glint_error *err)
{
    glint_mesh *mesh;
    glint_image *image[2] = {NULL, NULL};
    glint_status status = glint_mesh_sphere(GLINT_SPHERE_DENSITY, &mesh, err);
    if (status != GLINT_OK)
        return status;
    for (int i = 0; i < 2 && status == GLINT_OK; i++)
        status = glint_image_create(WIDTH, HEIGHT, &image[i], err);
    if (status == GLINT_OK)
        status = compare(report, mesh, image, err);
    glint_image_destroy(image[0]);
    glint_image_destroy(image[1]);
    glint_mesh_destroy(mesh);
    return status;
}

static void put(glint_numbers *numbers, const glint_device_errors *errors, bool quick)
{
    char text[64];
    glint_exponents exponents;
    glint_exponents_of(quick, &exponents);
    glint_exponents_say(&exponents, glint_n_all, text, sizeof text);
    glint_number_put_text(numbers, text, "device.exponents");
    glint_number_put(numbers, GLINT_COS_ONE + 1u, "device.codes");
    const glint_worst *rounding = &errors->rounding, *output = &errors->output;
    glint_number_put(numbers, N, "device.n");
    glint_number_put(numbers, (double)errors->points, "device.points");
    glint_number_put(numbers, (double)errors->differing, "device.verilog-differing");
    glint_number_put(numbers, (double)errors->sign_differing, "device.sign.differing");
    glint_number_put(numbers, (double)errors->drawn_differing, "device.drawn.differing");
    glint_number_put(numbers, (double)errors->drawn_differing / (double)errors->points,
                     "device.drawn.share");
    glint_number_put(numbers, rounding->error, "device.rounding");
    glint_number_put(numbers, rounding->n, "device.rounding.n");
    glint_number_put(numbers, errors->model.absolute.error / rounding->error,
                     "device.formula-to-rounding");
    glint_number_put(numbers, output->error, "device.output");
    glint_number_put(numbers, output->n, "device.output.n");
    glint_number_put(numbers, GLINT_LATENCY_PIPELINED, "device.latency");
    glint_number_put(numbers, GLINT_LATENCY_COMBINATIONAL, "device.latency.combinational");
}

glint_status glint_chapter_device(glint_report *report, glint_error *err)
{
    const glint_device_errors *errors;
    glint_status status =
        glint_report_write_lines(report, glint_drawing_device_drawn, "figure-3.1.svg", err);
    if (status == GLINT_OK)
        status = glint_report_write_lines(report, glint_drawing_device, "device.svg", err);
    if (status == GLINT_OK)
        status = render_pictures(report, err);
    if (status == GLINT_OK)
        status = glint_device_errors_of(report, &errors, err);
    if (status == GLINT_OK)
        put(&report->numbers, errors, report->quick);
    return status;
}
