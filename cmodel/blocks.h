/* The arithmetic of each block of figure 3.1, one function a block, named by the block's number.
 *
 * Private to cmodel/. The pure function, the clocked device and the ROM generator are all made of
 * these, so a block's rounding is stated here and nowhere else. Formats: glint_formats.h. */
#ifndef GLINT_CMODEL_BLOCKS_H
#define GLINT_CMODEL_BLOCKS_H

#include <stdint.h>

#include "glint_formats.h"
#include "glint_specular.h"

/* The one rule by which bits are dropped, half up: half a unit of the last place that is kept is
 * added, and what is below that place cut off. value is taken as `type`, which must hold it and
 * half a unit; where it is signed, it may come in its unsigned counterpart. */
#define GLINT_HALF_UP(type, value, dropped)                                                        \
    ((type)((value) + ((type)1 << ((dropped)-1))) >> (dropped))

/* Register 1 as it is loaded: a code above 1.0 saturates to 1.0. */
static inline uint32_t glint_block_saturate1(uint32_t cos_code)
{
    return cos_code > GLINT_COS_ONE ? GLINT_COS_ONE : cos_code;
}

/* Adder 6: cos γ − 1. In the circuit the integer digit of cos γ plus all ones, carry-in 0, with the
 * fraction passed beside it; the digit that results is the sign, of weight −1. */
static inline int32_t glint_block_adder6(uint32_t reg1)
{
    return (int32_t)reg1 - (int32_t)GLINT_COS_ONE;
}

/* Multiplier 7: σ(cos γ − 1), the exact product rounded half up to the fraction bits of t. */
#define GLINT_ROUND7(type, product) ((int32_t)GLINT_HALF_UP(type, product, GLINT_SIGMA_FRAC_BITS))

static inline int32_t glint_block_mul7(uint32_t rom33, int32_t adder6)
{
    return GLINT_ROUND7(int64_t, (int64_t)rom33 * adder6);
}

/* The same where t ≥ 0; elsewhere the result means nothing. There the product with its half is in
 * −1.0 to 1.0, so that for most widths 32 bits hold it: for loops that a compiler vectorises. */
static inline int32_t glint_block_mul7_inside(uint32_t rom33, int32_t adder6)
{
#if GLINT_COS_FRAC_BITS + GLINT_SIGMA_FRAC_BITS < 32
    return GLINT_ROUND7(int32_t, rom33 * (uint32_t)adder6);
#else
    return glint_block_mul7(rom33, adder6);
#endif
}

/* Adder 8: second operand 0, carry-in 1 at the integer digits; the fraction passes beside it. */
static inline int32_t glint_block_adder8(int32_t mul7)
{
    return mul7 + (1 << GLINT_T_FRAC_BITS);
}

/* t², rounded half up to the fraction bits of W, for a t of no more bits than W has.
 *
 * In 32 bits: with t = high·2^s + low, t² is (t·high)·2^s + t·low. The rounding looks at no bit
 * below its half, so the s lowest of the square may go before it. */
#define GLINT_SPLIT10 ((GLINT_W_BITS + 1) / 2)

static inline uint32_t glint_block_square10(uint32_t t)
{
    uint32_t high = t >> GLINT_SPLIT10;
    uint32_t low = t & ((1u << GLINT_SPLIT10) - 1u);
    uint32_t square = t * high + (t * low >> GLINT_SPLIT10);
    return GLINT_HALF_UP(uint32_t, square, GLINT_W_FRAC_BITS - GLINT_SPLIT10);
}

/* Multiplier 10 for gates cosine and sign: the low bits of t, as many as W has, squared, and as
 * many bits of that. Where the gate passes, t is in 0…1 and nothing is cut off. */
static inline uint32_t glint_block_mul10(int32_t adder8)
{
    const uint32_t kept = (1u << GLINT_W_BITS) - 1u;
    return glint_block_square10((uint32_t)adder8 & kept) & kept;
}

/* Multiplier 10 for gate drawn: all of t squared, wide enough to tell a W above 1. */
static inline uint64_t glint_block_mul10_drawn(int32_t adder8)
{
    return GLINT_HALF_UP(uint64_t, (uint64_t)((int64_t)adder8 * adder8), GLINT_W_FRAC_BITS);
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

/* Multipliers 13, 14, 15: W times one colour component, rounded half up to the bits of a colour. */
static inline uint8_t glint_block_mul_color(uint32_t keys12, uint8_t color)
{
    return (uint8_t)GLINT_HALF_UP(uint32_t, keys12 * color, GLINT_W_FRAC_BITS);
}

/* What the arithmetic above has room for. */
_Static_assert(GLINT_SIGMA_BITS + GLINT_COS_BITS < 64, "multiplier 7 has 64 bits");
_Static_assert(GLINT_T_BITS <= 32, "t is an int32_t");
_Static_assert(GLINT_W_DRAWN_BITS + GLINT_W_FRAC_BITS < 64, "the square of gate drawn has 64 bits");
_Static_assert(2 * GLINT_W_BITS - GLINT_SPLIT10 < 32 && GLINT_W_BITS + GLINT_SPLIT10 <= 32,
               "multiplier 10 puts the square together in 32 bits");
_Static_assert(GLINT_SPLIT10 < GLINT_W_FRAC_BITS,
               "multiplier 10 may drop no bit that its rounding looks at");
_Static_assert(GLINT_W_FRAC_BITS + GLINT_COLOR_BITS < 32, "multipliers 13 to 15 have 32 bits");

#endif
