/* The command line of `glint render`. */
#ifndef GLINT_SIM_CLI_RENDER_OPTIONS_H
#define GLINT_SIM_CLI_RENDER_OPTIONS_H

#include "backend/backend.h"
#include "cli/scene_options.h"
#include "cli/trace_options.h"

typedef struct glint_render_options {
    glint_scene_options what;
    bool both; /* render by c and by rtl and compare; else by backend.kind */
    bool gl;   /* by OpenGL, as backend.kind real and scene.specular have it */
    bool gold; /* with the gold of the thesis's listing instead */
    glint_backend_config backend;
    glint_scene scene; /* all but the mesh */
    glint_trace_options trace;
    const char *out;
    bool json, force;
} glint_render_options;

/* Returns GLINT_OPTIONS_RUN with *chosen filled, or the exit status to leave with. */
int glint_render_options_parse(int argc, char **argv, glint_render_options *chosen);

#endif
