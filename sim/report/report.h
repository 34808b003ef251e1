/* The report: figures and tables of the thesis again, from our own numbers, and a verdict on each
 * of its claims. docs/report.md says how it is made. */
#ifndef GLINT_SIM_REPORT_REPORT_H
#define GLINT_SIM_REPORT_REPORT_H

#include "glint_status.h"
#include "report/claims.h"

typedef struct glint_report_options {
    const char *directory; /* made if missing */
    const char *chapter;   /* that one alone, by its name (chapter.h); NULL: all */
    int threads;           /* the files are the same whatever it is, but for what is timed */
    bool quick;            /* coarser grids, smaller frames: seconds instead of a minute or two */
    const volatile bool *stop;
    /* Called before each chapter, with its title and how many of all are done; may be NULL. */
    void (*progress)(void *context, const char *chapter, int done, int count);
    void *context;
} glint_report_options;

typedef struct glint_report_result {
    glint_claims claims; /* to be freed; empty after an error */
    bool plotted;        /* false: there was no gnuplot, so the figures were not drawn */
    double seconds;
} glint_report_result;

/* Writes index.md, index.html (self-contained), index.json, and the data, plots and pictures they
 * are made of. GLINT_BAD_ARGUMENT when there is no such chapter. */
glint_status glint_report_make(const glint_report_options *options, glint_report_result *result,
                               glint_error *err);

#endif
