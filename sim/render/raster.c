/* Coverage by exact integer edge functions with the top-left rule, and the depth test. */
#include "render/raster.h"

#include <stdlib.h>
#include <string.h>

/* A box at least this wide is searched for a row's span by division instead of step by step. */
#define WIDE 24

/* The function of the edge from one corner to the next: positive on the inner side, twice the area
 * of the triangle that the edge forms with the point. */
typedef struct edge {
    int64_t value;          /* at the current sample, less the bias */
    int64_t step_x, step_y; /* one pixel to the right, one down */
    int64_t bias;           /* 0 or 1, see biased_edge_at() */
} edge;

static int64_t sample(int32_t pixel)
{
    return (int64_t)pixel * GLINT_SUBPIXEL_ONE + GLINT_SUBPIXEL_HALF;
}

/* The edge that starts at corner i, at the sample of pixel (x, y). */
static edge edge_at(const glint_triangle *t, int i, int32_t x, int32_t y)
{
    const int next = i < 2 ? i + 1 : 0;
    const int64_t dx = (int64_t)t->x[next] - t->x[i];
    const int64_t dy = (int64_t)t->y[next] - t->y[i];
    return (edge){
        .value = dx * (sample(y) - t->y[i]) - dy * (sample(x) - t->x[i]),
        .step_x = -dy * GLINT_SUBPIXEL_ONE,
        .step_y = dx * GLINT_SUBPIXEL_ONE,
    };
}

/* A sample exactly on an edge belongs to the triangle if that edge is a top or a left one, so that
 * exactly one of the two triangles along an edge owns it. Other edges require "positive" instead of
 * "not negative", which is one less in integers. */
static edge biased_edge_at(const glint_triangle *t, int i, int32_t x, int32_t y)
{
    edge e = edge_at(t, i, x, y);
    const bool left = e.step_x > 0;
    const bool top = e.step_x == 0 && e.step_y > 0;
    if (!left && !top) {
        e.bias = 1;
        e.value -= e.bias;
    }
    return e;
}

glint_weights glint_triangle_weights(const glint_triangle *t, int32_t x, int32_t y)
{
    const edge e1 = edge_at(t, 2, x, y); /* the edges opposite to corners 1 and 2 */
    const edge e2 = edge_at(t, 0, x, y);
    return (glint_weights){
        .at1 = (double)e1.value * t->inv_area,
        .at2 = (double)e2.value * t->inv_area,
        .step1 = (double)e1.step_x * t->inv_area,
        .step2 = (double)e2.step_x * t->inv_area,
    };
}

/* The inside of a narrow box's row, found step by step. */
static glint_pixels narrow_span(const edge e[3], int32_t first, int32_t last)
{
    int64_t a = e[0].value;
    int64_t b = e[1].value;
    int64_t c = e[2].value;
    int32_t x = first;
    while (x <= last && (a | b | c) < 0) {
        a += e[0].step_x;
        b += e[1].step_x;
        c += e[2].step_x;
        x++;
    }
    const int32_t start = x;
    while (x <= last && (a | b | c) >= 0) {
        a += e[0].step_x;
        b += e[1].step_x;
        c += e[2].step_x;
        x++;
    }
    return (glint_pixels){start, x - 1};
}

/* The same for a wide one, solved for where each edge function changes its sign. */
static glint_pixels wide_span(const edge e[3], int32_t first, int32_t last)
{
    int64_t low = 0;
    int64_t high = last - first;
    for (int i = 0; i < 3; i++) {
        const int64_t step = e[i].step_x;
        const int64_t value = e[i].value;
        if (value < 0) {
            if (step <= 0)
                return (glint_pixels){first, first - 1};
            const int64_t enter = (-value + step - 1) / step;
            low = low > enter ? low : enter;
        } else if (step < 0) {
            const int64_t leave = value / -step;
            high = high < leave ? high : leave;
        }
    }
    return low > high ? (glint_pixels){first, first - 1}
                      : (glint_pixels){first + (int32_t)low, first + (int32_t)high};
}

glint_pixels glint_triangle_pixels(const glint_triangle *t, int32_t y)
{
    int32_t low = t->x[0];
    int32_t high = t->x[0];
    for (int i = 1; i < 3; i++) {
        low = t->x[i] < low ? t->x[i] : low;
        high = t->x[i] > high ? t->x[i] : high;
    }
    const int32_t first = glint_first_sample(low);
    const int32_t last = glint_last_sample(high);
    edge e[3];
    for (int i = 0; i < 3; i++)
        e[i] = biased_edge_at(t, i, first, y);
    return last - first >= WIDE ? wide_span(e, first, last) : narrow_span(e, first, last);
}

/* The depth of a triangle as a function of its edge functions. In double precision, as a triangle
 * that is cut at the near plane has depths a thousand times apart. */
typedef struct depth_plane {
    double at_corner, per_edge1, per_edge2;
    double step; /* of one pixel to the right */
} depth_plane;

static depth_plane depth_plane_of(const glint_triangle *t, const edge e[3])
{
    const double at_corner = (double)t->inv_w[0];
    const double per_edge1 = ((double)t->inv_w[1] - at_corner) * t->inv_area;
    const double per_edge2 = ((double)t->inv_w[2] - at_corner) * t->inv_area;
    return (depth_plane){
        .at_corner = at_corner,
        .per_edge1 = per_edge1,
        .per_edge2 = per_edge2,
        .step = (double)e[2].step_x * per_edge1 + (double)e[0].step_x * per_edge2,
    };
}

/* The depth at the pixel that is `right` pixels after the edges' current one. */
static double depth_at(const depth_plane *d, const edge e[3], int64_t right)
{
    const int64_t edge1 = e[2].value + e[2].bias + right * e[2].step_x;
    const int64_t edge2 = e[0].value + e[0].bias + right * e[0].step_x;
    return d->at_corner + (double)edge1 * d->per_edge1 + (double)edge2 * d->per_edge2;
}

/* Takes `count` pixels from the first on where the triangle is nearer than what was there; of
 * equally near ones the first in the mesh's order stays. */
static void test_depth(float *depth, const glint_triangle **seen, int32_t count,
                       const glint_triangle *t, double from, double step)
{
    for (int32_t k = 0; k < count; k++) {
        const float here = (float)(from + k * step);
        if (here > depth[k]) {
            depth[k] = here;
            seen[k] = t;
        }
    }
}

static void draw(glint_visibility *band, glint_extent extent, const glint_triangle *t)
{
    const int32_t first_y = t->first_y > band->first_y ? t->first_y : band->first_y;
    const int32_t last_y = t->last_y < band->last_y ? t->last_y : band->last_y;
    const bool wide = t->last_x - t->first_x >= WIDE;
    edge e[3];
    for (int i = 0; i < 3; i++)
        e[i] = biased_edge_at(t, i, t->first_x, first_y);
    const depth_plane plane = depth_plane_of(t, e);
    size_t row = (size_t)(first_y - band->first_y) * (size_t)extent.width;
    for (int32_t y = first_y; y <= last_y; y++) {
        const glint_pixels s =
            wide ? wide_span(e, t->first_x, t->last_x) : narrow_span(e, t->first_x, t->last_x);
        if (s.first <= s.last) {
            const size_t at = row + (size_t)s.first;
            test_depth(&band->depth[at], &band->triangle[at], s.last - s.first + 1, t,
                       depth_at(&plane, e, s.first - t->first_x), plane.step);
        }
        row += (size_t)extent.width;
        for (int i = 0; i < 3; i++)
            e[i].value += e[i].step_y;
    }
}

void glint_visibility_create(glint_visibility *band, int32_t width)
{
    const size_t pixels = (size_t)width * GLINT_BAND_ROWS;
    band->depth = malloc(pixels * sizeof *band->depth);
    band->triangle = malloc(pixels * sizeof *band->triangle);
}

void glint_visibility_destroy(glint_visibility *band)
{
    free(band->depth);
    free(band->triangle);
}

void glint_visibility_begin(glint_visibility *band, glint_extent extent, int32_t first_y,
                            int32_t last_y)
{
    const size_t pixels = (size_t)extent.width * (size_t)(last_y - first_y + 1);
    band->first_y = first_y;
    band->last_y = last_y;
    memset(band->depth, 0, pixels * sizeof *band->depth);
    memset(band->triangle, 0, pixels * sizeof *band->triangle);
}

void glint_visibility_draw(glint_visibility *band, glint_extent extent,
                           const glint_triangle_list *list)
{
    if (list->last_y < band->first_y || list->first_y > band->last_y)
        return;
    for (size_t i = 0; i < list->count; i++) {
        const glint_triangle *t = &list->triangle[i];
        if (t->first_y <= band->last_y && t->last_y >= band->first_y)
            draw(band, extent, t);
    }
}
