/* Section 2.5: the albedo of the cosine-quadratic at normal incidence by (2.25), and the factor (n
 * + A)/B of (2.26), meant to keep it at most 1 for all n. */
#ifndef GLINT_SIM_ENERGY_NORMALIZATION_H
#define GLINT_SIM_ENERGY_NORMALIZATION_H

/* The upper limit of (2.25), 5.8/√n, radians. */
double glint_printed_limit(double n);

/* The integral of (2.25) from 0 to a limit in radians: of the parabola itself, which beyond its
 * zero rises again, and of cos θ, which beyond π/2 is negative. */
double glint_printed_albedo(double n, double limit);

/* The same with the dω of (2.25), which has sin θ already, read as sin θ dθ: sin²θ in all. */
double glint_printed_albedo_by_solid_angle(double n, double limit);

/* The integral of (2.24) over the hemisphere as it is printed, with (cos θ)/2 for cos(θ/2). */
double glint_misprinted_albedo(double n);

/* A factor (n + A)/B for the exponents n = 1 … count. The loss at an n is 1 less the albedo with
 * that factor at normal incidence. */
typedef struct glint_normalization {
    double a, b;
    int tight_n; /* where the albedo is 1; B is the smallest that conserves energy for all n */
    double mean_loss;
    double largest_loss;
    int largest_n; /* where that is */
} glint_normalization;

/* With the smallest B for an A > −1. albedo[i] is that of n = i + 1, without the factor. */
void glint_normalization_for(double a, const double *albedo, int count,
                             glint_normalization *result);

typedef enum glint_loss {
    GLINT_LOSS_MEAN,   /* over the exponents */
    GLINT_LOSS_LARGEST /* of any exponent */
} glint_loss;

/* The largest A searched. */
#define GLINT_NORMALIZATION_A_MAX 1000.0

/* The A, with its smallest B, of the least loss. Both losses have one minimum in A (the part that
 * is not lost is a mean or a least of straight lines over a largest of straight lines), so a search
 * by golden section finds it, to about 1e-9. */
void glint_normalization_best(glint_loss loss, const double *albedo, int count,
                              glint_normalization *result);

#endif
