/* Pairs a C model with its Verilog behind one interface; see twin.h. */
#include "lockstep/twin.h"

#include <stdlib.h>

#include "circuit/model.h"
#include "rtl/rtl.h"

struct glint_twin {
    glint_setting setting;
    glint_signals signals;
    void *model;
    glint_rtl *rtl; /* NULL: the C model alone */
};

static glint_status create(const glint_setting *setting, bool with_rtl, glint_twin **twin,
                           glint_error *err)
{
    *twin = NULL;
    glint_status status = glint_setting_check(setting, err);
    if (status != GLINT_OK)
        return status;
    glint_twin *created = calloc(1, sizeof *created);
    if (created == NULL)
        return glint_fail(err, GLINT_NO_MEMORY, "not enough memory for a pair of circuits");
    created->setting = *setting;
    status = glint_signals_find(setting, &created->signals, err);
    if (status == GLINT_OK)
        status = glint_model_create(setting, &created->model, err);
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
    glint_model_destroy(&twin->setting, twin->model);
    glint_rtl_destroy(twin->rtl);
    free(twin);
}

const glint_signals *glint_twin_signals(const glint_twin *twin)
{
    return &twin->signals;
}

void glint_twin_clock(glint_twin *twin, const glint_pins *pins)
{
    glint_model_clock(&twin->setting, twin->model, pins);
    if (twin->rtl != NULL)
        glint_rtl_clock(twin->rtl, pins);
}

void glint_twin_settle(glint_twin *twin, const glint_pins *pins, uint64_t *rtl)
{
    glint_rtl_settle(twin->rtl, pins, rtl);
}

void glint_twin_read(const glint_twin *twin, uint64_t *model, uint64_t *rtl)
{
    glint_signals_read(&twin->signals, glint_model_signals(&twin->setting, twin->model), model);
    if (rtl != NULL)
        glint_rtl_read(twin->rtl, rtl);
}
