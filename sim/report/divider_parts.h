/* The parts of the report on the divider, one file each. */
#ifndef GLINT_SIM_REPORT_DIVIDER_PARTS_H
#define GLINT_SIM_REPORT_DIVIDER_PARTS_H

#include <stdio.h>

#include "report/divider_report.h"

/* divider.md */
void glint_divider_write_markdown(FILE *out, const glint_divider_report *report);

/* The same without its title and opening; level: "##" or more, of its headings. */
void glint_divider_write_parts(FILE *out, const glint_divider_report *report, const char *level);

/* figure-2.12.dat: k and the relative error in per cent for each number of shifts of the figure;
 * figure-2.12.gnuplot: how it is plotted. */
void glint_divider_write_plot_data(FILE *out);
void glint_divider_write_plot_script(FILE *out);

#endif
