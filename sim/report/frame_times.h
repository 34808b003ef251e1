/* How long a frame takes by each formula and by the device: figure 3.13. */
#ifndef GLINT_SIM_REPORT_FRAME_TIMES_H
#define GLINT_SIM_REPORT_FRAME_TIMES_H

#include "report/frame_errors.h"

/* Each timed by turns with cosⁿ (blinn, in single precision). */
typedef enum glint_timed_method {
    GLINT_TIMED_COSINE_QUADRATIC,
    GLINT_TIMED_DEVICE,
    GLINT_TIMED_VERILOG,
    GLINT_TIMED_COUNT
} glint_timed_method;

typedef struct glint_frame_times {
    int width, height;
    glint_frame_light light;
    int count; /* exponents */
    int n[GLINT_FRAME_EXPONENTS_MAX];
    glint_study_row row[GLINT_FIGURE_COUNT][GLINT_TIMED_COUNT]
                       [GLINT_FRAME_EXPONENTS_MAX]; /* A: cosⁿ, B: the method */
} glint_frame_times;

glint_status glint_frame_times_measure(const glint_report *report, glint_frame_times *times,
                                       glint_error *err);

/* The claims of section 3.4 on frame times, from these numbers alone. threads: that they were
 * measured on. */
void glint_frame_times_find(const glint_frame_times *times, int threads, glint_findings *findings);

/* The table, figure 3.13, the claims and the numbers. */
glint_status glint_frame_times_write(glint_report *report, const glint_frame_times *times,
                                     glint_error *err);

#endif
