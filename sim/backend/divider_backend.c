/* The three ways to divide behind one interface. */
#include "backend/divider_backend.h"

#include <stdlib.h>

#include "circuit/circuits.h"

struct glint_divider_backend {
    glint_divider_config config;
    glint_rtl *rtl; /* kind rtl only */
    glint_backend_watch *watch;
    glint_history *history; /* since there is a watch, until that has found something */
};

static glint_setting setting_of(const glint_divider_config *config)
{
    glint_setting setting = glint_setting_divider(config->form, config->shifts);
    setting.verilog = config->verilog;
    return setting;
}

static glint_status create_circuit(glint_divider_backend *backend, glint_error *err)
{
    const glint_setting setting = setting_of(&backend->config);
    return glint_rtl_open(&setting, GLINT_RTL_FAST, &backend->rtl, err);
}

glint_status glint_divider_backend_create(const glint_divider_config *config,
                                          glint_divider_backend **backend, glint_error *err)
{
    *backend = NULL;
    if ((unsigned)config->kind >= GLINT_BACKEND_COUNT ||
        (unsigned)config->form >= GLINT_DIVIDER_FORM_COUNT)
        return glint_fail(err, GLINT_BAD_ARGUMENT, "unknown divider backend");
    if (config->shifts < GLINT_DIVIDER_SHIFTS_MIN || config->shifts > GLINT_DIVIDER_SHIFTS_MAX)
        return glint_fail(err, GLINT_BAD_ARGUMENT, "the number of shifts, %d, is outside %d…%d",
                          config->shifts, GLINT_DIVIDER_SHIFTS_MIN, GLINT_DIVIDER_SHIFTS_MAX);
    glint_divider_backend *created = calloc(1, sizeof *created);
    if (created == NULL)
        return glint_fail(err, GLINT_NO_MEMORY, "not enough memory for a divider");
    created->config = *config;
    const glint_status status =
        config->kind == GLINT_BACKEND_RTL ? create_circuit(created, err) : GLINT_OK;
    if (status != GLINT_OK) {
        free(created);
        return status;
    }
    *backend = created;
    return GLINT_OK;
}

void glint_divider_backend_destroy(glint_divider_backend *backend)
{
    if (backend == NULL)
        return;
    glint_rtl_destroy(backend->rtl);
    glint_history_destroy(backend->history);
    free(backend);
}

/* 2ⁿ·difference/k, rounded half up. */
static int32_t exact_quotient(int shifts, int32_t difference, int32_t k)
{
    int32_t numerator = 2 * difference * (1 << shifts) + k;
    int32_t denominator = 2 * k;
    int32_t cut = numerator / denominator;
    return numerator % denominator < 0 ? cut - 1 : cut; /* towards minus infinity */
}

static void divide_exactly(int shifts, const glint_division *divisions, size_t count,
                           glint_quotients *quotients)
{
    for (size_t i = 0; i < count; i++) {
        quotients[i].out_of_table = !glint_divider_in_table(divisions[i].k);
        for (int c = 0; c < GLINT_DIVIDER_COMPONENTS; c++)
            quotients[i].code[c] =
                quotients[i].out_of_table
                    ? 0
                    : exact_quotient(shifts, divisions[i].difference[c], divisions[i].k);
    }
}

void glint_divider_backend_set_watch(glint_divider_backend *backend, glint_backend_watch *watch)
{
    backend->watch = watch;
}

/* Notes the first quotient that is not the model's. */
static void compare_run(const glint_divider_backend *backend, const glint_division *divisions,
                        size_t count, const glint_quotients *model, const glint_quotients *rtl)
{
    glint_backend_watch *watch = backend->watch;
    for (size_t i = 0; i < count && !watch->found; i++)
        for (int c = 0; c < GLINT_DIVIDER_COMPONENTS && !watch->found; c++) {
            if (model[i].code[c] == rtl[i].code[c])
                continue;
            watch->found = true;
            watch->setting = setting_of(&backend->config);
            glint_answer_keep_divisions(&watch->answer, divisions, count, i);
            watch->answer.value = (glint_answer_value)(GLINT_ANSWER_R + c);
            watch->answer.model = model[i].code[c];
            watch->answer.rtl = rtl[i].code[c];
        }
}

static glint_status watch_run(const glint_divider_backend *backend, const glint_division *divisions,
                              size_t count, const glint_quotients *quotients, glint_error *err)
{
    glint_quotients *model = malloc(count * sizeof *model);
    if (model == NULL)
        return glint_fail(err, GLINT_NO_MEMORY,
                          "not enough memory to compare a run with the model");
    const glint_status status = glint_divide_batch(backend->config.shifts, divisions, count, model);
    if (status == GLINT_OK)
        compare_run(backend, divisions, count, model, quotients);
    free(model);
    return status;
}

static bool is_watched(const glint_divider_backend *backend)
{
    return backend->watch != NULL && !backend->watch->found;
}

static void give_history(glint_divider_backend *backend)
{
    backend->watch->history = backend->history;
    backend->history = NULL;
}

static glint_status divide_rtl(glint_divider_backend *backend, const glint_division *divisions,
                               size_t count, glint_quotients *quotients, glint_error *err)
{
    const glint_setting setting = setting_of(&backend->config);
    const bool watched = is_watched(backend) && count != 0;
    if (watched)
        glint_history_add(&backend->history, &setting,
                          &(glint_batch){.division = divisions, .count = count});
    glint_status status = glint_rtl_divide(backend->rtl, divisions, count, quotients, err);
    if (status == GLINT_OK && watched)
        status = watch_run(backend, divisions, count, quotients, err);
    if (watched && (backend->watch->found || status == GLINT_DEVICE_FAULT))
        give_history(backend);
    return status;
}

glint_status glint_divider_backend_divide(glint_divider_backend *backend,
                                          const glint_division *divisions, size_t count,
                                          glint_quotients *quotients, glint_error *err)
{
    const int shifts = backend->config.shifts;
    if (backend->config.kind == GLINT_BACKEND_REAL) {
        divide_exactly(shifts, divisions, count, quotients);
        return GLINT_OK;
    }
    if (backend->config.kind == GLINT_BACKEND_RTL)
        return divide_rtl(backend, divisions, count, quotients, err);
    if (glint_divide_batch(shifts, divisions, count, quotients) != GLINT_OK)
        return glint_fail(err, GLINT_BAD_ARGUMENT, "no divider with %d shifts", shifts);
    return GLINT_OK;
}

uint64_t glint_divider_backend_clocks(const glint_divider_backend *backend)
{
    return backend->rtl != NULL ? glint_rtl_clocks(backend->rtl) : 0;
}
