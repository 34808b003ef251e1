/* From two frames that differ to the answer of the circuit that made them differ. */
#ifndef GLINT_SIM_FAILURE_FRAME_H
#define GLINT_SIM_FAILURE_FRAME_H

#include "failure/failure.h"
#include "render/render.h"

typedef struct glint_frame_pair {
    const glint_scene *scene;            /* rendered twice, */
    const glint_backend_config *backend; /* by the C model and by this */
    const glint_image *model, *rtl;
    const glint_image_difference *difference; /* of the two, not equal; NULL: the circuit kept an
                                               * answer back, and there is no frame of the rtl */
} glint_frame_pair;

/* Renders the scene once more by the Verilog with every answer held against the C model's. stop:
 * may be NULL. */
glint_status glint_failure_of_frame(const glint_frame_pair *pair, const volatile bool *stop,
                                    glint_failure **failure, glint_error *err);

#endif
