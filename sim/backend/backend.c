/* The three backends behind one interface. */
#include "backend/backend.h"

#include <math.h>
#include <stdlib.h>

#include "rtl/rtl.h"

struct glint_backend {
    glint_backend_config config;
    glint_rtl *rtl;                /* kind rtl only, like circuit */
    glint_specular_config circuit; /* that was chosen */
    glint_backend_watch *watch;
    glint_history *history; /* since there is a watch, until that has found something */
};

/* The fastest lane count in the bench. */
#define FAST_LANES 16

static glint_status create_circuit(glint_backend *backend, glint_error *err)
{
    backend->circuit =
        (glint_specular_config){backend->config.gate, backend->config.pipeline,
                                backend->config.lanes != 0 ? backend->config.lanes : FAST_LANES};
    return glint_rtl_create_fast(&backend->circuit, &backend->rtl, err);
}

glint_status glint_backend_create(const glint_backend_config *config, glint_backend **backend,
                                  glint_error *err)
{
    *backend = NULL;
    if ((unsigned)config->kind >= GLINT_BACKEND_COUNT ||
        (unsigned)config->gate >= GLINT_GATE_COUNT ||
        (unsigned)config->pipeline >= GLINT_PIPELINE_COUNT)
        return glint_fail(err, GLINT_BAD_ARGUMENT, "no such backend, gate or pipeline");
    glint_backend *created = calloc(1, sizeof *created);
    if (created == NULL)
        return glint_fail(err, GLINT_NO_MEMORY, "no memory for a backend");
    created->config = *config;
    glint_status status =
        config->kind == GLINT_BACKEND_RTL ? create_circuit(created, err) : GLINT_OK;
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

static void shade_real(glint_gate gate, const glint_material *material, const uint32_t *cos_code,
                       size_t count, uint32_t *w_code, uint8_t *r, uint8_t *g, uint8_t *b)
{
    for (size_t i = 0; i < count; i++) {
        double w = glint_specular_real(gate, material->n, cos_code[i]);
        if (w_code != NULL)
            w_code[i] = round_half_up(w * GLINT_W_ONE);
        r[i] = (uint8_t)round_half_up(w * material->r);
        g[i] = (uint8_t)round_half_up(w * material->g);
        b[i] = (uint8_t)round_half_up(w * material->b);
    }
}

void glint_backend_set_watch(glint_backend *backend, glint_backend_watch *watch)
{
    backend->watch = watch;
}

/* What came of a run; w may be NULL. */
typedef struct shaded {
    const uint32_t *w;
    const uint8_t *r, *g, *b;
} shaded;

static uint32_t value_of(const shaded *of, glint_answer_value value, size_t i)
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

static glint_setting setting_of(const glint_backend *backend)
{
    return (glint_setting){.specular = backend->circuit};
}

/* Notes the first answer that is not the model's. */
static void compare_run(const glint_backend *backend, const glint_material *material,
                        const uint32_t *cos_code, size_t count, const shaded *model,
                        const shaded *rtl)
{
    glint_backend_watch *watch = backend->watch;
    for (size_t i = 0; i < count && !watch->found; i++)
        for (int v = 0; v < GLINT_ANSWER_VALUES && !watch->found; v++) {
            const glint_answer_value value = (glint_answer_value)v;
            if (value_of(model, value, i) == value_of(rtl, value, i))
                continue;
            watch->found = true;
            watch->setting = setting_of(backend);
            glint_answer_keep_points(&watch->answer, backend->circuit.lanes, material, cos_code,
                                     count, i);
            watch->answer.value = value;
            watch->answer.model = (int32_t)value_of(model, value, i);
            watch->answer.rtl = (int32_t)value_of(rtl, value, i);
        }
}

static glint_status watch_run(const glint_backend *backend, const glint_material *material,
                              const uint32_t *cos_code, size_t count, const shaded *rtl,
                              glint_error *err)
{
    uint32_t *w = rtl->w != NULL ? malloc(count * sizeof *w) : NULL;
    uint8_t *colors = malloc(3 * count);
    if (colors == NULL || (w == NULL && rtl->w != NULL)) {
        free(w);
        free(colors);
        return glint_fail(err, GLINT_NO_MEMORY, "no memory to hold a run against the model");
    }
    const glint_status status =
        glint_specular_batch(backend->config.gate, material, cos_code, count, w, colors,
                             colors + count, colors + 2 * count);
    if (status == GLINT_OK)
        compare_run(backend, material, cos_code, count,
                    &(shaded){w, colors, colors + count, colors + 2 * count}, rtl);
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

static glint_status shade_rtl(glint_backend *backend, const glint_material *material,
                              const uint32_t *cos_code, size_t count, uint32_t *w_code, uint8_t *r,
                              uint8_t *g, uint8_t *b, glint_error *err)
{
    const glint_setting setting = setting_of(backend);
    const bool watched = is_watched(backend) && count != 0;
    if (watched)
        glint_history_add(
            &backend->history, &setting,
            &(glint_batch){.material = material, .cos_code = cos_code, .count = count});
    glint_status status =
        glint_rtl_batch(backend->rtl, material, cos_code, count, w_code, r, g, b, err);
    if (status == GLINT_OK && watched)
        status = watch_run(backend, material, cos_code, count, &(shaded){w_code, r, g, b}, err);
    if (watched && (backend->watch->found || status == GLINT_DEVICE_FAULT))
        give_history(backend);
    return status;
}

glint_status glint_backend_shade(glint_backend *backend, const glint_material *material,
                                 const uint32_t *cos_code, size_t count, uint32_t *w_code,
                                 uint8_t *r, uint8_t *g, uint8_t *b, glint_error *err)
{
    const glint_gate gate = backend->config.gate;
    if (material->n > GLINT_N_MAX)
        return glint_fail(err, GLINT_BAD_ARGUMENT, "n = %u is not in 0…%u", material->n,
                          GLINT_N_MAX);
    switch (backend->config.kind) {
    case GLINT_BACKEND_RTL:
        return shade_rtl(backend, material, cos_code, count, w_code, r, g, b, err);
    case GLINT_BACKEND_REAL:
        shade_real(gate, material, cos_code, count, w_code, r, g, b);
        return GLINT_OK;
    default:
        return glint_specular_batch(gate, material, cos_code, count, w_code, r, g, b);
    }
}

uint64_t glint_backend_clocks(const glint_backend *backend)
{
    return backend->rtl != NULL ? glint_rtl_clocks(backend->rtl) : 0;
}
