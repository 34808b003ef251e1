/* What every lockstep does with a mismatch: keep the first ones, count all, and print them. */
#ifndef GLINT_SIM_MISMATCH_H
#define GLINT_SIM_MISMATCH_H

#include <stdio.h>

#include "lockstep/lockstep.h"

/* Takes one signal that differs after clock result->clocks into the result. */
void glint_mismatch_keep(glint_lockstep_result *result, const glint_signal_info *signal,
                         uint64_t model, uint64_t rtl);

/* A line for each mismatch kept. lane_name: what signal.lane counts, "lane" or "stage". */
void glint_mismatch_print(FILE *out, const glint_lockstep_result *result, const char *lane_name);

/* A line for each signal that differed at all. */
void glint_mismatch_print_totals(FILE *out, const glint_lockstep_result *result);

#endif
