/* Section 2.6 measured: a few objects, traced in full and with segments. */
#ifndef GLINT_SIM_REPORT_TRACE_RUNS_H
#define GLINT_SIM_REPORT_TRACE_RUNS_H

#include "report/chapter.h"
#include "trace/trace.h"

typedef enum glint_trace_object {
    GLINT_TRACE_SPHERE,
    GLINT_TRACE_TEAPOT,
    GLINT_TRACE_GRID, /* thin bars */
    GLINT_TRACE_OBJECTS
} glint_trace_object;

/* "sphere", "teapot", "grid". */
extern const char *const glint_trace_object_names[GLINT_TRACE_OBJECTS];

/* An object in front of a tracer, with its full trace. */
typedef struct glint_trace_subject {
    glint_mesh *mesh;
    glint_tracer *tracer;
    glint_image *full;
    glint_image *image; /* of the last run */
    int repeats;        /* of what is timed */
    double full_seconds;
} glint_trace_subject;

/* How a run compares with the full trace. */
typedef struct glint_trace_run {
    double rays; /* share of the pixels that were traced */
    double nmse;
    double gain;   /* full time / its time; processor time of one thread, the least of as many of
                      each; 0: not timed */
    double beyond; /* of the interpolated pixels: the share more than 2.3 (ΔE) off the truth */
    int largest;   /* difference of a component */
} glint_trace_run;

/* Destroy it in any case. */
glint_status glint_trace_subject_make(glint_report *report, glint_trace_object object,
                                      glint_trace_subject *subject, glint_error *err);
void glint_trace_subject_destroy(glint_trace_subject *subject);

/* timed: as often as the full trace was. */
glint_status glint_trace_subject_run(glint_trace_subject *subject, const glint_join *how,
                                     bool timed, glint_trace_run *run, glint_error *err);

/* The mean square of the differences of horizontal neighbours: more for a sharper picture. */
double glint_trace_sharpness(const glint_image *image);

/* Between horizontal neighbours of blocks of that length: the mean step where the nearest corner
 * changes, over the mean of all other steps. */
double glint_trace_seams(const glint_image *image, int segment);

/* Figures 2.17 to 2.19, and what is lost between equal ends (trace_figures.c). */
glint_status glint_trace_figures(glint_report *report, glint_error *err);
glint_status glint_trace_pictures(glint_report *report, glint_trace_object object,
                                  glint_trace_subject *subject, glint_error *err);

#endif
