/* What `glint render` prints about its frames. */
#ifndef GLINT_SIM_CLI_RENDER_REPORT_H
#define GLINT_SIM_CLI_RENDER_REPORT_H

#include <stdio.h>

#include "cli/render_options.h"
#include "trace/trace.h"

/* Of a frame that was traced. */
typedef struct glint_trace_result {
    glint_trace_stats joined, full; /* the frame, and the full trace of it */
    glint_image_difference error;   /* from the full trace to the frame */
    double build_seconds;           /* of the tree */
} glint_trace_result;

/* One frame by one backend. */
typedef struct glint_render_frame {
    const char *backend; /* its name */
    char driver[128];    /* backend gl: what draws, else "" */
    glint_renderer *renderer;
    glint_image *image;
    glint_render_stats stats;
    glint_trace_result trace; /* with --method trace; there is no renderer then */
} glint_render_frame;

/* With --isc on: the same frame with and without. */
typedef struct glint_render_isc {
    bool measured;
    double seconds_with, seconds_without; /* of shading, the least of some frames */
    glint_image_difference difference;    /* between the two */
} glint_render_isc;

typedef struct glint_render_result {
    glint_render_frame frame[2]; /* --backend both: c, then rtl; else one */
    int frame_count;
    glint_image_difference difference; /* from frame[0] to frame[1] */
    glint_render_isc isc;
} glint_render_result;

/* True when there are two frames and they are not the same picture. */
bool glint_render_differs(const glint_render_result *result);

void glint_render_report_text(FILE *out, const glint_render_options *chosen,
                              const glint_render_result *result);

/* packet: where the packet of a difference is, or NULL. Returns false when memory ran out. */
bool glint_render_report_json(const glint_render_options *chosen, const glint_render_result *result,
                              const char *packet);

#endif
