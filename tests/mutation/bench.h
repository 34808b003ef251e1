/* The test bench for a synthesised netlist with faults: the C model and the netlist side by side,
 * every output pin compared after every clock, until the first difference.
 *
 * Two tests in sequence, each with all registers 1 and then all 0 before the reset:
 *   lockstep  the random pins of `glint verify` (sim/circuit/random_pins.h)
 *   sweep     of the specular device and the power device, every cosine of every highlight in
 *             white, then every cosine code in changing colours; of the dividers, every k with
 *             every difference */
#ifndef GLINT_TESTS_MUTATION_BENCH_H
#define GLINT_TESTS_MUTATION_BENCH_H

#include <stdbool.h>

#include "glint_specular_device.h"
#include "netlist.h"

typedef struct mutation_effort {
    uint64_t lockstep_clocks; /* 0: no lockstep */
    uint64_t sweep_clocks;    /* at most, counted from its beginning; 0: no sweep */
    uint64_t seed;
    /* Not NULL: only this point, in a steady flow; specular device only. */
    const glint_specular_inputs *point;
    const volatile bool *stop; /* may be NULL */
} mutation_effort;

/* The verdict on one netlist. */
typedef struct mutation_verdict {
    uint64_t clocks;  /* compared, both tests together; 0 when nothing was */
    bool killed;      /* a pin differed: */
    const char *test; /* "lockstep", "sweep", "point" */
    uint64_t clock;   /* of that test, 1 is the first after the reset of creation */
    const char *pin;
    uint64_t model, netlist; /* its values, as bits */
} mutation_verdict;

/* Runs the bench on one mutant, 0 for the healthy netlist. GLINT_OK regardless of the verdict.
 * GLINT_BAD_ARGUMENT if both tests have 0 clocks, which would let every mutant survive, or for a
 * point through a circuit other than the specular device. */
glint_status mutation_run(const mutation_netlist_table *netlist, uint32_t mutant,
                          const mutation_effort *effort, mutation_verdict *verdict,
                          glint_error *err);

#endif
