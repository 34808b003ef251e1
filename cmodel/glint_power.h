/* The power device: a highlight unit of the specular device's inventory that is accurate against
 * Blinn's cosⁿγ, as a pure function.
 *
 *     x = 1 − cos γ     L = −n·log2(1 − x) = n·x·g(x),  g(x) = −log2(1 − x)/x
 *     W = 2^(−L)        (R,G,B)out = W · (R,G,B)
 *
 * g is between 1.44 and about 10 and smooth, so a table of few bits has it; n·x keeps the relative
 * accuracy of L where the cosine is near 1, without a normaliser; and a relative error of L by one
 * part in a hundred moves W by at most 1/(100·e). docs/highlight-units.md has the error.
 *
 * Two accuracies, by the size of the two tables: over every cosine code and n = 0…1023 W is within
 * 0.4981 or 0.2491 of 1/255 of cosⁿ, W(1) = 1, and W never falls as the cosine grows.
 *
 * Blocks are numbered by the inventory of figure 3.1; the same clock by clock is a highlight unit
 * (glint_unit.h), the twin of rtl/power_device.v. */
#ifndef GLINT_CMODEL_POWER_H
#define GLINT_CMODEL_POWER_H

#include <stddef.h>
#include <stdint.h>

#include "glint_specular.h"
#include "glint_unit.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef enum glint_power_accuracy {
    GLINT_POWER_HALF,    /* within half an 8-bit step; tables of 256 */
    GLINT_POWER_QUARTER, /* within a quarter of one; tables of 512 */
    GLINT_POWER_ACCURACY_COUNT
} glint_power_accuracy;

/* Register 1: x = 1 − cos γ, U0.18; where cos γ is 0, the code next below 1. */
#define GLINT_POWER_X_BITS GLINT_COS_FRAC_BITS

/* Multiplier 7: p = n·x, exact, U10.18; its middle goes on, q = p cut off to U4.12. */
#define GLINT_POWER_P_INT_BITS  GLINT_N_BITS
#define GLINT_POWER_P_BITS      (GLINT_POWER_P_INT_BITS + GLINT_POWER_X_BITS)
#define GLINT_POWER_Q_FRAC_BITS 12

/* L is below 16: where it is not, W is less than half of its last place, and 0. */
#define GLINT_POWER_L_INT_BITS 4
#define GLINT_POWER_Q_BITS     (GLINT_POWER_L_INT_BITS + GLINT_POWER_Q_FRAC_BITS)

/* The two tables have as many address bits each, `table`; ROM 9: g, U4.table; multiplier 10: v =
 * q·g, U8.table, rounded half up; ROM 33: 2^(−f), U1.w; key block 12: W, U1.w. */
#define GLINT_POWER_TABLE_BITS(accuracy)  (8 + (int)(accuracy))
#define GLINT_POWER_W_FRAC_BITS(accuracy) (12 + 2 * (int)(accuracy))
#define GLINT_POWER_V_INT_BITS            (2 * GLINT_POWER_L_INT_BITS)

/* Clocks from the edge that takes a cosine to its result, that edge included. */
#define GLINT_POWER_LATENCY_PIPELINED 5

/* Every block's value for one point. */
typedef struct glint_power_values {
    uint32_t reg1;               /* x, U0.18 */
    uint32_t mul7;               /* p, U10.18 */
    uint32_t rom9;               /* g, U4.8 or U4.9 */
    uint32_t mul10;              /* v, U8.8 or U8.9 */
    uint32_t cmp11;              /* 1: both p and v are below 16 */
    uint32_t rom33;              /* 2^(−f), f the fraction of v: U1.12 or U1.14 */
    uint32_t keys12;             /* W: that, shifted by the integer part of v; 0 where cmp11 is 0 */
    uint8_t mul13, mul14, mul15; /* W·R, W·G, W·B, U8.0, rounded half up */
} glint_power_values;

/* ROM 9 at an address of `table` bits: g in the middle of the interval, rounded half up. */
uint32_t glint_power_rom9(glint_power_accuracy accuracy, uint32_t address);

/* ROM 33: 2^(−address/2^table), rounded half up. */
uint32_t glint_power_rom33(glint_power_accuracy accuracy, uint32_t address);

/* Computes one point: cos_code U1.18, 0…GLINT_COS_CODE_MAX (codes above 1.0 saturate).
 * GLINT_BAD_ARGUMENT when cos_code, material->n or accuracy is out of range. */
glint_status glint_power_eval(glint_power_accuracy accuracy, const glint_material *material,
                              uint32_t cos_code, glint_power_values *values);

/* Computes count points with one material, bit-equal to glint_power_eval(); arrays as
 * glint_specular_batch() has them, w_code U1.12 or U1.14. GLINT_BAD_ARGUMENT when material->n or
 * accuracy is out of range (codes are not checked). */
glint_status glint_power_batch(glint_power_accuracy accuracy, const glint_material *material,
                               const uint32_t *GLINT_RESTRICT cos_code, size_t count,
                               uint32_t *GLINT_RESTRICT w_code, uint8_t *GLINT_RESTRICT r,
                               uint8_t *GLINT_RESTRICT g, uint8_t *GLINT_RESTRICT b);

/* What it approximates: cosⁿγ of the quantised cosine, 0…1; 0⁰ is 1. */
double glint_power_real(uint32_t n, uint32_t cos_code);

/* The same clock by clock, for glint_unit_device_create(); its variant is the accuracy. */
extern const glint_unit glint_unit_power;

/* "half", "quarter"; NULL when out of range. */
const char *glint_power_accuracy_name(glint_power_accuracy accuracy);

#ifdef __cplusplus
}
#endif

#endif
