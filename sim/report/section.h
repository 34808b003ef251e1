/* What the sections of the report have in common: where they write, and how they plot. */
#ifndef GLINT_SIM_REPORT_SECTION_H
#define GLINT_SIM_REPORT_SECTION_H

#include <stdbool.h>
#include <stdio.h>

#include "file/new_file.h"
#include "report/findings.h"

typedef struct glint_report {
    const char *directory; /* is there */
    int threads;
    bool quick;                /* coarser grids and smaller frames, the same code: for tests */
    const volatile bool *stop; /* may be NULL; when it becomes true: GLINT_INTERRUPTED */
    FILE *markdown;            /* the section's text; headings from level 2 on */
    glint_findings *findings;  /* to add to */
    cJSON *numbers;            /* an object of the section's own, for index.json */
    bool plotted;              /* false once gnuplot was missing */
} glint_report;

/* Measures, writes its text to `markdown` and its files into the directory. */
typedef glint_status glint_report_section(glint_report *report, glint_error *err);

/* A file of the report, to be committed or discarded (file/new_file.h). */
glint_status glint_report_open(const glint_report *report, const char *name, glint_new_file **file,
                               glint_error *err);

/* Has gnuplot draw NAME.gnuplot, which is there with its data, as NAME.svg and NAME.png; puts the
 * picture with its caption into the text, or where its data is when there is no gnuplot. */
glint_status glint_report_figure(glint_report *report, const char *name, const char *caption,
                                 glint_error *err);

/* GLINT_INTERRUPTED when the stop flag is up. */
glint_status glint_report_go_on(const glint_report *report, glint_error *err);

#endif
