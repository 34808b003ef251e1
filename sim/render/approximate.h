/* Phong's shading with cheaper cosines, as in the list of the thesis's appendix A: the rest of a
 * fragment, and whoever computes its highlight, stay the same.
 *
 * On the screen all of them are linear along edges and rows. A triangle's corners hold, in place of
 * normal/w, what is interpolated: unit normals, or N·L and N·H. */
#ifndef GLINT_SIM_RENDER_APPROXIMATE_H
#define GLINT_SIM_RENDER_APPROXIMATE_H

#include "render/shade.h"

/* The triangles of the list get the corners that lighting->cosines needs. */
void glint_approximate_corners(const glint_lighting *lighting, glint_triangle_list *list);

/* One row of gathered fragments: cosine codes, base and lit, and with a model its highlights, which
 * begin at `first` in the band. */
void glint_approximate_row(glint_shader *shader, const glint_lighting *lighting, int32_t y,
                           size_t count, const uint16_t *columns, size_t first, uint32_t *cos_code);

/* Fragments without a highlight: ambient and Lambert light alone, the same as with it. Adds to
 * *fragments. columns: room for the band. */
void glint_dull_band(glint_shader *shader, const glint_lighting *lighting,
                     const glint_visibility *band, uint16_t *columns, glint_image *image,
                     uint64_t *fragments);

#endif
