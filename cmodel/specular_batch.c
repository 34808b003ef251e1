/* Long runs of points with one material, in 32-bit arithmetic that a compiler can vectorise.
 *
 * Where a point is inside the highlight, t lies in 0…1, so the product σ(1 − cos γ) is at most 1
 * and a rounding step: with 31 fraction bits it fits 32 bits. Outside, the product may wrap; the
 * gate throws it away. The square of the 19-bit t is put together from two halves of 9 bits. */
#include "blocks.h"
#include "glint_specular.h"
#include "multiversion.h"

/* Half a unit in the last place of t, in units of the product of multiplier 7. */
#define HALF7 (1u << (GLINT_SIGMA_FRAC_BITS - 1))

/* What the points of one run have in common. */
typedef struct run {
    uint32_t sigma; /* ROM 33 */
    uint32_t limit; /* the smallest cosine that the gate passes */
    uint32_t r, g, b;
} run;

/* W, U1.18, of one point; inlined into the loops below. */
static inline uint32_t shade_w(const run *run, uint32_t cos_code)
{
    const uint32_t half_bits = GLINT_T_FRAC_BITS / 2;
    uint32_t cosine = glint_block_saturate1(cos_code);
    uint32_t product = run->sigma * (GLINT_COS_ONE - cosine);
    /* Half up of the negative number −product is half down of product. */
    uint32_t t = (1u << GLINT_T_FRAC_BITS) - ((product + HALF7 - 1u) >> GLINT_SIGMA_FRAC_BITS);
    uint32_t high = t >> half_bits;
    uint32_t low = t & ((1u << half_bits) - 1u);
    uint32_t cross = (high * low) << (half_bits + 1);
    uint32_t square = high * high + ((cross + low * low + (GLINT_W_ONE >> 1)) >> GLINT_W_FRAC_BITS);
    return cosine >= run->limit ? square : 0u;
}

static inline uint8_t shade_color(uint32_t w, uint32_t color)
{
    return (uint8_t)((w * color + (GLINT_W_ONE >> 1)) >> GLINT_W_FRAC_BITS);
}

GLINT_MULTIVERSION
static void shade_colors(const run *run, const uint32_t *restrict cos_code, size_t count,
                         uint8_t *restrict r, uint8_t *restrict g, uint8_t *restrict b)
{
    for (size_t i = 0; i < count; i++) {
        uint32_t w = shade_w(run, cos_code[i]);
        r[i] = shade_color(w, run->r);
        g[i] = shade_color(w, run->g);
        b[i] = shade_color(w, run->b);
    }
}

GLINT_MULTIVERSION
static void shade_ws(const run *run, const uint32_t *restrict cos_code, size_t count,
                     uint32_t *restrict w_code)
{
    for (size_t i = 0; i < count; i++)
        w_code[i] = shade_w(run, cos_code[i]);
}

/* Gate drawn needs the integer digits of the square, so it goes block by block. */
static void shade_drawn(const run *run, const uint32_t *restrict cos_code, size_t count,
                        uint32_t *restrict w_code, uint8_t *restrict r, uint8_t *restrict g,
                        uint8_t *restrict b)
{
    for (size_t i = 0; i < count; i++) {
        int32_t adder6 = glint_block_adder6(glint_block_saturate1(cos_code[i]));
        int32_t t = glint_block_adder8(glint_block_mul7(run->sigma, adder6));
        uint64_t square = glint_block_mul10_drawn(t);
        uint32_t w = square >= run->limit ? glint_block_sat10(GLINT_GATE_DRAWN, square) : 0u;
        if (w_code != NULL)
            w_code[i] = w;
        r[i] = shade_color(w, run->r);
        g[i] = shade_color(w, run->g);
        b[i] = shade_color(w, run->b);
    }
}

/* t ≥ 0 as long as the rounded product is at most 1.0: the largest such 1 − cos γ, by division. */
static uint32_t sign_limit(uint32_t sigma)
{
    uint32_t one = 1u << (GLINT_COS_FRAC_BITS + GLINT_SIGMA_FRAC_BITS);
    uint32_t widest = (one + HALF7) / sigma;
    return widest >= GLINT_COS_ONE ? 0u : GLINT_COS_ONE - widest;
}

glint_status glint_specular_batch(glint_gate gate, const glint_material *material,
                                  const uint32_t *restrict cos_code, size_t count,
                                  uint32_t *restrict w_code, uint8_t *restrict r,
                                  uint8_t *restrict g, uint8_t *restrict b)
{
    if ((unsigned)gate >= GLINT_GATE_COUNT || material->n > GLINT_N_MAX)
        return GLINT_BAD_ARGUMENT;
    run run = {glint_rom33(material->n), glint_rom9(gate, material->n), material->r, material->g,
               material->b};
    if (gate == GLINT_GATE_DRAWN) {
        shade_drawn(&run, cos_code, count, w_code, r, g, b);
        return GLINT_OK;
    }
    if (gate == GLINT_GATE_SIGN)
        run.limit = sign_limit(run.sigma);
    shade_colors(&run, cos_code, count, r, g, b);
    if (w_code != NULL)
        shade_ws(&run, cos_code, count, w_code);
    return GLINT_OK;
}
