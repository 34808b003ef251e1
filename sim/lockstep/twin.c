/* Pairs a C model with its Verilog behind one interface; see twin.h. */
#include "lockstep/twin.h"

#include <stdlib.h>

#include "rtl/rtl.h"

struct glint_twin {
    glint_setting setting;
    glint_signals signals;
    void *model;
    glint_rtl *rtl; /* NULL: the C model alone */
};

static glint_status create_model(glint_twin *twin, glint_error *err)
{
    const glint_setting *setting = &twin->setting;
    const glint_status status = setting->circuit->create(setting->values, &twin->model);
    if (status != GLINT_OK)
        return glint_fail(err, status, "cannot create the C model of these settings");
    return GLINT_OK;
}

static glint_status create(const glint_setting *setting, bool with_rtl, glint_twin **twin,
                           glint_error *err)
{
    *twin = NULL;
    glint_status status = glint_setting_check(setting, err);
    if (status != GLINT_OK)
        return status;
    glint_twin *created = calloc(1, sizeof *created);
    if (created == NULL)
        return glint_fail(err, GLINT_NO_MEMORY, "no memory for a pair of circuits");
    created->setting = *setting;
    status = glint_signals_find(setting, &created->signals, err);
    if (status == GLINT_OK)
        status = create_model(created, err);
    if (status == GLINT_OK && with_rtl)
        status = glint_rtl_open(setting, GLINT_RTL_OBSERVED, &created->rtl, err);
    if (status != GLINT_OK) {
        glint_twin_destroy(created);
        return status;
    }
    *twin = created;
    return GLINT_OK;
}

glint_status glint_twin_create(const glint_setting *setting, glint_twin **twin, glint_error *err)
{
    return create(setting, true, twin, err);
}

glint_status glint_twin_create_model(const glint_setting *setting, glint_twin **twin,
                                     glint_error *err)
{
    return create(setting, false, twin, err);
}

void glint_twin_destroy(glint_twin *twin)
{
    if (twin == NULL)
        return;
    if (twin->model != NULL)
        twin->setting.circuit->destroy(twin->model);
    glint_rtl_destroy(twin->rtl);
    free(twin);
}

const glint_signals *glint_twin_signals(const glint_twin *twin)
{
    return &twin->signals;
}

void glint_twin_clock(glint_twin *twin, const glint_pins *pins)
{
    twin->setting.circuit->clock(twin->model, pins);
    if (twin->rtl != NULL)
        glint_rtl_clock(twin->rtl, pins);
}

void glint_twin_read(const glint_twin *twin, uint64_t *model, uint64_t *rtl)
{
    glint_signals_read(&twin->signals, twin->setting.circuit->signals(twin->model), model);
    if (rtl != NULL)
        glint_rtl_read(twin->rtl, rtl);
}
