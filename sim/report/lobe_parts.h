/* The parts of the section on the lobes, for section_lobes.c alone. */
#ifndef GLINT_SIM_REPORT_LOBE_PARTS_H
#define GLINT_SIM_REPORT_LOBE_PARTS_H

#include "report/lobe_errors.h"

/* The quadratic's level in figure 2.7. */
#define GLINT_QUADRATIC_LEVEL 0.56

/* The zone of decay ends here: what is fainter is 2 levels of 255 or less. */
#define GLINT_DECAY_LEVEL 0.01

/* What was measured of every lobe that stands for cosⁿ. */
typedef struct glint_lobes {
    glint_exponents exponents;
    glint_accuracy by_n[GLINT_REFLECTANCE_COUNT][1000]; /* level GLINT_EPICENTRE_LEVEL */
    glint_accuracy quadratic[1000];                     /* level GLINT_QUADRATIC_LEVEL */
    glint_accuracy quadratic_decay[1000];               /* level GLINT_DECAY_LEVEL */
    glint_accuracy cosine_quadratic_decay[1000];        /* the same */
    glint_device_errors device;
} glint_lobes;

/* true for the lobes of N·H that stand for cosⁿ itself, scaled by nothing. */
bool glint_lobe_is_measured(glint_reflectance_model model);

glint_lobe_worst glint_lobes_worst(const glint_lobes *lobes, glint_reflectance_model model,
                                   double n_from);

/* Figures 2.2 to 2.7 and 2.10, and the family's. */
glint_status glint_lobes_draw(glint_report *report, const glint_lobes *lobes, glint_error *err);

/* The claims of sections 2.1 to 2.3, 2.7, 3.1 and 3.4 on formulas. */
void glint_lobes_find(const glint_lobes *lobes, glint_findings *findings);

#endif
