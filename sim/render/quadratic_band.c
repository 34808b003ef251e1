/* Quadratic shading, piece by piece: the pixels of a row in which one triangle is seen. */
#include "render/quadratic_band.h"

#include "render/paint.h"

/* What a triangle's components are interpolated by. */
typedef struct components {
    glint_quadratic of[3];
} components;

static components components_of(const glint_triangle *t)
{
    components q;
    for (int c = 0; c < 3; c++)
        q.of[c] = glint_quadratic_of_triangle(t, c);
    return q;
}

static void paint_exact(const glint_triangle *t, int32_t y, glint_pixels pixels, uint8_t *values)
{
    const glint_weights w = glint_triangle_weights(t, pixels.first, y);
    const components q = components_of(t);
    for (int32_t k = 0; k <= pixels.last - pixels.first; k++) {
        const double u = w.at1 + k * w.step1;
        const double v = w.at2 + k * w.step2;
        for (int c = 0; c < 3; c++)
            *values++ = glint_quadratic_level(glint_quadratic_at(&q.of[c], u, v));
    }
}

void glint_quadratic_band(const glint_visibility *band, glint_image *image, uint64_t *fragments)
{
    for (int32_t y = band->first_y; y <= band->last_y; y++) {
        glint_paint_begin_row(image, y);
        int32_t x = 0;
        glint_pixels pixels;
        const glint_triangle *t;
        while ((t = glint_visible_next(band, image->width, y, &x, &pixels)) != NULL) {
            *fragments += glint_paint_mark(image, y, pixels);
            paint_exact(t, y, pixels, glint_paint_pixel(image, pixels.first, y));
        }
    }
}
