/* The save file of a failure's waveform. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "failure/wave.h"
#include "failure/wave_signals.h"
#include "wave/presentation.h"

/* A heading, and behind it the lane. */
#define TITLE (GLINT_SHOW_LABEL + 64)

/* The groups of a circuit's signals: some dozen, or that many a lane. */
typedef struct groups {
    const glint_capture *capture;
    int count;
    int of_signal[GLINT_SIGNAL_WORDS_MAX];
    int first_differing[GLINT_SIGNAL_WORDS_MAX]; /* of the capture's clocks; its count: none */
    char title[GLINT_SIGNAL_WORDS_MAX][TITLE];
} groups;

/* Whether the heading is of one signal a lane: here it stands among its lane's. */
static bool is_of_every_lane(const glint_circuit *circuit, const char *title)
{
    for (int i = 0; i < circuit->heading_count; i++)
        if (strcmp(circuit->headings[i].title, title) == 0)
            return circuit->headings[i].every_lane != 0;
    return false;
}

static void title_of(const glint_setting *setting, const glint_signal_info *signal,
                     char title[TITLE])
{
    const char *heading = signal->heading;
    if (heading != NULL && signal->lane >= 0 && is_of_every_lane(setting->circuit, heading))
        heading = NULL;
    if (heading == NULL && signal->lane >= 0)
        glint_show_lane_title(setting, signal->lane, title);
    else if (heading == NULL)
        (void)snprintf(title, TITLE, "Signals");
    else if (signal->lane >= 0 && glint_show_place(setting) != NULL)
        (void)snprintf(title, TITLE, "%s, %s %d", heading, glint_setting_lane_name(setting),
                       signal->lane);
    else
        (void)snprintf(title, TITLE, "%s", heading);
}

/* The first clock in which a signal differs; the count of clocks when in none. */
static int first_differing(const glint_capture *capture, int index)
{
    int i = 0;
    while (i < capture->count && !glint_capture_differs_at(capture, i, index))
        i++;
    return i;
}

static void find_groups(groups *all, const glint_capture *capture)
{
    all->capture = capture;
    for (int i = 0; i < capture->signals.count; i++) {
        char title[TITLE];
        int group = 0;
        title_of(&capture->setting, &capture->signals.info[i], title);
        while (group < all->count && strcmp(all->title[group], title) != 0)
            group++;
        if (group == all->count) {
            (void)snprintf(all->title[group], TITLE, "%s", title);
            all->first_differing[group] = capture->count;
            all->count++;
        }
        all->of_signal[i] = group;
        const int first = first_differing(capture, i);
        if (first < all->first_differing[group])
            all->first_differing[group] = first;
    }
}

static void scope_of(const glint_setting *setting, int lane, char scope[64])
{
    if (lane < 0)
        (void)snprintf(scope, 64, "TOP.");
    else
        (void)snprintf(scope, 64, "TOP.%.32s[%d].", glint_setting_lane_name(setting), lane);
}

/* What the rows of one signal or pin have in common. */
typedef struct subject {
    const glint_setting *setting;
    const glint_signal_info *signal;
} subject;

/* The variable behind whose name the endings stand, in `row`, which has the rest. */
static void add_row(glint_gtkw *rows, const subject *subject, const char *side, const char *ending,
                    glint_gtkw_trace row)
{
    char scope[64], name[GLINT_SHOW_LABEL], both[32], label[GLINT_SHOW_LABEL];
    scope_of(subject->setting, subject->signal->lane, scope);
    (void)snprintf(both, sizeof both, "%s%s", side, ending);
    (void)snprintf(name, sizeof name, "%s%s", subject->signal->name, both);
    glint_show_label(subject->signal, glint_show_place(subject->setting), both, label);
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

/* Both sides of a signal and, if it ever differs, where. */
static void add_signal(glint_gtkw *rows, const glint_capture *capture, int index)
{
    const subject subject = {&capture->setting, &capture->signals.info[index]};
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
    for (int i = 0; i < glint_setting_pin_count(setting); i++) {
        const glint_pin_info pin = glint_setting_pin(setting, i);
        const glint_signal_info signal = glint_show_pin(&pin);
        const subject subject = {setting, &signal};
        add_code(rows, &subject, "", GLINT_GTKW_COLOR_NORMAL);
        add_number(rows, &subject, "", GLINT_GTKW_COLOR_NORMAL);
    }
}

static void add_group(glint_gtkw *rows, const groups *all, int group)
{
    for (int i = 0; i < all->capture->signals.count; i++)
        if (all->of_signal[i] == group)
            add_signal(rows, all->capture, i);
}

static void add_own(glint_gtkw *rows, const glint_setting *setting, glint_failure_own which,
                    int width, unsigned flags, int color)
{
    const char *name = glint_failure_own_name(setting, which);
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
    add_own(rows, &all->capture->setting, GLINT_FAILURE_MISMATCH, 1, GLINT_GTKW_SHOW_BINARY,
            GLINT_GTKW_COLOR_RED);
    add_own(rows, &all->capture->setting, GLINT_FAILURE_CLOCK, GLINT_FAILURE_CLOCK_BITS,
            GLINT_GTKW_SHOW_DECIMAL, GLINT_GTKW_COLOR_NORMAL);
    add_own(rows, &all->capture->setting, GLINT_FAILURE_CLK, 1, GLINT_GTKW_SHOW_BINARY,
            GLINT_GTKW_COLOR_NORMAL);
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
    char setting[GLINT_SETTING_TEXT], title[GLINT_SETTING_TEXT + 64];
    const glint_failure_times times = glint_failure_times_of(capture);
    const glint_gtkw_window window = {.waveform = waveform,
                                      .first_time = times.first,
                                      .last_time = times.end,
                                      .marker_time = (int64_t)times.marker};
    groups *all = calloc(1, sizeof *all);
    if (all == NULL)
        return glint_fail(err, GLINT_NO_MEMORY, "not enough memory for the groups of a save file");
    find_groups(all, capture);
    glint_setting_describe(&capture->setting, setting);
    (void)snprintf(title, sizeof title, "Model against Verilog: %s", setting);
    const glint_status status = glint_gtkw_write(path, title, &window, fill, all, err);
    free(all);
    return status;
}
