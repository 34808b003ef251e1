/* What is left for a person when lockstep finds a mismatch: a text and a waveform. */
#ifndef GLINT_SIM_FAILURE_H
#define GLINT_SIM_FAILURE_H

#include <stdbool.h>
#include <stdio.h>

#include "lockstep/lockstep.h"
#include "wave/gtkw.h"

#define GLINT_FAILURE_PATH 4096

typedef struct glint_failure_files {
    char waveform[GLINT_FAILURE_PATH], save_file[GLINT_FAILURE_PATH];
} glint_failure_files;

/* DIRECTORY/mismatch_NAME.fst and .gtkw; false when that is too long. */
bool glint_failure_name(glint_failure_files *files, const char *directory, const char *name);

/* The clocks around a failing one, 32 before it and 8 after, and the view of them. */
typedef struct glint_failure_window {
    uint64_t first, last;
    glint_gtkw_window window;
} glint_failure_window;
glint_failure_window glint_failure_window_of(uint64_t failing, const char *waveform);

/* Looks whether all of a waveform arrived; a part of one is removed. */
glint_status glint_failure_check_waveform(const char *path, glint_error *err);

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
