/* Searches on one variable, deterministic: the same bits from the same function. */
#ifndef GLINT_SIM_REFLECTANCE_SEARCH_H
#define GLINT_SIM_REFLECTANCE_SEARCH_H

typedef double (*glint_search_function)(const void *context, double x);

/* The largest value of a continuous function over from…to: the best of samples + 1 equally spaced
 * places, refined by golden section between its neighbours. Right when no two maxima lie within two
 * spacings. *at (may be NULL) is where it is. */
double glint_search_maximum(glint_search_function f, const void *context, double from, double to,
                            int samples, double *at);

/* Where a function that does not rise crosses zero, by bisection to the last bit; from < to, with
 * f(from) ≥ 0 ≥ f(to). */
double glint_search_zero(glint_search_function f, const void *context, double from, double to);

#endif
