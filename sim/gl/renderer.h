/* Frames by OpenGL: the scene of render/render.h through the shaders of sim/shader, drawn by Mesa
 * in software without a display. It samples pixels where Glint's rasterizer does, at their centres,
 * without multisampling or dithering; which pixels an edge covers is the driver's own decision
 * (docs/shaders.md). */
#ifndef GLINT_SIM_GL_RENDERER_H
#define GLINT_SIM_GL_RENDERER_H

#include "render/render.h"

typedef struct glint_gl_renderer glint_gl_renderer;

/* A renderer of width × height frames of the mesh, which goes to OpenGL here, once. See context.h
 * for threads, for what is said where OpenGL is missing, and for what may be used at once. */
glint_status glint_gl_renderer_create(const glint_mesh *mesh, int width, int height, int threads,
                                      glint_gl_renderer **renderer, glint_error *err);
void glint_gl_renderer_destroy(glint_gl_renderer *renderer); /* NULL is allowed */

/* What draws, in OpenGL's own words: "llvmpipe (LLVM 15.0.6, 256 bits)". */
const char *glint_gl_renderer_name(const glint_gl_renderer *renderer);

/* From now on frames have the bump-mapped gold of the thesis's listing (sim/shader/gold.vert) in
 * place of the scene's light, colours, model and shading. */
glint_status glint_gl_renderer_gild(glint_gl_renderer *renderer, glint_error *err);

/* Draws a frame of the renderer's mesh, whichever the scene has, as glint_render() does with
 * backend real; the highlight is scene->specular's if by_model, else the cosine-quadratic's, the
 * device's formula. The first frame of a shading and model compiles the shaders, which
 * stats->seconds leaves out; of the other figures it has triangles, fragments and highlights.
 * GLINT_BAD_ARGUMENT for a scene value out of range or a shading without shaders. */
glint_status glint_gl_render(glint_gl_renderer *renderer, const glint_scene *scene,
                             glint_image *image, const volatile bool *stop,
                             glint_render_stats *stats, glint_error *err);

#endif
