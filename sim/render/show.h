/* What a mesh is made of, as a picture: its triangulation as wires, its normals as colours. Nothing
 * is lit, so nothing comes from a circuit. */
#ifndef GLINT_SIM_RENDER_SHOW_H
#define GLINT_SIM_RENDER_SHOW_H

#include "render/shade.h"

/* Into empty rows, both; both add to *fragments.
 *
 * Pixels whose centre is within half a pixel of an edge of the triangle seen in them get the
 * object's colour; the rest of the object is black. */
void glint_wires_band(const glint_visibility *band, const uint8_t color[3], glint_image *image,
                      uint64_t *fragments);

/* x, y, z of the interpolated, normalised normal in camera axes, −1…1, as R, G, B, 0…255, rounded
 * half up. columns: room for a row. */
void glint_normals_band(glint_shader *shader, const glint_visibility *band, uint16_t *columns,
                        glint_image *image, uint64_t *fragments);

#endif
