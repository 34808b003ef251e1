/* Nodes by Newton's method on the Legendre polynomials. */
#include "energy/gauss.h"

#include <math.h>

#define PI 3.14159265358979323846

/* More than Newton's method needs from the start below. */
#define STEPS 8

/* P_order(x), by its recurrence, and its derivative; x is inside −1…1. */
static double legendre(int order, double x, double *slope)
{
    double before = 1.0, value = x;
    for (int k = 2; k <= order; k++) {
        const double next = ((2 * k - 1) * x * value - (k - 1) * before) / k;
        before = value;
        value = next;
    }
    *slope = order * (x * value - before) / (x * x - 1.0);
    return value;
}

void glint_gauss_make(int order, glint_gauss *rule)
{
    rule->order = order;
    for (int i = 0; i < order; i++) {
        double x = cos(PI * (i + 0.75) / (order + 0.5)), slope = 1.0;
        for (int step = 0; step < STEPS; step++) {
            const double value = legendre(order, x, &slope);
            x -= value / slope;
        }
        legendre(order, x, &slope);
        rule->node[i] = x;
        rule->weight[i] = 2.0 / ((1.0 - x * x) * slope * slope);
    }
}

double glint_gauss_integrate(const glint_gauss *rule, glint_integrand *f, const void *context,
                             double from, double to)
{
    const double middle = 0.5 * (from + to), half = 0.5 * (to - from);
    double sum = 0.0;
    for (int i = 0; i < rule->order; i++)
        sum += rule->weight[i] * f(context, middle + half * rule->node[i]);
    return half * sum;
}
