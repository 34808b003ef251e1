/* A program of OpenGL for one shading and one reflectance model, from the files of sim/shader. */
#ifndef GLINT_SIM_GL_PROGRAM_H
#define GLINT_SIM_GL_PROGRAM_H

#include "gl/functions.h"
#include "render/render.h"

/* Whether there are shaders for it. */
bool glint_gl_has_shading(glint_shading shading);

/* Compiles and links it. GLINT_BAD_INPUT, with the first line of the driver's log, for a shader
 * that the driver rejects; GLINT_BAD_ARGUMENT for a shading without shaders. */
glint_status glint_gl_program(const glint_gl *gl, glint_shading shading,
                              glint_reflectance_model model, GLuint *program, glint_error *err);

/* The bump-mapped gold of the thesis's listing, which has no model and no shading of these. */
glint_status glint_gl_gold_program(const glint_gl *gl, GLuint *program, glint_error *err);

#endif
