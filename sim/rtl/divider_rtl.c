/* Chooses the Verilated divider asked for, and reads its signals by name. */
#include "rtl/divider_rtl.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "rtl/divider_model.h"
#include "rtl/places.h"
#include "rtl_models.h" /* written by the Makefile: GLINT_DIVIDER_MODELS(X) */

struct glint_divider_rtl {
    const glint_divider_model *model;
    void *instance;
    glint_signal_place *places;
};

#define DECLARE_TABLE(table) extern const glint_divider_model table;
GLINT_DIVIDER_MODELS(DECLARE_TABLE)

#define POINT_AT_TABLE(table) &table,
static const glint_divider_model *const models[] = {GLINT_DIVIDER_MODELS(POINT_AT_TABLE)};

static glint_status find_places(glint_divider_rtl *rtl, glint_error *err)
{
    const glint_divider_model *model = rtl->model;
    int count = glint_divider_signal_count(model->form, model->shifts);
    rtl->places = calloc((size_t)count, sizeof *rtl->places);
    if (rtl->places == NULL)
        return glint_fail(err, GLINT_NO_MEMORY, "no memory for the circuit's signals");
    for (int i = 0; i < count; i++) {
        glint_signal_info info = glint_divider_signal_info(model->form, model->shifts, i);
        glint_signal_place *place = &rtl->places[i];
        if (!model->find(rtl->instance, info.lane, info.name, &place->data, &place->size))
            return glint_fail(err, GLINT_DEVICE_FAULT, "the divider has no signal %s (stage %d)",
                              info.name, info.lane);
        place->mask = glint_signal_mask(&info);
    }
    return GLINT_OK;
}

glint_status glint_divider_rtl_create_from(const glint_divider_model *model,
                                           glint_divider_rtl **rtl, glint_error *err)
{
    *rtl = NULL;
    glint_divider_rtl *created = calloc(1, sizeof *created);
    if (created == NULL)
        return glint_fail(err, GLINT_NO_MEMORY, "no memory for a divider");
    created->model = model;
    created->instance = model->create();
    glint_status status = created->instance == NULL
                              ? glint_fail(err, GLINT_NO_MEMORY, "no memory for a divider")
                              : find_places(created, err);
    if (status != GLINT_OK) {
        glint_divider_rtl_destroy(created);
        return status;
    }
    *rtl = created;
    return GLINT_OK;
}

glint_status glint_divider_rtl_create(glint_divider_form form, int shifts, glint_divider_rtl **rtl,
                                      glint_error *err)
{
    for (size_t i = 0; i < sizeof models / sizeof models[0]; i++)
        if (models[i]->form == form && models[i]->shifts == shifts)
            return glint_divider_rtl_create_from(models[i], rtl, err);
    *rtl = NULL;
    const char *name = glint_divider_form_name(form);
    return glint_fail(err, GLINT_BAD_ARGUMENT, "no divider of form %s was built for %d shifts",
                      name != NULL ? name : "unknown", shifts);
}

void glint_divider_rtl_destroy(glint_divider_rtl *rtl)
{
    if (rtl == NULL)
        return;
    if (rtl->instance != NULL)
        rtl->model->destroy(rtl->instance);
    free(rtl->places);
    free(rtl);
}

void glint_divider_rtl_clock(glint_divider_rtl *rtl, const glint_divider_inputs *inputs)
{
    rtl->model->clock(rtl->instance, inputs);
}

uint64_t glint_divider_rtl_signal_bits(const glint_divider_rtl *rtl, int index)
{
    return glint_signal_read(&rtl->places[index]);
}

uint64_t glint_divider_rtl_clocks(const glint_divider_rtl *rtl)
{
    return rtl->model->clocks(rtl->instance);
}

glint_status glint_divider_rtl_batch(glint_divider_rtl *rtl, const glint_division *divisions,
                                     size_t count, glint_quotients *quotients, glint_error *err)
{
    size_t done = rtl->model->batch(rtl->instance, divisions, count, quotients);
    if (done != count)
        return glint_fail(err, GLINT_DEVICE_FAULT, "the divider returned %zu of %zu quotients",
                          done, count);
    return GLINT_OK;
}

glint_status glint_divider_rtl_trace_open(glint_divider_rtl *rtl, const char *path,
                                          glint_error *err)
{
    errno = 0;
    if (!rtl->model->trace_open(rtl->instance, path))
        return glint_fail(err, GLINT_IO_ERROR, "%s: cannot write a waveform: %s", path,
                          errno != 0 ? strerror(errno) : "unknown cause");
    return GLINT_OK;
}

void glint_divider_rtl_trace_close(glint_divider_rtl *rtl)
{
    rtl->model->trace_close(rtl->instance);
}
