/* What each shading is called and what it needs. */
#ifndef GLINT_SIM_RENDER_SHADINGS_H
#define GLINT_SIM_RENDER_SHADINGS_H

#include "render/shade.h"

/* It interpolates with the divider. */
bool glint_shading_divides(glint_shading shading);

/* Vertices are lit. */
bool glint_shading_lights_vertices(glint_shading shading);

/* Of its fragments. */
glint_cosines glint_shading_cosines(glint_shading shading);

/* Something in its frames comes from a circuit. */
bool glint_shading_uses_circuit(glint_shading shading);

/* GLINT_BAD_ARGUMENT when the scene asks something of its shading that it cannot do with that kind
 * of backend. */
glint_status glint_shading_check(const glint_scene *scene, glint_backend_kind kind,
                                 glint_error *err);

#endif
