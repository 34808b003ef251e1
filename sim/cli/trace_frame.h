/* What `glint render --method trace` does in place of the rasterizer. The functions are weak: a
 * program may be linked without them (Makefile, glint-first), and they are then NULL. */
#ifndef GLINT_SIM_CLI_TRACE_FRAME_H
#define GLINT_SIM_CLI_TRACE_FRAME_H

#include "cli/render_report.h"
#include "file/json.h"

/* Traces a frame into frame->image, and the full one for comparison. */
glint_status glint_trace_frame(const glint_render_options *chosen,
                               const glint_backend_config *backend, const glint_scene *scene,
                               glint_render_frame *frame, glint_error *err) __attribute__((weak));

/* For a packet: the frame once more by one thread, its circuit watched. */
typedef struct glint_trace_again {
    const glint_render_options *chosen;
    const glint_scene *scene;
} glint_trace_again;

glint_status glint_trace_frame_again(void *context, glint_backend_watch *watch, glint_error *err)
    __attribute__((weak));

/* What is printed of a frame's rays. */
void glint_trace_frame_print(FILE *out, const glint_render_options *chosen,
                             const glint_render_frame *frame) __attribute__((weak));
void glint_trace_frame_json(json_t *json, const glint_render_options *chosen,
                            const glint_render_frame *frame) __attribute__((weak));

#endif
