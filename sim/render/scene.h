/* Range checks for a scene's values. */
#ifndef GLINT_SIM_RENDER_SCENE_H
#define GLINT_SIM_RENDER_SCENE_H

#include "render/render.h"

/* GLINT_BAD_ARGUMENT for the first value out of its range (render.h), naming it. */
glint_status glint_scene_check(const glint_scene *scene, glint_error *err);

/* Registers 2 to 5 for a scene: n, and the highlight's colour times Ie·Ks, rounded half up. */
glint_material glint_scene_material(const glint_scene *scene);

#endif
