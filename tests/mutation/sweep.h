/* Directed pins for the bench, clock by clock. */
#ifndef GLINT_TESTS_MUTATION_SWEEP_H
#define GLINT_TESTS_MUTATION_SWEEP_H

#include "circuit/setting.h"

/* Where the next clock of the sweep is; begins as {0}. */
typedef struct mutation_sweep {
    uint32_t n; /* of a highlight unit: from the largest n on; GLINT_N_COUNT of them: second part */
    uint32_t place, limit;
} mutation_sweep;

/* Of the specular device and the power device: for every n, the narrowest highlight first, a point
 * a clock in white: every cosine from 8 codes below the limit (ROM 9; where W is no longer 0) to
 * 1.0, some further below and two beyond. Then every code, in changing colours, with n = 2, where t
 * is the cosine, or n = 1, where W is: so every t of a highlight and every W, and every code beyond
 * 1.0.
 *
 * Of the dividers: every k, 0…255, with every code of the difference, −256…255: one division after
 * the other, or one a clock with each component at another place of the sweep.
 *
 * Other circuits: their description's domain; 0 clocks if there is none. */
uint64_t mutation_sweep_clocks(const glint_setting *setting);

/* The pins of the next clock; clock 1 is the first. */
void mutation_sweep_next(mutation_sweep *at, const glint_setting *setting, uint64_t clock,
                         glint_pins *pins);

#endif
