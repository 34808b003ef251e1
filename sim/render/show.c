/* Wires and normals; see show.h. */
#include "render/show.h"

#include <math.h>

#include "render/paint.h"
#include "render/pixel.h"

/* The distance of the sample of pixel (x, y) from the nearest edge, in pixels. */
static double distance_from_edge(const glint_triangle *t, int32_t x, int32_t y)
{
    const double px = ((double)x + 0.5) * GLINT_SUBPIXEL_ONE;
    const double py = ((double)y + 0.5) * GLINT_SUBPIXEL_ONE;
    double least = INFINITY;
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3;
        const double dx = (double)t->x[j] - (double)t->x[i], dy = (double)t->y[j] - (double)t->y[i];
        const double across = fabs(dx * (py - (double)t->y[i]) - dy * (px - (double)t->x[i]));
        least = fmin(least, across / sqrt(dx * dx + dy * dy));
    }
    return least / GLINT_SUBPIXEL_ONE;
}

void glint_wires_band(const glint_visibility *band, const uint8_t color[3], glint_image *image,
                      uint64_t *fragments)
{
    for (int32_t y = band->first_y; y <= band->last_y; y++) {
        int32_t x = 0;
        glint_pixels pixels;
        const glint_triangle *t;
        while ((t = glint_visible_next(band, image->width, y, &x, &pixels)) != NULL) {
            *fragments += glint_paint_mark(image, y, pixels);
            for (int32_t at = pixels.first; at < x; at++)
                if (distance_from_edge(t, at, y) <= 0.5)
                    memcpy(glint_paint_pixel(image, at, y), color, 3);
        }
    }
}

void glint_normals_band(glint_shader *shader, const glint_visibility *band, uint16_t *columns,
                        glint_image *image, uint64_t *fragments)
{
    for (int32_t y = band->first_y; y <= band->last_y; y++) {
        const size_t found = glint_shader_gather(shader, band, y, image->width, columns);
        for (size_t i = 0; i < found; i++) {
            float square = GLINT_TINY;
            for (int axis = 0; axis < 3; axis++)
                square += shader->n[axis][i] * shader->n[axis][i];
            for (int axis = 0; axis < 3; axis++) {
                shader->base[axis][i] =
                    glint_intensity_of(127.5f * (shader->n[axis][i] / sqrtf(square) + 1.0f));
            }
        }
        glint_shader_write(shader, columns, 0, found, image, y);
        *fragments += found;
    }
}
