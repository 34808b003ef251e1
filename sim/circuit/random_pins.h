/* Random pins for any circuit: from its own stimulus, or else by each pin's role.
 *
 * A circuit without its own stimulus gets the schedule of schedule.h (resets and stalls, long runs
 * without either), phases in which inputs are valid always, often or seldom, and data anywhere in
 * its range, at its ends, 0, 1, −1, with one bit set or all but one, and short.
 *
 * The same setting and seed give the same pins, on every machine; a shorter run is the beginning of
 * a longer one. */
#ifndef GLINT_SIM_CIRCUIT_RANDOM_PINS_H
#define GLINT_SIM_CIRCUIT_RANDOM_PINS_H

#include <stddef.h>

#include "circuit/setting.h"

typedef struct glint_random_pins {
    glint_setting setting;
    union {
        max_align_t align;
        unsigned char bytes[GLINT_STIMULUS_SIZE_MAX];
    } state; /* the circuit's own, or that of random_pins.c */
} glint_random_pins;

void glint_random_pins_begin(glint_random_pins *source, const glint_setting *setting,
                             uint64_t seed);

/* The pins of the next clock, from clock 1 on. */
void glint_random_pins_next(glint_random_pins *source, glint_pins *pins);

#endif
