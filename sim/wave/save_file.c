/* The content of a circuit's save file: which rows, in which groups. */
#include "wave/save_file.h"

#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "wave/presentation.h"

#define SCOPE_TEXT 256
#define TITLE_TEXT 256

/* Appends to a text until it is full. */
typedef struct scope {
    char text[SCOPE_TEXT];
    size_t used;
} scope;

static void append(scope *to, const char *text, size_t length)
{
    const size_t room = SCOPE_TEXT - 1 - to->used;
    const size_t taken = length < room ? length : room;
    memcpy(to->text + to->used, text, taken);
    to->used += taken;
    to->text[to->used] = '\0';
}

static void append_lane(scope *to, const char *lane_scope, int lane)
{
    char number[16];
    const char *place = strstr(lane_scope, "%d");
    if (place == NULL) {
        append(to, lane_scope, strlen(lane_scope));
    } else {
        (void)snprintf(number, sizeof number, "%d", lane);
        append(to, lane_scope, (size_t)(place - lane_scope));
        append(to, number, strlen(number));
        append(to, place + 2, strlen(place + 2));
    }
    append(to, ".", 1);
}

/* The scope below "TOP.top.", and of a lane its own, that a path leads to, with a dot behind it.
 * Returns the path's last component. */
static const char *place_in(const glint_setting *setting, int lane, const char *path, scope *where)
{
    const glint_circuit *circuit = setting->circuit;
    const char *top = glint_setting_top(setting);
    const char *last = strrchr(path, '.');
    const char *name = last != NULL ? last + 1 : path;
    where->used = 0;
    append(where, "TOP.", 4);
    append(where, top, strlen(top));
    append(where, ".", 1);
    if (lane >= 0 && circuit->lane_scope != NULL)
        append_lane(where, circuit->lane_scope, lane);
    append(where, path, (size_t)(name - path));
    return name;
}

static void add_row(glint_gtkw *rows, const glint_setting *setting, const glint_signal_info *signal)
{
    scope where;
    char label[GLINT_SHOW_LABEL];
    const char *path = signal->path != NULL ? signal->path : signal->name;
    const char *name = place_in(setting, signal->lane, path, &where);
    glint_show_label(signal, glint_show_place(setting), "", label);
    glint_gtkw_trace trace = {.scope = where.text,
                              .name = name,
                              .label = label,
                              .width = signal->int_bits + signal->frac_bits,
                              .flags = glint_show_number(signal),
                              .color = glint_show_color(signal),
                              .frac_bits = signal->frac_bits};
    glint_gtkw_add(rows, &trace);
    if (!glint_show_curve(setting, signal))
        return;
    trace.flags |= GLINT_GTKW_SHOW_CURVE;
    glint_gtkw_add(rows, &trace);
    glint_gtkw_curve_height(rows);
}

static void add_pin(glint_gtkw *rows, const glint_setting *setting, int index)
{
    const glint_pin_info pin = setting->circuit->pin(setting->values, index);
    const glint_signal_info row = glint_show_pin(&pin);
    add_row(rows, setting, &row);
}

/* Where a pin stands among the others: what controls the circuit, then what comes anew with every
 * thing that it takes, of a lane or with a sign, then the rest. */
static int rank_of(const glint_pin_info *pin)
{
    switch (pin->role) {
    case GLINT_PIN_RESET:
    case GLINT_PIN_RESET_LOW:
        return 0;
    case GLINT_PIN_ENABLE:
    case GLINT_PIN_ENABLE_LOW:
        return 1;
    case GLINT_PIN_VALID:
        return 2;
    default:
        return pin->lane >= 0 ? 3 : pin->is_signed ? 4 : 5;
    }
}
#define RANKS 6

/* Whether lanes have ports of their own in the waveform, as instances have. A bare generate block,
 * "lane[%d]", has none: there is the whole port alone. */
static bool lanes_have_ports(const glint_setting *setting)
{
    static const char index[] = "[%d]";
    const char *scope = setting->circuit->lane_scope;
    const size_t length = scope != NULL ? strlen(scope) : 0, last = sizeof index - 1;
    return length > 0 && (length < last || strcmp(scope + length - last, index) != 0);
}

/* All lanes of a port, as `part` is lane 0's of it: side by side, no number. */
static void add_whole(glint_gtkw *rows, const glint_setting *setting, glint_signal_info part,
                      int lanes)
{
    part.int_bits = lanes * (part.int_bits + part.frac_bits);
    part.frac_bits = 0;
    part.is_signed = false;
    part.lane = -1;
    part.path = NULL;
    scope where;
    const char *name = place_in(setting, -1, part.name, &where);
    glint_gtkw_add(rows, &(glint_gtkw_trace){.scope = where.text,
                                             .name = name,
                                             .label = part.name,
                                             .width = part.int_bits,
                                             .flags = GLINT_GTKW_SHOW_HEX,
                                             .color = glint_show_color(&part)});
}

static void add_whole_pin(glint_gtkw *rows, const glint_setting *setting, const glint_pin_info *pin)
{
    int lanes = 0;
    for (int i = 0; i < setting->circuit->pin_count(setting->values); i++)
        lanes += strcmp(setting->circuit->pin(setting->values, i).name, pin->name) == 0;
    add_whole(rows, setting, glint_show_pin(pin), lanes);
}

static void add_whole_output(glint_gtkw *rows, const glint_setting *setting,
                             const glint_signal_info *output)
{
    int lanes = 0;
    for (int i = 0; i < setting->circuit->signal_count(setting->values); i++) {
        const glint_signal_info other = setting->circuit->signal(setting->values, i);
        lanes += glint_signal_is_port(other.kind) && strcmp(other.name, output->name) == 0;
    }
    add_whole(rows, setting, *output, lanes);
}

/* The pins of several lanes form one wide port, which is not a number, so only lane 0's are shown,
 * as the lane's ports, where it has them. */
static void add_inputs(glint_gtkw *rows, const glint_setting *setting)
{
    const glint_circuit *circuit = setting->circuit;
    const glint_pin_info clock = {.name = circuit->clock_port, .int_bits = 1, .lane = -1};
    const glint_signal_info clock_row = glint_show_pin(&clock);
    glint_gtkw_heading(rows, GLINT_SHOW_INPUTS);
    if (circuit->clock_port != NULL)
        add_row(rows, setting, &clock_row);
    for (int rank = 0; rank < RANKS; rank++)
        for (int i = 0; i < circuit->pin_count(setting->values); i++) {
            const glint_pin_info pin = circuit->pin(setting->values, i);
            if (pin.lane > 0 || rank_of(&pin) != rank)
                continue;
            if (pin.lane == 0 && !lanes_have_ports(setting))
                add_whole_pin(rows, setting, &pin);
            else
                add_pin(rows, setting, i);
        }
}

/* Of one heading, or of one lane; of lane 0 and of the whole circuit, what has no heading. */
typedef struct selection {
    const glint_heading *heading; /* NULL: of the lane */
    int lane;                     /* −1: of the whole circuit */
} selection;

static bool is_selected(const selection *of, const glint_signal_info *signal)
{
    if (signal->is_copy)
        return false;
    if (of->heading == NULL)
        return signal->lane == of->lane && (of->lane > 0 || signal->heading == NULL);
    return signal->heading != NULL && strcmp(signal->heading, of->heading->title) == 0 &&
           (signal->lane <= 0 || of->heading->every_lane);
}

/* rows: NULL counts them only. */
static int add_signals(glint_gtkw *rows, const glint_setting *setting, const selection *of)
{
    int count = 0;
    for (int i = 0; i < setting->circuit->signal_count(setting->values); i++) {
        const glint_signal_info signal = setting->circuit->signal(setting->values, i);
        const bool is_part =
            glint_signal_is_port(signal.kind) && signal.lane >= 0 && !lanes_have_ports(setting);
        if (!is_selected(of, &signal) || (is_part && signal.lane > 0))
            continue;
        count++;
        if (rows != NULL && is_part)
            add_whole_output(rows, setting, &signal);
        else if (rows != NULL)
            add_row(rows, setting, &signal);
    }
    return count;
}

static void add_open(glint_gtkw *rows, const glint_setting *setting, const selection *of,
                     const char *title)
{
    if (add_signals(NULL, setting, of) == 0)
        return;
    glint_gtkw_heading(rows, title);
    (void)add_signals(rows, setting, of);
}

static void add_folded(glint_gtkw *rows, const glint_setting *setting, const selection *of,
                       const char *title)
{
    if (add_signals(NULL, setting, of) == 0)
        return;
    glint_gtkw_begin_closed_group(rows, title);
    const bool has_pins = of->heading == NULL && of->lane > 0 && lanes_have_ports(setting);
    for (int i = 0; has_pins && i < setting->circuit->pin_count(setting->values); i++)
        if (setting->circuit->pin(setting->values, i).lane == of->lane)
            add_pin(rows, setting, i);
    (void)add_signals(rows, setting, of);
    glint_gtkw_end_group(rows, title);
}

static int last_lane(const glint_setting *setting)
{
    int last = -1;
    for (int i = 0; i < setting->circuit->signal_count(setting->values); i++) {
        const int lane = setting->circuit->signal(setting->values, i).lane;
        last = lane > last ? lane : last;
    }
    return last;
}

static void add_heading(glint_gtkw *rows, const glint_setting *setting,
                        const glint_heading *heading)
{
    const selection of = {.heading = heading};
    (heading->folded ? add_folded : add_open)(rows, setting, &of, heading->title);
}

static bool comes_earlier(const glint_setting *setting, int index, const char *heading)
{
    for (int i = 0; i < index; i++) {
        const char *other = setting->circuit->signal(setting->values, i).heading;
        if (other != NULL && strcmp(other, heading) == 0)
            return true;
    }
    return false;
}

/* Of a circuit without a table of them: each where a signal first has it. */
static void add_headings_of_signals(glint_gtkw *rows, const glint_setting *setting)
{
    for (int i = 0; i < setting->circuit->signal_count(setting->values); i++) {
        const glint_heading heading = {.title =
                                           setting->circuit->signal(setting->values, i).heading};
        if (heading.title != NULL && !comes_earlier(setting, i, heading.title))
            add_heading(rows, setting, &heading);
    }
}

static void fill(glint_gtkw *rows, const void *context)
{
    const glint_setting *setting = context;
    const glint_circuit *circuit = setting->circuit;
    add_inputs(rows, setting);
    for (int i = 0; i < circuit->heading_count; i++)
        add_heading(rows, setting, &circuit->headings[i]);
    if (circuit->heading_count == 0)
        add_headings_of_signals(rows, setting);
    add_open(rows, setting, &(selection){.lane = -1}, GLINT_SHOW_SIGNALS);
    for (int lane = 0; lane <= last_lane(setting); lane++) {
        char title[GLINT_SHOW_LABEL];
        glint_show_lane_title(setting, lane, title);
        add_folded(rows, setting, &(selection){.lane = lane}, title);
    }
}

/* "gate cosine, 12 shifts, 1 lane": a choice is named where there are several. */
static void write_parameters(const glint_setting *setting, char *text, size_t size)
{
    const glint_circuit *circuit = setting->circuit;
    size_t used = 0;
    int choices = 0;
    for (int i = 0; i < circuit->parameter_count; i++)
        choices += circuit->parameters[i].choices != NULL;
    for (int i = 0; i < circuit->parameter_count && used < size; i++) {
        const glint_parameter *parameter = &circuit->parameters[i];
        const int value = setting->values[i];
        const size_t length = strlen(parameter->name);
        const bool is_plural = length > 1 && parameter->name[length - 1] == 's';
        int added;
        if (parameter->choices != NULL)
            added =
                snprintf(text + used, size - used, ", %s%s%s", choices > 1 ? parameter->name : "",
                         choices > 1 ? " " : "", parameter->choices[value]);
        else if (is_plural)
            added = snprintf(text + used, size - used, ", %d %.*s", value,
                             (int)length - (value == 1), parameter->name);
        else
            added = snprintf(text + used, size - used, ", %s %d", parameter->name, value);
        used += (size_t)added;
    }
}

glint_status glint_wave_save_file(const glint_setting *setting, const glint_gtkw_window *window,
                                  const char *path, glint_error *err)
{
    char title[TITLE_TEXT];
    const int length = snprintf(title, sizeof title, "%s", setting->circuit->title);
    if (length >= 0 && length < TITLE_TEXT)
        write_parameters(setting, title + length, (size_t)(TITLE_TEXT - length));
    return glint_gtkw_write(path, title, window, fill, setting, err);
}
