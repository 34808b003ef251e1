/* What each highlight unit computes, without rounding. */
#ifndef GLINT_SIM_COMPARE_FORMULA_H
#define GLINT_SIM_COMPARE_FORMULA_H

#include <stdint.h>

#include "circuit/setting.h"
#include "glint_specular_device.h"
#include "glint_unit.h"

/* That of one setting. */
typedef struct glint_compare_formula {
    const glint_unit *unit; /* NULL: the specular device */
    int variant;            /* of the unit */
    glint_gate gate;        /* of the specular device */
} glint_compare_formula;

/* GLINT_BAD_ARGUMENT for a circuit without one. */
glint_status glint_compare_formula_of(const glint_setting *setting, glint_compare_formula *formula,
                                      glint_error *err);

/* The one n that the unit is made for; 0: it takes any. */
uint32_t glint_compare_formula_n(const glint_compare_formula *formula);

/* W, 0…1; n and the code in range. */
double glint_compare_formula_w(const glint_compare_formula *formula, uint32_t n, uint32_t cos_code);

#endif
