/* Display names, radices and colours, shared by every waveform; see presentation.h. */
#include "wave/presentation.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>

/* So many bits, one by one, have room in a clock of the view; of more GTKWave cuts off the last. */
#define BITS_OF_A_CLOCK 8

#define NUMBER_BITS 64 /* wider values are unreadable as numbers */
#define CURVE_BITS  4  /* fewer make no curve */

const char *glint_show_place(const glint_setting *setting)
{
    const glint_circuit *circuit = setting->circuit;
    if (circuit->lane_name == NULL)
        return NULL;
    const int count = circuit->signal_count(setting->values);
    int first = -1;
    for (int i = 0; i < count; i++) {
        const int lane = circuit->signal(setting->values, i).lane;
        if (lane >= 0 && first >= 0 && lane != first)
            return circuit->lane_name;
        first = lane >= 0 ? lane : first;
    }
    return NULL;
}

void glint_show_lane_title(const glint_setting *setting, int lane, char title[GLINT_SHOW_LABEL])
{
    const char *given = setting->circuit->lane_name;
    const char *name = given != NULL && given[0] != '\0' ? given : "lane";
    (void)snprintf(title, GLINT_SHOW_LABEL, "%c%s %d", toupper((unsigned char)name[0]), name + 1,
                   lane);
}

void glint_show_label(const glint_signal_info *signal, const char *place, const char *ending,
                      char label[GLINT_SHOW_LABEL])
{
    if (place != NULL && signal->lane >= 0)
        (void)snprintf(label, GLINT_SHOW_LABEL, "%s%d %s%s", place, signal->lane, signal->name,
                       ending);
    else
        (void)snprintf(label, GLINT_SHOW_LABEL, "%s%s", signal->name, ending);
}

static int width_of(const glint_signal_info *signal)
{
    return signal->int_bits + signal->frac_bits;
}

/* Single bits; valid bits, one a lane; the bits of the dividers' table, which their names tell. */
static bool is_bits(const glint_signal_info *signal)
{
    return width_of(signal) == 1 || strstr(signal->name, "valid") != NULL ||
           strstr(signal->name, "bits") != NULL;
}

unsigned glint_show_number(const glint_signal_info *signal)
{
    return width_of(signal) > NUMBER_BITS ? GLINT_GTKW_SHOW_HEX
           : signal->is_signed            ? GLINT_GTKW_SHOW_SIGNED
           : is_bits(signal)              ? GLINT_GTKW_SHOW_BINARY
                                          : GLINT_GTKW_SHOW_DECIMAL;
}

unsigned glint_show_code(const glint_signal_info *signal)
{
    const bool is_long = is_bits(signal) && signal->int_bits > BITS_OF_A_CLOCK;
    return signal->frac_bits > 0 || is_long ? GLINT_GTKW_SHOW_HEX : glint_show_number(signal);
}

int glint_show_color(const glint_signal_info *signal)
{
    return signal->kind == GLINT_SIGNAL_STAGE   ? GLINT_GTKW_COLOR_ORANGE
           : glint_signal_is_port(signal->kind) ? GLINT_GTKW_COLOR_YELLOW
                                                : GLINT_GTKW_COLOR_NORMAL;
}

static bool can_be_curve(const glint_signal_info *signal)
{
    return glint_signal_is_port(signal->kind) && signal->frac_bits == 0 && !signal->is_signed &&
           !is_bits(signal) && signal->int_bits >= CURVE_BITS && signal->int_bits <= NUMBER_BITS;
}

bool glint_show_curve(const glint_setting *setting, const glint_signal_info *signal)
{
    const glint_circuit *circuit = setting->circuit;
    const int count = circuit->signal_count(setting->values);
    for (int i = 0; i < count; i++) {
        const glint_signal_info other = circuit->signal(setting->values, i);
        if (can_be_curve(&other))
            return can_be_curve(signal) && strcmp(other.name, signal->name) == 0;
    }
    return false;
}

glint_signal_info glint_show_pin(const glint_pin_info *pin)
{
    return (glint_signal_info){.name = pin->name,
                               .kind = GLINT_SIGNAL_REGISTER, /* in no colour */
                               .int_bits = pin->int_bits,
                               .frac_bits = pin->frac_bits,
                               .is_signed = pin->is_signed,
                               .lane = pin->lane,
                               .meaning = pin->meaning};
}
