#include "wave/save_file.h"

#include <inttypes.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "file/new_file.h"

/* Trace flags of GTKWave's save files. */
#define SHOW_HEX         0x22u /* right-justified */
#define SHOW_DECIMAL     0x24u
#define SHOW_BINARY      0x28u
#define SHOW_SIGNED      0x420u
#define SHOW_FIXED_POINT 0x40000000u /* with [fpshift_count] */
#define SHOW_CURVE       0x88000u    /* analog steps, scaled to the whole file */
#define CURVE_HEIGHT     0x20000u    /* an empty row that the curve above grows into */
#define HEADING          0x200u
#define GROUP_BEGIN      0x800200u
#define GROUP_CLOSED     0x400000u
#define GROUP_END        0x1000200u

#define COLOR_NORMAL 0
#define COLOR_STAGE  2 /* orange */
#define COLOR_OUTPUT 3 /* yellow */

/* Pixels of GTKWave's wave area at the size written below, for the zoom that shows the window. */
#define WINDOW_WIDTH  1600
#define WINDOW_HEIGHT 1000
#define SIGNALS_WIDTH 400
#define WAVE_WIDTH    1130
#define ZOOM_FRAME    200
#define CURVE_ROWS    3 /* beside the curve's own */

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

static void write_heading(FILE *out, const char *title)
{
    fprintf(out, "@%x\n-%s\n", HEADING, title);
}

static void begin_closed_group(FILE *out, const char *title)
{
    fprintf(out, "@%x\n-%s\n", GROUP_BEGIN | GROUP_CLOSED, title);
}

static void end_group(FILE *out, const char *title)
{
    fprintf(out, "@%x\n-%s\n", GROUP_END, title);
}

static void write_trace(FILE *out, const char *scope, const char *name, int width, unsigned flags,
                        int color, int frac_bits)
{
    fprintf(out, "@%x\n", frac_bits > 0 ? flags | SHOW_FIXED_POINT : flags);
    if (color != COLOR_NORMAL)
        fprintf(out, "[color] %d\n", color);
    if (frac_bits > 0)
        fprintf(out, "[fpshift_count] %d\n", frac_bits);
    if (width > 1)
        fprintf(out, "%s%s[%d:0]\n", scope, name, width - 1);
    else
        fprintf(out, "%s%s\n", scope, name);
}

static int color_of(glint_signal_kind kind)
{
    return kind == GLINT_SIGNAL_STAGE    ? COLOR_STAGE
           : kind == GLINT_SIGNAL_OUTPUT ? COLOR_OUTPUT
                                         : COLOR_NORMAL;
}

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
        return SHOW_BINARY;
    return signal->is_signed ? SHOW_SIGNED : SHOW_DECIMAL;
}

static void write_signal(FILE *out, const glint_signal_info *signal)
{
    char scope[64] = "TOP.specular_device.";
    int width = signal->int_bits + signal->frac_bits;
    unsigned flags = flags_of(signal);
    if (signal->lane >= 0)
        (void)snprintf(scope, sizeof scope, "TOP.specular_device.lane[%d].u.", signal->lane);
    write_trace(out, scope, signal->name, width, flags, color_of(signal->kind), signal->frac_bits);
    if (!has_curve(signal))
        return;
    write_trace(out, scope, signal->name, width, flags | SHOW_CURVE, color_of(signal->kind),
                signal->frac_bits);
    for (int i = 0; i < CURVE_ROWS; i++)
        fprintf(out, "@%x\n-\n", CURVE_HEIGHT);
}

/* With pipeline drawn a stage is a wire and says nothing new. The saturated square differs from the
 * square, and the limit is needed in stage 3, with gate drawn only. */
static bool is_shown(const glint_specular_config *config, const glint_signal_info *signal)
{
    if (signal->kind == GLINT_SIGNAL_STAGE && config->pipeline == GLINT_PIPELINE_DRAWN)
        return strcmp(signal->name, "s1_valid") == 0;
    if (strcmp(signal->name, "sat10") == 0 || strcmp(signal->name, "s3_rom9") == 0)
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
    write_heading(out, "Clock and control");
    write_trace(out, top, "clk", 1, SHOW_BINARY, COLOR_NORMAL, 0);
    write_trace(out, top, "reset", 1, SHOW_BINARY, COLOR_NORMAL, 0);
    write_trace(out, top, "en", 1, SHOW_BINARY, COLOR_NORMAL, 0);
    write_heading(out, "Inputs 32 (cos), 18, 17 (n), colours");
    write_trace(out, top, "in_valid", config->lanes, SHOW_BINARY, COLOR_NORMAL, 0);
    /* Several lanes share the pins, so their bits are no single number. */
    write_trace(out, top, "cos", config->lanes * GLINT_COS_BITS,
                config->lanes == 1 ? SHOW_DECIMAL : SHOW_HEX, COLOR_NORMAL,
                config->lanes == 1 ? GLINT_COS_FRAC_BITS : 0);
    write_trace(out, top, "n_we", 1, SHOW_BINARY, COLOR_NORMAL, 0);
    write_trace(out, top, "n", GLINT_N_BITS, SHOW_DECIMAL, COLOR_NORMAL, 0);
    write_trace(out, top, "rgb_we", 1, SHOW_BINARY, COLOR_NORMAL, 0);
    write_trace(out, top, "r", GLINT_COLOR_BITS, SHOW_DECIMAL, COLOR_NORMAL, 0);
    write_trace(out, top, "g", GLINT_COLOR_BITS, SHOW_DECIMAL, COLOR_NORMAL, 0);
    write_trace(out, top, "b", GLINT_COLOR_BITS, SHOW_DECIMAL, COLOR_NORMAL, 0);
}

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

/* R, G, B on their way to stage 4: three copies of each, the same but later. */
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

/* Closed, to be opened by who wants to look. */
static void write_color_copies(FILE *out, const glint_specular_config *config)
{
    if (config->pipeline == GLINT_PIPELINE_DRAWN)
        return;
    begin_closed_group(out, "R, G, B in stages 2, 3, 4");
    write_signals(out, config, is_color_copy, NULL);
    end_group(out, "R, G, B in stages 2, 3, 4");
}

/* The other lanes do the same as lane 0: closed as well. */
static void write_lane(FILE *out, const glint_specular_config *config, int lane)
{
    char title[16];
    (void)snprintf(title, sizeof title, "Lane %d", lane);
    begin_closed_group(out, title);
    for (int i = 0; i < glint_specular_signal_count(config); i++) {
        glint_signal_info signal = glint_specular_signal_info(config, i);
        if (signal.lane == lane && is_shown(config, &signal))
            write_signal(out, &signal);
    }
    end_group(out, title);
}

static void write_body(FILE *out, const glint_specular_config *config)
{
    write_inputs(out, config);
    for (size_t i = 0; i < sizeof groups / sizeof groups[0]; i++) {
        write_heading(out, groups[i].title);
        write_signals(out, config, is_of_group, &groups[i]);
    }
    write_heading(out, "Outputs");
    write_signals(out, config, is_output, NULL);
    write_heading(out, "Valid bits, stage by stage");
    write_signals(out, config, is_valid_bit, NULL);
    write_color_copies(out, config);
    for (int lane = 1; lane < config->lanes; lane++)
        write_lane(out, config, lane);
}

static void write_header(FILE *out, const glint_wave_view *view)
{
    const char *slash = strrchr(view->waveform, '/');
    double shown = (double)(view->last_time - view->first_time);
    /* GTKWave's zoom: a frame of so many pixels shows 2^−zoom time units. */
    double zoom = -log2(shown * ZOOM_FRAME / WAVE_WIDTH);
    fprintf(out, "[*] Specular-colour device, gate %s, pipeline %s, %d lane%s\n",
            glint_gate_name(view->config->gate), glint_pipeline_name(view->config->pipeline),
            view->config->lanes, view->config->lanes == 1 ? "" : "s");
    fprintf(out, "[dumpfile] \"%s\"\n", slash != NULL ? slash + 1 : view->waveform);
    fprintf(out, "[timestart] %" PRIu64 "\n", view->first_time);
    fprintf(out, "[size] %d %d\n[pos] -1 -1\n", WINDOW_WIDTH, WINDOW_HEIGHT);
    fprintf(out, "*%f %" PRId64, zoom, view->marker_time);
    for (int i = 0; i < 26; i++) /* the named markers a…z: none */
        fprintf(out, " -1");
    fprintf(out, "\n[sst_width] 0\n[signals_width] %d\n[sst_expanded] 0\n", SIGNALS_WIDTH);
}

glint_status glint_wave_save_file(const glint_wave_view *view, const char *path, glint_error *err)
{
    glint_new_file *file;
    glint_status status = glint_new_file_open(path, &file, err);
    if (status != GLINT_OK)
        return status;
    FILE *out = glint_new_file_stream(file);
    write_header(out, view);
    write_body(out, view->config);
    return glint_new_file_commit(file, err);
}
