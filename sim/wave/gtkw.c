#include "wave/gtkw.h"

#include <inttypes.h>
#include <math.h>
#include <string.h>

/* Trace flags of GTKWave's save files. */
#define SHOW_FIXED_POINT 0x40000000u /* with [fpshift_count] */
#define CURVE_HEIGHT     0x20000u    /* an empty row that the curve above grows into */
#define HEADING          0x200u
#define GROUP_BEGIN      0x800200u
#define GROUP_CLOSED     0x400000u
#define GROUP_END        0x1000200u

#define COLOR_STAGE  2 /* orange */
#define COLOR_OUTPUT 3 /* yellow */

/* Pixels of GTKWave's wave area at the size written below, for the zoom that shows the window. */
#define WINDOW_WIDTH  1600
#define WINDOW_HEIGHT 1000
#define SIGNALS_WIDTH 400
#define WAVE_WIDTH    1130
#define ZOOM_FRAME    200
#define CURVE_ROWS    3 /* beside the curve's own */

void glint_gtkw_heading(FILE *out, const char *title)
{
    fprintf(out, "@%x\n-%s\n", HEADING, title);
}

void glint_gtkw_begin_closed_group(FILE *out, const char *title)
{
    fprintf(out, "@%x\n-%s\n", GROUP_BEGIN | GROUP_CLOSED, title);
}

void glint_gtkw_end_group(FILE *out, const char *title)
{
    fprintf(out, "@%x\n-%s\n", GROUP_END, title);
}

void glint_gtkw_trace(FILE *out, const char *scope, const char *name, int width, unsigned flags,
                      int color, int frac_bits)
{
    fprintf(out, "@%x\n", frac_bits > 0 ? flags | SHOW_FIXED_POINT : flags);
    if (color != GLINT_GTKW_COLOR_NORMAL)
        fprintf(out, "[color] %d\n", color);
    if (frac_bits > 0)
        fprintf(out, "[fpshift_count] %d\n", frac_bits);
    if (width > 1)
        fprintf(out, "%s%s[%d:0]\n", scope, name, width - 1);
    else
        fprintf(out, "%s%s\n", scope, name);
}

void glint_gtkw_curve_height(FILE *out)
{
    for (int i = 0; i < CURVE_ROWS; i++)
        fprintf(out, "@%x\n-\n", CURVE_HEIGHT);
}

int glint_gtkw_color(glint_signal_kind kind)
{
    return kind == GLINT_SIGNAL_STAGE    ? COLOR_STAGE
           : kind == GLINT_SIGNAL_OUTPUT ? COLOR_OUTPUT
                                         : GLINT_GTKW_COLOR_NORMAL;
}

void glint_gtkw_header(FILE *out, const char *title, const glint_gtkw_window *window)
{
    const char *slash = strrchr(window->waveform, '/');
    double shown = (double)(window->last_time - window->first_time);
    /* GTKWave's zoom: a frame of so many pixels shows 2^−zoom time units. */
    double zoom = -log2(shown * ZOOM_FRAME / WAVE_WIDTH);
    fprintf(out, "[*] %s\n", title);
    fprintf(out, "[dumpfile] \"%s\"\n", slash != NULL ? slash + 1 : window->waveform);
    fprintf(out, "[timestart] %" PRIu64 "\n", window->first_time);
    fprintf(out, "[size] %d %d\n[pos] -1 -1\n", WINDOW_WIDTH, WINDOW_HEIGHT);
    fprintf(out, "*%f %" PRId64, zoom, window->marker_time);
    for (int i = 0; i < 26; i++) /* the named markers a…z: none */
        fprintf(out, " -1");
    fprintf(out, "\n[sst_width] 0\n[signals_width] %d\n[sst_expanded] 0\n", SIGNALS_WIDTH);
}
