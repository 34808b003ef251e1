/* The save file of a failure's waveform. */
#include <stdio.h>
#include <string.h>

#include "failure/pins.h"
#include "failure/wave.h"
#include "failure/wave_signals.h"
#include "file/new_file.h"
#include "wave/divider_wave.h"
#include "wave/gtkw.h"
#include "wave/save_file.h"

/* Clocks about the failing one that are in sight at first, wide enough for their values. */
#define SHOWN_BEFORE 8
#define SHOWN_AFTER  6

#define TITLE 96

/* The groups of a circuit's signals: some dozen, or that many a lane. */
typedef struct groups {
    const glint_capture *capture;
    int count;
    int of_signal[GLINT_SETTING_SIGNALS_MAX];
    int first_differing[GLINT_SETTING_SIGNALS_MAX]; /* of the capture's clocks; its count: none */
    char title[GLINT_SETTING_SIGNALS_MAX][TITLE];
} groups;

static void title_of(const glint_setting *setting, int index, char title[TITLE])
{
    const glint_signal_info signal = glint_setting_signal(setting, index);
    if (setting->is_divider && signal.lane >= 0)
        (void)snprintf(title, TITLE, "Stage %d", signal.lane);
    else if (setting->is_divider)
        (void)snprintf(title, TITLE, "%s",
                       glint_divider_heading(setting->form, setting->shifts, index));
    else if (signal.lane >= 0 && setting->specular.lanes > 1)
        (void)snprintf(title, TITLE, "%s: lane %d", glint_wave_heading(&signal), signal.lane);
    else
        (void)snprintf(title, TITLE, "%s", glint_wave_heading(&signal));
}

/* The first clock in which a signal differs; the count of clocks when in none. */
static int first_differing(const glint_capture *capture, int index)
{
    int i = 0;
    while (i < capture->count && capture->clock[i].rtl[index] == capture->clock[i].model[index])
        i++;
    return i;
}

static void find_groups(groups *all, const glint_capture *capture)
{
    memset(all, 0, sizeof *all);
    all->capture = capture;
    for (int i = 0; i < glint_setting_signal_count(&capture->setting); i++) {
        char title[TITLE];
        int group = 0;
        title_of(&capture->setting, i, title);
        while (group < all->count && strcmp(all->title[group], title) != 0)
            group++;
        if (group == all->count) {
            memcpy(all->title[group], title, TITLE);
            all->first_differing[group] = capture->count;
            all->count++;
        }
        all->of_signal[i] = group;
        const int first = first_differing(capture, i);
        if (first < all->first_differing[group])
            all->first_differing[group] = first;
    }
}

static void scope_of(const glint_setting *setting, int lane, char scope[32])
{
    if (lane < 0)
        (void)snprintf(scope, 32, "TOP.");
    else
        (void)snprintf(scope, 32, "TOP.%s[%d].", glint_setting_lane_name(setting), lane);
}

static unsigned flags_of(int width, bool is_signed)
{
    return width == 1  ? GLINT_GTKW_SHOW_BINARY
           : is_signed ? GLINT_GTKW_SHOW_SIGNED
                       : GLINT_GTKW_SHOW_DECIMAL;
}

static void write_side(FILE *out, const char *scope, const glint_signal_info *signal,
                       const char *ending, int color)
{
    char name[64];
    const int width = signal->int_bits + signal->frac_bits;
    (void)snprintf(name, sizeof name, "%s%s", signal->name, ending);
    glint_gtkw_trace(out, scope, name, width, flags_of(width, signal->is_signed != 0), color,
                     signal->frac_bits);
}

/* Both sides of a signal; of one that differs, where it does. */
static void write_signal(FILE *out, const glint_capture *capture, int index)
{
    char scope[32], name[64];
    const glint_signal_info signal = glint_setting_signal(&capture->setting, index);
    const bool differs = glint_capture_differs(capture, index);
    scope_of(&capture->setting, signal.lane, scope);
    write_side(out, scope, &signal, GLINT_FAILURE_RTL,
               differs ? GLINT_GTKW_COLOR_RED : GLINT_GTKW_COLOR_NORMAL);
    write_side(out, scope, &signal, GLINT_FAILURE_MODEL, GLINT_GTKW_COLOR_NORMAL);
    if (!differs)
        return;
    (void)snprintf(name, sizeof name, "%s%s", signal.name, GLINT_FAILURE_DIFFERS);
    glint_gtkw_trace(out, scope, name, 1, GLINT_GTKW_SHOW_BINARY, GLINT_GTKW_COLOR_RED, 0);
}

static void write_pins(FILE *out, const glint_setting *setting)
{
    glint_gtkw_heading(out, "Inputs");
    for (int i = 0; i < glint_pin_count(setting); i++) {
        char scope[32];
        const glint_pin_info pin = glint_pin(setting, i);
        scope_of(setting, pin.lane, scope);
        glint_gtkw_trace(out, scope, pin.name, pin.width,
                         strcmp(pin.name, "in_valid") == 0 ? GLINT_GTKW_SHOW_BINARY
                                                           : flags_of(pin.width, pin.is_signed),
                         GLINT_GTKW_COLOR_NORMAL, pin.frac_bits);
    }
}

static void write_group(FILE *out, const groups *all, int group)
{
    for (int i = 0; i < glint_setting_signal_count(&all->capture->setting); i++)
        if (all->of_signal[i] == group)
            write_signal(out, all->capture, i);
}

static void write_body(FILE *out, const groups *all)
{
    glint_gtkw_heading(out, "Model and Verilog differ");
    glint_gtkw_trace(out, "TOP.", "mismatch", 1, GLINT_GTKW_SHOW_BINARY, GLINT_GTKW_COLOR_RED, 0);
    glint_gtkw_trace(out, "TOP.", "clock", GLINT_FAILURE_CLOCK_BITS, GLINT_GTKW_SHOW_DECIMAL,
                     GLINT_GTKW_COLOR_NORMAL, 0);
    glint_gtkw_trace(out, "TOP.", "clk", 1, GLINT_GTKW_SHOW_BINARY, GLINT_GTKW_COLOR_NORMAL, 0);
    for (int clock = 0; clock < all->capture->count; clock++)
        for (int g = 0; g < all->count; g++)
            if (all->first_differing[g] == clock) {
                glint_gtkw_heading(out, all->title[g]);
                write_group(out, all, g);
            }
    write_pins(out, &all->capture->setting);
    for (int g = 0; g < all->count; g++) {
        if (all->first_differing[g] < all->capture->count)
            continue;
        glint_gtkw_begin_closed_group(out, all->title[g]);
        write_group(out, all, g);
        glint_gtkw_end_group(out, all->title[g]);
    }
}

static glint_gtkw_window window_of(const glint_capture *capture, const char *waveform)
{
    const uint64_t failing = capture->clock[capture->failing].clock;
    const uint64_t oldest = capture->clock[0].clock;
    const uint64_t first = failing > oldest + SHOWN_BEFORE ? failing - SHOWN_BEFORE : oldest;
    return (glint_gtkw_window){.waveform = waveform,
                               .first_time =
                                   first * GLINT_RTL_TRACE_PERIOD - GLINT_RTL_TRACE_PERIOD / 2,
                               .last_time = (failing + SHOWN_AFTER) * GLINT_RTL_TRACE_PERIOD,
                               .marker_time = (int64_t)(failing * GLINT_RTL_TRACE_PERIOD)};
}

glint_status glint_failure_write_save_file(const glint_capture *capture, const char *waveform,
                                           const char *path, glint_error *err)
{
    char setting[GLINT_SETTING_TEXT], title[128];
    groups all;
    glint_new_file *file;
    const glint_gtkw_window window = window_of(capture, waveform);
    const glint_status status = glint_new_file_open(path, &file, err);
    if (status != GLINT_OK)
        return status;
    find_groups(&all, capture);
    glint_setting_describe(&capture->setting, setting);
    (void)snprintf(title, sizeof title, "Model against Verilog: %s", setting);
    glint_gtkw_header(glint_new_file_stream(file), title, &window);
    write_body(glint_new_file_stream(file), &all);
    return glint_new_file_commit(file, err);
}
