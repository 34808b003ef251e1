/* The single definition of every width, binary point, latency and limit of the specular device.
 *
 * C includes this file; the Verilog header rtl/glint_formats.vh is generated from it (glint-gen),
 * and a test fails when the two disagree. Formats are written U<i>.<f> (unsigned, i integer and f
 * fraction bits) or S<i>.<f> (two's complement; the first of the i integer bits is the sign).
 * docs/formats.md gives the reason for each number and explains how to change one.
 *
 * Four are chosen: the fraction bits of the cosine and of σ, the bits of n and of a colour. The
 * others follow from them; where a comment spells one out in digits, it assumes the current
 * choice. */
#ifndef GLINT_CMODEL_FORMATS_H
#define GLINT_CMODEL_FORMATS_H

/* A condition between numbers, and what to do if it fails. */
#ifdef __cplusplus
#define GLINT_REQUIRE(condition, text) static_assert(condition, text)
#else
#define GLINT_REQUIRE(condition, text) _Static_assert(condition, text)
#endif

/* Register 1: cos γ, U1.18. Codes above 1.0 saturate to 1.0 as they enter the register. */
#define GLINT_COS_FRAC_BITS 18
#define GLINT_COS_BITS      (1 + GLINT_COS_FRAC_BITS)
#define GLINT_COS_ONE       (1u << GLINT_COS_FRAC_BITS)
#define GLINT_COS_CODE_MAX  ((1u << GLINT_COS_BITS) - 1u)

/* Register 2: the exponent n, an integer 0…1023. */
#define GLINT_N_BITS  10
#define GLINT_N_COUNT (1u << GLINT_N_BITS)
#define GLINT_N_MAX   (GLINT_N_COUNT - 1u)

/* ROM 33: σ = (n+1)/3, U9.13: a third of 2^10 is below 2^9. */
#define GLINT_SIGMA_INT_BITS  (GLINT_N_BITS - 1)
#define GLINT_SIGMA_FRAC_BITS 13
#define GLINT_SIGMA_BITS      (GLINT_SIGMA_INT_BITS + GLINT_SIGMA_FRAC_BITS)

/* Adder 6: cos γ − 1, S1.18. */
#define GLINT_ADDER6_BITS (1 + GLINT_COS_FRAC_BITS)

/* Multiplier 7 and adder 8: σ(cos γ − 1), rounded half up, and t, both S10.18. The multiplier drops
 * as many fraction bits as σ has. */
#define GLINT_T_INT_BITS  (1 + GLINT_SIGMA_INT_BITS)
#define GLINT_T_FRAC_BITS GLINT_COS_FRAC_BITS
#define GLINT_T_BITS      (GLINT_T_INT_BITS + GLINT_T_FRAC_BITS)

/* Multiplier 10, key block 12: W = t², rounded half up, U1.18 for the gates `cosine` and `sign`: it
 * drops as many fraction bits as t has. For the gate `drawn` the square keeps its integer bits,
 * U17.18, and saturates to 1.0 afterwards: t² is below 2^20/9. */
#define GLINT_W_FRAC_BITS      GLINT_T_FRAC_BITS
#define GLINT_W_BITS           (1 + GLINT_W_FRAC_BITS)
#define GLINT_W_ONE            (1u << GLINT_W_FRAC_BITS)
#define GLINT_W_DRAWN_INT_BITS (2 * GLINT_N_BITS - 3)
#define GLINT_W_DRAWN_BITS     (GLINT_W_DRAWN_INT_BITS + GLINT_W_FRAC_BITS)

/* Registers 3, 4, 5 and multipliers 13, 14, 15: one colour component, U8.0, rounded half up. */
#define GLINT_COLOR_BITS 8
#define GLINT_COLOR_MAX  ((1u << GLINT_COLOR_BITS) - 1u)

/* The constant of ROM 9 with gate `drawn`: half of one 8-bit step of W, 2^18 / (2·255), rounded. */
#define GLINT_DRAWN_LIMIT ((GLINT_W_ONE + GLINT_COLOR_MAX) / (2u * GLINT_COLOR_MAX))

/* Clocks from the edge that loads registers 1–5 to a valid output, that edge included. */
#define GLINT_LATENCY_COMBINATIONAL 1
#define GLINT_LATENCY_PIPELINED     4

/* Cosines per clock, all with one material. */
#define GLINT_LANES_MAX 32

/* Derived numbers, which must not be defined independently. */
GLINT_REQUIRE(
    GLINT_T_FRAC_BITS == GLINT_COS_FRAC_BITS,
    "GLINT_T_FRAC_BITS must be GLINT_COS_FRAC_BITS: multiplier 7 drops the bits of sigma");
GLINT_REQUIRE(GLINT_W_FRAC_BITS == GLINT_T_FRAC_BITS,
              "GLINT_W_FRAC_BITS must be GLINT_T_FRAC_BITS: multiplier 10 drops the bits of t");
GLINT_REQUIRE(GLINT_W_BITS == GLINT_COS_BITS,
              "GLINT_W_BITS must be GLINT_COS_BITS: ROM 9 holds a cosine or, gate drawn, a W");
GLINT_REQUIRE(GLINT_N_COUNT / 3u < 1u << GLINT_SIGMA_INT_BITS,
              "GLINT_SIGMA_INT_BITS must hold (GLINT_N_MAX + 1) / 3");
GLINT_REQUIRE(GLINT_T_INT_BITS == 1 + GLINT_SIGMA_INT_BITS,
              "GLINT_T_INT_BITS must be a sign and GLINT_SIGMA_INT_BITS");
GLINT_REQUIRE((GLINT_N_COUNT / 3u) * (GLINT_N_COUNT / 3u) >> GLINT_W_DRAWN_INT_BITS == 0,
              "GLINT_W_DRAWN_INT_BITS must hold the square of (GLINT_N_MAX + 1) / 3");

/* Limits set by the C types that hold them; cmodel/blocks.h has those of the arithmetic. */
GLINT_REQUIRE(GLINT_COS_FRAC_BITS >= 10 && GLINT_COS_FRAC_BITS <= 20,
              "GLINT_COS_FRAC_BITS must be 10 to 20: above, glint_block_mul10() needs more than 32 "
              "bits; below, the codes 1000 above 1.0 that waveforms show are none");
GLINT_REQUIRE(GLINT_SIGMA_FRAC_BITS >= 2 && GLINT_N_BITS + GLINT_SIGMA_FRAC_BITS <= 30,
              "GLINT_SIGMA_FRAC_BITS must be 2 or more, and with GLINT_N_BITS 30 at most: "
              "glint_rom33() works in 32 bits");
GLINT_REQUIRE(GLINT_N_BITS >= 9 && GLINT_N_BITS <= 12,
              "GLINT_N_BITS must be 9 to 12: n is a port of two bytes, t an int32_t");
GLINT_REQUIRE(GLINT_COLOR_BITS == 8, "GLINT_COLOR_BITS must be 8: a colour is a byte everywhere");

#endif
