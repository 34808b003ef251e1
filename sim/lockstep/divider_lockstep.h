/* The C model of a divider and its Verilog side by side; as lockstep.h is for the specular device.
 *
 * What comes up: divisions back to back and with gaps, starts while a division is under way, stalls
 * by the clock enable, resets in mid-flow, every k of the table, 0 and beyond it, the largest
 * differences and all others. */
#ifndef GLINT_SIM_DIVIDER_LOCKSTEP_H
#define GLINT_SIM_DIVIDER_LOCKSTEP_H

#include "glint_divider_device.h"
#include "lockstep/lockstep.h"
#include "lockstep/random.h"
#include "rtl/divider_rtl.h"

typedef struct glint_divider_stimulus {
    glint_random random;
    uint32_t clocks_left;                                           /* of the present phase */
    uint32_t start_chance, stall_chance, reset_chance, miss_chance; /* of 256 */
} glint_divider_stimulus;

void glint_divider_stimulus_init(glint_divider_stimulus *stimulus, uint64_t seed);

/* The pins of the next clock. */
void glint_divider_stimulus_next(glint_divider_stimulus *stimulus, glint_divider_inputs *inputs);

typedef struct glint_divider_lockstep_options {
    glint_divider_form form;
    int shifts;
    uint64_t clocks; /* how many; 0 compares nothing, and is refused */
    uint64_t seed;
    const glint_divider_model *model; /* NULL: the build for form and shifts; else a test's own */
    const volatile bool *stop;        /* may be NULL */
    void (*progress)(void *context, uint64_t done, uint64_t total); /* may be NULL */
    void *progress_context;
} glint_divider_lockstep_options;

typedef struct glint_divider_lockstep_result {
    glint_lockstep_result found; /* its history stays empty: the pins are these: */
    /* The clocks since the oldest division still under way was taken, stalled ones between, up to
     * the first mismatch, oldest first. */
    int history_count;
    glint_divider_inputs history[GLINT_HISTORY];
} glint_divider_lockstep_result;

/* As glint_lockstep_run(). */
glint_status glint_divider_lockstep_run(const glint_divider_lockstep_options *options,
                                        glint_divider_lockstep_result *result, glint_error *err);

/* As glint_lockstep_trace(). */
glint_status glint_divider_lockstep_trace(const glint_divider_lockstep_options *options,
                                          const char *path, uint64_t first, uint64_t last,
                                          glint_error *err);

#endif
