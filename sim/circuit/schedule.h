/* When random pins reset and stall, so that runs reach deep state.
 *
 * Time is divided into eras, each with a mixed part and a long run. The mixed part consists of
 * phases of a few dozen clocks, each with its own character: no stalls, few or many, a stall of 64
 * or more clocks in a row; one phase in four has resets. The long run has no reset and few stalls.
 * Its enabled clocks:
 *
 *   era    mixed part, clocks    long run, enabled clocks (and 4096)
 *   0      16 384                2^16
 *   1      8 192                 2^20
 *   2, …   as the long run before, twice the long run before
 *
 * So 100 000 clocks include 2^16 enabled ones without a reset, 1 200 000 include 2^20, and from
 * there on the longest run is at least about a quarter of all clocks. The total is not known in
 * advance: a shorter run of the same seed is the start of a longer one. */
#ifndef GLINT_SIM_CIRCUIT_SCHEDULE_H
#define GLINT_SIM_CIRCUIT_SCHEDULE_H

#include "circuit/random.h"

typedef struct glint_schedule {
    int era;                             /* the next one's number */
    uint64_t mixed_left;                 /* clocks of the era's mixed part */
    uint64_t enabled_left;               /* enabled clocks of its long run */
    uint64_t previous_run;               /* enabled clocks of the long run before */
    uint32_t clocks_left;                /* of the phase */
    uint32_t stall_chance, reset_chance; /* of 256 */
} glint_schedule;

/* Starts as {0}. */

/* Of the next clock. True when it starts a phase: the caller's cue to change its own mix. */
bool glint_schedule_next(glint_schedule *schedule, glint_random *random, bool *reset, bool *en);

#endif
