/* Visibility: which triangle each pixel in a band of rows shows. */
#ifndef GLINT_SIM_RENDER_RASTER_H
#define GLINT_SIM_RENDER_RASTER_H

#include "render/setup.h"

/* Rows per band. Fixed, so that results do not depend on how bands are assigned to threads. */
#define GLINT_BAND_ROWS 16

/* What is seen of a band, row by row, extent.width pixels each. */
typedef struct glint_visibility {
    int32_t first_y, last_y;
    float *depth;                    /* 1/w of the nearest so far, 0 for nothing */
    const glint_triangle **triangle; /* and the triangle, NULL for nothing */
} glint_visibility;

/* Room for one band of that width; the arrays are NULL when there is no memory. */
void glint_visibility_create(glint_visibility *band, int32_t width);
void glint_visibility_destroy(glint_visibility *band);

/* Empties the band and sets it to rows first_y … last_y. */
void glint_visibility_begin(glint_visibility *band, glint_extent extent, int32_t first_y,
                            int32_t last_y);

/* Draws the triangles of the list in their order. */
void glint_visibility_draw(glint_visibility *band, glint_extent extent,
                           const glint_triangle_list *list);

/* Pixels of one row next to each other, first … last. */
typedef struct glint_pixels {
    int32_t first, last;
} glint_pixels;

/* The triangle seen at or after column *x of row y, nearest to it, and the pixels in a row that it
 * is seen in; *x is moved past them. NULL when there is none. */
static inline const glint_triangle *glint_visible_next(const glint_visibility *band, int32_t width,
                                                       int32_t y, int32_t *x, glint_pixels *pixels)
{
    const glint_triangle *const *seen =
        &band->triangle[(size_t)(y - band->first_y) * (size_t)width];
    int32_t at = *x;
    while (at < width && seen[at] == NULL)
        at++;
    const glint_triangle *t = at < width ? seen[at] : NULL;
    pixels->first = at;
    while (at < width && seen[at] == t)
        at++;
    pixels->last = at - 1;
    *x = at;
    return t;
}

/* All pixels of row y that the triangle covers, beyond the frame's sides too; last < first when it
 * covers none. */
glint_pixels glint_triangle_pixels(const glint_triangle *t, int32_t y);

/* The weights of corners 1 and 2 of a triangle at the sample of pixel (x, y), 0…1 inside, and their
 * increments for one pixel to the right. They come from the exact integer edge functions, so they
 * stay inside the triangle however thin it is. */
typedef struct glint_weights {
    double at1, at2, step1, step2;
} glint_weights;

glint_weights glint_triangle_weights(const glint_triangle *t, int32_t x, int32_t y);

#endif
