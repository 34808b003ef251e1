/* Deterministic searches in one variable: the same function gives the same bits. */
#ifndef GLINT_SIM_REFLECTANCE_SEARCH_H
#define GLINT_SIM_REFLECTANCE_SEARCH_H

typedef double (*glint_search_function)(const void *context, double x);

/* The largest value of a continuous function over from…to: the best of samples + 1 equally spaced
 * places, refined by golden section between its neighbours. Correct if no two maxima lie within two
 * spacings. *at (may be NULL) receives its place. */
double glint_search_maximum(glint_search_function f, const void *context, double from, double to,
                            int samples, double *at);

/* The zero of a non-increasing function, by bisection to the last bit; from < to, with f(from) ≥ 0
 * ≥ f(to). */
double glint_search_zero(glint_search_function f, const void *context, double from, double to);

#endif
