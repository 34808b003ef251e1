/* The GTKWave save file for a waveform of the specular device. */
#ifndef GLINT_SIM_SAVE_FILE_H
#define GLINT_SIM_SAVE_FILE_H

#include "glint_specular_device.h"
#include "wave/gtkw.h"

typedef struct glint_wave_view {
    const glint_specular_config *config;
    glint_gtkw_window window;
} glint_wave_view;

/* Writes the save file, beside and then renamed: the pins on top, then the blocks of the figure;
 * presentation.h has the rules. The other lanes are folded below lane 0. */
glint_status glint_wave_save_file(const glint_wave_view *view, const char *path, glint_error *err);

#endif
