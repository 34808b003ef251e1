/* Random input pins for the dividers, the same for the same seed.
 *
 * It covers divisions back to back and with gaps, starts while a division is in progress, every k
 * in the table, 0 and beyond it, the largest differences and all others. Resets and stalls:
 * schedule.h. */
#ifndef GLINT_SIM_CIRCUIT_DIVIDER_STIMULUS_H
#define GLINT_SIM_CIRCUIT_DIVIDER_STIMULUS_H

#include "circuit/random.h"
#include "circuit/schedule.h"
#include "glint_divider_device.h"

typedef struct glint_divider_stimulus {
    glint_random random;
    glint_schedule schedule;
    uint32_t start_chance, miss_chance; /* of 256, in the present phase */
} glint_divider_stimulus;

void glint_divider_stimulus_init(glint_divider_stimulus *stimulus, uint64_t seed);

/* The pins of the next clock. */
void glint_divider_stimulus_next(glint_divider_stimulus *stimulus, glint_divider_inputs *inputs);

#endif
