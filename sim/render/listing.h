/* Quadratic interpolation as the thesis's listing has it, line by line (appendix A, class
 * Quadratic_Interpolation): P0 … P5 of the polynomial over pixel coordinates, with the listing's
 * slips, each of which can be left out. Without any of them it is quadratic.h's polynomial.
 * docs/quadratic-span.md shows what each does. */
#ifndef GLINT_SIM_RENDER_LISTING_H
#define GLINT_SIM_RENDER_LISTING_H

#include "image/image.h"
#include "render/raster.h"

/* X(id, name, what the listing does): one bit each of a mask, in the order of the enum. */
#define GLINT_LISTING_SLIPS(X)                                                                     \
    X(MEANS, "means", "lines 309-311: a middle is the mean of its ends, not lit")                  \
    X(FACTOR, "factor", "lines 322, 341, 360: P4 lacks a factor Y3")                               \
    X(DIVISION, "division", "lines 327, 346, 365: P3 is divided by Y2 and multiplied by it")       \
    X(SIGN, "sign", "line 358: C23 of blue has -4 I23")                                            \
    X(ORIGIN, "origin", "lines 301-303, 494-496: x and y count from the frame's corner")           \
    X(FIXED, "fixed", "lines 301-303: X in 16.16 fixed point, taken for pixels")                   \
    X(DEBUG, "debug", "lines 501-512: grey in place of the intensity, but for one column")

typedef enum glint_slip {
#define GLINT_SLIP_ID(id, name, what) GLINT_SLIP_##id,
    GLINT_LISTING_SLIPS(GLINT_SLIP_ID)
#undef GLINT_SLIP_ID
        GLINT_SLIP_COUNT
} glint_slip;

#define GLINT_SLIPS_ALL ((1u << GLINT_SLIP_COUNT) - 1)

/* P0 … P5 of one component. */
typedef struct glint_listing {
    double p[6];
} glint_listing;

/* Three corners in pixels, from the top down, with their intensities I1, I2, I3 and those of the
 * middles, I12, I13, I23. Coordinates are relative to corner 1, unless the origin slips. */
glint_listing glint_listing_of(const double x[3], const double y[3], const double corner[3],
                               const double middle[3], unsigned slips, bool blue);

/* What the listing paints of the band, each value rounded half up and held in 0 … 255, one that is
 * not a number 0. Adds to *fragments. */
void glint_listing_band(const glint_visibility *band, unsigned slips, glint_image *image,
                        uint64_t *fragments);

#endif
