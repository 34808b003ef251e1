/* The options of `glint render` that trace rays (thesis 2.6). Any of them without --method trace is
 * an error. */
#ifndef GLINT_SIM_CLI_TRACE_OPTIONS_H
#define GLINT_SIM_CLI_TRACE_OPTIONS_H

#include "cli/options.h"
#include "render/render.h"
#include "trace/join.h"

typedef struct glint_trace_options {
    bool traced; /* --method trace; else the rest says nothing */
    glint_join join;
    bool shadows;
    double reflect;

    /* As given, until they are settled. */
    int method, fill, measure;
    int64_t segment, centre;
    const char *limit;
    bool segment_given, centre_given, fill_given, measure_given, reflect_given;
} glint_trace_options;

void glint_trace_options_begin(glint_trace_options *chosen);

/* Rows of the option table, and for the details of --help. */
#define GLINT_TRACE_OPTIONS 8
void glint_trace_options_add(glint_trace_options *chosen, glint_option rows[GLINT_TRACE_OPTIONS]);

#define GLINT_TRACE_DETAILS                                                                        \
    "--method trace finds what is seen by rays (Embree 3), one for each pixel. With\n"             \
    "--segment L only the two ends of L pixels in a row are traced, and those between\n"           \
    "interpolated where the ends differ by at most the limit; else the segment is\n"               \
    "halved. nearest, bilinear and bicubic work on blocks of L by L pixels. The full\n"            \
    "trace is made too, for the error and the time saved.\n"

/* After the command line is read; gl: OpenGL is to draw. Returns GLINT_OPTIONS_RUN, or the exit
 * status when it makes no sense with the scene. */
int glint_trace_options_settle(const char *command, const glint_scene *scene, bool gl,
                               glint_trace_options *chosen);

#endif
