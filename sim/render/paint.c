/* Flat shading, and Gouraud's in perspective. */
#include "render/paint.h"

void glint_flat_band(const glint_visibility *band, glint_image *image, uint64_t *fragments)
{
    for (int32_t y = band->first_y; y <= band->last_y; y++) {
        int32_t x = 0;
        glint_pixels pixels;
        const glint_triangle *t;
        while ((t = glint_visible_next(band, image->width, y, &x, &pixels)) != NULL) {
            *fragments += glint_paint_mark(image, y, pixels);
            for (int32_t at = pixels.first; at < x; at++)
                memcpy(glint_paint_pixel(image, at, y), t->color[0], 3);
        }
    }
}

/* I = (Σ weight·I/w) / (Σ weight/w), where numerator and denominator are linear on the screen. */
static void perspective_pixels(const glint_triangle *t, int32_t y, glint_pixels pixels,
                               uint8_t *values)
{
    const glint_weights w = glint_triangle_weights(t, pixels.first, y);
    for (int32_t k = 0; k <= pixels.last - pixels.first; k++) {
        const double b1 = (w.at1 + k * w.step1) * (double)t->inv_w[1];
        const double b2 = (w.at2 + k * w.step2) * (double)t->inv_w[2];
        const double b0 =
            (1.0 - (w.at1 + k * w.step1) - (w.at2 + k * w.step2)) * (double)t->inv_w[0];
        const double inv_sum = 1.0 / (b0 + b1 + b2);
        for (int c = 0; c < 3; c++) {
            const double value =
                (b0 * t->color[0][c] + b1 * t->color[1][c] + b2 * t->color[2][c]) * inv_sum;
            *values++ = (uint8_t)(value + 0.5);
        }
    }
}

void glint_perspective_band(const glint_visibility *band, glint_image *image, uint64_t *fragments)
{
    for (int32_t y = band->first_y; y <= band->last_y; y++) {
        int32_t x = 0;
        glint_pixels pixels;
        const glint_triangle *t;
        while ((t = glint_visible_next(band, image->width, y, &x, &pixels)) != NULL) {
            *fragments += glint_paint_mark(image, y, pixels);
            perspective_pixels(t, y, pixels, glint_paint_pixel(image, pixels.first, y));
        }
    }
}
