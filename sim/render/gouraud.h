/* Deferred Gouraud shading of one band of rows by the span unit (span.h): intensities along the
 * edges of the triangles seen in it, then along their rows. Also the two shadings that need no
 * division by the circuit: flat, and Gouraud in perspective. */
#ifndef GLINT_SIM_RENDER_GOURAUD_H
#define GLINT_SIM_RENDER_GOURAUD_H

#include "backend/divider_backend.h"
#include "image/image.h"
#include "render/raster.h"
#include "render/span.h"

/* One thread's room and counters. */
typedef struct glint_gouraud glint_gouraud;

/* For bands of that width. NULL: no memory. */
glint_gouraud *glint_gouraud_create(int32_t width);
void glint_gouraud_destroy(glint_gouraud *gouraud); /* NULL is allowed */

/* Shades the band into the image, whose rows are empty. divider has that many shifts; NULL: the
 * values of a run are exact, without a circuit. Adds to *fragments and *operations. */
glint_status glint_gouraud_band(glint_gouraud *gouraud, const glint_visibility *band,
                                glint_divider_backend *divider, int shifts, glint_image *image,
                                uint64_t *fragments, glint_span_operations *operations,
                                glint_error *err);

#endif
