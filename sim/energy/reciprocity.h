/* Helmholtz reciprocity (2.20): f_r(L,V) = f_r(V,L). */
#ifndef GLINT_SIM_ENERGY_RECIPROCITY_H
#define GLINT_SIM_ENERGY_RECIPROCITY_H

#include <stdint.h>

#include "reflectance/reflectance.h"

/* f_r for the cosines of L and V. */
typedef double glint_brdf(const void *context, const glint_geometry *geometry);

typedef struct glint_reciprocity {
    uint64_t pairs;           /* compared */
    uint64_t dark;            /* of these, 0 both ways */
    double largest;           /* |f_r(L,V) − f_r(V,L)| relative to the larger of the two */
    glint_vec3 light, viewer; /* where; N is Z */
} glint_reciprocity;

/* Compares at `pairs` random pairs of directions above the surface (half of them with V near the
 * mirrored L, where narrow lobes are not 0) and at every pair of a grid of directions that includes
 * the normal, grazing and nearly equal ones. Returns where f is least symmetric. */
void glint_reciprocity_measure(glint_brdf *f, const void *context, uint64_t pairs, uint64_t seed,
                               glint_reciprocity *result);

/* A glint_brdf; its context is a glint_reflectance. */
double glint_reciprocity_of_model(const void *reflectance, const glint_geometry *geometry);

#endif
