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

/* The same by the reciprocal of the denominator: normalised, 1/m from a table of 128, one step of
 * Newton's, and a shift back; U1.12, rounded half up, at most 1. */
#define GLINT_NEWTON_FRAC_BITS  12
#define GLINT_NEWTON_TABLE_BITS 7
#define GLINT_NEWTON_SEED_BITS  10 /* of the table: U0.10 */
#define GLINT_NEWTON_M_BITS     17 /* fraction bits of m, of 2 − m·y and of the second y */
extern const glint_unit glint_unit_newton;

/* The table: 1/m in the middle of its interval, rounded half up; address: 0…127. */
uint32_t glint_newton_seed(uint32_t address);

/* The power by its definition, cosⁿ = 2^(n·log2 cos): the cosine is normalised, its logarithm comes
 * from a table of 128 lines, the power from ROM 33 of the power device (accuracy half) and a shift;
 * U1.12. */
#define GLINT_LOG2_W_FRAC_BITS 12
#define GLINT_LOG2_FRAC_BITS   22 /* of the logarithm */
#define GLINT_LOG2_TABLE_BITS  7
#define GLINT_LOG2_SLOPE_FRAC  20 /* the slope is that of a whole interval */
#define GLINT_LOG2_SLOPE_BITS  14
#define GLINT_LOG2_L_INT_BITS  5
extern const glint_unit glint_unit_log2;

/* The line of interval `address`, 0…127: where it begins, U1.22, and how far it rises, U0.20. The
 * chord of the logarithm, raised by half of what the logarithm is above it; the last one is not. */
uint32_t glint_log2_base(uint32_t address);
uint32_t glint_log2_slope(uint32_t address);

/* The thesis's quadratic, ac² + (1−a)c = c·(1 − a·(1−c)) (2.3), where the line is not negative; a
 * of n from a ROM, U10.13; W U1.18, rounded half up. n = 0 has the a of n = 1, which is 0. */
#define GLINT_QUADRATIC_A_INT_BITS  10
#define GLINT_QUADRATIC_A_FRAC_BITS 13
#define GLINT_QUADRATIC_A_BITS      (GLINT_QUADRATIC_A_INT_BITS + GLINT_QUADRATIC_A_FRAC_BITS)
extern const glint_unit glint_unit_quadratic;

/* ROM 33: a(n) by (2.4) and (2.7), rounded half up. */
uint32_t glint_quadratic_rom33(uint32_t n);

/* cosⁿ of one n by a bipartite table: the bits of the cosine in three parts a, b, c, and W the sum
 * of two words, one at (a, b), the value where the interval begins, and one at (a, c), how much is
 * added within it, which is that of all b alike. U1.12, not rounded again, so that W may fall by a
 * last place where b steps. The n of the pins is not used.
 *
 * Variant v: n = 8·2^v. As cosⁿ gets steeper with n, a has a bit more for each; the cosine's last
 * bits are left away. */
#define GLINT_BIPARTITE_FRAC_BITS   12
#define GLINT_BIPARTITE_VARIANTS    3
#define GLINT_BIPARTITE_N(v)        (8u << (v))
#define GLINT_BIPARTITE_A_BITS      5 /* of variant 0 */
#define GLINT_BIPARTITE_B_BITS      4
#define GLINT_BIPARTITE_C_BITS      3
#define GLINT_BIPARTITE_OFFSET_BITS 6 /* of a word that is added: last places of W */
extern const glint_unit glint_unit_bipartite;

/* The two tables: address (a, b) gives U0.12, (a, c) gives last places of that. */
uint32_t glint_bipartite_value(int variant, uint32_t address);
uint32_t glint_bipartite_offset(int variant, uint32_t address);

#ifdef __cplusplus
}
#endif

#endif
