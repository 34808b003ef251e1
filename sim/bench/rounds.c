/* Round after round; see rounds.h. */
#define _POSIX_C_SOURCE 200809L

#include "bench/rounds.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

static double now(clockid_t clock)
{
    struct timespec t;
    clock_gettime(clock, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* Items per second over at least `seconds` and at least one pass. The rate uses the thread's
 * processor time; since reading that takes as long as a fast pass, wall-clock time decides when to
 * stop. */
static glint_status measure(glint_bench_pass *pass, void *work, int candidate, int items,
                            double seconds, const volatile bool *stop, double *rate,
                            glint_error *err)
{
    uint64_t passes = 0;
    const double start = now(CLOCK_MONOTONIC), own_start = now(CLOCK_THREAD_CPUTIME_ID);
    do {
        glint_status status = pass(work, candidate, err);
        if (status != GLINT_OK)
            return status;
        if (stop != NULL && *stop)
            return glint_fail(err, GLINT_INTERRUPTED, "interrupted");
        passes++;
    } while (now(CLOCK_MONOTONIC) - start < seconds);
    *rate = (double)passes * items / (now(CLOCK_THREAD_CPUTIME_ID) - own_start);
    return GLINT_OK;
}

glint_status glint_rounds_measure(glint_bench_pass *pass, void *work, int count, int items,
                                  double seconds, const volatile bool *stop, glint_rounds *rounds,
                                  glint_error *err)
{
    glint_status status = GLINT_OK;
    for (int round = 0; round < GLINT_ROUNDS; round++)
        for (int i = 0; status == GLINT_OK && i < count; i++)
            status = measure(pass, work, i, items, seconds / GLINT_ROUNDS, stop,
                             &rounds->rate[i][round], err);
    return status;
}

static int compare_doubles(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static double median(const double values[GLINT_ROUNDS])
{
    double sorted[GLINT_ROUNDS];
    memcpy(sorted, values, sizeof sorted);
    qsort(sorted, GLINT_ROUNDS, sizeof *sorted, compare_doubles);
    return sorted[GLINT_ROUNDS / 2];
}

double glint_rounds_rate(const glint_rounds *rounds, int candidate)
{
    return median(rounds->rate[candidate]);
}

double glint_rounds_ratio(const glint_rounds *rounds, int candidate, int to)
{
    double ratio[GLINT_ROUNDS];
    for (int round = 0; round < GLINT_ROUNDS; round++)
        ratio[round] = rounds->rate[candidate][round] / rounds->rate[to][round];
    return median(ratio);
}
