/* What the two ROMs hold, computed from the formula. The Verilog ROMs are generated from here. */
#include "blocks.h"
#include "glint_specular.h"

uint32_t glint_rom33(uint32_t n)
{
    uint32_t numerator = ((n & GLINT_N_MAX) + 1u) << GLINT_SIGMA_FRAC_BITS;
    /* The fraction of a third is never a half, so rounding half up needs no tie rule here. */
    return (2u * numerator + 3u) / 6u;
}

/* t ≥ 0 as the device itself computes it. */
static int glint_t_is_positive(uint32_t sigma, uint32_t cos_code)
{
    return glint_block_adder8(glint_block_mul7(sigma, glint_block_adder6(cos_code))) >= 0;
}

/* t never falls as the cosine grows, so the limit is found by halving the interval. */
static uint32_t glint_cosine_limit(uint32_t sigma)
{
    uint32_t low = 0, high = GLINT_COS_ONE; /* t ≥ 0 at high; the limit is in low…high */
    while (low < high) {
        uint32_t middle = (low + high) / 2u;
        if (glint_t_is_positive(sigma, middle))
            high = middle;
        else
            low = middle + 1u;
    }
    return high;
}

uint32_t glint_rom9(glint_gate gate, uint32_t n)
{
    switch (gate) {
    case GLINT_GATE_COSINE:
        return glint_cosine_limit(glint_rom33(n));
    case GLINT_GATE_DRAWN:
        return GLINT_DRAWN_LIMIT;
    default:
        return 0;
    }
}
