/* Curves over one variable, drawn by gnuplot into the report. */
#ifndef GLINT_SIM_REPORT_CHART_H
#define GLINT_SIM_REPORT_CHART_H

#include "report/chapter.h"

#define GLINT_CHART_CURVES_MAX 8

/* For the settings of many curves. The empty line keeps the key off the variable's name. */
#define GLINT_CHART_KEY_BELOW "set key below title ' '\n"

typedef struct glint_chart {
    const char *name; /* of the files: NAME.dat, NAME.gnuplot, NAME.svg, NAME.png */
    const char *title;
    const char *x_label, *y_label;
    const char *settings; /* more lines for gnuplot, each with its newline; may be NULL */
    const char *style;    /* "with …"; NULL: lines */
    int curves;           /* 1…GLINT_CHART_CURVES_MAX */
    const char *curve[GLINT_CHART_CURVES_MAX]; /* their titles */
} glint_chart;

/* values: rows × (1 + curves), the variable first; NAN leaves a gap in a curve. */
glint_status glint_chart_draw(glint_report *report, const glint_chart *chart, const double *values,
                              int rows, glint_error *err);

#endif
