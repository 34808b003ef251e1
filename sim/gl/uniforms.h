/* A scene's values as the uniforms of a program. */
#ifndef GLINT_SIM_GL_UNIFORMS_H
#define GLINT_SIM_GL_UNIFORMS_H

#include "gl/functions.h"
#include "render/camera.h"
#include "render/shade.h"

/* Sets those that the program has, which must be in use. The model is one of the scene's n. */
void glint_gl_set_uniforms(const glint_gl *gl, GLuint program, const glint_scene *scene,
                           const glint_camera *camera, const glint_lighting *lighting,
                           glint_reflectance_model model);

#endif
