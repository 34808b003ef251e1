/* The directional albedo by Monte Carlo: an independent check of albedo.h, from vectors and the
 * BRDF alone. */
#ifndef GLINT_SIM_ENERGY_MONTE_CARLO_H
#define GLINT_SIM_ENERGY_MONTE_CARLO_H

#include <stdint.h>

#include "reflectance/reflectance.h"

typedef struct glint_estimate {
    double mean;
    double error; /* standard error of the mean, from the samples' own spread */
} glint_estimate;

#define GLINT_SAMPLES_MIN 2

/* Draws V with a density that mixes lobes of Blinn (for Phong's model, of Phong) with the exponents
 * n and √n and a cosine around N, so that sample weights stay bounded. Lambert's uses the cosine
 * alone, which gives all samples equal weight. angle: between N and L, radians, 0 ≤ angle < π/2.
 * The same seed gives the same samples. */
glint_estimate glint_monte_carlo_albedo(const glint_reflectance *reflectance, double angle,
                                        int samples, uint64_t seed);

#endif
