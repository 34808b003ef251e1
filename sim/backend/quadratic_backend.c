/* The two ways to walk spans behind one interface. */
#include "backend/quadratic_backend.h"

#include <stdlib.h>

#include "circuit/circuits.h"

struct glint_quadratic_backend {
    glint_quadratic_config config;
    glint_rtl *rtl; /* kind rtl only */
    glint_backend_watch *watch;
    glint_history *history; /* since there is a watch, until that has found something */
};

static glint_setting setting_of(const glint_quadratic_config *config)
{
    glint_setting setting = glint_setting_span(config->fraction);
    setting.verilog = config->verilog;
    return setting;
}

glint_status glint_quadratic_backend_create(const glint_quadratic_config *config,
                                            glint_quadratic_backend **backend, glint_error *err)
{
    *backend = NULL;
    if (config->kind != GLINT_BACKEND_C && config->kind != GLINT_BACKEND_RTL)
        return glint_fail(err, GLINT_BAD_ARGUMENT, "spans are walked by backends c and rtl only");
    if (config->fraction < GLINT_QUADRATIC_SPAN_FRACTION_MIN ||
        config->fraction > GLINT_QUADRATIC_SPAN_FRACTION_MAX)
        return glint_fail(err, GLINT_BAD_ARGUMENT,
                          "the number of fraction bits, %d, is outside %d…%d", config->fraction,
                          GLINT_QUADRATIC_SPAN_FRACTION_MIN, GLINT_QUADRATIC_SPAN_FRACTION_MAX);
    glint_quadratic_backend *created = calloc(1, sizeof *created);
    if (created == NULL)
        return glint_fail(err, GLINT_NO_MEMORY, "not enough memory for a span unit");
    created->config = *config;
    const glint_setting setting = setting_of(config);
    const glint_status status = config->kind == GLINT_BACKEND_RTL
                                    ? glint_rtl_open(&setting, GLINT_RTL_FAST, &created->rtl, err)
                                    : GLINT_OK;
    if (status != GLINT_OK) {
        free(created);
        return status;
    }
    *backend = created;
    return GLINT_OK;
}

void glint_quadratic_backend_destroy(glint_quadratic_backend *backend)
{
    if (backend == NULL)
        return;
    glint_rtl_destroy(backend->rtl);
    glint_history_destroy(backend->history);
    free(backend);
}

void glint_quadratic_backend_set_watch(glint_quadratic_backend *backend, glint_backend_watch *watch)
{
    backend->watch = watch;
}

static void walk_model(int fraction, const glint_spans *spans, uint8_t *rgb)
{
    for (size_t i = 0; i < spans->count; i++) {
        (void)glint_quadratic_span(fraction, &spans->walk[i], spans->length[i], rgb);
        rgb += GLINT_QUADRATIC_SPAN_COMPONENTS * (size_t)spans->length[i];
    }
}

/* ---- Watched --------------------------------------------------------------------------------- */

/* A run clock by clock, and what the model makes of it; both NULL without memory. */
typedef struct watched {
    size_t pixels;
    glint_span_step *step;
    uint8_t *model;
} watched;

static void free_watched(watched *w)
{
    free(w->step);
    free(w->model);
}

static bool begin_watched(const glint_spans *spans, watched *w)
{
    for (size_t i = 0; i < spans->count; i++)
        w->pixels += spans->length[i];
    w->step = calloc(w->pixels, sizeof *w->step);
    w->model = malloc(GLINT_QUADRATIC_SPAN_COMPONENTS * w->pixels);
    if (w->step == NULL || w->model == NULL)
        return false;
    size_t at = 0;
    for (size_t i = 0; i < spans->count; i++)
        for (uint32_t k = 0; k < spans->length[i]; k++)
            w->step[at++] = (glint_span_step){k == 0, spans->walk[i]};
    return true;
}

/* Notes the first intensity that is not the model's. */
static void compare(const glint_quadratic_backend *backend, const watched *w, const uint8_t *rgb)
{
    glint_backend_watch *watch = backend->watch;
    for (size_t i = 0; i < GLINT_QUADRATIC_SPAN_COMPONENTS * w->pixels && !watch->found; i++) {
        if (w->model[i] == rgb[i])
            continue;
        watch->found = true;
        watch->setting = setting_of(&backend->config);
        glint_answer_keep_steps(&watch->answer, backend->config.fraction, w->step, w->pixels,
                                i / GLINT_QUADRATIC_SPAN_COMPONENTS);
        watch->answer.value =
            (glint_answer_value)(GLINT_ANSWER_R + (int)(i % GLINT_QUADRATIC_SPAN_COMPONENTS));
        watch->answer.model = w->model[i];
        watch->answer.rtl = rgb[i];
    }
}

static glint_status walk_watched(glint_quadratic_backend *backend, const glint_spans *spans,
                                 const watched *w, glint_error *err)
{
    glint_backend_watch *watch = backend->watch;
    const glint_setting setting = setting_of(&backend->config);
    glint_history_add(&backend->history, &setting,
                      &(glint_batch){.step = w->step, .count = w->pixels});
    const glint_status status = glint_rtl_walk(backend->rtl, spans, err);
    walk_model(backend->config.fraction, spans, w->model);
    if (status == GLINT_OK)
        compare(backend, w, spans->rgb);
    if (watch->found || status == GLINT_DEVICE_FAULT) {
        watch->history = backend->history;
        backend->history = NULL;
    }
    return status;
}

glint_status glint_quadratic_backend_walk(glint_quadratic_backend *backend,
                                          const glint_spans *spans, glint_error *err)
{
    if (backend->config.kind == GLINT_BACKEND_C) {
        walk_model(backend->config.fraction, spans, spans->rgb);
        return GLINT_OK;
    }
    if (backend->watch == NULL || backend->watch->found || spans->count == 0)
        return glint_rtl_walk(backend->rtl, spans, err);
    watched w = {0};
    const glint_status status =
        begin_watched(spans, &w)
            ? walk_watched(backend, spans, &w, err)
            : glint_fail(err, GLINT_NO_MEMORY, "not enough memory to compare a run with the model");
    free_watched(&w);
    return status;
}

uint64_t glint_quadratic_backend_clocks(const glint_quadratic_backend *backend)
{
    return backend->rtl != NULL ? glint_rtl_clocks(backend->rtl) : 0;
}
