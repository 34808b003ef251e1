/* Deferred quadratic shading of one band of rows (quadratic.h). */
#ifndef GLINT_SIM_RENDER_QUADRATIC_BAND_H
#define GLINT_SIM_RENDER_QUADRATIC_BAND_H

#include "image/image.h"
#include "render/quadratic.h"

/* Every pixel has the polynomial's value in double precision, rounded half up and held in
 * 0 … 255. Adds to *fragments. */
void glint_quadratic_band(const glint_visibility *band, glint_image *image, uint64_t *fragments);

#endif
