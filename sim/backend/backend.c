/* The three backends behind one interface. */
#include "backend/backend.h"

#include <math.h>
#include <stdlib.h>

#include "circuit/circuits.h"
#include "circuit/highlight.h"
#include "circuit/units.h"

struct glint_backend {
    glint_backend_config config;
    glint_setting setting; /* of config */
    glint_rtl *rtl;        /* kind rtl only */
    glint_backend_watch *watch;
    glint_history *history; /* since there is a watch, until that has found something */
};

/* The fastest lane count in the bench. */
#define FAST_LANES 16

glint_setting glint_backend_setting(const glint_backend_config *config)
{
    const int lanes = config->lanes != 0 ? config->lanes : FAST_LANES;
    const glint_specular_config specular = {config->gate, config->pipeline, lanes};
    glint_setting setting = config->device == NULL || config->device == &glint_circuit_specular
                                ? glint_setting_specular(&specular)
                                : glint_setting_unit(config->device, config->variant,
                                                     config->w_drop, config->pipeline, lanes);
    setting.verilog = config->verilog;
    return setting;
}

glint_backend_config glint_backend_config_of(glint_backend_kind kind, const glint_setting *setting)
{
    const bool is_specular = setting->circuit == &glint_circuit_specular;
    const bool has_variant = glint_highlight_parameter(setting->circuit) != NULL;
    return (glint_backend_config){
        .kind = kind,
        .device = setting->circuit,
        .variant = has_variant ? setting->values[0] : 0,
        .w_drop = glint_setting_value(setting, GLINT_HIGHLIGHT_W_DROP_NAME, 0),
        .gate = is_specular ? (glint_gate)setting->values[GLINT_SPECULAR_GATE] : GLINT_GATE_COSINE,
        .pipeline = (glint_pipeline)glint_setting_value(setting, "pipeline", 0),
        .lanes = glint_highlight_lanes(setting),
        .verilog = setting->verilog};
}

static glint_status create_circuit(glint_backend *backend, glint_error *err)
{
    return glint_rtl_open(&backend->setting, GLINT_RTL_FAST, &backend->rtl, err);
}

glint_status glint_backend_create(const glint_backend_config *config, glint_backend **backend,
                                  glint_error *err)
{
    *backend = NULL;
    if ((unsigned)config->kind >= GLINT_BACKEND_COUNT ||
        (unsigned)config->gate >= GLINT_GATE_COUNT ||
        (unsigned)config->pipeline >= GLINT_PIPELINE_COUNT)
        return glint_fail(err, GLINT_BAD_ARGUMENT, "no such backend, gate or pipeline");
    if (config->device != NULL && !glint_is_highlight(config->device))
        return glint_fail(err, GLINT_BAD_ARGUMENT, "circuit %s does not compute highlights",
                          config->device->name);
    const glint_setting setting = glint_backend_setting(config);
    glint_status status = glint_setting_check(&setting, err);
    if (status != GLINT_OK)
        return status;
    glint_backend *created = calloc(1, sizeof *created);
    if (created == NULL)
        return glint_fail(err, GLINT_NO_MEMORY, "not enough memory for a backend");
    created->config = *config;
    created->setting = setting;
    status = config->kind == GLINT_BACKEND_RTL ? create_circuit(created, err) : GLINT_OK;
    if (status != GLINT_OK) {
        free(created);
        return status;
    }
    *backend = created;
    return GLINT_OK;
}

void glint_backend_destroy(glint_backend *backend)
{
    if (backend == NULL)
        return;
    glint_rtl_destroy(backend->rtl);
    glint_history_destroy(backend->history);
    free(backend);
}

static uint32_t round_half_up(double value)
{
    return (uint32_t)floor(value + 0.5);
}

static void shade_real(const glint_setting *setting, const glint_material *material,
                       const glint_points *points)
{
    const double one = 1u << glint_highlight_w_frac_bits(setting);
    for (size_t i = 0; i < points->count; i++) {
        double w = glint_highlight_real(setting, material->n, points->cos[i]);
        if (points->w != NULL)
            points->w[i] = round_half_up(w * one);
        points->r[i] = (uint8_t)round_half_up(w * material->r);
        points->g[i] = (uint8_t)round_half_up(w * material->g);
        points->b[i] = (uint8_t)round_half_up(w * material->b);
    }
}

static glint_status shade_c(const glint_setting *setting, const glint_material *material,
                            const glint_points *points)
{
    return glint_highlight_batch(setting, material, points->cos, points->count, points->w,
                                 points->r, points->g, points->b);
}

void glint_backend_set_watch(glint_backend *backend, glint_backend_watch *watch)
{
    backend->watch = watch;
}

static uint32_t value_of(const glint_points *of, glint_answer_value value, size_t i)
{
    switch (value) {
    case GLINT_ANSWER_R:
        return of->r[i];
    case GLINT_ANSWER_G:
        return of->g[i];
    case GLINT_ANSWER_B:
        return of->b[i];
    default:
        return of->w != NULL ? of->w[i] : 0;
    }
}

/* Notes the first answer that is not the model's. */
static void compare_run(const glint_backend *backend, const glint_material *material,
                        const glint_points *model, const glint_points *rtl)
{
    glint_backend_watch *watch = backend->watch;
    for (size_t i = 0; i < rtl->count && !watch->found; i++)
        for (int v = 0; v < GLINT_ANSWER_VALUES && !watch->found; v++) {
            const glint_answer_value value = (glint_answer_value)v;
            if (value_of(model, value, i) == value_of(rtl, value, i))
                continue;
            watch->found = true;
            watch->setting = backend->setting;
            glint_answer_keep_points(&watch->answer, glint_highlight_lanes(&backend->setting),
                                     material, rtl->cos, rtl->count, i);
            watch->answer.value = value;
            watch->answer.model = (int32_t)value_of(model, value, i);
            watch->answer.rtl = (int32_t)value_of(rtl, value, i);
        }
}

static glint_status watch_run(const glint_backend *backend, const glint_material *material,
                              const glint_points *rtl, glint_error *err)
{
    const size_t count = rtl->count;
    uint32_t *w = rtl->w != NULL ? malloc(count * sizeof *w) : NULL;
    uint8_t *colors = malloc(3 * count);
    if (colors == NULL || (w == NULL && rtl->w != NULL)) {
        free(w);
        free(colors);
        return glint_fail(err, GLINT_NO_MEMORY,
                          "not enough memory to compare a run with the model");
    }
    const glint_points model = {rtl->cos, count, w, colors, colors + count, colors + 2 * count};
    const glint_status status = shade_c(&backend->setting, material, &model);
    if (status == GLINT_OK)
        compare_run(backend, material, &model, rtl);
    free(w);
    free(colors);
    return status;
}

static bool is_watched(const glint_backend *backend)
{
    return backend->watch != NULL && !backend->watch->found;
}

static void give_history(glint_backend *backend)
{
    backend->watch->history = backend->history;
    backend->history = NULL;
}

static void remember(glint_backend *backend, const glint_material *material,
                     const glint_points *points)
{
    const glint_batch batch = {
        .material = material, .cos_code = points->cos, .count = points->count};
    glint_history_add(&backend->history, &backend->setting, &batch);
}

static glint_status shade_rtl(glint_backend *backend, const glint_material *material,
                              const glint_points *points, glint_error *err)
{
    const bool watched = is_watched(backend) && points->count != 0;
    if (watched)
        remember(backend, material, points);
    glint_status status = glint_rtl_shade(backend->rtl, material, points, err);
    if (status == GLINT_OK && watched)
        status = watch_run(backend, material, points, err);
    if (watched && (backend->watch->found || status == GLINT_DEVICE_FAULT))
        give_history(backend);
    return status;
}

glint_status glint_backend_shade(glint_backend *backend, const glint_material *material,
                                 const glint_points *points, glint_error *err)
{
    const glint_setting *setting = &backend->setting;
    if (material->n > GLINT_N_MAX)
        return glint_fail(err, GLINT_BAD_ARGUMENT, "n = %u is outside 0…%u", material->n,
                          GLINT_N_MAX);
    switch (backend->config.kind) {
    case GLINT_BACKEND_RTL:
        return shade_rtl(backend, material, points, err);
    case GLINT_BACKEND_REAL:
        shade_real(setting, material, points);
        return GLINT_OK;
    default:
        return shade_c(setting, material, points);
    }
}

uint64_t glint_backend_clocks(const glint_backend *backend)
{
    return backend->rtl != NULL ? glint_rtl_clocks(backend->rtl) : 0;
}
