/* How a circuit is shown in its waveforms and in a failure's: names, radices and colours. Headings
 * come from the description: signal.heading, circuit.headings. */
#ifndef GLINT_SIM_WAVE_PRESENTATION_H
#define GLINT_SIM_WAVE_PRESENTATION_H

#include <stdbool.h>

#include "circuit/setting.h"
#include "wave/gtkw.h"

#define GLINT_SHOW_LABEL 128

/* Keep headings short: the widest heading or name sets the width of the name column. */
#define GLINT_SHOW_INPUTS  "Inputs"
#define GLINT_SHOW_SIGNALS "Signals" /* those without a heading of their own */

/* What signal.lane counts, "lane" or "stage", for labels; NULL where there is no more than one. */
const char *glint_show_place(const glint_setting *setting);

/* "Lane 3", "Stage 3": the heading of one lane's signals. */
void glint_show_lane_title(const glint_setting *setting, int lane, char title[GLINT_SHOW_LABEL]);

/* A signal's name with that of its lane or stage, "lane3 reg1", unless `place` is NULL or the
 * signal is of the whole circuit; `ending` goes behind it. No dots: GTKWave would leave out what is
 * before them. */
void glint_show_label(const glint_signal_info *signal, const char *place, const char *ending,
                      char label[GLINT_SHOW_LABEL]);

/* Flags of a signal: integers and, with the position of its point, a fixed-point code as numbers;
 * what is read bit by bit as bits, what is wider than 64 bits in hex. */
unsigned glint_show_number(const glint_signal_info *signal);

/* Flags for comparing two sides: fixed-point codes and wide values in hex, so that the last place
 * is visible; the rest as above. */
unsigned glint_show_code(const glint_signal_info *signal);

/* Pipeline registers and outputs have a colour of their own. */
int glint_show_color(const glint_signal_info *signal);

/* Drawn as a curve as well: the first output that is an integer without sign of some bits, in every
 * lane. */
bool glint_show_curve(const glint_setting *setting, const glint_signal_info *signal);

/* A pin as a signal: its name, width, point, sign and lane. */
glint_signal_info glint_show_pin(const glint_pin_info *pin);

#endif
