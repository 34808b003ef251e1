/* Frames by the power device against frames by Blinn's cosⁿ: no component of a pixel more than one
 * level away, and an NMSE of 1e-5 at most, for sphere and teapot in the thesis's four lights. The
 * same measure finds the specular device far off.
 *
 * A list of n; with GLINT_EVERY_N=1 all of 1…1023. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

#include "circuit/circuits.h"
#include "glint_power.h"
#include "report/frame_errors.h"
#include "studio.h"

enum { WIDTH = 128, HEIGHT = 96 };
static const double nmse_allowed = 1e-5;

typedef struct worst {
    int level;
    double nmse;
    uint32_t n;
} worst;

static studio open_device(const char *name, int variant, glint_backend_kind kind)
{
    const glint_backend_config config = {.kind = kind,
                                         .device = glint_circuit_named(name),
                                         .variant = variant,
                                         .pipeline = GLINT_PIPELINE_PIPELINED};
    studio s = {0};
    glint_error err = {""};
    if (glint_renderer_create(WIDTH, HEIGHT, 1, &config, &s.renderer, &err) != GLINT_OK ||
        glint_image_create(WIDTH, HEIGHT, &s.image, &err) != GLINT_OK)
        fail_msg("%s", err.text);
    return s;
}

static uint32_t n_after(uint32_t n)
{
    static const uint32_t list[] = {1, 2, 5, 10, 20, 50, 80, 100, 200, 500, 1000, GLINT_N_MAX};
    if (getenv("GLINT_EVERY_N") != NULL)
        return n + 1;
    for (size_t i = 0; i < sizeof list / sizeof list[0]; i++)
        if (list[i] > n)
            return list[i];
    return GLINT_N_COUNT;
}

static void compare(studio *device, studio *power, const glint_scene *scene, worst *found)
{
    glint_image_difference difference;
    glint_error err;
    glint_scene by_power = *scene;
    by_power.by_model = true;
    by_power.specular = GLINT_REFLECTANCE_BLINN;
    shoot(power, &by_power);
    shoot(device, scene);
    assert_true(device->stats.highlights > 0);
    assert_int_equal(glint_image_compare(power->image, device->image, &difference, &err), GLINT_OK);
    assert_int_equal(difference.mask_pixels, 0);
    if (difference.largest > found->level)
        found->level = difference.largest;
    if (difference.nmse > found->nmse) {
        found->nmse = difference.nmse;
        found->n = (uint32_t)scene->n;
    }
}

static worst worst_of(const char *name, int variant, glint_backend_kind kind)
{
    studio device = open_device(name, variant, kind);
    studio power = open_studio(WIDTH, HEIGHT, 1, GLINT_BACKEND_REAL);
    worst found = {0};
    for (int figure = 0; figure < GLINT_FIGURE_COUNT; figure++) {
        glint_mesh *mesh;
        glint_error err;
        assert_int_equal(glint_frame_mesh((glint_test_figure)figure, &mesh, &err), GLINT_OK);
        for (int light = 0; light < GLINT_LIGHT_COUNT; light++)
            for (uint32_t n = n_after(0); n <= GLINT_N_MAX; n = n_after(n)) {
                glint_scene scene;
                glint_frame_scene((glint_frame_light)light, &scene);
                scene.mesh = mesh;
                scene.n = (double)n;
                compare(&device, &power, &scene, &found);
            }
        glint_mesh_destroy(mesh);
    }
    close_studio(&device);
    close_studio(&power);
    print_message("%s, variant %d, %s: %d levels, NMSE %.3g at n %u\n", name, variant,
                  kind == GLINT_BACKEND_C ? "C" : "Verilog", found.level, found.nmse, found.n);
    return found;
}

static void frames_by_the_c_model(void **state)
{
    (void)state;
    for (int variant = 0; variant < GLINT_POWER_ACCURACY_COUNT; variant++) {
        const worst found = worst_of("power", variant, GLINT_BACKEND_C);
        assert_int_equal(found.level, 1);
        assert_true(found.nmse > 0 && found.nmse <= nmse_allowed);
    }
}

static void frames_by_the_verilog(void **state)
{
    (void)state;
    const worst found = worst_of("power", GLINT_POWER_HALF, GLINT_BACKEND_RTL);
    assert_int_equal(found.level, 1);
    assert_true(found.nmse > 0 && found.nmse <= nmse_allowed);
}

static void the_specular_device_is_far_off(void **state)
{
    (void)state;
    const worst found = worst_of("specular", 0, GLINT_BACKEND_C);
    assert_true(found.level > 10);
    assert_true(found.nmse > 100 * nmse_allowed);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(frames_by_the_c_model),
        cmocka_unit_test(frames_by_the_verilog),
        cmocka_unit_test(the_specular_device_is_far_off),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
