/* How far a unit's W is from cosⁿ and from its own formula, by its C model, which lockstep and the
 * exhaustive run show to be the Verilog bit for bit. */
#ifndef GLINT_SIM_COMPARE_ERRORS_H
#define GLINT_SIM_COMPARE_ERRORS_H

#include <stdint.h>

#include "circuit/setting.h"

/* The exponents that the device is for, as in the thesis. */
enum { GLINT_COMPARE_N_MIN = 1, GLINT_COMPARE_N_MAX = 1000 };

/* One difference |W − reference|, in 1/255, and the first point that has it. */
typedef struct glint_compare_worst {
    double steps;
    uint32_t n, code;
} glint_compare_worst;

typedef struct glint_compare_errors {
    uint64_t points;           /* compared */
    glint_compare_worst power; /* against cosⁿ of the code's cosine */
    glint_compare_worst own;   /* against what the unit computes, without rounding */
    /* Σ(W − cosⁿ)² / Σ(cosⁿ)² over the cosines, which is over the half vectors of a hemisphere,
     * since equal steps of the cosine are equal solid angles; of the n where it is largest. */
    double nmse;
    uint32_t nmse_n;
} glint_compare_errors;

/* Every n, or the one that the unit is made for, with codes 0, stride, 2·stride … and 1.0; stride 1
 * is every point. */
glint_status glint_compare_measure(const glint_setting *setting, uint32_t stride,
                                   glint_compare_errors *errors, glint_error *err);

#endif
