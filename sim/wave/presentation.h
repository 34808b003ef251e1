/* How the circuits are shown, in waveforms of one circuit and of a failure: which signals stand
 * under which heading, in what order, by what name, in which radix and colour. */
#ifndef GLINT_SIM_PRESENTATION_H
#define GLINT_SIM_PRESENTATION_H

#include <stdbool.h>

#include "glint_divider_device.h"
#include "glint_specular_device.h"
#include "wave/gtkw.h"

#define GLINT_SHOW_LABEL 64

/* Headings are short: the widest of them and of the names is the width of the column of names. */
#define GLINT_SHOW_INPUTS "Inputs"

/* The specular device's headings, 0 on top: the outputs first, as the pins are to be seen together
 * in any window, then the figure's blocks as the data flows. */
int glint_show_specular_sections(void);
int glint_show_specular_section(const glint_signal_info *signal);
const char *glint_show_specular_title(int section);
bool glint_show_specular_folded(int section); /* of use to few: folded */

/* The heading that signal `index` of a divider stands under, and whether it begins there. */
const char *glint_show_divider_title(glint_divider_form form, int shifts, int index);
bool glint_show_divider_begins(glint_divider_form form, int shifts, int index);

/* A signal's name with that of its lane or stage, "lane3 reg1", unless `place` is NULL or the
 * signal is of the whole circuit; `ending` goes behind it. No dots: GTKWave would leave out what is
 * before them. */
void glint_show_label(const glint_signal_info *signal, const char *place, const char *ending,
                      char label[GLINT_SHOW_LABEL]);

/* Flags of a signal: integers and, with the position of its point, a fixed-point code as numbers;
 * what is read bit by bit as bits. */
unsigned glint_show_number(const glint_signal_info *signal);

/* Flags where two sides are held against each other: fixed-point codes and long rows of bits in
 * hex, so that the last place is seen; the rest as above. */
unsigned glint_show_code(const glint_signal_info *signal);

/* Pipeline registers and outputs have a colour of their own. */
int glint_show_color(const glint_signal_info *signal);

/* Drawn as a curve as well. */
bool glint_show_curve(const glint_signal_info *signal);

#endif
