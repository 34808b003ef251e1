/* The input pins of either circuit as a list of named numbers: for tables, waveforms and files. */
#ifndef GLINT_SIM_FAILURE_PINS_H
#define GLINT_SIM_FAILURE_PINS_H

#include "circuit/setting.h"

typedef struct glint_pin_info {
    const char *name; /* the Verilog's */
    int lane;         /* of the specular device's cosines; −1: of the whole circuit */
    int width, frac_bits;
    bool is_signed;
    int64_t min, max; /* values that fit */
} glint_pin_info;

#define GLINT_PINS_MAX 32

/* The pins, 0…count−1. */
int glint_pin_count(const glint_setting *setting);
glint_pin_info glint_pin(const glint_setting *setting, int index);

int64_t glint_pin_get(const glint_setting *setting, const glint_pins *pins, int index);
void glint_pin_set(const glint_setting *setting, glint_pins *pins, int index, int64_t value);

#endif
