#include "wave/save_file.h"

#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "wave/presentation.h"

#define TOP    "TOP.specular_device."
#define OF_ONE 64 /* characters of a lane's scope */

static void lane_scope(int lane, char scope[OF_ONE])
{
    if (lane < 0)
        (void)snprintf(scope, OF_ONE, TOP);
    else
        (void)snprintf(scope, OF_ONE, TOP "lane[%d].u.", lane);
}

/* A lane's name is of use where there are several. */
static const char *place_of(const glint_specular_config *config)
{
    return config->lanes > 1 ? "lane" : NULL;
}

static void add_signal(glint_gtkw *rows, const glint_specular_config *config,
                       const glint_signal_info *signal)
{
    char scope[OF_ONE], label[GLINT_SHOW_LABEL];
    lane_scope(signal->lane, scope);
    glint_show_label(signal, place_of(config), "", label);
    glint_gtkw_trace trace = {.scope = scope,
                              .name = signal->name,
                              .label = label,
                              .width = signal->int_bits + signal->frac_bits,
                              .flags = glint_show_number(signal),
                              .color = glint_show_color(signal),
                              .frac_bits = signal->frac_bits};
    glint_gtkw_add(rows, &trace);
    if (!glint_show_curve(signal))
        return;
    trace.flags |= GLINT_GTKW_SHOW_CURVE;
    glint_gtkw_add(rows, &trace);
    glint_gtkw_curve_height(rows);
}

/* With pipeline combinational a stage is a wire and says nothing new. The saturated square differs
 * from the square, and the limit is needed in stage 2, with gate drawn only. */
static bool is_shown(const glint_specular_config *config, const glint_signal_info *signal)
{
    if (signal->kind == GLINT_SIGNAL_STAGE && config->pipeline == GLINT_PIPELINE_COMBINATIONAL)
        return strcmp(signal->name, "s1_valid") == 0;
    if (strcmp(signal->name, "sat10") == 0 || strcmp(signal->name, "s2_rom9") == 0)
        return config->gate == GLINT_GATE_DRAWN;
    return true;
}

static void add_pin(glint_gtkw *rows, const char *name, int width, unsigned flags)
{
    const glint_gtkw_trace trace = {
        .scope = TOP, .name = name, .label = name, .width = width, .flags = flags};
    glint_gtkw_add(rows, &trace);
}

/* The cosine of one lane: the pins of several are one wide vector, and no number. */
static void add_cosine(glint_gtkw *rows, const glint_specular_config *config, int lane)
{
    const glint_signal_info cosine = {
        .name = "cos", .int_bits = 1, .frac_bits = GLINT_COS_FRAC_BITS, .lane = lane};
    char scope[OF_ONE], label[GLINT_SHOW_LABEL];
    lane_scope(lane, scope);
    glint_show_label(&cosine, place_of(config), "", label);
    const glint_gtkw_trace trace = {.scope = scope,
                                    .name = cosine.name,
                                    .label = label,
                                    .width = GLINT_COS_BITS,
                                    .flags = glint_show_number(&cosine),
                                    .frac_bits = cosine.frac_bits};
    glint_gtkw_add(rows, &trace);
}

static void add_inputs(glint_gtkw *rows, const glint_specular_config *config)
{
    glint_gtkw_heading(rows, GLINT_SHOW_INPUTS);
    add_pin(rows, "clk", 1, GLINT_GTKW_SHOW_BINARY);
    add_pin(rows, "reset", 1, GLINT_GTKW_SHOW_BINARY);
    add_pin(rows, "en", 1, GLINT_GTKW_SHOW_BINARY);
    add_pin(rows, "in_valid", config->lanes, GLINT_GTKW_SHOW_BINARY);
    add_cosine(rows, config, 0);
    add_pin(rows, "n_we", 1, GLINT_GTKW_SHOW_BINARY);
    add_pin(rows, "n", GLINT_N_BITS, GLINT_GTKW_SHOW_DECIMAL);
    add_pin(rows, "rgb_we", 1, GLINT_GTKW_SHOW_BINARY);
    add_pin(rows, "r", GLINT_COLOR_BITS, GLINT_GTKW_SHOW_DECIMAL);
    add_pin(rows, "g", GLINT_COLOR_BITS, GLINT_GTKW_SHOW_DECIMAL);
    add_pin(rows, "b", GLINT_COLOR_BITS, GLINT_GTKW_SHOW_DECIMAL);
}

/* The signals of the device and of lane 0 under one heading. */
static void add_signals(glint_gtkw *rows, const glint_specular_config *config, int section)
{
    for (int i = 0; i < glint_specular_signal_count(config); i++) {
        const glint_signal_info signal = glint_specular_signal_info(config, i);
        if (signal.lane <= 0 && is_shown(config, &signal) &&
            glint_show_specular_section(&signal) == section)
            add_signal(rows, config, &signal);
    }
}

static void add_section(glint_gtkw *rows, const glint_specular_config *config, int section)
{
    const char *title = glint_show_specular_title(section);
    if (!glint_show_specular_folded(section)) {
        glint_gtkw_heading(rows, title);
        add_signals(rows, config, section);
    } else if (config->pipeline != GLINT_PIPELINE_COMBINATIONAL) {
        glint_gtkw_begin_closed_group(rows, title);
        add_signals(rows, config, section);
        glint_gtkw_end_group(rows, title);
    }
}

/* The other lanes do the same as lane 0: folded. */
static void add_lane(glint_gtkw *rows, const glint_specular_config *config, int lane)
{
    char title[16];
    (void)snprintf(title, sizeof title, "Lane %d", lane);
    glint_gtkw_begin_closed_group(rows, title);
    add_cosine(rows, config, lane);
    for (int i = 0; i < glint_specular_signal_count(config); i++) {
        const glint_signal_info signal = glint_specular_signal_info(config, i);
        if (signal.lane == lane && is_shown(config, &signal))
            add_signal(rows, config, &signal);
    }
    glint_gtkw_end_group(rows, title);
}

static void fill(glint_gtkw *rows, const void *context)
{
    const glint_specular_config *config = context;
    add_inputs(rows, config);
    for (int i = 0; i < glint_show_specular_sections(); i++)
        add_section(rows, config, i);
    for (int lane = 1; lane < config->lanes; lane++)
        add_lane(rows, config, lane);
}

glint_status glint_wave_save_file(const glint_wave_view *view, const char *path, glint_error *err)
{
    char title[128];
    (void)snprintf(title, sizeof title, "Specular-colour device, gate %s, pipeline %s, %d lane%s",
                   glint_gate_name(view->config->gate), glint_pipeline_name(view->config->pipeline),
                   view->config->lanes, view->config->lanes == 1 ? "" : "s");
    return glint_gtkw_write(path, title, &view->window, fill, view->config, err);
}
