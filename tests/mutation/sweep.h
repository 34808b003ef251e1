/* Directed pins for the bench, a clock after the other. */
#ifndef GLINT_TESTS_MUTATION_SWEEP_H
#define GLINT_TESTS_MUTATION_SWEEP_H

#include "glint_divider_device.h"
#include "glint_specular_device.h"

/* Where the next clock of the specular sweep is; begins as {0}. */
typedef struct mutation_sweep {
    uint32_t n; /* from the largest n on; GLINT_N_COUNT of them: the second part */
    uint32_t place;
} mutation_sweep;

/* For every n, the narrowest highlight first, a point a clock in white: every cosine from 8 codes
 * below the limit to 1.0, some further below and two beyond. Then with n = 2, where t is the
 * cosine, every t of a highlight and with it every W, in changing colours. */
void mutation_sweep_specular(mutation_sweep *at, glint_specular_inputs *inputs);
uint64_t mutation_sweep_specular_clocks(void);

/* Every k, 0…255, with every code of the difference, −256…255: one division after the other, or one
 * a clock with each component at another place of the sweep. Clock 1 is the first. */
void mutation_sweep_sequential(int shifts, uint64_t clock, glint_divider_inputs *inputs);
uint64_t mutation_sweep_sequential_clocks(int shifts);
void mutation_sweep_pipelined(uint64_t clock, glint_divider_inputs *inputs);
uint64_t mutation_sweep_pipelined_clocks(int shifts);

#endif
