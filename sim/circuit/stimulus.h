/* Random input pins for the specular device, the same for the same seed and number of lanes.
 *
 * It covers dense runs and runs with gaps, lanes valid in any pattern and singly, material written
 * with a point, between points and without any, and all kinds of cosines: anywhere, out of range,
 * exactly 0 and 1, inside the highlight, around its limit. Resets and stalls: schedule.h. */
#ifndef GLINT_SIM_CIRCUIT_STIMULUS_H
#define GLINT_SIM_CIRCUIT_STIMULUS_H

#include "circuit/random.h"
#include "circuit/schedule.h"
#include "glint_specular_device.h"

typedef struct glint_stimulus {
    glint_random random;
    int lanes;
    glint_schedule schedule;
    uint32_t n; /* the exponent that register 2 holds, to aim at its highlight */
    uint32_t gap_chance, lane_gap_chance, material_chance; /* of 256, in the present phase */
    uint32_t turns; /* whether lanes are valid one by one in it, and how */
    uint32_t turn;  /* whose it is */
} glint_stimulus;

void glint_stimulus_init(glint_stimulus *stimulus, uint64_t seed, int lanes);

/* The pins of the next clock. */
void glint_stimulus_next(glint_stimulus *stimulus, glint_specular_inputs *inputs);

#endif
