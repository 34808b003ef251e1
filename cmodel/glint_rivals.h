/* Rivals of the specular and the power device: published ways to a highlight, each as a circuit
 * behind the same pins, so that what they cost can be compared (docs/highlight-units.md).
 *
 * Each is a highlight unit (glint_unit.h) and the twin of rtl/NAME_device.v. */
#ifndef GLINT_CMODEL_RIVALS_H
#define GLINT_CMODEL_RIVALS_H

#include "glint_unit.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Lyon's (1 − n·x/k)^k, 0 where n·x ≥ k, x = 1 − cos γ: k − 1 multiplications less than it looks,
 * as k is a power of two. Variant 0: k = 4, two squarings; 1: k = 8, three. The line and its
 * squares are U1.16, rounded half up. */
#define GLINT_LYON_FRAC_BITS 16
#define GLINT_LYON_VARIANTS  2
#define GLINT_LYON_LOG2_K(v) (2 + (v))
extern const glint_unit glint_unit_lyon;

/* Schlick's cos γ / (n − n·cos γ + cos γ) by division, one bit of the quotient a stage, restoring;
 * U1.12, cut off. Where both are 0, at cos γ = n = 0, the quotient is 1. */
#define GLINT_SCHLICK_FRAC_BITS 12
#define GLINT_SCHLICK_DEN_BITS  (GLINT_N_BITS + GLINT_COS_FRAC_BITS)
extern const glint_unit glint_unit_schlick;

#ifdef __cplusplus
}
#endif

#endif
