/* What every comparison of signals does with a mismatch: keep the first ones, count all, print. */
#ifndef GLINT_SIM_MISMATCH_H
#define GLINT_SIM_MISMATCH_H

#include <stdio.h>

#include "lockstep/lockstep.h"
#include "lockstep/twin.h"

/* Compares all signals as they are after clock result->clocks, and adds what comes of it. */
void glint_mismatch_compare(glint_lockstep_result *result, const glint_setting *setting,
                            const glint_twin *twin);

/* The same for values read already. */
void glint_mismatch_compare_values(glint_lockstep_result *result, const glint_setting *setting,
                                   const uint64_t *model, const uint64_t *rtl);

/* The number that a signal's bits stand for. */
double glint_mismatch_number(const glint_signal_info *signal, uint64_t bits);

/* A line for one: clock, signal, lane, block, meaning, both values. */
void glint_mismatch_print_one(FILE *out, const glint_setting *setting,
                              const glint_mismatch *mismatch);

/* A line for each mismatch kept. */
void glint_mismatch_print(FILE *out, const glint_setting *setting,
                          const glint_lockstep_result *result);

/* A line for each signal that differed at all. */
void glint_mismatch_print_totals(FILE *out, const glint_lockstep_result *result);

#endif
