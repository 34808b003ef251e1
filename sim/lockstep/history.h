/* A circuit's recent inputs, as the pins of its last clocks, for answers that are wrong only
 * because of what preceded them. */
#ifndef GLINT_SIM_LOCKSTEP_HISTORY_H
#define GLINT_SIM_LOCKSTEP_HISTORY_H

#include "lockstep/batch_pins.h"

#define GLINT_HISTORY_CLOCKS 65536 /* kept, the last */

typedef struct glint_history glint_history;

void glint_history_destroy(glint_history *history); /* NULL is allowed */

/* Adds the clocks of a run; *history is made when it is NULL, of a circuit in reset state, and
 * stays NULL without memory. */
void glint_history_add(glint_history **history, const glint_setting *setting,
                       const glint_batch *batch);

const glint_setting *glint_history_setting(const glint_history *history);

/* The pins kept, in order, to be freed with free(), and which clock, from 1 on, took the first.
 * NULL: no memory, or no clock yet. */
glint_pins *glint_history_pins(const glint_history *history, size_t *count, uint64_t *first_clock);

#endif
