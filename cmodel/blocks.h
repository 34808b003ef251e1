/* The arithmetic of each block of figure 3.1, one function a block, named by the block's number.
 *
 * Private to cmodel/. The pure function, the clocked device and the ROM generator are all made of
 * these, so a block's rounding is stated here and nowhere else. Formats: glint_formats.h. */
#ifndef GLINT_BLOCKS_H
#define GLINT_BLOCKS_H

#include <stdint.h>

#include "glint_formats.h"
#include "glint_specular.h"

/* Register 1 as it is loaded: a code above 1.0 saturates to 1.0. */
static inline uint32_t glint_block_saturate1(uint32_t cos_code)
{
    return cos_code > GLINT_COS_ONE ? GLINT_COS_ONE : cos_code;
}

/* Adder 6: the integer digit of cos γ plus all ones, carry-in 0; the fraction passes beside it. The
 * digit that results is the sign: its weight is −1. */
static inline int32_t glint_block_adder6(uint32_t reg1)
{
    uint32_t digit = ((reg1 >> GLINT_COS_FRAC_BITS) + 1u) & 1u;
    uint32_t fraction = reg1 & (GLINT_COS_ONE - 1u);
    return (int32_t)fraction - (int32_t)(digit << GLINT_COS_FRAC_BITS);
}

/* Multiplier 7: σ(cos γ − 1), the exact product rounded half up to 18 fraction bits. */
static inline int32_t glint_block_mul7(uint32_t rom33, int32_t adder6)
{
    int64_t product = (int64_t)rom33 * adder6;
    int64_t half = INT64_C(1) << (GLINT_SIGMA_FRAC_BITS - 1);
    return (int32_t)((product + half) >> GLINT_SIGMA_FRAC_BITS);
}

/* Adder 8: second operand 0, carry-in 1 at the integer digits; the fraction passes beside it. */
static inline int32_t glint_block_adder8(int32_t mul7)
{
    return mul7 + (1 << GLINT_T_FRAC_BITS);
}

/* Multiplier 10 for gates cosine and sign: the 19 low bits of t squared, rounded half up to
 * 18 fraction bits. Where the gate passes, t is in 0…1 and these bits are all of it. */
static inline uint32_t glint_block_mul10(int32_t adder8)
{
    uint64_t t = (uint32_t)adder8 & ((1u << GLINT_W_BITS) - 1u);
    uint64_t half = UINT64_C(1) << (GLINT_W_FRAC_BITS - 1);
    return (uint32_t)((t * t + half) >> GLINT_W_FRAC_BITS) & ((1u << GLINT_W_BITS) - 1u);
}

/* Multiplier 10 for gate drawn: all of t squared, wide enough to tell a W above 1. */
static inline uint64_t glint_block_mul10_drawn(int32_t adder8)
{
    int64_t t = adder8;
    int64_t half = INT64_C(1) << (GLINT_W_FRAC_BITS - 1);
    return (uint64_t)((t * t + half) >> GLINT_W_FRAC_BITS);
}

/* Multiplier 10 as the gate has it. */
static inline uint64_t glint_block_mul10_gated(glint_gate gate, int32_t adder8)
{
    return gate == GLINT_GATE_DRAWN ? glint_block_mul10_drawn(adder8) : glint_block_mul10(adder8);
}

/* The saturation behind multiplier 10, gate drawn only: at most 1.0. */
static inline uint32_t glint_block_sat10(glint_gate gate, uint64_t mul10)
{
    return gate == GLINT_GATE_DRAWN && mul10 > GLINT_W_ONE ? GLINT_W_ONE : (uint32_t)mul10;
}

/* Comparator 11: 1 where the key block is to pass the square. */
static inline uint32_t glint_block_cmp11(glint_gate gate, uint32_t rom9, uint32_t reg1,
                                         int32_t adder8, uint64_t mul10)
{
    switch (gate) {
    case GLINT_GATE_SIGN:
        return adder8 >= 0;
    case GLINT_GATE_DRAWN:
        return mul10 >= rom9;
    default:
        return reg1 >= rom9;
    }
}

/* Key block 12: the square where comparator 11 passes it, else zero. */
static inline uint32_t glint_block_keys12(uint32_t cmp11, uint32_t sat10)
{
    return cmp11 != 0 ? sat10 : 0u;
}

/* Multipliers 13, 14, 15: W times one colour component, rounded half up to 8 bits. */
static inline uint8_t glint_block_mul_color(uint32_t keys12, uint8_t color)
{
    return (uint8_t)((keys12 * color + (GLINT_W_ONE >> 1)) >> GLINT_W_FRAC_BITS);
}

#endif
