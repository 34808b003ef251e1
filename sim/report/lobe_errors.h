/* The deviation of the lobes from exact cosⁿ, over many n, and that of the device, code by code. */
#ifndef GLINT_SIM_REPORT_LOBE_ERRORS_H
#define GLINT_SIM_REPORT_LOBE_ERRORS_H

#include <stdint.h>

#include "reflectance/accuracy.h"
#include "report/chapter.h"

/* The exponents of a report: all of 1…1000, or some with --quick. */
typedef struct glint_exponents {
    double n[1000];
    int count;
} glint_exponents;

void glint_exponents_of(bool quick, glint_exponents *exponents);

/* Some of them: those from … to, both included. */
typedef struct glint_n_range {
    double from, to;
} glint_n_range;

extern const glint_n_range glint_n_all;

/* "999 exponents n = 2…1000", "n = 1", "no exponent": which of them are in the range. */
void glint_exponents_say(const glint_exponents *exponents, glint_n_range range, char *text,
                         size_t room);

/* Measures a model at each exponent (accuracy.h) into by_n, as many as there are exponents. */
glint_status glint_lobe_errors(const glint_report *report, glint_reflectance_model model,
                               double level, const glint_exponents *exponents, glint_accuracy *by_n,
                               glint_error *err);

/* A largest error over exponents; NaN if there are none. */
typedef struct glint_worst {
    double error, n, cosine;
} glint_worst;

typedef struct glint_lobe_worst {
    glint_worst absolute, epicentre_absolute, epicentre_relative;
} glint_lobe_worst;

glint_lobe_worst glint_lobe_worst_of(const glint_exponents *exponents, const glint_accuracy *by_n,
                                     glint_n_range range);

/* true for the unscaled lobes of N·H that approximate cosⁿ itself. */
bool glint_lobe_is_measured(glint_reflectance_model model);

#endif
