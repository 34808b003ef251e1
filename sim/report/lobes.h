/* The parts of the chapter on the lobes. */
#ifndef GLINT_SIM_REPORT_LOBES_H
#define GLINT_SIM_REPORT_LOBES_H

#include "report/device_errors.h"

/* The quadratic's level in figure 2.7. */
#define GLINT_QUADRATIC_LEVEL 0.56

/* The zone of decay ends here: anything fainter is 2 levels of 255 or less. */
#define GLINT_DECAY_LEVEL 0.01

/* From here on the cosine-quadratic is zero above the surface. */
#define GLINT_LOBE_ENDS_FROM 3.0

/* (2.15), zero beyond its zero. */
double glint_formula_w(double n, double cosine);

/* The measurements of every lobe that approximates cosⁿ. */
typedef struct glint_lobes {
    glint_exponents exponents;
    glint_accuracy by_n[GLINT_REFLECTANCE_COUNT][1000]; /* level GLINT_EPICENTRE_LEVEL */
    glint_accuracy quadratic[1000];                     /* level GLINT_QUADRATIC_LEVEL */
    glint_accuracy quadratic_decay[1000];               /* level GLINT_DECAY_LEVEL */
    glint_accuracy cosine_quadratic_decay[1000];        /* the same */
} glint_lobes;

/* What sections 2.1 to 2.3 derive or state about a curve's shape, computed independently: the
 * numbers lobes.a.…, lobes.integral.…, lobes.place.…, lobes.decay.… and lobes.quadratic.…. */
void glint_derivations_put(const glint_lobes *lobes, glint_numbers *numbers);
glint_status glint_shapes_put(const glint_lobes *lobes, glint_numbers *numbers, glint_error *err);

/* Figures 2.2 to 2.7 and 2.10, and the family's. */
glint_status glint_lobes_draw(glint_report *report, const glint_lobes *lobes, glint_error *err);

#endif
