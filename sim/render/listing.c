/* The listing's arithmetic, in its order and with its names; see listing.h. */
#include "render/listing.h"

#include "render/paint.h"
#include "render/quadratic.h"

#define ONE_16_16 65536.0
#define DARK      100 /* the debug code's grey, lines 504…512 */

static bool has(unsigned slips, glint_slip slip)
{
    return (slips >> slip & 1u) != 0;
}

/* Lines 312…316. */
typedef struct curvature {
    double c2, c3, c12, c13, c23;
} curvature;

static curvature curvature_of(const double corner[3], const double middle[3], unsigned slips,
                              bool blue)
{
    double m[3];
    for (int i = 0; i < 3; i++) {
        const int *end = glint_edge_ends[i];
        m[i] = has(slips, GLINT_SLIP_MEANS) ? (corner[end[0]] + corner[end[1]]) / 2.0 : middle[i];
    }
    const glint_quadratic q = glint_quadratic_of(corner, m);
    curvature c = {q.c2, q.c3, q.c12, q.c13, q.c23};
    if (blue && has(slips, GLINT_SLIP_SIGN))
        c.c23 -= 8.0 * m[2];
    return c;
}

/* Lines 317…327. */
static glint_listing solve(double i1, const curvature *c, double x2, double y2, double x3,
                           double y3, unsigned slips)
{
    const double d23 = 2.0 * x2 * x2 * y3 - 2.0 * x2 * y2 * x3;
    const double d32 = 2.0 * y2 * x3 * x3 - 2.0 * x2 * x3 * y3;
    const double e23 = x2 * y2 * y3 - y2 * y2 * x3;
    const double e32 = y2 * x3 * y3 - x2 * y3 * y3;
    const double det = e32 * d23 - e23 * d32;
    const double area = x2 * y3 - y2 * x3;
    const double factor = has(slips, GLINT_SLIP_FACTOR) ? 1.0 : y3;
    glint_listing l;
    double *p = l.p;
    p[4] = ((4.0 * c->c13 * y2 - c->c23 * y3) * d23 - (4.0 * c->c12 * factor - c->c23 * y2) * d32) /
           det;
    p[5] =
        ((4.0 * c->c12 * y3 - c->c23 * y2) * e32 - (4.0 * c->c13 * y2 - c->c23 * y3) * e23) / det;
    p[0] = i1;
    p[1] = (c->c3 * x2 - c->c2 * x3) / area;
    p[2] = (c->c2 * y3 - c->c3 * y2) / area;
    p[3] =
        has(slips, GLINT_SLIP_DIVISION)
            ? (2.0 * c->c12 - p[5] * x2 * x2 - p[4] * x2 * y2) / y2 * y2
            : (2.0 * c->c12 * x3 * x3 - c->c23 * x2 * x3 + 2.0 * c->c13 * x2 * x2) / (area * area);
    return l;
}

glint_listing glint_listing_of(const double x[3], const double y[3], const double corner[3],
                               const double middle[3], unsigned slips, bool blue)
{
    const curvature c = curvature_of(corner, middle, slips, blue);
    const bool from_frame = has(slips, GLINT_SLIP_ORIGIN);
    const double x1 = from_frame ? 0.0 : x[0];
    const double y1 = from_frame ? 0.0 : y[0];
    const double unit = has(slips, GLINT_SLIP_FIXED) ? ONE_16_16 : 1.0;
    return solve(corner[0], &c, (x[1] - x1) * unit, y[1] - y1, (x[2] - x1) * unit, y[2] - y1,
                 slips);
}

/* A triangle as the listing has it: corners from the top down. */
typedef struct sorted {
    double x[3], y[3]; /* pixels */
    int corner[3];     /* of the triangle */
} sorted;

static sorted sort(const glint_triangle *t)
{
    sorted s = {.corner = {0, 1, 2}};
    for (int i = 1; i < 3; i++)
        for (int k = i; k > 0 && t->y[s.corner[k]] < t->y[s.corner[k - 1]]; k--) {
            const int other = s.corner[k];
            s.corner[k] = s.corner[k - 1];
            s.corner[k - 1] = other;
        }
    for (int i = 0; i < 3; i++) {
        s.x[i] = (double)t->x[s.corner[i]] / GLINT_SUBPIXEL_ONE;
        s.y[i] = (double)t->y[s.corner[i]] / GLINT_SUBPIXEL_ONE;
    }
    return s;
}

/* The edge between two corners, as a place in glint_triangle.middle. */
static int edge_between(int a, int b)
{
    return a + b - 1; /* 0+1, 0+2, 1+2 */
}

static glint_listing component_of(const glint_triangle *t, const sorted *s, int c, unsigned slips)
{
    double corner[3], middle[3];
    for (int i = 0; i < 3; i++) {
        const int *end = glint_edge_ends[i];
        corner[i] = t->color[s->corner[i]][c];
        middle[i] = t->middle[edge_between(s->corner[end[0]], s->corner[end[1]])][c];
    }
    return glint_listing_of(s->x, s->y, corner, middle, slips, c == 2);
}

/* Lines 494…496. */
static double at(const double p[6], double x, double y)
{
    return p[5] * x * x + p[4] * x * y + p[3] * y * y + p[2] * x + p[1] * y + p[0];
}

/* Lines 501…512: of the three questions only the last has a say. */
static uint8_t debug_level(int32_t x, double x3)
{
    return (double)x <= x3 && x3 < (double)x + 1.0 ? 255 : DARK;
}

static void paint(const glint_triangle *t, int32_t y, glint_pixels pixels, unsigned slips,
                  uint8_t *values)
{
    const sorted s = sort(t);
    const bool from_frame = has(slips, GLINT_SLIP_ORIGIN);
    const double x0 = 0.5 - (from_frame ? 0.0 : s.x[0]);
    const double y0 = 0.5 - (from_frame ? 0.0 : s.y[0]);
    glint_listing l[3];
    for (int c = 0; c < 3; c++)
        l[c] = component_of(t, &s, c, slips);
    for (int32_t x = pixels.first; x <= pixels.last; x++)
        for (int c = 0; c < 3; c++)
            *values++ = has(slips, GLINT_SLIP_DEBUG)
                            ? debug_level(x, s.x[2])
                            : glint_quadratic_level(at(l[c].p, x + x0, y + y0));
}

void glint_listing_band(const glint_visibility *band, unsigned slips, glint_image *image,
                        uint64_t *fragments)
{
    for (int32_t y = band->first_y; y <= band->last_y; y++) {
        glint_paint_begin_row(image, y);
        int32_t x = 0;
        glint_pixels pixels;
        const glint_triangle *t;
        while ((t = glint_visible_next(band, image->width, y, &x, &pixels)) != NULL) {
            *fragments += glint_paint_mark(image, y, pixels);
            paint(t, y, pixels, slips, glint_paint_pixel(image, pixels.first, y));
        }
    }
}
