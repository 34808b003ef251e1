/* Quadratic interpolation of intensity over a triangle (the thesis's appendix A, class
 * Quadratic_Interpolation, in its corrected form; docs/quadratic-span.md).
 *
 * A component's intensity is the one polynomial of second degree
 *
 *     I(x, y) = P5·x² + P4·xy + P3·y² + P2·x + P1·y + P0
 *
 * with six given values: lit at the corners (I1, I2, I3) and at the middles of the edges (I12, I13,
 * I23). With the weights u of corner 2 and v of corner 3, which are linear on the screen,
 *
 *     I = I1 + C2·u + C3·v + 2·C12·u² + 2·C13·v² + C23·u·v
 *     C2 = 4·I12 − 3·I1 − I2    C12 = I1 + I2 − 2·I12    C23 = 4·(I1 − I12 − I13 + I23)
 *     C3 = 4·I13 − 3·I1 − I3    C13 = I1 + I3 − 2·I13
 *
 * C12 = C13 = C23 = 0 when every middle is the mean of its ends: then I is linear, as Gouraud's.
 * Between 0 and 255 at the six points, I is within −85 … 340 on the triangle: the six basis
 * functions are nowhere together more than 4/3, or less than −1/3. */
#ifndef GLINT_SIM_RENDER_QUADRATIC_H
#define GLINT_SIM_RENDER_QUADRATIC_H

#include "render/raster.h"

/* The edges in the order of glint_triangle.middle: between corners 1 and 2, 1 and 3, 2 and 3,
 * counted from 0. */
extern const int glint_edge_ends[3][2];

/* One component's six values and what is made of them. */
typedef struct glint_quadratic {
    double i1, c2, c3, c12, c13, c23;
} glint_quadratic;

/* corner: I1, I2, I3; middle: I12, I13, I23. */
glint_quadratic glint_quadratic_of(const double corner[3], const double middle[3]);

/* Component 0…2 of a triangle that is lit at all six points. */
glint_quadratic glint_quadratic_of_triangle(const glint_triangle *t, int component);

/* I at weights u and v. */
static inline double glint_quadratic_at(const glint_quadratic *q, double u, double v)
{
    return q->i1 + u * (q->c2 + 2.0 * q->c12 * u + q->c23 * v) + v * (q->c3 + 2.0 * q->c13 * v);
}

/* Rounded half up and held in 0 … 255; what is not a number is 0. */
static inline uint8_t glint_quadratic_level(double intensity)
{
    if (!(intensity > 0.0))
        return 0;
    return intensity < 254.5 ? (uint8_t)(intensity + 0.5) : 255;
}

#endif
