/* What the ROMs of the rivals hold. */
#include "rival_tables.h"

#include "glint_rivals.h"

uint32_t glint_newton_seed(uint32_t address)
{
    return newton_seeds[address & ((1u << GLINT_NEWTON_TABLE_BITS) - 1u)];
}

uint32_t glint_log2_base(uint32_t address)
{
    return log2_bases[address & ((1u << GLINT_LOG2_TABLE_BITS) - 1u)];
}

uint32_t glint_log2_slope(uint32_t address)
{
    return log2_slopes[address & ((1u << GLINT_LOG2_TABLE_BITS) - 1u)];
}

/* Of a variant's address bits. */
static uint32_t within(int variant, int low_bits, uint32_t address)
{
    return address & ((1u << (GLINT_BIPARTITE_A_BITS + variant + low_bits)) - 1u);
}

uint32_t glint_bipartite_value(int variant, uint32_t address)
{
    return bipartite_values[variant][within(variant, GLINT_BIPARTITE_B_BITS, address)];
}

uint32_t glint_bipartite_offset(int variant, uint32_t address)
{
    return bipartite_offsets[variant][within(variant, GLINT_BIPARTITE_C_BITS, address)];
}

uint32_t glint_quadratic_rom33(uint32_t n)
{
    return quadratic_as[n & GLINT_N_MAX];
}
