/* Strips a circuit's description down to its pins. */
#include "pins.h"

#include <stdbool.h>
#include <string.h>

static const glint_circuit *whole;
static glint_circuit bare;
static glint_parameter parameters[GLINT_PARAMETERS_MAX];

/* The outputs, and the one register of the dividers that is a pin as well. */
static bool is_pin(const glint_signal_info *info)
{
    return info->kind == GLINT_SIGNAL_OUTPUT || strcmp(info->name, "busy") == 0;
}

static int pin_count(const int *values)
{
    int count = 0;
    for (int i = 0; i < whole->signal_count(values); i++) {
        const glint_signal_info info = whole->signal(values, i);
        count += is_pin(&info);
    }
    return count;
}

static glint_signal_info pin(const int *values, int index)
{
    for (int i = 0;; i++) {
        glint_signal_info info = whole->signal(values, i);
        if (is_pin(&info) && index-- == 0) {
            info.kind = GLINT_SIGNAL_OUTPUT;
            return info;
        }
    }
}

glint_setting pins_setting(const glint_setting *setting)
{
    glint_setting netlist = *setting;
    whole = setting->circuit;
    bare = *whole;
    for (int i = 0; i < bare.parameter_count; i++) {
        parameters[i] = whole->parameters[i];
        parameters[i].verilog = NULL;
    }
    bare.parameters = parameters;
    bare.signal_count = pin_count;
    bare.signal = pin;
    netlist.circuit = &bare;
    return netlist;
}
