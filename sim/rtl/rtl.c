/* Chooses the Verilated build for the settings asked for, and reads its signals by name. */
#include "rtl/rtl.h"

#include <errno.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "rtl/places.h"
#include "rtl/rtl_model.h"

struct glint_rtl {
    const glint_rtl_model *model;
    void *instance;
    glint_signal_place *places;
};

/* The builds: GLINT_RTL_MODELS(X) is X(table) for each, written by the Makefile. */
#include "rtl_models.h"

#define DECLARE_TABLE(table) extern const glint_rtl_model table;
GLINT_RTL_MODELS(DECLARE_TABLE)

#define POINT_AT_TABLE(table) &table,
static const glint_rtl_model *const models[] = {GLINT_RTL_MODELS(POINT_AT_TABLE)};

static const glint_rtl_model *find_model(const glint_specular_config *config, bool observed)
{
    for (size_t i = 0; i < sizeof models / sizeof models[0]; i++) {
        const glint_specular_config *built = &models[i]->config;
        if (built->gate == config->gate && built->pipeline == config->pipeline &&
            built->lanes == config->lanes && models[i]->observed == observed)
            return models[i];
    }
    return NULL;
}

static glint_status find_places(glint_rtl *rtl, glint_error *err)
{
    const glint_specular_config *config = &rtl->model->config;
    int count = glint_specular_signal_count(config);
    rtl->places = calloc((size_t)count, sizeof *rtl->places);
    if (rtl->places == NULL)
        return glint_fail(err, GLINT_NO_MEMORY, "no memory for the circuit's signals");
    for (int i = 0; i < count; i++) {
        glint_signal_info info = glint_specular_signal_info(config, i);
        glint_signal_place *place = &rtl->places[i];
        if (!rtl->model->find(rtl->instance, info.lane, info.name, &place->data, &place->size))
            return glint_fail(err, GLINT_DEVICE_FAULT, "the circuit has no signal %s (lane %d)",
                              info.name, info.lane);
        place->mask = glint_signal_mask(&info);
    }
    return GLINT_OK;
}

glint_status glint_rtl_create_from(const glint_rtl_model *model,
                                   const glint_specular_config *config, glint_rtl **rtl,
                                   glint_error *err)
{
    *rtl = NULL;
    if (model == NULL) {
        const char *gate = glint_gate_name(config->gate);
        const char *pipeline = glint_pipeline_name(config->pipeline);
        return glint_fail(err, GLINT_BAD_ARGUMENT,
                          "no circuit was built for gate %s, pipeline %s, %d lanes",
                          gate != NULL ? gate : "unknown", pipeline != NULL ? pipeline : "unknown",
                          config->lanes);
    }
    glint_rtl *created = calloc(1, sizeof *created);
    if (created == NULL)
        return glint_fail(err, GLINT_NO_MEMORY, "no memory for a circuit");
    created->model = model;
    created->instance = model->create();
    glint_status status = created->instance == NULL
                              ? glint_fail(err, GLINT_NO_MEMORY, "no memory for a circuit")
                          : model->observed ? find_places(created, err)
                                            : GLINT_OK;
    if (status != GLINT_OK) {
        glint_rtl_destroy(created);
        return status;
    }
    *rtl = created;
    return GLINT_OK;
}

glint_status glint_rtl_create(const glint_specular_config *config, glint_rtl **rtl,
                              glint_error *err)
{
    return glint_rtl_create_from(find_model(config, true), config, rtl, err);
}

glint_status glint_rtl_create_fast(const glint_specular_config *config, glint_rtl **rtl,
                                   glint_error *err)
{
    const glint_rtl_model *fast = find_model(config, false);
    if (fast == NULL)
        return glint_rtl_create(config, rtl, err);
    return glint_rtl_create_from(fast, config, rtl, err);
}

void glint_rtl_destroy(glint_rtl *rtl)
{
    if (rtl == NULL)
        return;
    if (rtl->instance != NULL)
        rtl->model->destroy(rtl->instance);
    free(rtl->places);
    free(rtl);
}

void glint_rtl_clock(glint_rtl *rtl, const glint_specular_inputs *inputs)
{
    rtl->model->clock(rtl->instance, inputs);
}

uint64_t glint_rtl_signal_bits(const glint_rtl *rtl, int index)
{
    return glint_signal_read(&rtl->places[index]);
}

uint64_t glint_rtl_clocks(const glint_rtl *rtl)
{
    return rtl->model->clocks(rtl->instance);
}

glint_status glint_rtl_batch(glint_rtl *rtl, const glint_material *material,
                             const uint32_t *cos_code, size_t count, uint32_t *w_code, uint8_t *r,
                             uint8_t *g, uint8_t *b, glint_error *err)
{
    const glint_rtl_batch_io io = {cos_code, count, w_code, r, g, b};
    if (material->n > GLINT_N_MAX)
        return glint_fail(err, GLINT_BAD_ARGUMENT, "n = %u is not in 0…%u", material->n,
                          GLINT_N_MAX);
    size_t done = rtl->model->batch(rtl->instance, material, &io);
    if (done != count)
        return glint_fail(err, GLINT_DEVICE_FAULT, "the circuit returned %zu of %zu results", done,
                          count);
    return GLINT_OK;
}

glint_status glint_rtl_trace_open(glint_rtl *rtl, const char *path, glint_error *err)
{
    errno = 0;
    if (!rtl->model->trace_open(rtl->instance, path))
        return glint_fail(err, GLINT_IO_ERROR, "%s: cannot write a waveform: %s", path,
                          errno != 0 ? strerror(errno) : "unknown cause");
    return GLINT_OK;
}

void glint_rtl_trace_close(glint_rtl *rtl)
{
    rtl->model->trace_close(rtl->instance);
}

const glint_specular_config *glint_rtl_built(int index)
{
    for (size_t i = 0; i < sizeof models / sizeof models[0]; i++)
        if (models[i]->observed && index-- == 0)
            return &models[i]->config;
    return NULL;
}

const char *glint_rtl_verilator_version(void)
{
    return GLINT_VERILATOR_VERSION;
}
