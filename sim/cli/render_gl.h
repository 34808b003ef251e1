/* A frame of `glint render` by OpenGL. */
#ifndef GLINT_SIM_CLI_RENDER_GL_H
#define GLINT_SIM_CLI_RENDER_GL_H

#include "cli/render_report.h"

/* Renders the scene into frame->image, which is made here. Weak, as the subcommands are
 * (commands.h): NULL in a program without it. */
glint_status glint_render_by_gl(const glint_render_options *chosen, const glint_scene *scene,
                                glint_render_frame *frame, glint_error *err) __attribute__((weak));

#endif
