/* The report: figures and tables of the thesis again, from our own numbers, and verdicts on its
 * claims: those that the sections (sections.h) take up. */
#ifndef GLINT_SIM_REPORT_REPORT_H
#define GLINT_SIM_REPORT_REPORT_H

#include "report/section.h"

typedef struct glint_report_options {
    const char *directory; /* made if missing */
    int threads;           /* the files are the same whatever it is, but for what is timed */
    bool quick;            /* coarser grids, smaller frames: seconds instead of a minute or two */
    const volatile bool *stop;
    /* Called before each section, with its title and how many of all are done; may be NULL. */
    void (*progress)(void *context, const char *section, int done, int count);
    void *context;
} glint_report_options;

typedef struct glint_report_result {
    glint_findings *findings; /* to be destroyed, NULL after an error */
    bool plotted;             /* false: there was no gnuplot, so the figures were not drawn */
    double seconds;
} glint_report_result;

/* Writes index.md, index.html (self-contained), index.json, and the data, plots and pictures they
 * are made of. */
glint_status glint_report_make(const glint_report_options *options, glint_report_result *result,
                               glint_error *err);

#endif
