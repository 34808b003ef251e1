/* An OpenGL context without a display or a window, by EGL on Mesa's surfaceless platform. libEGL is
 * loaded when a context is made, so that no other command needs it. */
#ifndef GLINT_SIM_GL_CONTEXT_H
#define GLINT_SIM_GL_CONTEXT_H

#include "gl/functions.h"
#include "glint_status.h"

typedef struct glint_gl_context glint_gl_context;

/* An OpenGL 3.3 core context, current for the calling thread, which alone may use it. One at a time
 * in a process. Mesa renders in software, with the given number of threads, and writes no cache of
 * compiled shaders, unless its own environment variables say otherwise (LIBGL_ALWAYS_SOFTWARE,
 * LP_NUM_THREADS, MESA_SHADER_CACHE_DISABLE). GLINT_IO_ERROR, saying what to install, where there
 * is no EGL or no driver behind it. */
glint_status glint_gl_context_create(int threads, glint_gl_context **context, glint_error *err);
void glint_gl_context_destroy(glint_gl_context *context); /* NULL is allowed */

const glint_gl *glint_gl_of(const glint_gl_context *context);

#endif
