/* Gauss–Legendre nodes, for integrals of smooth functions. */
#ifndef GLINT_SIM_ENERGY_GAUSS_H
#define GLINT_SIM_ENERGY_GAUSS_H

#define GLINT_GAUSS_ORDER_MAX 64

typedef struct glint_gauss {
    int order;                            /* exact for polynomials up to degree 2·order − 1 */
    double node[GLINT_GAUSS_ORDER_MAX];   /* in −1…1 */
    double weight[GLINT_GAUSS_ORDER_MAX]; /* their sum is 2 */
} glint_gauss;

/* order: 1…GLINT_GAUSS_ORDER_MAX. Errors of the nodes and weights are a few 1e-16. */
void glint_gauss_make(int order, glint_gauss *rule);

typedef double glint_integrand(const void *context, double x);

double glint_gauss_integrate(const glint_gauss *rule, glint_integrand *f, const void *context,
                             double from, double to);

#endif
