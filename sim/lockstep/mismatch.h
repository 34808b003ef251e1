/* What every signal comparison does with mismatches: keep the first few, count all, print them. */
#ifndef GLINT_SIM_LOCKSTEP_MISMATCH_H
#define GLINT_SIM_LOCKSTEP_MISMATCH_H

#include <stdio.h>

#include "lockstep/lockstep.h"
#include "lockstep/twin.h"

/* Compares all signals after clock result->clocks and adds the outcome. */
void glint_mismatch_compare(glint_lockstep_result *result, const glint_twin *twin);

/* The same for words read already. */
void glint_mismatch_compare_values(glint_lockstep_result *result, const glint_signals *signals,
                                   const uint64_t *model, const uint64_t *rtl);

/* A signal that differed after that clock, with the words that it had. */
glint_mismatch glint_mismatch_of(uint64_t clock, const glint_signal_info *signal,
                                 const uint64_t *model, const uint64_t *rtl);

/* The number that a signal's words stand for. */
double glint_mismatch_number(const glint_signal_info *signal, const uint64_t *words);

/* Its bits as JSON has them: "0x1f", without zeros in front. text: GLINT_VALUE_TEXT. */
void glint_mismatch_bits(const glint_signal_info *signal, const uint64_t *words, char *text);

/* A line for one: clock, signal, lane, block, meaning, both values. */
void glint_mismatch_print_one(FILE *out, const glint_setting *setting,
                              const glint_mismatch *mismatch);

/* A line for each mismatch kept. */
void glint_mismatch_print(FILE *out, const glint_setting *setting,
                          const glint_lockstep_result *result);

/* A line for each signal that differed at all. */
void glint_mismatch_print_totals(FILE *out, const glint_lockstep_result *result);

#endif
