/* The vectors of one pixel, for the loops over fragments. */
#ifndef GLINT_SIM_RENDER_PIXEL_H
#define GLINT_SIM_RENDER_PIXEL_H

#include <math.h>

#include "render/shade.h"

/* Is lost in any sum but that of a normal or an H without length, whose cosine it makes 0 instead
 * of 0/0. */
#define GLINT_TINY 1e-37f

/* One pixel's vectors: V, which depends on the pixel alone, is the way back along the ray through
 * it; H = L + V, L and V of unit length, N of any. */
typedef struct glint_pixel {
    float lv, nn, nh, hh, nl, nv;
} glint_pixel;

/* In the loops that use it: no branches and no selections of floating-point values, so that
 * compilers vectorise all of it. */
__attribute__((always_inline)) static inline glint_pixel
glint_pixel_of(const glint_lighting *c, float vy, uint16_t column, float nx, float ny, float nz)
{
    const float vx = (c->half_width - ((float)column + 0.5f)) * c->inv_focal;
    const float inv_v = 1.0f / sqrtf(vx * vx + (vy * vy + 1.0f));
    const float hx = c->light[0] + vx * inv_v;
    const float hy = c->light[1] + vy * inv_v;
    const float hz = c->light[2] + inv_v;
    return (glint_pixel){
        .lv = (c->light[0] * vx + c->light[1] * vy + c->light[2]) * inv_v,
        .nn = nx * nx + ny * ny + nz * nz,
        .nh = nx * hx + ny * hy + nz * hz,
        .hh = hx * hx + hy * hy + hz * hz,
        .nl = nx * c->light[0] + ny * c->light[1] + nz * c->light[2],
        .nv = (nx * vx + ny * vy + nz) * inv_v,
    };
}

static inline float glint_row_vy(const glint_lighting *lighting, int32_t y)
{
    return ((float)y + 0.5f - lighting->half_height) * lighting->inv_focal;
}

#endif
