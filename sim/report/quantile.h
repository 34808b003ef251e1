/* What of many measurements is told. */
#ifndef GLINT_SIM_REPORT_QUANTILE_H
#define GLINT_SIM_REPORT_QUANTILE_H

/* The value below which a share (0…1) of them lies, between neighbours by their distance: 0.5 is
 * the median, 0.25 and 0.75 enclose the middle half. count: 1 or more. Sorts the values. */
double glint_quantile(double *values, int count, double share);

#endif
