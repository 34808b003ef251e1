/* Interpolation along rows and over blocks, each component by itself, rounded half up. */
#include "trace/fill.h"

#include <stdlib.h>
#include <string.h>

/* What a fill works on. */
typedef struct canvas {
    const glint_image *image;
    const uint8_t *traced;
    const uint8_t *from; /* of a cubic: the colours before it began, traced or linear */
} canvas;

static size_t place(const canvas *c, int x, int y)
{
    return (size_t)y * (size_t)c->image->width + (size_t)x;
}

static uint8_t *color_at(const canvas *c, int x, int y)
{
    return &c->image->rgb[3 * place(c, x, y)];
}

/* Rounded half up and held in 0 … 255. */
static uint8_t level_of(double value)
{
    const double above = value + 0.5;
    return above <= 0.0 ? 0 : above >= 255.0 ? 255 : (uint8_t)above;
}

/* The nearer of two ends, the first where both are as near. */
static int nearer(int first, int last, int at)
{
    return 2 * (at - first) <= last - first ? first : last;
}

static void nearest(const canvas *c, const glint_box *box)
{
    for (int y = box->top; y <= box->bottom; y++)
        for (int x = box->left; x <= box->right; x++)
            if (!c->traced[place(c, x, y)])
                memcpy(
                    color_at(c, x, y),
                    color_at(c, nearer(box->left, box->right, x), nearer(box->top, box->bottom, y)),
                    3);
}

static void straight(const canvas *c, const glint_box *box, bool mean)
{
    const int length = box->right - box->left;
    const uint8_t *left = color_at(c, box->left, box->top);
    const uint8_t *right = color_at(c, box->right, box->top);
    if (memcmp(left, right, 3) == 0) {
        nearest(c, box);
        return;
    }
    for (int k = 1; k < length; k++) {
        uint8_t *color = color_at(c, box->left + k, box->top);
        for (int i = 0; i < 3; i++) {
            const int value =
                mean ? (left[i] + right[i] + 1) / 2
                     : (2 * (left[i] * (length - k) + right[i] * k) + length) / (2 * length);
            color[i] = (uint8_t)value;
        }
    }
}

/* ---- Four and 16 points, four and two ---------------------------------------------------------
 */

static double share(int first, int last, int at)
{
    return last > first ? (double)(at - first) / (last - first) : 0.0;
}

/* The columns or rows of a box's points, as far apart as its own sides: −1, 0, 1, 2 of these steps
 * from its first. One beyond the frame is −1, and so are the outer two without a cubic. */
static void four(int first, int last, int size, bool cubic, int at[4])
{
    const int before = first - (last - first);
    const int after = last + (last - first);
    at[0] = cubic && before >= 0 ? before : -1;
    at[1] = first;
    at[2] = last;
    at[3] = cubic && after < size ? after : -1;
}

/* Keys's cubic convolution, a = −1/2; a point that is missing continues the line through the two
 * next to it, so that without both outer ones this is linear. */
static double between(const int at[4], double v[4], double t)
{
    if (at[0] < 0)
        v[0] = 2.0 * v[1] - v[2];
    if (at[3] < 0)
        v[3] = 2.0 * v[2] - v[1];
    const double cube = 3.0 * (v[1] - v[2]) + v[3] - v[0];
    const double square = 2.0 * v[0] - 5.0 * v[1] + 4.0 * v[2] - v[3];
    return v[1] + 0.5 * t * (v[2] - v[0] + t * (square + t * cube));
}

/* A box's points. */
typedef struct points {
    int column[4], row[4];
} points;

/* The colour's component at column x of each of the four rows. */
static void across(const canvas *c, const points *p, const uint8_t *from, double t, int component,
                   double down[4])
{
    for (int j = 0; j < 4; j++) {
        double v[4] = {0.0};
        for (int i = 0; i < 4 && p->row[j] >= 0; i++)
            if (p->column[i] >= 0)
                v[i] = from[3 * place(c, p->column[i], p->row[j]) + (size_t)component];
        down[j] = p->row[j] >= 0 ? between(p->column, v, t) : 0.0;
    }
}

/* Whether all of the points have one colour, as those of the background have. */
static bool is_flat(const canvas *c, const points *p, const uint8_t *from)
{
    const uint8_t *first = &from[3 * place(c, p->column[1], p->row[1])];
    for (int j = 0; j < 4; j++)
        for (int i = 0; i < 4; i++)
            if (p->column[i] >= 0 && p->row[j] >= 0 &&
                memcmp(first, &from[3 * place(c, p->column[i], p->row[j])], 3) != 0)
                return false;
    return true;
}

static void smooth(const canvas *c, const glint_box *box, bool cubic)
{
    points p;
    const uint8_t *from = cubic ? c->from : c->image->rgb;
    four(box->left, box->right, c->image->width, cubic, p.column);
    four(box->top, box->bottom, c->image->height, cubic && box->top < box->bottom, p.row);
    if (is_flat(c, &p, from)) {
        nearest(c, box);
        return;
    }
    for (int component = 0; component < 3; component++)
        for (int x = box->left; x <= box->right; x++) {
            double down[4];
            across(c, &p, from, share(box->left, box->right, x), component, down);
            for (int y = box->top; y <= box->bottom; y++)
                if (!c->traced[place(c, x, y)])
                    color_at(c, x, y)[component] =
                        level_of(between(p.row, down, share(box->top, box->bottom, y)));
        }
}

/* ---- Both ------------------------------------------------------------------------------------ */

static void mark_object(const canvas *c, const glint_box *box)
{
    for (int y = box->top; y <= box->bottom; y++)
        for (int x = box->left; x <= box->right; x++)
            if (!c->traced[place(c, x, y)])
                c->image->object[place(c, x, y)] = c->image->object[place(
                    c, nearer(box->left, box->right, x), nearer(box->top, box->bottom, y))];
}

static void fill_all(glint_fill fill, const canvas *c, const glint_box *box, size_t count)
{
    for (size_t i = 0; i < count; i++)
        if (fill == GLINT_FILL_MEAN || fill == GLINT_FILL_LINEAR)
            straight(c, &box[i], fill == GLINT_FILL_MEAN);
        else if (fill == GLINT_FILL_NEAREST)
            nearest(c, &box[i]);
        else
            smooth(c, &box[i], fill != GLINT_FILL_BILINEAR);
}

/* The points of a cubic that were not traced are those of the linear fill: that comes first. */
static glint_status fill_cubic(glint_fill fill, canvas *c, const glint_box *box, size_t count,
                               glint_error *err)
{
    const size_t bytes = 3 * (size_t)c->image->width * (size_t)c->image->height;
    uint8_t *from = malloc(bytes);
    if (from == NULL)
        return glint_fail(err, GLINT_NO_MEMORY, "not enough memory for a second frame of %dx%d",
                          c->image->width, c->image->height);
    fill_all(fill == GLINT_FILL_CUBIC ? GLINT_FILL_LINEAR : GLINT_FILL_BILINEAR, c, box, count);
    memcpy(from, c->image->rgb, bytes);
    c->from = from;
    fill_all(fill, c, box, count);
    free(from);
    return GLINT_OK;
}

glint_status glint_fill_boxes(glint_fill fill, const glint_box *box, size_t count,
                              const uint8_t *traced, glint_image *image, glint_error *err)
{
    canvas c = {.image = image, .traced = traced};
    for (size_t i = 0; i < count; i++)
        mark_object(&c, &box[i]);
    if (fill == GLINT_FILL_CUBIC || fill == GLINT_FILL_BICUBIC)
        return fill_cubic(fill, &c, box, count, err);
    fill_all(fill, &c, box, count);
    return GLINT_OK;
}
