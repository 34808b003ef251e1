/* What the section on the formulas' speed measures, for section_speed.c and the tests of its
 * claims. */
#ifndef GLINT_SIM_REPORT_SPEEDS_H
#define GLINT_SIM_REPORT_SPEEDS_H

#include "bench/bench.h"
#include "report/findings.h"

/* Runs of the bench, one after the other: how far they lie apart is what its numbers are good for.
 */
#define GLINT_SPEED_RUNS 5

typedef struct glint_speeds {
    glint_bench_formula_rates run[GLINT_SPEED_RUNS], median;
    glint_bench_rates device;
    double device_to_schlick[GLINT_BENCH_CANDIDATES]; /* by the same kind of loop */
} glint_speeds;

/* The claims of sections 3.1 and 3.4 on speed: from these numbers alone. */
void glint_speeds_find(const glint_speeds *speeds, glint_findings *findings);

#endif
