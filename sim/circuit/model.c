/* The C model of a setting: the two ways that a circuit has one; see model.h. */
#include "circuit/model.h"

#include <stdlib.h>

#include "circuit/guard.h"

static glint_status begin(const glint_setting *setting, void **model)
{
    const glint_circuit *circuit = setting->circuit;
    *model = calloc(1, circuit->model_size);
    if (*model == NULL)
        return GLINT_NO_MEMORY;
    if (circuit->begin != NULL)
        circuit->begin(setting->values, *model);
    return GLINT_OK;
}

glint_status glint_model_create(const glint_setting *setting, void **model, glint_error *err)
{
    const glint_circuit *circuit = setting->circuit;
    *model = NULL;
    glint_guard_enter();
    const glint_status status =
        circuit->create != NULL ? circuit->create(setting->values, model) : begin(setting, model);
    glint_guard_leave();
    if (status != GLINT_OK)
        *model = NULL; /* create() may leave here what it has freed */
    if (status == GLINT_NO_MEMORY)
        return glint_fail(err, status, "no memory for the C model");
    if (status != GLINT_OK)
        return glint_fail(err, status, "create() of the C model returns the error %d", (int)status);
    if (*model == NULL)
        return glint_fail(err, GLINT_BAD_INPUT, "create() leaves no C model behind");
    return GLINT_OK;
}

void glint_model_destroy(const glint_setting *setting, void *model)
{
    if (model == NULL)
        return;
    glint_guard_enter();
    if (setting->circuit->destroy != NULL)
        setting->circuit->destroy(model);
    else
        free(model);
    glint_guard_leave();
}

void glint_model_clock(const glint_setting *setting, void *model, const void *pins)
{
    glint_guard_enter();
    setting->circuit->clock(model, pins);
    glint_guard_leave();
}

const void *glint_model_signals(const glint_setting *setting, const void *model)
{
    return setting->circuit->signals != NULL ? setting->circuit->signals(model) : model;
}
