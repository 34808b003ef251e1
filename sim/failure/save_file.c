/* The save file of a failure's waveform. */
#include <stdio.h>
#include <string.h>

#include "failure/pins.h"
#include "failure/wave.h"
#include "failure/wave_signals.h"
#include "wave/presentation.h"

#define TITLE 64

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
    const char *of_specular = setting->is_divider
                                  ? NULL
                                  : glint_show_specular_title(glint_show_specular_section(&signal));
    if (setting->is_divider && signal.lane >= 0)
        (void)snprintf(title, TITLE, "Stage %d", signal.lane);
    else if (setting->is_divider)
        (void)snprintf(title, TITLE, "%s",
                       glint_show_divider_title(setting->form, setting->shifts, index));
    else if (signal.lane >= 0 && setting->specular.lanes > 1)
        (void)snprintf(title, TITLE, "%s, lane %d", of_specular, signal.lane);
    else
        (void)snprintf(title, TITLE, "%s", of_specular);
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

/* What the rows of one signal or pin have in common. */
typedef struct subject {
    const glint_setting *setting;
    const glint_signal_info *signal;
} subject;

/* The lane's or stage's name, where there are several. */
static const char *place_of(const glint_setting *setting)
{
    return setting->is_divider || setting->specular.lanes > 1 ? glint_setting_lane_name(setting)
                                                              : NULL;
}

/* The variable behind whose name the endings stand, in `row`, which has the rest. */
static void add_row(glint_gtkw *rows, const subject *subject, const char *side, const char *ending,
                    glint_gtkw_trace row)
{
    char scope[32], name[GLINT_SHOW_LABEL], both[32], label[GLINT_SHOW_LABEL];
    scope_of(subject->setting, subject->signal->lane, scope);
    (void)snprintf(both, sizeof both, "%s%s", side, ending);
    (void)snprintf(name, sizeof name, "%s%s", subject->signal->name, both);
    glint_show_label(subject->signal, place_of(subject->setting), both, label);
    row.scope = scope;
    row.name = name;
    row.label = label;
    glint_gtkw_add(rows, &row);
}

static void add_code(glint_gtkw *rows, const subject *subject, const char *side, int color)
{
    const glint_signal_info *signal = subject->signal;
    add_row(rows, subject, side, "",
            (glint_gtkw_trace){.width = signal->int_bits + signal->frac_bits,
                               .flags = glint_show_code(signal),
                               .color = color});
}

/* The number of a fixed-point code, from the waveform: GTKWave's own leaves out a fraction below
 * 0.0001. */
static void add_number(glint_gtkw *rows, const subject *subject, const char *side, int color)
{
    const glint_signal_info *signal = subject->signal;
    if (signal->frac_bits > 0)
        add_row(rows, subject, side, GLINT_FAILURE_REAL,
                (glint_gtkw_trace){.width = signal->int_bits + signal->frac_bits,
                                   .flags = GLINT_GTKW_SHOW_HEX,
                                   .color = color,
                                   .frac_bits = signal->frac_bits,
                                   .is_text = true});
}

/* Both sides of a signal; of one that differs, where it does. */
static void add_signal(glint_gtkw *rows, const glint_capture *capture, int index)
{
    const glint_signal_info signal = glint_setting_signal(&capture->setting, index);
    const subject subject = {&capture->setting, &signal};
    const bool differs = glint_capture_differs(capture, index);
    const int color = differs ? GLINT_GTKW_COLOR_RED : GLINT_GTKW_COLOR_NORMAL;
    add_code(rows, &subject, GLINT_FAILURE_RTL, color);
    add_code(rows, &subject, GLINT_FAILURE_MODEL, GLINT_GTKW_COLOR_NORMAL);
    if (differs)
        add_row(rows, &subject, GLINT_FAILURE_DIFFERS, "",
                (glint_gtkw_trace){.width = 1, .flags = GLINT_GTKW_SHOW_BINARY, .color = color});
    add_number(rows, &subject, GLINT_FAILURE_RTL, color);
    if (differs) /* else the two numbers are the same */
        add_number(rows, &subject, GLINT_FAILURE_MODEL, GLINT_GTKW_COLOR_NORMAL);
}

static void add_pins(glint_gtkw *rows, const glint_setting *setting)
{
    glint_gtkw_heading(rows, GLINT_SHOW_INPUTS);
    for (int i = 0; i < glint_pin_count(setting); i++) {
        const glint_pin_info pin = glint_pin(setting, i);
        const glint_signal_info signal = {.name = pin.name,
                                          .int_bits = pin.width - pin.frac_bits,
                                          .frac_bits = pin.frac_bits,
                                          .is_signed = pin.is_signed,
                                          .lane = pin.lane};
        const subject subject = {setting, &signal};
        add_code(rows, &subject, "", GLINT_GTKW_COLOR_NORMAL);
        add_number(rows, &subject, "", GLINT_GTKW_COLOR_NORMAL);
    }
}

static void add_group(glint_gtkw *rows, const groups *all, int group)
{
    for (int i = 0; i < glint_setting_signal_count(&all->capture->setting); i++)
        if (all->of_signal[i] == group)
            add_signal(rows, all->capture, i);
}

static void add_top(glint_gtkw *rows, const char *name, int width, unsigned flags, int color)
{
    const glint_gtkw_trace trace = {.scope = "TOP.",
                                    .name = name,
                                    .label = name,
                                    .width = width,
                                    .flags = flags,
                                    .color = color};
    glint_gtkw_add(rows, &trace);
}

static void fill(glint_gtkw *rows, const void *context)
{
    const groups *all = context;
    glint_gtkw_heading(rows, "Model and Verilog differ");
    add_top(rows, "mismatch", 1, GLINT_GTKW_SHOW_BINARY, GLINT_GTKW_COLOR_RED);
    add_top(rows, "clock", GLINT_FAILURE_CLOCK_BITS, GLINT_GTKW_SHOW_DECIMAL,
            GLINT_GTKW_COLOR_NORMAL);
    add_top(rows, "clk", 1, GLINT_GTKW_SHOW_BINARY, GLINT_GTKW_COLOR_NORMAL);
    for (int clock = 0; clock < all->capture->count; clock++)
        for (int g = 0; g < all->count; g++)
            if (all->first_differing[g] == clock) {
                glint_gtkw_heading(rows, all->title[g]);
                add_group(rows, all, g);
            }
    add_pins(rows, &all->capture->setting);
    for (int g = 0; g < all->count; g++) {
        if (all->first_differing[g] < all->capture->count)
            continue;
        glint_gtkw_begin_closed_group(rows, all->title[g]);
        add_group(rows, all, g);
        glint_gtkw_end_group(rows, all->title[g]);
    }
}

glint_status glint_failure_write_save_file(const glint_capture *capture, const char *waveform,
                                           const char *path, glint_error *err)
{
    char setting[GLINT_SETTING_TEXT], title[128];
    groups all;
    const glint_failure_times times = glint_failure_times_of(capture);
    const glint_gtkw_window window = {.waveform = waveform,
                                      .first_time = times.first,
                                      .last_time = times.end,
                                      .marker_time = (int64_t)times.marker};
    find_groups(&all, capture);
    glint_setting_describe(&capture->setting, setting);
    (void)snprintf(title, sizeof title, "Model against Verilog: %s", setting);
    return glint_gtkw_write(path, title, &window, fill, &all, err);
}
