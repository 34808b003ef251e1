/* What is seen at a pixel of a renderer's last frame. Not to be asked before the first frame, nor
 * while one is being rendered. */
#ifndef GLINT_SIM_RENDER_PICK_H
#define GLINT_SIM_RENDER_PICK_H

#include "render/render.h"

/* The run of cosine codes and the material of the last frame, for inspection: the fragment of pixel
 * (x, y). Returns false when no object covers that pixel, or when the frame has another shading
 * than Phong's, or a model's highlights, and so no codes at pixels. */
bool glint_renderer_fragment(const glint_renderer *renderer, int x, int y, uint32_t *cos_code,
                             glint_material *material);

/* The mesh's triangle that is seen in pixel (x, y) of the last frame; false when none is. */
bool glint_renderer_triangle(glint_renderer *renderer, int x, int y, uint32_t *triangle);

#define GLINT_NO_TRIANGLE UINT32_MAX

/* The same for every pixel: width·height numbers, row by row, GLINT_NO_TRIANGLE where none is. */
void glint_renderer_triangles(glint_renderer *renderer, uint32_t *seen);

#endif
