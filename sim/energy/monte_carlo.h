/* The directional albedo by random directions: the independent check of albedo.h, from vectors and
 * the BRDF alone. */
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
 * n and √n and a cosine around N, so that no sample weighs without bound. For Lambert's: the cosine
 * alone, with which all samples weigh the same. angle: between N and L,
 * radians, 0 ≤ angle < π/2. The same seed gives the same samples. */
glint_estimate glint_monte_carlo_albedo(const glint_reflectance *reflectance, double angle,
                                        int samples, uint64_t seed);

#endif
