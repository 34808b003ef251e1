#include "lockstep/twin.h"

#include <stdlib.h>

struct glint_twin {
    glint_setting setting;
    int signal_count;
    glint_specular_device *specular; /* of the four, those of the setting's circuit */
    glint_rtl *specular_rtl;
    glint_divider_device *divider;
    glint_divider_rtl *divider_rtl;
};

static glint_status create_specular_rtl(glint_twin *twin, glint_error *err)
{
    const glint_setting *setting = &twin->setting;
    if (setting->specular_model != NULL)
        return glint_rtl_create_from(setting->specular_model, &setting->specular,
                                     &twin->specular_rtl, err);
    return glint_rtl_create(&setting->specular, &twin->specular_rtl, err);
}

static glint_status create_divider_rtl(glint_twin *twin, glint_error *err)
{
    const glint_setting *setting = &twin->setting;
    if (setting->divider_model != NULL)
        return glint_divider_rtl_create_from(setting->divider_model, &twin->divider_rtl, err);
    return glint_divider_rtl_create(setting->form, setting->shifts, &twin->divider_rtl, err);
}

static glint_status create_model(glint_twin *twin, glint_error *err)
{
    const glint_setting *setting = &twin->setting;
    const glint_status status =
        setting->is_divider
            ? glint_divider_device_create(setting->form, setting->shifts, &twin->divider)
            : glint_specular_device_create(&setting->specular, &twin->specular);
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
    created->signal_count = glint_setting_signal_count(setting);
    status = create_model(created, err);
    if (status == GLINT_OK && with_rtl)
        status = setting->is_divider ? create_divider_rtl(created, err)
                                     : create_specular_rtl(created, err);
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
    glint_specular_device_destroy(twin->specular);
    glint_rtl_destroy(twin->specular_rtl);
    glint_divider_device_destroy(twin->divider);
    glint_divider_rtl_destroy(twin->divider_rtl);
    free(twin);
}

void glint_twin_clock(glint_twin *twin, const glint_pins *pins)
{
    if (twin->setting.is_divider) {
        glint_divider_device_clock(twin->divider, &pins->divider);
        if (twin->divider_rtl != NULL)
            glint_divider_rtl_clock(twin->divider_rtl, &pins->divider);
    } else {
        glint_specular_device_clock(twin->specular, &pins->specular);
        if (twin->specular_rtl != NULL)
            glint_rtl_clock(twin->specular_rtl, &pins->specular);
    }
}

static void read_divider(const glint_twin *twin, uint64_t *model, uint64_t *rtl)
{
    for (int i = 0; i < twin->signal_count; i++) {
        model[i] = glint_divider_signal_bits(twin->divider, i);
        if (rtl != NULL)
            rtl[i] = glint_divider_rtl_signal_bits(twin->divider_rtl, i);
    }
}

static void read_specular(const glint_twin *twin, uint64_t *model, uint64_t *rtl)
{
    const glint_specular_signals *signals = glint_specular_device_signals(twin->specular);
    for (int i = 0; i < twin->signal_count; i++) {
        model[i] = glint_specular_signal_bits(&twin->setting.specular, signals, i);
        if (rtl != NULL)
            rtl[i] = glint_rtl_signal_bits(twin->specular_rtl, i);
    }
}

void glint_twin_read(const glint_twin *twin, uint64_t model[GLINT_SETTING_SIGNALS_MAX],
                     uint64_t rtl[GLINT_SETTING_SIGNALS_MAX])
{
    if (twin->setting.is_divider)
        read_divider(twin, model, rtl);
    else
        read_specular(twin, model, rtl);
}
