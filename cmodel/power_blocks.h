/* The arithmetic of each block of the power device, one function a block. Private to cmodel/, as
 * blocks.h is, and with its rule of rounding. */
#ifndef GLINT_CMODEL_POWER_BLOCKS_H
#define GLINT_CMODEL_POWER_BLOCKS_H

#include "blocks.h"
#include "glint_power.h"

/* Register 1 as it is loaded: 1 − cos γ, within 0 and the code next below 1. */
static inline uint32_t glint_power_block_x(uint32_t cos_code)
{
    const uint32_t x = GLINT_COS_ONE - glint_block_saturate1(cos_code);
    return x < GLINT_COS_ONE ? x : GLINT_COS_ONE - 1u;
}

/* Multiplier 7: n·x. */
static inline uint32_t glint_power_block_mul7(uint32_t n, uint32_t x)
{
    return n * x;
}

/* Whether n·x needs more integer bits than L has. */
static inline uint32_t glint_power_block_over7(uint32_t mul7)
{
    return mul7 >> (GLINT_POWER_L_INT_BITS + GLINT_POWER_X_BITS) != 0;
}

/* The bits of n·x that multiplier 10 takes: U4.12, cut off. */
static inline uint32_t glint_power_block_q(uint32_t mul7)
{
    return mul7 >> (GLINT_POWER_X_BITS - GLINT_POWER_Q_FRAC_BITS) &
           ((1u << GLINT_POWER_Q_BITS) - 1u);
}

/* The address of ROM 9: the high bits of x. */
static inline uint32_t glint_power_block_address9(int table_bits, uint32_t x)
{
    return x >> (GLINT_POWER_X_BITS - table_bits);
}

/* Multiplier 10: v = q·g, rounded half up to the fraction bits of the table. */
static inline uint32_t glint_power_block_mul10(uint32_t q, uint32_t rom9)
{
    return GLINT_HALF_UP(uint32_t, q * rom9, GLINT_POWER_Q_FRAC_BITS);
}

/* Comparator 11: 1 where L is below 16. */
static inline uint32_t glint_power_block_cmp11(int table_bits, uint32_t over7, uint32_t mul10)
{
    return over7 == 0 && mul10 >> (GLINT_POWER_L_INT_BITS + table_bits) == 0;
}

/* The address of ROM 33: the fraction of v. */
static inline uint32_t glint_power_block_address33(int table_bits, uint32_t mul10)
{
    return mul10 & ((1u << table_bits) - 1u);
}

/* Key block 12: the power shifted by the integer part of L, or zero. */
static inline uint32_t glint_power_block_keys12(int table_bits, uint32_t cmp11, uint32_t rom33,
                                                uint32_t mul10)
{
    const uint32_t shift = mul10 >> table_bits & ((1u << GLINT_POWER_L_INT_BITS) - 1u);
    return cmp11 != 0 ? rom33 >> shift : 0u;
}

/* glint_unit.ws: power_batch.c. */
void glint_power_ws(int variant, uint32_t n, const uint32_t *cos_code, size_t count,
                    uint32_t *w_code);

_Static_assert(GLINT_POWER_P_BITS <= 32, "n x has 32 bits");
_Static_assert(GLINT_POWER_X_BITS > GLINT_POWER_Q_FRAC_BITS, "q is a part of n x");
_Static_assert(GLINT_POWER_X_BITS >= GLINT_POWER_TABLE_BITS(GLINT_POWER_QUARTER),
               "ROM 9 is addressed by x");
_Static_assert(GLINT_POWER_Q_BITS + GLINT_POWER_L_INT_BITS +
                       GLINT_POWER_TABLE_BITS(GLINT_POWER_QUARTER) <
                   32,
               "multiplier 10 has 32 bits");

#endif
