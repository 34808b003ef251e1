/* The shaders of sim/shader as lines without their newline; the last one NULL. */
#ifndef GLINT_SIM_GL_TEXTS_H
#define GLINT_SIM_GL_TEXTS_H

#include "reflectance/reflectance.h"

/* The file of each reflectance model, by its number. */
extern const char *const *const glint_shader_models[GLINT_REFLECTANCE_COUNT];

/* What several programs share. */
extern const char *const glint_shader_surface[], *const glint_shader_light[];
extern const char *const glint_shader_camera[], *const glint_shader_frame[];

/* The stages of each shading. */
extern const char *const glint_shader_phong_vert[], *const glint_shader_phong_frag[];
extern const char *const glint_shader_gouraud_vert[], *const glint_shader_gouraud_frag[];
extern const char *const glint_shader_flat_vert[], *const glint_shader_flat_geom[];
extern const char *const glint_shader_flat_frag[];

/* The gold of the thesis's listing. */
extern const char *const glint_shader_gold_vert[], *const glint_shader_gold_frag[];

#endif
