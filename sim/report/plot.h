/* Plots by gnuplot, which need not be there. */
#ifndef GLINT_SIM_REPORT_PLOT_H
#define GLINT_SIM_REPORT_PLOT_H

#include <stdbool.h>

#include "glint_status.h"

/* Has gnuplot run the script NAME.gnuplot of the directory, in that directory, once for NAME.svg
 * and once for NAME.png. The script sets no terminal and no output. *plotted: false, with GLINT_OK,
 * when there is no gnuplot. A gnuplot that fails is GLINT_IO_ERROR. */
glint_status glint_plot(const char *directory, const char *name, bool *plotted, glint_error *err);

#endif
