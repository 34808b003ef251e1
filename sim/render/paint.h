/* The shadings whose pixels need no circuit (flat, and Gouraud in perspective), and the row and
 * pixel writers shared by all run-based shadings. */
#ifndef GLINT_SIM_RENDER_PAINT_H
#define GLINT_SIM_RENDER_PAINT_H

#include <string.h>

#include "image/image.h"
#include "render/raster.h"

/* Empties row y. */
static inline void glint_paint_begin_row(glint_image *image, int32_t y)
{
    const size_t row = (size_t)y * (size_t)image->width;
    memset(&image->rgb[3 * row], 0, 3 * (size_t)image->width);
    memset(&image->object[row], 0, (size_t)image->width);
}

/* Marks pixels of row y as the object's; returns how many. */
static inline uint64_t glint_paint_mark(glint_image *image, int32_t y, glint_pixels pixels)
{
    const size_t count = (size_t)(pixels.last - pixels.first + 1);
    memset(&image->object[(size_t)y * (size_t)image->width + (size_t)pixels.first], 1, count);
    return count;
}

static inline uint8_t *glint_paint_pixel(const glint_image *image, int32_t x, int32_t y)
{
    return &image->rgb[3 * ((size_t)y * (size_t)image->width + (size_t)x)];
}

/* Into rows that are empty, like the next. Each pixel has its triangle's colour. Adds to
 * *fragments. */
void glint_flat_band(const glint_visibility *band, glint_image *image, uint64_t *fragments);

/* Each pixel gets the colour of the object's point seen in it: corner colours interpolated on the
 * object, not on the screen. Adds to *fragments. */
void glint_perspective_band(const glint_visibility *band, glint_image *image, uint64_t *fragments);

#endif
