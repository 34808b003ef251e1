/* Interpolation of what was not traced. */
#ifndef GLINT_SIM_TRACE_FILL_H
#define GLINT_SIM_TRACE_FILL_H

#include "trace/join.h"

/* Pixels left … right of rows top … bottom, whose four corners are traced. A segment is a box of
 * one row. */
typedef struct glint_box {
    uint16_t left, right, top, bottom;
} glint_box;

/* Gives the pixels of the boxes that are not traced their colours, box after box: where boxes
 * share an edge, the later one counts. traced: 1 for each pixel of the image that is.
 * GLINT_NO_MEMORY. */
glint_status glint_fill_boxes(glint_fill fill, const glint_box *box, size_t count,
                              const uint8_t *traced, glint_image *image, glint_error *err);

#endif
