/* The waveform of a capture: both sides of every signal, and the GTKWave save file for it. */
#ifndef GLINT_SIM_FAILURE_WAVE_H
#define GLINT_SIM_FAILURE_WAVE_H

#include "failure/capture.h"

/* Writes a VCD under a temporary name, then renames it. The rising edge of clock c is at 10·c ns;
 * pins change half a clock earlier. Scope TOP has `mismatch` (1 where any signal differs), `clock`
 * (its number), clk, the pins by their names (a pin called like one of those three
 * puts glint_ before that one's name), and of each signal NAME_rtl and NAME_model; plus
 * NAME_differs if it ever does. For fixed-point signals, NAME_…_real holds the number that the code
 * stands for, as text. Signals and pins of one lane or stage are in TOP.lane[i] or TOP.stage[i]. */
glint_status glint_failure_write_wave(const glint_capture *capture, const char *path,
                                      glint_error *err);

/* Writes the save file for the waveform of that name beside it: the marker on the failing clock,
 * the groups in which anything differs on top, in the order in which they begin to, the others
 * folded, the Verilog's value of each signal above the model's: fixed-point codes in hex, the
 * numbers that they stand for below them. */
glint_status glint_failure_write_save_file(const glint_capture *capture, const char *waveform,
                                           const char *path, glint_error *err);

#endif
