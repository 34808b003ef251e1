/* Quantiles of measurements; see quantile.h. */
#include "report/quantile.h"

#include <stdlib.h>

static int compare(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

double glint_quantile(double *values, int count, double share)
{
    qsort(values, (size_t)count, sizeof *values, compare);
    const double at = share * (count - 1);
    const int below = at < count - 1 ? (int)at : count - 1;
    const int above = below < count - 1 ? below + 1 : below;
    return values[below] + (at - below) * (values[above] - values[below]);
}
