/* The deviation of a lobe from exact cosⁿ. */
#ifndef GLINT_SIM_REFLECTANCE_ACCURACY_H
#define GLINT_SIM_REFLECTANCE_ACCURACY_H

#include "reflectance/reflectance.h"

typedef struct glint_largest_error {
    double error;  /* ≥ 0 */
    double cosine; /* where */
} glint_largest_error;

typedef struct glint_accuracy {
    glint_largest_error absolute;           /* over cosines 0…1 */
    glint_largest_error epicentre_absolute; /* where cosⁿ ≥ level */
    glint_largest_error epicentre_relative; /* there, of cosⁿ */
} glint_accuracy;

/* Measures a prepared lobe, n > 0. level: above 0, below 1; GLINT_EPICENTRE_LEVEL is the thesis's.
 * Samples thousands of places and refines the worst by golden section: exact to about 1e-12 for a
 * formula; for the device, which has steps, the largest value sampled. GLINT_BAD_ARGUMENT for a
 * level out of range, n = 0, Lambert's and the microfacet models. */
glint_status glint_accuracy_measure(const glint_reflectance *prepared, double level,
                                    glint_accuracy *accuracy, glint_error *err);

#endif
