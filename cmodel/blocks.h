/* The arithmetic of each block of figure 3.1, one function per block, named after the block's
 * number.
 *
 * Private to cmodel/. The pure function, the clocked device and the ROM generator are all built
 * from these, so a block's rounding is defined here and nowhere else. Formats: glint_formats.h. */
#ifndef GLINT_CMODEL_BLOCKS_H
#define GLINT_CMODEL_BLOCKS_H

#include <stdint.h>

#include "glint_formats.h"
#include "glint_specular.h"

/* The only rounding rule, half up: add half a unit in the last place kept, then truncate. value is
 * treated as `type`, which must hold it plus half a unit; a signed value may be passed as its
 * unsigned counterpart. */
#define GLINT_HALF_UP(type, value, dropped)                                                        \
    ((type)((value) + ((type)1 << ((dropped)-1))) >> (dropped))

/* Register 1 on loading: a code above 1.0 saturates to 1.0. */
static inline uint32_t glint_block_saturate1(uint32_t cos_code)
{
    return cos_code > GLINT_COS_ONE ? GLINT_COS_ONE : cos_code;
}

/* Adder 6: cos γ − 1. In the circuit the integer digit of cos γ plus all ones, carry-in 0, with the
 * fraction passed beside it; the resulting digit is the sign, of weight −1. */
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

/* The same for t ≥ 0; otherwise the result is meaningless. For t ≥ 0 the product plus its half lies
 * within −1.0 to 1.0, so 32 bits hold it for most widths, which lets a compiler vectorise the
 * loop. */
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

/* t², rounded half up to the fraction bits of W, for a t with no more bits than W.
 *
 * In 32 bits: with t = high·2^s + low, t² is (t·high)·2^s + t·low. The rounding depends on no bit
 * below its half, so the lowest s bits of the square can be dropped first. */
#define GLINT_SPLIT10 ((GLINT_W_BITS + 1) / 2)

static inline uint32_t glint_block_square10(uint32_t t)
{
    uint32_t high = t >> GLINT_SPLIT10;
    uint32_t low = t & ((1u << GLINT_SPLIT10) - 1u);
    uint32_t square = t * high + (t * low >> GLINT_SPLIT10);
    return GLINT_HALF_UP(uint32_t, square, GLINT_W_FRAC_BITS - GLINT_SPLIT10);
}

/* Multiplier 10 for gates cosine and sign: squares the low bits of t, as many as W has, and keeps
 * as many bits of the result. Where the gate passes, t is within 0…1 and nothing is lost. */
static inline uint32_t glint_block_mul10(int32_t adder8)
{
    const uint32_t kept = (1u << GLINT_W_BITS) - 1u;
    return glint_block_square10((uint32_t)adder8 & kept) & kept;
}

/* Multiplier 10 for gate drawn: squares all of t, wide enough to represent W above 1. */
static inline uint64_t glint_block_mul10_drawn(int32_t adder8)
{
    return GLINT_HALF_UP(uint64_t, (uint64_t)((int64_t)adder8 * adder8), GLINT_W_FRAC_BITS);
}

/* Multiplier 10 for the given gate. */
static inline uint64_t glint_block_mul10_gated(glint_gate gate, int32_t adder8)
{
    return gate == GLINT_GATE_DRAWN ? glint_block_mul10_drawn(adder8) : glint_block_mul10(adder8);
}

/* The saturation to 1.0 after multiplier 10, gate drawn only. */
static inline uint32_t glint_block_sat10(glint_gate gate, uint64_t mul10)
{
    return gate == GLINT_GATE_DRAWN && mul10 > GLINT_W_ONE ? GLINT_W_ONE : (uint32_t)mul10;
}

/* Comparator 11: 1 if the key block should pass the square. */
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

/* Key block 12: the square if comparator 11 passes it, else zero. */
static inline uint32_t glint_block_keys12(uint32_t cmp11, uint32_t sat10)
{
    return cmp11 != 0 ? sat10 : 0u;
}

/* Multipliers 13, 14, 15: W times one colour component, rounded half up to the bits of a colour. */
static inline uint8_t glint_block_mul_color(uint32_t keys12, uint8_t color)
{
    return (uint8_t)GLINT_HALF_UP(uint32_t, keys12 * color, GLINT_W_FRAC_BITS);
}

/* The same for a W of other fraction bits, of a highlight unit. */
static inline uint8_t glint_block_mul_by(int w_frac_bits, uint32_t keys12, uint8_t color)
{
    return (uint8_t)GLINT_HALF_UP(uint32_t, keys12 * color, w_frac_bits);
}

/* W with its last `dropped` places rounded off, half up; 0: as it is. */
static inline uint32_t glint_block_round_w(int dropped, uint32_t keys12)
{
    return (keys12 + (1u << dropped >> 1)) >> dropped;
}

/* The widths that the arithmetic above relies on. */
_Static_assert(GLINT_SIGMA_BITS + GLINT_COS_BITS < 64, "multiplier 7 has 64 bits");
_Static_assert(GLINT_T_BITS <= 32, "t is an int32_t");
_Static_assert(GLINT_W_DRAWN_BITS + GLINT_W_FRAC_BITS < 64, "the square of gate drawn has 64 bits");
_Static_assert(2 * GLINT_W_BITS - GLINT_SPLIT10 < 32 && GLINT_W_BITS + GLINT_SPLIT10 <= 32,
               "multiplier 10 puts the square together in 32 bits");
_Static_assert(GLINT_SPLIT10 < GLINT_W_FRAC_BITS,
               "multiplier 10 may drop no bit that its rounding looks at");
_Static_assert(GLINT_W_FRAC_BITS + GLINT_COLOR_BITS < 32, "multipliers 13 to 15 have 32 bits");

#endif
