/* From two differing frames to the circuit's answer that caused the difference. */
#ifndef GLINT_SIM_FAILURE_FRAME_H
#define GLINT_SIM_FAILURE_FRAME_H

#include "failure/failure.h"
#include "render/render.h"

typedef struct glint_frame_pair {
    const glint_scene *scene;            /* rendered twice, */
    const glint_backend_config *backend; /* by the C model and by this */
    const glint_image *model, *rtl;
    const glint_image_difference *difference; /* of the two, not equal; NULL: the circuit failed to
                                               * answer, so there is no rtl frame */
    /* What asks the circuit again, which it has watched; NULL: the rasterizer. */
    glint_status (*ask)(void *context, glint_backend_watch *watch, glint_error *err);
    void *context;
} glint_frame_pair;

/* Renders the scene once more with the Verilog, comparing every answer with the C model's. stop:
 * may be NULL. */
glint_status glint_failure_of_frame(const glint_frame_pair *pair, const volatile bool *stop,
                                    glint_failure **failure, glint_error *err);

#endif
