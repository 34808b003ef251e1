/* The one definition of every width, binary point, latency and limit of the specular device.
 *
 * C includes this file; the Verilog header rtl/glint_formats.vh is generated from it (glint-gen),
 * and a test fails when the two disagree. Formats are written U<i>.<f> (unsigned, i integer and f
 * fraction bits) or S<i>.<f> (two's complement; the first of the i integer bits is the sign).
 * docs/formats.md gives the reason for each number. */
#ifndef GLINT_FORMATS_H
#define GLINT_FORMATS_H

/* Register 1: cos γ, U1.18. Codes above 1.0 saturate to 1.0 as they enter the register. */
#define GLINT_COS_FRAC_BITS 18
#define GLINT_COS_BITS      (1 + GLINT_COS_FRAC_BITS)
#define GLINT_COS_ONE       (1u << GLINT_COS_FRAC_BITS)
#define GLINT_COS_CODE_MAX  ((1u << GLINT_COS_BITS) - 1u)

/* Register 2: the exponent n, an integer 0…1023. */
#define GLINT_N_BITS  10
#define GLINT_N_COUNT (1u << GLINT_N_BITS)
#define GLINT_N_MAX   (GLINT_N_COUNT - 1u)

/* ROM 33: σ = (n+1)/3, U9.13. */
#define GLINT_SIGMA_INT_BITS  9
#define GLINT_SIGMA_FRAC_BITS 13
#define GLINT_SIGMA_BITS      (GLINT_SIGMA_INT_BITS + GLINT_SIGMA_FRAC_BITS)

/* Adder 6: cos γ − 1, S1.18. */
#define GLINT_ADDER6_BITS (1 + GLINT_COS_FRAC_BITS)

/* Multiplier 7 and adder 8: σ(cos γ − 1), rounded half up, and t, both S10.18. */
#define GLINT_T_INT_BITS  10
#define GLINT_T_FRAC_BITS 18
#define GLINT_T_BITS      (GLINT_T_INT_BITS + GLINT_T_FRAC_BITS)

/* Multiplier 10, key block 12: W = t², rounded half up, U1.18 for the gates `cosine` and `sign`.
 * For the gate `drawn` the square keeps its integer bits, U17.18, and saturates to 1.0 after. */
#define GLINT_W_FRAC_BITS      18
#define GLINT_W_BITS           (1 + GLINT_W_FRAC_BITS)
#define GLINT_W_ONE            (1u << GLINT_W_FRAC_BITS)
#define GLINT_W_DRAWN_INT_BITS 17
#define GLINT_W_DRAWN_BITS     (GLINT_W_DRAWN_INT_BITS + GLINT_W_FRAC_BITS)

/* Registers 3, 4, 5 and multipliers 13, 14, 15: one colour component, U8.0, rounded half up. */
#define GLINT_COLOR_BITS 8
#define GLINT_COLOR_MAX  255u

/* The constant of ROM 9 with gate `drawn`: half of one 8-bit step of W, 2^18 / (2·255), rounded. */
#define GLINT_DRAWN_LIMIT ((GLINT_W_ONE + GLINT_COLOR_MAX) / (2u * GLINT_COLOR_MAX))

/* Clocks from the edge that loads registers 1–5 to a valid output, that edge included. */
#define GLINT_LATENCY_COMBINATIONAL 1
#define GLINT_LATENCY_PIPELINED     4

/* Cosines a clock with one material. */
#define GLINT_LANES_MAX 32

#endif
