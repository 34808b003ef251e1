/* What ISC saves: frames with it and without it, in turn. */
#ifndef GLINT_SIM_CLI_RENDER_ISC_H
#define GLINT_SIM_CLI_RENDER_ISC_H

#include "cli/render_report.h"

/* Renders the first frame's scene anew, both ways, by its own renderer; the pictures are compared
 * with that frame's. */
glint_status glint_render_measure_isc(const glint_scene *scene, glint_render_result *result,
                                      glint_error *err);

#endif
