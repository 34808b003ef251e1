/* Plots by gnuplot, which need not be there. */
#ifndef GLINT_SIM_REPORT_PLOT_H
#define GLINT_SIM_REPORT_PLOT_H

#include <stdbool.h>

#include "glint_status.h"

/* How long gnuplot may draw one picture, here: it takes well below a second. */
#define GLINT_PLOT_SECONDS 60.0

typedef struct glint_plot_limits {
    const volatile bool *stop; /* may be NULL */
    double seconds;            /* for one picture */
} glint_plot_limits;

/* Has gnuplot run the script NAME.gnuplot of the directory, in that directory, once for NAME.svg
 * and once for NAME.png. The script sets no terminal and no output. *plotted: false, with GLINT_OK,
 * when there is no gnuplot. A gnuplot that fails, or takes longer than the limit, is
 * GLINT_IO_ERROR; GLINT_INTERRUPTED when *stop becomes true while it draws. In each of these cases
 * the picture is what it was before; a gnuplot that has not ended by itself is ended, and all that
 * it has started. */
glint_status glint_plot(const char *directory, const char *name, const glint_plot_limits *limits,
                        bool *plotted, glint_error *err);

#endif
