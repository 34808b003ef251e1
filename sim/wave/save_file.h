/* A GTKWave save file for a waveform of the specular device: signals grouped by the figure's blocks
 * in the order the data flows, fixed-point values shown as real numbers, W and R as curves too,
 * pipeline registers and outputs in colours of their own. */
#ifndef GLINT_SIM_SAVE_FILE_H
#define GLINT_SIM_SAVE_FILE_H

#include "glint_specular_device.h"
#include "wave/gtkw.h"

typedef struct glint_wave_view {
    const glint_specular_config *config;
    glint_gtkw_window window;
} glint_wave_view;

/* The heading that a signal of the specular device stands under. */
const char *glint_wave_heading(const glint_signal_info *signal);

/* Writes the save file, beside and then renamed. */
glint_status glint_wave_save_file(const glint_wave_view *view, const char *path, glint_error *err);

#endif
