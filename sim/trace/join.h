/* Section 2.6 of the thesis: an image joined from few traced pixels. A row is cut into segments
 * whose two ends are traced and whose inner pixels are interpolated. Where the colours of the ends
 * differ by more than the limit (the thesis's switch InterpolOK is 0), the pixel in the middle is
 * traced as well and both halves are judged anew (2.30). With the fills for two directions a
 * segment is a block, judged by its four corners and cut into four.
 *
 * Which pixels are traced depends on the colours alone. All that one level asks for are traced
 * together, so that a circuit gets them in long runs. */
#ifndef GLINT_SIM_TRACE_JOIN_H
#define GLINT_SIM_TRACE_JOIN_H

#include "image/image.h"
#include "trace/measure.h"

typedef enum glint_fill {
    GLINT_FILL_MEAN,     /* (2.27): every inner pixel is the mean of the two ends */
    GLINT_FILL_LINEAR,   /* a straight line from end to end */
    GLINT_FILL_CUBIC,    /* of four points of the row, two on each side (figure 2.18) */
    GLINT_FILL_NEAREST,  /* blocks: the nearest of the four corners */
    GLINT_FILL_BILINEAR, /* blocks: of the four corners */
    GLINT_FILL_BICUBIC,  /* blocks: of 16 points, 4 × 4 (figure 2.18) */
    GLINT_FILL_COUNT
} glint_fill;

/* Cubic fills are Keys's cubic convolution (a = −1/2) of points as far apart as the segment's or
 * block's own ends. Between segments that were halved differently, some of the outer points were
 * not traced; they are what the linear fill gives. */

/* In that order; NULL ends them. */
extern const char *const glint_fill_names[];

static inline bool glint_fill_is_of_blocks(glint_fill fill)
{
    return fill >= GLINT_FILL_NEAREST;
}

#define GLINT_SEGMENT_MAX (GLINT_IMAGE_SIDE_MAX - 1)

typedef struct glint_join {
    int segment; /* L: inner pixels of a segment, or of a block along each side. 0: all are traced
                  */
    int centre;  /* L in the middle half of the rows and columns, by segments only; -1: the same */
    glint_fill fill;
    glint_measure measure;
    double limit; /* the largest difference that is interpolated; INFINITY: all are */
} glint_join;

/* Gives the pixels their colours and whether they are the object's. pixel: their places in the
 * image, row by row; no pixel is asked for twice. */
typedef glint_status glint_join_trace(void *context, const uint32_t *pixel, size_t count,
                                      glint_image *image, glint_error *err);

typedef struct glint_join_stats {
    uint64_t traced; /* pixels */
    uint64_t
        segments;    /* or blocks that were interpolated, those without inner pixels not counted */
    uint64_t filled; /* their inner pixels */
    int levels;      /* of halving that were needed: 0 for none */
} glint_join_stats;

/* Every pixel of the image is written. An inner pixel is the object's if the nearest end is. */
glint_status glint_join_image(const glint_join *how, glint_join_trace *trace, void *context,
                              glint_image *image, glint_join_stats *stats, glint_error *err);

/* GLINT_BAD_ARGUMENT for a value out of its range or without a sense, naming it. */
glint_status glint_join_check(const glint_join *how, glint_error *err);

#endif
