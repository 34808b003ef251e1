/* A GTKWave save file for a waveform of the specular device: signals grouped by the figure's blocks
 * in the order the data flows, fixed-point values shown as real numbers, W and R as curves too,
 * pipeline registers and outputs in colours of their own. */
#ifndef GLINT_SIM_SAVE_FILE_H
#define GLINT_SIM_SAVE_FILE_H

#include "glint_specular_device.h"

typedef struct glint_wave_view {
    const glint_specular_config *config;
    const char *waveform; /* the file it belongs to: its last component is named in the save file */
    uint64_t first_time;  /* the window shown, in ns */
    uint64_t last_time;   /* > first_time */
    int64_t marker_time;  /* where the marker stands; −1: nowhere */
} glint_wave_view;

/* Writes the save file, beside and then renamed. */
glint_status glint_wave_save_file(const glint_wave_view *view, const char *path, glint_error *err);

#endif
