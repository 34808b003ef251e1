#include "lockstep/setting.h"

#include <stdio.h>

static glint_status check_specular(const glint_specular_config *config, glint_error *err)
{
    if (glint_gate_name(config->gate) == NULL || glint_pipeline_name(config->pipeline) == NULL)
        return glint_fail(err, GLINT_BAD_ARGUMENT,
                          "there is no gate number %d with pipeline number %d", (int)config->gate,
                          (int)config->pipeline);
    if (config->lanes < 1 || config->lanes > GLINT_LANES_MAX ||
        (config->lanes & (config->lanes - 1)) != 0)
        return glint_fail(err, GLINT_BAD_ARGUMENT, "%d lanes: there are 1, 2, 4, 8 or 16",
                          config->lanes);
    return GLINT_OK;
}

glint_status glint_setting_check(const glint_setting *setting, glint_error *err)
{
    if (!setting->is_divider)
        return check_specular(&setting->specular, err);
    if (glint_divider_form_name(setting->form) == NULL)
        return glint_fail(err, GLINT_BAD_ARGUMENT, "there is no divider of form number %d",
                          (int)setting->form);
    if (setting->shifts < GLINT_DIVIDER_SHIFTS_MIN || setting->shifts > GLINT_DIVIDER_SHIFTS_MAX)
        return glint_fail(err, GLINT_BAD_ARGUMENT, "%d shifts are not in %d to %d", setting->shifts,
                          GLINT_DIVIDER_SHIFTS_MIN, GLINT_DIVIDER_SHIFTS_MAX);
    return GLINT_OK;
}

int glint_setting_signal_count(const glint_setting *setting)
{
    return setting->is_divider ? glint_divider_signal_count(setting->form, setting->shifts)
                               : glint_specular_signal_count(&setting->specular);
}

glint_signal_info glint_setting_signal(const glint_setting *setting, int index)
{
    return setting->is_divider ? glint_divider_signal_info(setting->form, setting->shifts, index)
                               : glint_specular_signal_info(&setting->specular, index);
}

const char *glint_setting_lane_name(const glint_setting *setting)
{
    return setting->is_divider ? "stage" : "lane";
}

int glint_setting_latency(const glint_setting *setting)
{
    return setting->is_divider ? glint_divider_latency(setting->shifts)
                               : glint_specular_latency(setting->specular.pipeline);
}

void glint_setting_describe(const glint_setting *setting, char text[GLINT_SETTING_TEXT])
{
    const glint_specular_config *config = &setting->specular;
    if (setting->is_divider)
        (void)snprintf(text, GLINT_SETTING_TEXT, "divider %s, %d shifts",
                       glint_divider_form_name(setting->form), setting->shifts);
    else
        (void)snprintf(text, GLINT_SETTING_TEXT, "gate %s, pipeline %s, lanes %d",
                       glint_gate_name(config->gate), glint_pipeline_name(config->pipeline),
                       config->lanes);
}

void glint_setting_name(const glint_setting *setting, char text[GLINT_SETTING_TEXT])
{
    const glint_specular_config *config = &setting->specular;
    if (setting->is_divider)
        (void)snprintf(text, GLINT_SETTING_TEXT, "divider_%s_%d",
                       glint_divider_form_name(setting->form), setting->shifts);
    else
        (void)snprintf(text, GLINT_SETTING_TEXT, "specular_%s_%s_%d", glint_gate_name(config->gate),
                       glint_pipeline_name(config->pipeline), config->lanes);
}

void glint_setting_options(const glint_setting *setting, char text[GLINT_SETTING_OPTIONS])
{
    const glint_specular_config *config = &setting->specular;
    if (setting->is_divider)
        (void)snprintf(text, GLINT_SETTING_OPTIONS, "--circuit divider --form %s --shifts %d",
                       glint_divider_form_name(setting->form), setting->shifts);
    else
        (void)snprintf(
            text, GLINT_SETTING_OPTIONS, "--circuit specular --gate %s --pipeline %s --lanes %d",
            glint_gate_name(config->gate), glint_pipeline_name(config->pipeline), config->lanes);
}
