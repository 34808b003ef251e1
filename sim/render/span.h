/* The span unit of Gouraud's shading, in integers: intensities along a run of pixels from one end's
 * to the other's, the increment divided by the circuit, the sum kept in fixed point.
 *
 * A run is an edge of a triangle (a value for each pixel row or, where it is shallow, for each
 * column) or a row's span (a value for each pixel). It has three channels, one for each colour
 * component, all alike: a channel subtracts the end intensities and the end coordinates, has the
 * first divided by the second, and adds the quotient step by step. All of these operations are
 * counted, as in the four rows of the thesis's Table 2.1. */
#ifndef GLINT_SIM_RENDER_SPAN_H
#define GLINT_SIM_RENDER_SPAN_H

#include "glint_divider.h"

typedef struct glint_run {
    int32_t start, end; /* rows or columns of the ends, start ≤ end */
    uint8_t from[3], to[3];
} glint_run;

/* Operations of one component each. */
typedef struct glint_operations {
    uint64_t additions; /* and subtractions */
    uint64_t divisions;
} glint_operations;

typedef enum glint_span_stage {
    GLINT_SPAN_EDGE_INCREMENTS,
    GLINT_SPAN_EDGE_POINTS,
    GLINT_SPAN_ROW_INCREMENTS,
    GLINT_SPAN_ROW_POINTS,
    GLINT_SPAN_STAGE_COUNT
} glint_span_stage;

typedef struct glint_span_operations {
    glint_operations stage[GLINT_SPAN_STAGE_COUNT];
} glint_span_operations;

/* A run longer than the divider's table is cut into segments of GLINT_DIVIDER_K_MAX steps; the last
 * one may be shorter. A segment is a run in its own right between the exact values of the whole run
 * at its ends, rounded half up, so no error carries over. A run without steps is one segment. */
int32_t glint_run_segment_count(const glint_run *run);
glint_run glint_run_segment(const glint_run *run, int32_t index);

/* The segment to which the value at a place start … end belongs: where two meet, the later one. */
int32_t glint_run_segment_at(const glint_run *run, int32_t place);

/* Sets a segment's increments up: the differences for the divider. false: it has no steps and needs
 * no division. */
bool glint_run_set_up(const glint_run *segment, glint_division *division,
                      glint_operations *operations);

/* The values of a segment at places first … last (both within it), three bytes each: the sum from
 * `from` on with `shifts` fraction bits, rounded half up and held in 0 … 255 for each value, never
 * within the sum. quotients: of the division that glint_run_set_up() gave. */
void glint_run_walk(const glint_run *segment, int shifts, const glint_quotients *quotients,
                    int32_t first, int32_t last, uint8_t *values, glint_operations *operations);

/* The values of a whole run at places first … last without any circuit: from + (to − from)·i/k in
 * exact integers, rounded half up. */
void glint_run_exact(const glint_run *run, int32_t first, int32_t last, uint8_t *values);

/* The thesis's triangle: Δx/Δy AB 7/8, AC 9/12, BC 16/4. Here its corners are on pixel centres, A
 * on top. Table 2.1 gives 18/9, 99, 66/33, 225. */
typedef struct glint_table_21 {
    /* The rasterizer drawing it: edges as far as rows need them, spans from the first to the last
     * pixel that the fill rule gives. The first value of a run is there without an addition. */
    glint_span_operations drawn;
    uint64_t drawn_rows, drawn_pixels; /* that it covers */
    double area;                       /* in pixels */

    /* The same unit over the runs that the thesis describes: edges along the longer of Δx and Δy,
     * rows from the left edge's point to the right one's, and of each run the points between its
     * ends. */
    glint_span_operations described;
    uint64_t described_edge_points, described_rows, described_pixels; /* walked */
} glint_table_21;

/* Runs both, dividing by divider's C model with that many shifts, and counts. */
glint_status glint_count_table_21(int shifts, glint_table_21 *table, glint_error *err);

#endif
