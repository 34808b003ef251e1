/* Options of single shadings: --isc of phong, --delta of mixed, --map of reflection-map. */
#ifndef GLINT_SIM_CLI_SHADING_OPTIONS_H
#define GLINT_SIM_CLI_SHADING_OPTIONS_H

#include "cli/options.h"
#include "render/render.h"

typedef struct glint_shading_options {
    int isc; /* index of "off" or "on" */
    int64_t delta, map;
    bool delta_given, map_given;
} glint_shading_options;

#define GLINT_SHADING_OPTIONS 3

glint_shading_options glint_shading_options_default(void);
void glint_shading_options_add(glint_shading_options *chosen,
                               glint_option rows[GLINT_SHADING_OPTIONS]);

/* Into the scene, whose shading is set. Returns GLINT_OPTIONS_RUN, or the exit status when one was
 * given to another shading than its own. */
int glint_shading_options_settle(const char *command, const glint_shading_options *chosen,
                                 glint_scene *scene);

#endif
