/* Writes GTKWave save files: their rows, and the view that they open with. */
#ifndef GLINT_SIM_WAVE_GTKW_H
#define GLINT_SIM_WAVE_GTKW_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

#include "glint_status.h"

/* How a trace is shown: flags of GTKWave's save files. */
#define GLINT_GTKW_SHOW_HEX     0x22u /* right-justified */
#define GLINT_GTKW_SHOW_DECIMAL 0x24u
#define GLINT_GTKW_SHOW_BINARY  0x28u
#define GLINT_GTKW_SHOW_SIGNED  0x420u
#define GLINT_GTKW_SHOW_CURVE   0x88000u /* analog steps, scaled to the whole file */

#define GLINT_GTKW_COLOR_NORMAL 0
#define GLINT_GTKW_COLOR_RED    1
#define GLINT_GTKW_COLOR_ORANGE 2
#define GLINT_GTKW_COLOR_YELLOW 3

/* The waveform, and where to look. The view has GLINT_GTKW_CLOCKS clocks, the marker behind the
 * first GLINT_GTKW_BEFORE of them, or as many as the waveform has before it. */
typedef struct glint_gtkw_window {
    const char *waveform; /* the file it belongs to: its last component is named in the save file */
    uint64_t first_time, last_time; /* ns: what the waveform has, first < last */
    int64_t marker_time;            /* −1: no marker */
} glint_gtkw_window;

#define GLINT_GTKW_CLOCKS 20
#define GLINT_GTKW_BEFORE 8

/* GTKWave uses a save file's start of view only if the whole view then lies within the waveform;
 * otherwise it starts at the beginning, wherever the marker is. The width of the view depends on
 * the window. A waveform that lasts until this time has its marker in view in every window wide
 * enough for GLINT_GTKW_BEFORE clocks. */
uint64_t glint_gtkw_end_for_marker(uint64_t first_time, uint64_t marker_time);

/* One signal of the waveform as a row. */
typedef struct glint_gtkw_trace {
    const char *scope, *name; /* scope ends with a dot */
    const char *label;        /* what stands before it */
    int width;                /* bits */
    unsigned flags;
    int color;
    int frac_bits; /* above 0: GTKWave shows the code as a real number, but leaves out a fraction
                    * below 0.0001 */
    bool is_text;  /* the waveform has the number as a text: flags means nothing */
} glint_gtkw_trace;

/* The rows under way. */
typedef struct glint_gtkw glint_gtkw;

/* A row of text, and a group that starts folded. */
void glint_gtkw_heading(glint_gtkw *rows, const char *title);
void glint_gtkw_begin_closed_group(glint_gtkw *rows, const char *title);
void glint_gtkw_end_group(glint_gtkw *rows, const char *title);

void glint_gtkw_add(glint_gtkw *rows, const glint_gtkw_trace *trace);

/* The empty rows that the curve above them grows into. */
void glint_gtkw_curve_height(glint_gtkw *rows);

/* Writes the file under a temporary name, then renames it. `fill` makes the rows; it is called
 * twice, first to measure names and values so that both are fully visible. */
typedef void glint_gtkw_fill(glint_gtkw *rows, const void *context);
glint_status glint_gtkw_write(const char *path, const char *title, const glint_gtkw_window *window,
                              glint_gtkw_fill *fill, const void *context, glint_error *err);

#endif
