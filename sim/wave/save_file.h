/* The GTKWave save file for a waveform of a circuit, by its description. */
#ifndef GLINT_SIM_WAVE_SAVE_FILE_H
#define GLINT_SIM_WAVE_SAVE_FILE_H

#include "circuit/setting.h"
#include "wave/gtkw.h"

/* Writes the save file under a temporary name, then renames it: the pins on top, then the signals
 * of the whole circuit and of lane 0 under the description's headings, then each remaining lane,
 * folded. Duplicate signals are left out; presentation.h has the rules for the rest. */
glint_status glint_wave_save_file(const glint_setting *setting, const glint_gtkw_window *window,
                                  const char *path, glint_error *err);

#endif
