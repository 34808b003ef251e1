/* The directional albedo R(L) (2.21) of a reflectance model: the fraction of a beam of light from
 * direction L that the surface reflects, ∫ f_r(L,V) (N·V) dω over the hemisphere of V. A model
 * conserves energy when it is at most 1 (2.22). By reciprocity it is also what a viewer in
 * direction L sees of the surface in a white furnace, lit uniformly with 1 from all directions.
 *
 *     glint_albedo_rules rules;
 *     glint_albedo_rules_make(1, &rules);
 *     glint_albedo albedo;
 *     glint_albedo_prepare(&reflectance, &rules, &albedo);
 *     r = glint_albedo_at(&albedo, 0.0);
 *
 * Method. The half vector H, instead of V, runs over the sphere, in polar coordinates (t, φ) around
 * N: V is L mirrored at H, dω_V = 4 (L·H) dω_H, and N·V > 0 bounds φ by a closed form. For a lobe
 * of N·H the integral over φ is elementary, leaving one over t; Phong's is treated likewise in
 * polar coordinates around R. Microfacet models are integrated over φ as well, piecewise between
 * the angles where the geometry term has an edge. In t the pieces follow the lobe, doubling from
 * its half width outwards; where φ is bounded, t = b + (e−b) sin²u removes the square-root
 * singularities at both ends. */
#ifndef GLINT_SIM_ENERGY_ALBEDO_H
#define GLINT_SIM_ENERGY_ALBEDO_H

#include "energy/gauss.h"
#include "reflectance/reflectance.h"

/* Largest difference from results with twice the nodes in each direction, for angles of incidence
 * 0…89° and n from 1 to 1000 (measured at every n up to 19, then at least every ninth): lobes of
 * one cosine and Lambert's; the device, whose steps no quadrature rule follows; microfacets. */
#define GLINT_ALBEDO_ERROR_LOBE       1e-7
#define GLINT_ALBEDO_ERROR_DEVICE     2e-5
#define GLINT_ALBEDO_ERROR_MICROFACET 2e-5

typedef struct glint_albedo_rules {
    glint_gauss line;  /* for lobes: over t */
    glint_gauss plane; /* for the rest: over t and φ */
    int staircase;     /* pieces of each interval, for the device */
} glint_albedo_rules;

/* fineness: 1 or more; multiplies the number of nodes in each direction. At most
 * GLINT_ALBEDO_FINENESS_MAX. */
#define GLINT_ALBEDO_FINENESS_MAX 4
void glint_albedo_rules_make(int fineness, glint_albedo_rules *rules);

typedef struct glint_albedo {
    const glint_reflectance *reflectance;
    const glint_albedo_rules *rules;
    glint_reflectance_cosine kind;
    double half_width; /* radians from the lobe's axis where it is half as high */
    double reach;      /* zero from here on */
    int pieces;        /* of each interval */
} glint_albedo;

/* Keeps both pointers. */
void glint_albedo_prepare(const glint_reflectance *reflectance, const glint_albedo_rules *rules,
                          glint_albedo *albedo);

/* angle: between N and L, radians, 0 ≤ angle < π/2. */
double glint_albedo_at(const glint_albedo *albedo, double angle);

/* The same integral over both coordinates of H for every model: slower, as a check. */
double glint_albedo_over_sphere(const glint_albedo *albedo, double angle);

#endif
