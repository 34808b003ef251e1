#include "wave/save_file.h"

#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "file/new_file.h"
#include "wave/gtkw.h"

typedef struct group {
    const char *title;
    int blocks[4]; /* numbers of the figure, ended by 0 */
} group;

/* The figure's blocks as the data flows through them. A heading takes one row where a group that
 * can be folded takes two: the whole circuit is to be seen at once. */
static const group groups[] = {
    {"Register 1: cos gamma", {1}},
    {"Register 2, ROM 33: n, sigma", {2, 33}},
    {"Blocks 6, 7, 8: sigma (cos - 1) + 1", {6, 7, 8}},
    {"ROM 9, comparator 11: inside?", {9, 11}},
    {"Multiplier 10, key block 12: W", {10, 12}},
    {"Registers 3, 4, 5: R, G, B", {3, 4, 5}},
    {"Multipliers 13, 14, 15: W R, W G, W B", {13, 14, 15}},
};

/* The signals drawn as curves too: the highlight's shape, inside the device and at its output. */
static const char *const curves[] = {"keys12", "out_r"};

static bool has_curve(const glint_signal_info *signal)
{
    for (size_t i = 0; i < sizeof curves / sizeof curves[0]; i++)
        if (strcmp(signal->name, curves[i]) == 0)
            return true;
    return false;
}

static unsigned flags_of(const glint_signal_info *signal)
{
    int width = signal->int_bits + signal->frac_bits;
    if (width == 1 || signal->block == 0) /* valid bits: one a lane */
        return GLINT_GTKW_SHOW_BINARY;
    return signal->is_signed ? GLINT_GTKW_SHOW_SIGNED : GLINT_GTKW_SHOW_DECIMAL;
}

static void write_signal(FILE *out, const glint_signal_info *signal)
{
    char scope[64] = "TOP.specular_device.";
    int width = signal->int_bits + signal->frac_bits;
    unsigned flags = flags_of(signal);
    if (signal->lane >= 0)
        (void)snprintf(scope, sizeof scope, "TOP.specular_device.lane[%d].u.", signal->lane);
    glint_gtkw_trace(out, scope, signal->name, width, flags, glint_gtkw_color(signal->kind),
                     signal->frac_bits);
    if (!has_curve(signal))
        return;
    glint_gtkw_trace(out, scope, signal->name, width, flags | GLINT_GTKW_SHOW_CURVE,
                     glint_gtkw_color(signal->kind), signal->frac_bits);
    glint_gtkw_curve_height(out);
}

/* With pipeline drawn a stage is a wire and says nothing new. The saturated square differs from the
 * square, and the limit is needed in stage 2, with gate drawn only. */
static bool is_shown(const glint_specular_config *config, const glint_signal_info *signal)
{
    if (signal->kind == GLINT_SIGNAL_STAGE && config->pipeline == GLINT_PIPELINE_DRAWN)
        return strcmp(signal->name, "s1_valid") == 0;
    if (strcmp(signal->name, "sat10") == 0 || strcmp(signal->name, "s2_rom9") == 0)
        return config->gate == GLINT_GATE_DRAWN;
    return true;
}

static bool is_in_group(const group *group, const glint_signal_info *signal)
{
    for (int i = 0; i < 4 && group->blocks[i] != 0; i++)
        if (group->blocks[i] == signal->block)
            return true;
    return false;
}

static void write_inputs(FILE *out, const glint_specular_config *config)
{
    const char *top = "TOP.specular_device.";
    glint_gtkw_heading(out, "Clock and control");
    glint_gtkw_trace(out, top, "clk", 1, GLINT_GTKW_SHOW_BINARY, GLINT_GTKW_COLOR_NORMAL, 0);
    glint_gtkw_trace(out, top, "reset", 1, GLINT_GTKW_SHOW_BINARY, GLINT_GTKW_COLOR_NORMAL, 0);
    glint_gtkw_trace(out, top, "en", 1, GLINT_GTKW_SHOW_BINARY, GLINT_GTKW_COLOR_NORMAL, 0);
    glint_gtkw_heading(out, "Inputs 32 (cos), 18, 17 (n), colours");
    glint_gtkw_trace(out, top, "in_valid", config->lanes, GLINT_GTKW_SHOW_BINARY,
                     GLINT_GTKW_COLOR_NORMAL, 0);
    /* Several lanes share the pins, so their bits are no single number. */
    glint_gtkw_trace(out, top, "cos", config->lanes * GLINT_COS_BITS,
                     config->lanes == 1 ? GLINT_GTKW_SHOW_DECIMAL : GLINT_GTKW_SHOW_HEX,
                     GLINT_GTKW_COLOR_NORMAL, config->lanes == 1 ? GLINT_COS_FRAC_BITS : 0);
    glint_gtkw_trace(out, top, "n_we", 1, GLINT_GTKW_SHOW_BINARY, GLINT_GTKW_COLOR_NORMAL, 0);
    glint_gtkw_trace(out, top, "n", GLINT_N_BITS, GLINT_GTKW_SHOW_DECIMAL, GLINT_GTKW_COLOR_NORMAL,
                     0);
    glint_gtkw_trace(out, top, "rgb_we", 1, GLINT_GTKW_SHOW_BINARY, GLINT_GTKW_COLOR_NORMAL, 0);
    glint_gtkw_trace(out, top, "r", GLINT_COLOR_BITS, GLINT_GTKW_SHOW_DECIMAL,
                     GLINT_GTKW_COLOR_NORMAL, 0);
    glint_gtkw_trace(out, top, "g", GLINT_COLOR_BITS, GLINT_GTKW_SHOW_DECIMAL,
                     GLINT_GTKW_COLOR_NORMAL, 0);
    glint_gtkw_trace(out, top, "b", GLINT_COLOR_BITS, GLINT_GTKW_SHOW_DECIMAL,
                     GLINT_GTKW_COLOR_NORMAL, 0);
}

static const char outputs_title[] = "Outputs";
static const char valid_bits_title[] = "Valid bits, stage by stage";
static const char color_copies_title[] = "R, G, B in stages 2, 3";

typedef bool is_wanted(const glint_signal_info *signal, const void *context);

/* The signals of the device and of lane 0 that are wanted, in the order the data flows. */
static void write_signals(FILE *out, const glint_specular_config *config, is_wanted *wanted,
                          const void *context)
{
    for (int i = 0; i < glint_specular_signal_count(config); i++) {
        glint_signal_info signal = glint_specular_signal_info(config, i);
        if (signal.lane <= 0 && is_shown(config, &signal) && wanted(&signal, context))
            write_signal(out, &signal);
    }
}

/* R, G, B on their way to stage 3: two copies of each, the same but later. */
static bool is_color_copy(const glint_signal_info *signal, const void *context)
{
    (void)context;
    return signal->kind == GLINT_SIGNAL_STAGE && signal->block >= 3 && signal->block <= 5;
}

static bool is_of_group(const glint_signal_info *signal, const void *context)
{
    return signal->kind != GLINT_SIGNAL_OUTPUT && !is_color_copy(signal, NULL) &&
           is_in_group(context, signal);
}

static bool is_output(const glint_signal_info *signal, const void *context)
{
    (void)context;
    return signal->kind == GLINT_SIGNAL_OUTPUT;
}

static bool is_valid_bit(const glint_signal_info *signal, const void *context)
{
    (void)context;
    return signal->block == 0 && signal->kind == GLINT_SIGNAL_STAGE;
}

const char *glint_wave_heading(const glint_signal_info *signal)
{
    if (is_output(signal, NULL))
        return outputs_title;
    if (is_valid_bit(signal, NULL))
        return valid_bits_title;
    if (is_color_copy(signal, NULL))
        return color_copies_title;
    size_t i = 0;
    while (!is_in_group(&groups[i], signal))
        i++;
    return groups[i].title;
}

/* Closed, to be opened by who wants to look. */
static void write_color_copies(FILE *out, const glint_specular_config *config)
{
    if (config->pipeline == GLINT_PIPELINE_DRAWN)
        return;
    glint_gtkw_begin_closed_group(out, color_copies_title);
    write_signals(out, config, is_color_copy, NULL);
    glint_gtkw_end_group(out, color_copies_title);
}

/* The other lanes do the same as lane 0: closed as well. */
static void write_lane(FILE *out, const glint_specular_config *config, int lane)
{
    char title[16];
    (void)snprintf(title, sizeof title, "Lane %d", lane);
    glint_gtkw_begin_closed_group(out, title);
    for (int i = 0; i < glint_specular_signal_count(config); i++) {
        glint_signal_info signal = glint_specular_signal_info(config, i);
        if (signal.lane == lane && is_shown(config, &signal))
            write_signal(out, &signal);
    }
    glint_gtkw_end_group(out, title);
}

static void write_body(FILE *out, const glint_specular_config *config)
{
    write_inputs(out, config);
    for (size_t i = 0; i < sizeof groups / sizeof groups[0]; i++) {
        glint_gtkw_heading(out, groups[i].title);
        write_signals(out, config, is_of_group, &groups[i]);
    }
    glint_gtkw_heading(out, outputs_title);
    write_signals(out, config, is_output, NULL);
    glint_gtkw_heading(out, valid_bits_title);
    write_signals(out, config, is_valid_bit, NULL);
    write_color_copies(out, config);
    for (int lane = 1; lane < config->lanes; lane++)
        write_lane(out, config, lane);
}

glint_status glint_wave_save_file(const glint_wave_view *view, const char *path, glint_error *err)
{
    glint_new_file *file;
    glint_status status = glint_new_file_open(path, &file, err);
    if (status != GLINT_OK)
        return status;
    FILE *out = glint_new_file_stream(file);
    char title[128];
    (void)snprintf(title, sizeof title, "Specular-colour device, gate %s, pipeline %s, %d lane%s",
                   glint_gate_name(view->config->gate), glint_pipeline_name(view->config->pipeline),
                   view->config->lanes, view->config->lanes == 1 ? "" : "s");
    glint_gtkw_header(out, title, &view->window);
    write_body(out, view->config);
    return glint_new_file_commit(file, err);
}
