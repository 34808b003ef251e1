/* The C model and the Verilog in lockstep: both get the same random pins, and after each clock
 * every register and every named internal value is compared bit for bit. */
#ifndef GLINT_SIM_LOCKSTEP_LOCKSTEP_H
#define GLINT_SIM_LOCKSTEP_LOCKSTEP_H

#include <stdbool.h>

#include "circuit/words.h"
#include "lockstep/reach.h"
#include "lockstep/roles.h"

#define GLINT_MISMATCHES_KEPT 16

typedef struct glint_lockstep_options {
    glint_setting setting;
    uint64_t clocks; /* how many; 0 would compare nothing and is rejected */
    uint64_t seed;
    const volatile bool *stop;                                      /* may be NULL */
    void (*progress)(void *context, uint64_t done, uint64_t total); /* may be NULL */
    void *progress_context;
} glint_lockstep_options;

#define GLINT_TOTALS_MAX 256

/* One signal that differed after one clock. */
typedef struct glint_mismatch {
    uint64_t clock; /* 1 is the first after the reset of creation */
    glint_signal_info signal;
    uint64_t model[GLINT_VALUE_WORDS], rtl[GLINT_VALUE_WORDS]; /* its words; the rest is 0 */
} glint_mismatch;

typedef struct glint_lockstep_result {
    uint64_t clocks;      /* compared */
    uint64_t comparisons; /* pairs of values compared, counted as each is */
    uint64_t mismatches;
    uint64_t first_clock; /* of the first mismatch */
    int kept;
    glint_mismatch mismatch[GLINT_MISMATCHES_KEPT];
    /* Mismatches by signal name, those above 0, in the order the data flows; of a circuit with more
     * names than fit, the first. */
    int totals_count;
    struct {
        const char *name;
        int block;
        uint64_t mismatches;
    } totals[GLINT_TOTALS_MAX];
    glint_reach reach; /* of the pins that both sides were given */
    glint_roles roles; /* what the run says about the description's roles and kinds */
} glint_lockstep_result;

/* Runs it. GLINT_OK regardless of the finding, which is in result. GLINT_INTERRUPTED if stopped:
 * result then holds the comparison so far. */
glint_status glint_lockstep_run(const glint_lockstep_options *options,
                                glint_lockstep_result *result, glint_error *err);

#endif
