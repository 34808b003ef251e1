/* Random input pins for the dividers, the same for the same seed.
 *
 * What comes up: divisions back to back and with gaps, starts while a division is under way, stalls
 * by the clock enable, resets in mid-flow, every k of the table, 0 and beyond it, the largest
 * differences and all others. */
#ifndef GLINT_SIM_DIVIDER_STIMULUS_H
#define GLINT_SIM_DIVIDER_STIMULUS_H

#include "glint_divider_device.h"
#include "lockstep/random.h"

typedef struct glint_divider_stimulus {
    glint_random random;
    uint32_t clocks_left;                                           /* of the present phase */
    uint32_t start_chance, stall_chance, reset_chance, miss_chance; /* of 256 */
} glint_divider_stimulus;

void glint_divider_stimulus_init(glint_divider_stimulus *stimulus, uint64_t seed);

/* The pins of the next clock. */
void glint_divider_stimulus_next(glint_divider_stimulus *stimulus, glint_divider_inputs *inputs);

#endif
