/* Scenes: their defaults, their limits, and the material that the device gets of them. */
#include "render/scene.h"

#include <math.h>

#include "circuit/circuits.h"
#include "render/listing.h"
#include "render/quadratic_band.h"
#include "render/reflection_map.h"
#include "render/shadings.h"

void glint_scene_defaults(glint_scene *scene)
{
    const glint_mesh *mesh = scene->mesh;
    *scene = (glint_scene){
        .mesh = mesh,
        .light = {-1.0f, 1.2f, 1.6f},
        .color = {200, 90, 40},
        .highlight = {255, 255, 255},
        .ia = {1.0f, 1.0f, 1.0f},
        .ie = {1.0f, 1.0f, 1.0f},
        .ka = 0.2f,
        .kd = 0.8f,
        .ks = 0.8f,
        .n = 80,
        .yaw = 25.0f,
        .pitch = 22.0f,
        .fov = 35.0f,
        .distance = 0.0f,
        .shading = GLINT_SHADING_PHONG,
        .shifts = GLINT_DIVIDER_SHIFTS_DEFAULT,
        .fraction = GLINT_QUADRATIC_SPAN_FRACTION_DEFAULT,
        .slips = GLINT_SLIPS_ALL,
        .map_size = GLINT_MAP_SIZE_DEFAULT,
        .f0 = (float)GLINT_F0_DEFAULT,
    };
}

bool glint_scene_circuit(const glint_scene *scene, glint_setting *setting)
{
    if (glint_shading_divides(scene->shading))
        *setting = glint_setting_divider(GLINT_DIVIDER_PIPELINED, scene->shifts);
    else if (scene->shading == GLINT_SHADING_QUADRATIC)
        *setting = glint_setting_span(scene->fraction);
    else
        return false;
    return true;
}

glint_status glint_scene_check_exponent(glint_reflectance_model model, double n, glint_error *err)
{
    const glint_reflectance_info *info = glint_reflectance_describe(model);
    if (info == NULL) {
        return glint_fail(err, GLINT_BAD_ARGUMENT, "unknown reflectance model number %d",
                          (int)model);
    }
    const double max = fmin(info->n_max, GLINT_N_MAX);
    return n >= info->n_min && n <= max
               ? GLINT_OK
               : glint_fail(err, GLINT_BAD_ARGUMENT, "model %s takes n from %g to %g here, not %g",
                            glint_reflectance_names[model], info->n_min, max, n);
}

/* The comparison is false for a NaN, so that a NaN is out of every range. */
static glint_status check_range(const char *name, float value, float low, float high,
                                glint_error *err)
{
    if (value >= low && value <= high)
        return GLINT_OK;
    return glint_fail(err, GLINT_BAD_ARGUMENT, "scene: %s is %g, not from %g to %g", name,
                      (double)value, (double)low, (double)high);
}

static glint_status check_light(const float light[3], glint_error *err)
{
    bool zero = true;
    for (int axis = 0; axis < 3; axis++) {
        if (!isfinite(light[axis])) {
            return glint_fail(err, GLINT_BAD_ARGUMENT, "scene: light's %c is %g, not a number",
                              "xyz"[axis], (double)light[axis]);
        }
        zero = zero && light[axis] == 0.0f;
    }
    if (zero)
        return glint_fail(err, GLINT_BAD_ARGUMENT, "scene: light 0,0,0 has no direction");
    return GLINT_OK;
}

/* The circuits' register holds whole numbers. */
static glint_status check_n(const glint_scene *scene, glint_error *err)
{
    if (!(scene->n >= 0.0 && scene->n <= GLINT_N_MAX)) {
        return glint_fail(err, GLINT_BAD_ARGUMENT, "scene: n is %g, not from 0 to %u", scene->n,
                          GLINT_N_MAX);
    }
    if (!scene->by_model && scene->n != floor(scene->n)) {
        return glint_fail(err, GLINT_BAD_ARGUMENT,
                          "scene: n is %g, but the device takes whole numbers only", scene->n);
    }
    return GLINT_OK;
}

static glint_status check_shading(const glint_scene *scene, glint_error *err)
{
    if ((unsigned)scene->shading >= GLINT_SHADING_COUNT)
        return glint_fail(err, GLINT_BAD_ARGUMENT, "scene: unknown shading");
    if (scene->shifts != GLINT_SHIFTS_EXACT &&
        (scene->shifts < GLINT_DIVIDER_SHIFTS_MIN || scene->shifts > GLINT_DIVIDER_SHIFTS_MAX)) {
        return glint_fail(err, GLINT_BAD_ARGUMENT, "scene: shifts is %d, not from %d to %d",
                          scene->shifts, GLINT_DIVIDER_SHIFTS_MIN, GLINT_DIVIDER_SHIFTS_MAX);
    }
    if (scene->delta < 0 || scene->delta > GLINT_DELTA_MAX) {
        return glint_fail(err, GLINT_BAD_ARGUMENT, "scene: delta is %d, not from 0 to %d",
                          scene->delta, GLINT_DELTA_MAX);
    }
    if (scene->map_size < GLINT_MAP_SIZE_MIN || scene->map_size > GLINT_MAP_SIZE_MAX) {
        return glint_fail(err, GLINT_BAD_ARGUMENT, "scene: map_size is %d, not from %d to %d",
                          scene->map_size, GLINT_MAP_SIZE_MIN, GLINT_MAP_SIZE_MAX);
    }
    if (scene->fraction != GLINT_FRACTION_EXACT &&
        (scene->fraction < GLINT_QUADRATIC_SPAN_FRACTION_MIN ||
         scene->fraction > GLINT_QUADRATIC_SPAN_FRACTION_MAX)) {
        return glint_fail(err, GLINT_BAD_ARGUMENT, "scene: fraction is %d, not from %d to %d",
                          scene->fraction, GLINT_QUADRATIC_SPAN_FRACTION_MIN,
                          GLINT_QUADRATIC_SPAN_FRACTION_MAX);
    }
    return GLINT_OK;
}

glint_status glint_scene_check(const glint_scene *scene, glint_error *err)
{
    const struct {
        const char *name;
        float value, low, high;
    } ranges[] = {
        {"red of ia", scene->ia[0], 0.0f, 1.0f},
        {"green of ia", scene->ia[1], 0.0f, 1.0f},
        {"blue of ia", scene->ia[2], 0.0f, 1.0f},
        {"red of ie", scene->ie[0], 0.0f, 1.0f},
        {"green of ie", scene->ie[1], 0.0f, 1.0f},
        {"blue of ie", scene->ie[2], 0.0f, 1.0f},
        {"ka", scene->ka, 0.0f, 1.0f},
        {"kd", scene->kd, 0.0f, 1.0f},
        {"ks", scene->ks, 0.0f, 1.0f},
        {"yaw", scene->yaw, -GLINT_ANGLE_MAX, GLINT_ANGLE_MAX},
        {"pitch", scene->pitch, -GLINT_ANGLE_MAX, GLINT_ANGLE_MAX},
        {"fov", scene->fov, GLINT_FOV_MIN, GLINT_FOV_MAX},
        {"distance", scene->distance, 0.0f, GLINT_DISTANCE_MAX},
        {"f0", scene->f0, 0.0f, 1.0f},
    };
    for (size_t i = 0; i < sizeof ranges / sizeof ranges[0]; i++) {
        const glint_status status =
            check_range(ranges[i].name, ranges[i].value, ranges[i].low, ranges[i].high, err);
        if (status != GLINT_OK)
            return status;
    }
    if (scene->mesh == NULL)
        return glint_fail(err, GLINT_BAD_ARGUMENT, "scene: mesh is missing");
    glint_status status = check_n(scene, err);
    if (status == GLINT_OK)
        status = check_shading(scene, err);
    return status == GLINT_OK ? check_light(scene->light, err) : status;
}

static uint8_t register_of(const glint_scene *scene, int c)
{
    const double value = scene->highlight[c] * (double)scene->ie[c] * (double)scene->ks + 0.5;
    return value < 255.0 ? (uint8_t)value : 255;
}

glint_material glint_scene_material(const glint_scene *scene)
{
    return (glint_material){
        .n = (uint16_t)scene->n, /* whole but for a model, which has its own */
        .r = register_of(scene, 0),
        .g = register_of(scene, 1),
        .b = register_of(scene, 2),
    };
}
