/* What is left for a person when lockstep finds a mismatch: a text and a waveform. */
#ifndef GLINT_SIM_FAILURE_H
#define GLINT_SIM_FAILURE_H

#include <stdio.h>

#include "lockstep/lockstep.h"

#define GLINT_FAILURE_PATH 4096

typedef struct glint_failure_files {
    char waveform[GLINT_FAILURE_PATH], save_file[GLINT_FAILURE_PATH];
} glint_failure_files;

/* Writes to out: the mismatches kept, a line each (clock, signal, block, both values), the pins of
 * the clocks up to the first of them, and the totals by signal. */
void glint_lockstep_report(FILE *out, const glint_lockstep_options *options,
                           const glint_lockstep_result *result);

/* Replays the run to the first mismatch and writes a waveform of the 32 clocks before it and the 8
 * after it into directory (made if missing), with a save file whose marker stands on it. */
glint_status glint_lockstep_failure_wave(const glint_lockstep_options *options,
                                         const glint_lockstep_result *result, const char *directory,
                                         glint_failure_files *files, glint_error *err);

#endif
