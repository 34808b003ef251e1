/* The shift-accumulate divider (thesis section 2.4, figure 2.13), bit-exact.
 *
 * Gouraud's increment along a span is a difference of two intensities divided by the span's length,
 * ΔI = (Ib − Ia)/k (2.16). The circuit replaces the division by shifts and accumulating additions:
 *
 *     1/k ≈ i₁/2 + i₂/4 + … + iₙ/2ⁿ,  iⱼ ∈ {0, 1}                                       (2.18)
 *
 * with the bits iⱼ from a table indexed by k: those of 2ⁿ/k rounded to nearest, half up. The sum
 * cannot reach 1/1, so for k = 1 the table has one more bit, i₀ of weight 1. No shifted-out bit is
 * lost: the quotient is the exact sum, with n fraction bits.
 *
 * Here the circuit is a pure function. glint_divider_device.h has its two forms clock by clock:
 * sequential (one bit per clock) and pipelined (one division of three components per clock). */
#ifndef GLINT_CMODEL_DIVIDER_H
#define GLINT_CMODEL_DIVIDER_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "glint_formats.h"
#include "glint_status.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Number of shifts n. The thesis uses 6, 7 and 8; with the default, the last pixel of every span in
 * the table is within half an 8-bit level (docs/divider.md). */
#define GLINT_DIVIDER_SHIFTS_MIN     6
#define GLINT_DIVIDER_SHIFTS_MAX     16
#define GLINT_DIVIDER_SHIFTS_DEFAULT 12

/* Span length k: the table holds 1…GLINT_DIVIDER_K_MAX; the input has GLINT_DIVIDER_K_BITS bits. */
#define GLINT_DIVIDER_K_MAX  16
#define GLINT_DIVIDER_K_BITS 8

/* Difference of two 8-bit intensities, S9.0: −255…255. */
#define GLINT_DIVIDER_DIFFERENCE_BITS (1 + GLINT_COLOR_BITS)
#define GLINT_DIVIDER_DIFFERENCE_MAX  ((int)GLINT_COLOR_MAX)

/* Colour components that the pipelined form divides at once by the same k. */
#define GLINT_DIVIDER_COMPONENTS 3

/* Width of the sequential form's counter, which counts 0…GLINT_DIVIDER_SHIFTS_MAX. */
#define GLINT_DIVIDER_LEFT_BITS 5

GLINT_REQUIRE(GLINT_DIVIDER_SHIFTS_MAX >> GLINT_DIVIDER_LEFT_BITS == 0,
              "GLINT_DIVIDER_LEFT_BITS must hold GLINT_DIVIDER_SHIFTS_MAX");
GLINT_REQUIRE(
    GLINT_DIVIDER_SHIFTS_MIN >= 2 && GLINT_DIVIDER_SHIFTS_MIN <= GLINT_DIVIDER_SHIFTS_DEFAULT &&
        GLINT_DIVIDER_SHIFTS_DEFAULT <= GLINT_DIVIDER_SHIFTS_MAX,
    "GLINT_DIVIDER_SHIFTS_DEFAULT must be in GLINT_DIVIDER_SHIFTS_MIN...MAX, and the least "
    "2: the circuit shifts its bits");
GLINT_REQUIRE(GLINT_DIVIDER_DIFFERENCE_BITS + GLINT_DIVIDER_SHIFTS_MAX <= 32,
              "GLINT_DIVIDER_SHIFTS_MAX: a quotient is an int32_t");
GLINT_REQUIRE(GLINT_DIVIDER_K_BITS <= 8, "GLINT_DIVIDER_K_BITS must be 8 at most: k is a byte");
GLINT_REQUIRE(GLINT_DIVIDER_K_MAX >= 1 && GLINT_DIVIDER_K_MAX + 1 < 1 << GLINT_DIVIDER_K_BITS,
              "GLINT_DIVIDER_K_BITS must hold GLINT_DIVIDER_K_MAX, and some k beyond the table");

/* The bits i₀ i₁ … iₙ of the table for k as one number, iₙ the lowest: 2ⁿ/k rounded to nearest,
 * half up. 0 if k is 0 or past the end of the table. shifts: GLINT_DIVIDER_SHIFTS_MIN…MAX. */
uint32_t glint_divider_bits(int shifts, uint32_t k);

/* Whether k is in the table. */
bool glint_divider_in_table(uint32_t k);

/* Divides: *quotient is difference · glint_divider_bits(shifts, k), a code with `shifts` fraction
 * bits, S9.n. For k outside the table, *quotient is 0 and *out_of_table 1, as in the circuit.
 * GLINT_BAD_ARGUMENT for shifts, difference or k (more than its input's bits) out of range. */
glint_status glint_divide(int shifts, int32_t difference, uint32_t k, int32_t *quotient,
                          bool *out_of_table);

/* A division of three components by one length, the pipelined form's input. */
typedef struct glint_division {
    int16_t difference[GLINT_DIVIDER_COMPONENTS]; /* −255…255 */
    uint8_t k;
} glint_division;

typedef struct glint_quotients {
    int32_t code[GLINT_DIVIDER_COMPONENTS]; /* S9.n */
    bool out_of_table;
} glint_quotients;

/* Divides count times, bit-equal to glint_divide(). GLINT_BAD_ARGUMENT for shifts out of range
 * (differences are not checked). */
glint_status glint_divide_batch(int shifts, const glint_division *divisions, size_t count,
                                glint_quotients *quotients);

#ifdef __cplusplus
}
#endif

#endif
