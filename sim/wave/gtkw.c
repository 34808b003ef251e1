/* The syntax of a GTKWave save file. */
#include "wave/gtkw.h"

#include <inttypes.h>
#include <math.h>
#include <string.h>

#include "file/new_file.h"
#include "rtl/rtl.h"

/* Trace flags of GTKWave's save files. */
#define SHOW_FIXED_POINT 0x40000000u /* with [fpshift_count] */
#define CURVE_HEIGHT     0x20000u    /* an empty row that the curve above grows into */
#define HEADING          0x200u
#define GROUP_BEGIN      0x800200u
#define GROUP_CLOSED     0x400000u
#define GROUP_END        0x1000200u

/* Pixels of GTKWave's window, in its own fonts. */
#define WINDOW_WIDTH  1600
#define WINDOW_HEIGHT 1000
#define BESIDE_PANES  64 /* of the width: the folded tree of scopes, the scroll bar, edges */
#define CHARACTER     8  /* of names and values */
#define PANE_EDGES    24 /* about names and values */
#define ZOOM_FRAME    200
#define CURVE_ROWS    3 /* beside the curve's own */

/* GTKWave prints at most this many fraction digits: 16 significant ones plus three zeros, since it
 * drops fractions below 0.0001. */
#define FRACTION_DIGITS 19

struct glint_gtkw {
    FILE *out; /* NULL: only the widths are wanted */
    int label_width, value_width;
};

static int max(int a, int b)
{
    return a > b ? a : b;
}

static void write_title(glint_gtkw *rows, unsigned flags, const char *title)
{
    rows->label_width = max(rows->label_width, (int)strlen(title));
    if (rows->out != NULL)
        fprintf(rows->out, "@%x\n-%s\n", flags, title);
}

void glint_gtkw_heading(glint_gtkw *rows, const char *title)
{
    write_title(rows, HEADING, title);
}

void glint_gtkw_begin_closed_group(glint_gtkw *rows, const char *title)
{
    write_title(rows, GROUP_BEGIN | GROUP_CLOSED, title);
}

void glint_gtkw_end_group(glint_gtkw *rows, const char *title)
{
    write_title(rows, GROUP_END, title);
}

static int decimal_digits(int bits)
{
    return 1 + (int)(bits * 0.30103);
}

/* Characters of the widest value, with the equals sign before it. */
static int value_width(const glint_gtkw_trace *trace)
{
    if (trace->frac_bits > 0) /* and a sign and a point */
        return 3 + decimal_digits(trace->width - trace->frac_bits) +
               (trace->frac_bits < FRACTION_DIGITS ? trace->frac_bits : FRACTION_DIGITS);
    if ((trace->flags & GLINT_GTKW_SHOW_HEX) == GLINT_GTKW_SHOW_HEX)
        return 1 + (trace->width + 3) / 4;
    if ((trace->flags & GLINT_GTKW_SHOW_BINARY) == GLINT_GTKW_SHOW_BINARY)
        return 1 + trace->width;
    return 2 + decimal_digits(trace->width);
}

void glint_gtkw_add(glint_gtkw *rows, const glint_gtkw_trace *trace)
{
    const bool is_shifted = trace->frac_bits > 0 && !trace->is_text;
    rows->label_width = max(rows->label_width, (int)strlen(trace->label));
    rows->value_width = max(rows->value_width, value_width(trace));
    if (rows->out == NULL)
        return;
    fprintf(rows->out, "@%x\n", is_shifted ? trace->flags | SHOW_FIXED_POINT : trace->flags);
    if (trace->color != GLINT_GTKW_COLOR_NORMAL)
        fprintf(rows->out, "[color] %d\n", trace->color);
    if (is_shifted)
        fprintf(rows->out, "[fpshift_count] %d\n", trace->frac_bits);
    fprintf(rows->out, "+{%s} %s%s", trace->label, trace->scope, trace->name);
    if (trace->width > 1 && !trace->is_text)
        fprintf(rows->out, "[%d:0]", trace->width - 1);
    fprintf(rows->out, "\n");
}

void glint_gtkw_curve_height(glint_gtkw *rows)
{
    for (int i = 0; i < CURVE_ROWS && rows->out != NULL; i++)
        fprintf(rows->out, "@%x\n-\n", CURVE_HEIGHT);
}

/* When the view begins; that it all lies in the waveform comes first. */
static uint64_t view_begin(const glint_gtkw_window *window)
{
    const uint64_t before = GLINT_GTKW_BEFORE * GLINT_RTL_TRACE_PERIOD;
    const uint64_t view = GLINT_GTKW_CLOCKS * GLINT_RTL_TRACE_PERIOD;
    const uint64_t marker = window->marker_time < 0 ? 0 : (uint64_t)window->marker_time;
    uint64_t begin = marker > before ? marker - before : 0;
    if (begin + view > window->last_time)
        begin = window->last_time > view ? window->last_time - view : 0;
    return begin > window->first_time ? begin : window->first_time;
}

uint64_t glint_gtkw_end_for_marker(uint64_t first_time, uint64_t marker_time)
{
    /* The beginning is taken when the view fits between it and the end; where it does not, the view
     * is longer than from the beginning to the end, which is to be as long as from the first time
     * to the marker. */
    const uint64_t before = GLINT_GTKW_BEFORE * GLINT_RTL_TRACE_PERIOD;
    const uint64_t view = GLINT_GTKW_CLOCKS * GLINT_RTL_TRACE_PERIOD;
    const uint64_t begin = marker_time > first_time + before ? marker_time - before : first_time;
    const uint64_t length = marker_time - first_time + GLINT_RTL_TRACE_PERIOD;
    return begin + (length > view ? length : view);
}

static void write_header(FILE *out, const char *title, const glint_gtkw_window *window,
                         const glint_gtkw *widths)
{
    const char *slash = strrchr(window->waveform, '/');
    const int signals = CHARACTER * (widths->label_width + widths->value_width) + PANE_EDGES;
    const double wave = WINDOW_WIDTH - BESIDE_PANES - signals;
    const double view = GLINT_GTKW_CLOCKS * GLINT_RTL_TRACE_PERIOD;
    /* GTKWave's zoom: a window of this many pixels shows 2^−zoom time units. */
    const double zoom = -log2(view * ZOOM_FRAME / wave);
    fprintf(out, "[*] %s\n", title);
    fprintf(out, "[dumpfile] \"%s\"\n", slash != NULL ? slash + 1 : window->waveform);
    fprintf(out, "[timestart] %" PRIu64 "\n", view_begin(window));
    fprintf(out, "[size] %d %d\n[pos] -1 -1\n", WINDOW_WIDTH, WINDOW_HEIGHT);
    fprintf(out, "*%f %" PRId64, zoom, window->marker_time);
    for (int i = 0; i < 26; i++) /* the named markers a…z: none */
        fprintf(out, " -1");
    fprintf(out, "\n[sst_width] 0\n[signals_width] %d\n[sst_expanded] 0\n", signals);
}

glint_status glint_gtkw_write(const char *path, const char *title, const glint_gtkw_window *window,
                              glint_gtkw_fill *fill, const void *context, glint_error *err)
{
    glint_gtkw rows = {0};
    glint_new_file *file;
    const glint_status status = glint_new_file_open(path, &file, err);
    if (status != GLINT_OK)
        return status;
    fill(&rows, context);
    rows.out = glint_new_file_stream(file);
    write_header(rows.out, title, window, &rows);
    fill(&rows, context);
    return glint_new_file_commit(file, err);
}
