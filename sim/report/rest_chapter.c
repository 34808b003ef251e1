/* Of section 2.6, ray tracing with pixel segments, what can be decided without a ray tracer: the
 * counts (2.28) and (2.31). A segment has L inner pixels between two traced ones, so the traced
 * pixels of a row are L + 1 apart, and its last pixel is traced as well. */
#include "report/chapter.h"

#define ROW         640 /* the thesis's */
#define SEGMENT     7
#define LENGTHS_MAX 64

static int ceil_of(int a, int b)
{
    return (a + b - 1) / b;
}

static int traced(int row, int segment)
{
    return ceil_of(row - 1, segment + 1) + 1;
}

/* ⌈Xmax/(L+1) + 1⌉ */
static int by_2_28(int row, int segment)
{
    return ceil_of(row, segment + 1) + 1;
}

/* ⌈Xmax/(ΣL + 1)⌉ + 1, the sum over the row's segments. */
static int by_2_31(int row, int segment)
{
    const int segments = traced(row, segment) - 1;
    return ceil_of(row, segments * segment + 1) + 1;
}

glint_status glint_chapter_rest(glint_report *report, glint_error *err)
{
    int differing = 0, largest = 0;
    (void)err;
    for (int segment = 1; segment <= LENGTHS_MAX; segment++) {
        const int difference = by_2_28(ROW, segment) - traced(ROW, segment);
        differing += difference != 0;
        largest = difference > largest ? difference : largest;
    }
    glint_numbers *numbers = &report->numbers;
    glint_number_put(numbers, ROW, "rest.row");
    glint_number_put(numbers, SEGMENT, "rest.segment");
    glint_number_put(numbers, LENGTHS_MAX, "rest.lengths");
    glint_number_put(numbers, traced(ROW, SEGMENT), "rest.traced");
    glint_number_put(numbers, by_2_28(ROW, SEGMENT), "rest.by-2-28");
    glint_number_put(numbers, by_2_31(ROW, SEGMENT), "rest.by-2-31");
    glint_number_put(numbers, differing, "rest.differing");
    glint_number_put(numbers, largest, "rest.differing.by");
    return GLINT_OK;
}
