/* The parts of a GTKWave save file, for the save files of all circuits. */
#ifndef GLINT_SIM_GTKW_H
#define GLINT_SIM_GTKW_H

#include <stdint.h>
#include <stdio.h>

#include "glint_signal.h"

/* How a trace is shown: flags of GTKWave's save files. */
#define GLINT_GTKW_SHOW_HEX     0x22u /* right-justified */
#define GLINT_GTKW_SHOW_DECIMAL 0x24u
#define GLINT_GTKW_SHOW_BINARY  0x28u
#define GLINT_GTKW_SHOW_SIGNED  0x420u
#define GLINT_GTKW_SHOW_CURVE   0x88000u /* analog steps, scaled to the whole file */

#define GLINT_GTKW_COLOR_NORMAL 0
#define GLINT_GTKW_COLOR_RED    1

/* What the window shows when the file is opened. */
typedef struct glint_gtkw_window {
    const char *waveform; /* the file it belongs to: its last component is named in the save file */
    uint64_t first_time;  /* ns */
    uint64_t last_time;   /* > first_time */
    int64_t marker_time;  /* where the marker stands; −1: nowhere */
} glint_gtkw_window;

/* The beginning of the file. */
void glint_gtkw_header(FILE *out, const char *title, const glint_gtkw_window *window);

/* A row of text, and a group that is folded until somebody opens it. */
void glint_gtkw_heading(FILE *out, const char *title);
void glint_gtkw_begin_closed_group(FILE *out, const char *title);
void glint_gtkw_end_group(FILE *out, const char *title);

/* One signal: scope ends with a dot; frac_bits above 0 shows the code as a real number. */
void glint_gtkw_trace(FILE *out, const char *scope, const char *name, int width, unsigned flags,
                      int color, int frac_bits);

/* The empty rows that the curve above them grows into. */
void glint_gtkw_curve_height(FILE *out);

/* Colour of a signal: pipeline registers and outputs have their own. */
int glint_gtkw_color(glint_signal_kind kind);

#endif
