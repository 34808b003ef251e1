/* The parts of the section on the lobes, for section_lobes.c alone. */
#ifndef GLINT_SIM_REPORT_LOBE_PARTS_H
#define GLINT_SIM_REPORT_LOBE_PARTS_H

#include "report/lobe_errors.h"

/* The quadratic's level in figure 2.7. */
#define GLINT_QUADRATIC_LEVEL 0.56

/* The zone of decay ends here: what is fainter is 2 levels of 255 or less. */
#define GLINT_DECAY_LEVEL 0.01

/* A least and a largest over exponents; not a number over none. */
typedef struct glint_span_of_n {
    double least, largest;
} glint_span_of_n;

/* What the thesis derives instead of tabulating, done again by computing. */
typedef struct glint_derivations {
    int a_count, a_undefined; /* (2.8) as printed, at n = 1…1000 */
    int a_first_undefined;    /* 0: none */
    double a_lost;            /* the largest relative error that cancellation makes of it */
    double a_limit;           /* at n = 1 */

    double integral_apart; /* of W to its zero, from 1/(n+1), relative; over all exponents */
    double in_front_short; /* by how much less it is in front of the surface, the largest */
    double in_front_short_n;

    /* From n = 3 on: for n = 1 and 2 the lobe has no end above the surface. */
    glint_span_of_n relative_apart;   /* of the place of the largest W/cosⁿ − 1, searched, from
                                         c = n/(n+1); in widths of the lobe, 1/(n+1) */
    glint_span_of_n relative_level;   /* cosⁿ at c = n/(n+1) */
    glint_span_of_n relative_there;   /* W/cosⁿ − 1 at the place searched */
    glint_span_of_n relative_at_end;  /* 1 − W/cosⁿ where W is zero */
    glint_span_of_n level_at_end;     /* cosⁿ at c = (n−2)/(n+1), where W is zero */
    glint_span_of_n absolute_to_end;  /* the largest absolute error to the one there */
    double relative_at_1, level_at_1; /* W/cosⁿ − 1 and cosⁿ at c = n/(n+1) for n = 1 */
} glint_derivations;

/* Where those begin. */
#define GLINT_LOBE_ENDS_FROM 3.0

/* (2.15), zero beyond its zero. */
double glint_formula_w(double n, double cosine);

/* What was measured of every lobe that stands for cosⁿ. */
typedef struct glint_lobes {
    glint_exponents exponents;
    glint_accuracy by_n[GLINT_REFLECTANCE_COUNT][1000]; /* level GLINT_EPICENTRE_LEVEL */
    glint_accuracy quadratic[1000];                     /* level GLINT_QUADRATIC_LEVEL */
    glint_accuracy quadratic_decay[1000];               /* level GLINT_DECAY_LEVEL */
    glint_accuracy cosine_quadratic_decay[1000];        /* the same */
    glint_device_errors device;
    glint_derivations derived;
} glint_lobes;

/* true for the lobes of N·H that stand for cosⁿ itself, scaled by nothing. */
bool glint_lobe_is_measured(glint_reflectance_model model);

glint_lobe_worst glint_lobes_worst(const glint_lobes *lobes, glint_reflectance_model model,
                                   glint_n_range range);

/* From the exponents and by_n[GLINT_REFLECTANCE_COSINE_QUADRATIC]. */
void glint_derivations_measure(const glint_lobes *lobes, glint_derivations *derived);

/* Figures 2.2 to 2.7 and 2.10, and the family's. */
glint_status glint_lobes_draw(glint_report *report, const glint_lobes *lobes, glint_error *err);

/* The claims of sections 2.1 to 2.3, 2.7, 3.1 and 3.4 on formulas: from these numbers alone. */
void glint_lobes_find(const glint_lobes *lobes, glint_findings *findings);

#endif
