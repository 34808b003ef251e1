/* Golden section and bisection; see search.h. */
#include "reflectance/search.h"

#include <math.h>
#include <stddef.h>

/* Where two maxima are equal to rounding, golden section cannot tell them apart any more. */
#define WIDTH_LEFT 1e-9

typedef struct peak {
    double x, value;
} peak;

static peak better(peak a, double x, double value)
{
    return value > a.value ? (peak){x, value} : a;
}

static peak golden_section(glint_search_function f, const void *context, double from, double to,
                           peak best)
{
    const double ratio = 0.5 * (sqrt(5.0) - 1.0);
    const double enough = WIDTH_LEFT * (to - from);
    double low = to - ratio * (to - from), high = from + ratio * (to - from);
    double at_low = f(context, low), at_high = f(context, high);
    while (to - from > enough) {
        best = better(better(best, low, at_low), high, at_high);
        if (at_low >= at_high) {
            to = high;
            high = low;
            at_high = at_low;
            low = to - ratio * (to - from);
            at_low = f(context, low);
        } else {
            from = low;
            low = high;
            at_low = at_high;
            high = from + ratio * (to - from);
            at_high = f(context, high);
        }
    }
    return best;
}

double glint_search_maximum(glint_search_function f, const void *context, double from, double to,
                            int samples, double *at)
{
    const double step = (to - from) / samples;
    peak best = {from, f(context, from)};
    for (int i = 1; i <= samples; i++) {
        const double x = i < samples ? from + i * step : to;
        best = better(best, x, f(context, x));
    }
    best = golden_section(f, context, fmax(from, best.x - step), fmin(to, best.x + step), best);
    if (at != NULL)
        *at = best.x;
    return best.value;
}

double glint_search_zero(glint_search_function f, const void *context, double from, double to)
{
    for (;;) {
        const double middle = from + 0.5 * (to - from);
        if (middle <= from || middle >= to)
            return from;
        if (f(context, middle) >= 0.0)
            from = middle;
        else
            to = middle;
    }
}
