/* Measures candidates side by side, in turn, round after round, so that other load on the machine
 * affects them all alike. */
#ifndef GLINT_SIM_BENCH_ROUNDS_H
#define GLINT_SIM_BENCH_ROUNDS_H

#include <stdbool.h>

#include "glint_status.h"

#define GLINT_ROUNDS         7
#define GLINT_CANDIDATES_MAX 24

/* One pass of a candidate over all of its work. */
typedef glint_status glint_bench_pass(void *work, int candidate, glint_error *err);

typedef struct glint_rounds {
    double rate[GLINT_CANDIDATES_MAX][GLINT_ROUNDS]; /* items a second */
} glint_rounds;

/* Measures candidates 0…count−1 for about `seconds` each, on the calling thread; a pass is over
 * `items` items. Rates use the thread's own processor time, so other processes do not count. */
glint_status glint_rounds_measure(glint_bench_pass *pass, void *work, int count, int items,
                                  double seconds, const volatile bool *stop, glint_rounds *rounds,
                                  glint_error *err);

/* The median of the rounds. */
double glint_rounds_rate(const glint_rounds *rounds, int candidate);

/* The median of the ratios within a round. */
double glint_rounds_ratio(const glint_rounds *rounds, int candidate, int to);

#endif
