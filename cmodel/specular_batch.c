/* Long runs of points with one material: the blocks of blocks.h in loops that a compiler
 * vectorises.
 *
 * Where a point is outside the highlight, t is not needed: the gate, by its limit of the cosine,
 * throws it away. */
#include "blocks.h"
#include "glint_specular.h"
#include "multiversion.h"

/* What the points of one run have in common. */
typedef struct run {
    uint32_t sigma; /* ROM 33 */
    uint32_t limit; /* ROM 9 */
    uint8_t r, g, b;
} run;

/* W of one point, for gates that can be expressed as a cosine limit; inlined into the loops
 * below. */
static inline uint32_t shade_w(const run *run, uint32_t cos_code)
{
    uint32_t reg1 = glint_block_saturate1(cos_code);
    int32_t t = glint_block_adder8(glint_block_mul7_inside(run->sigma, glint_block_adder6(reg1)));
    uint32_t pass = glint_block_cmp11(GLINT_GATE_COSINE, run->limit, reg1, t, 0);
    return glint_block_keys12(pass, glint_block_square10((uint32_t)t));
}

GLINT_MULTIVERSION
static void shade_colors(const run *run, const uint32_t *restrict cos_code, size_t count,
                         uint8_t *restrict r, uint8_t *restrict g, uint8_t *restrict b)
{
    for (size_t i = 0; i < count; i++) {
        uint32_t w = shade_w(run, cos_code[i]);
        r[i] = glint_block_mul_color(w, run->r);
        g[i] = glint_block_mul_color(w, run->g);
        b[i] = glint_block_mul_color(w, run->b);
    }
}

GLINT_MULTIVERSION
static void shade_ws(const run *run, const uint32_t *restrict cos_code, size_t count,
                     uint32_t *restrict w_code)
{
    for (size_t i = 0; i < count; i++)
        w_code[i] = shade_w(run, cos_code[i]);
}

/* Gate drawn needs the integer digits of t and its square, inside and outside. */
static inline uint32_t shade_w_drawn(const run *run, uint32_t cos_code)
{
    int32_t adder6 = glint_block_adder6(glint_block_saturate1(cos_code));
    int32_t t = glint_block_adder8(glint_block_mul7(run->sigma, adder6));
    uint64_t square = glint_block_mul10_drawn(t);
    uint32_t pass = glint_block_cmp11(GLINT_GATE_DRAWN, run->limit, 0, t, square);
    return glint_block_keys12(pass, glint_block_sat10(GLINT_GATE_DRAWN, square));
}

static void shade_drawn(const run *run, const uint32_t *restrict cos_code, size_t count,
                        uint32_t *restrict w_code, uint8_t *restrict r, uint8_t *restrict g,
                        uint8_t *restrict b)
{
    for (size_t i = 0; i < count; i++) {
        uint32_t w = shade_w_drawn(run, cos_code[i]);
        if (w_code != NULL)
            w_code[i] = w;
        r[i] = glint_block_mul_color(w, run->r);
        g[i] = glint_block_mul_color(w, run->g);
        b[i] = glint_block_mul_color(w, run->b);
    }
}

glint_status glint_specular_batch(glint_gate gate, const glint_material *material,
                                  const uint32_t *restrict cos_code, size_t count,
                                  uint32_t *restrict w_code, uint8_t *restrict r,
                                  uint8_t *restrict g, uint8_t *restrict b)
{
    if ((unsigned)gate >= GLINT_GATE_COUNT || material->n > GLINT_N_MAX)
        return GLINT_BAD_ARGUMENT;
    /* Gate sign passes what gate cosine does: its ROM 9 holds the least cosine with t ≥ 0. */
    const glint_gate limiting = gate == GLINT_GATE_SIGN ? GLINT_GATE_COSINE : gate;
    const run run = {glint_rom33(material->n), glint_rom9(limiting, material->n), material->r,
                     material->g, material->b};
    if (gate == GLINT_GATE_DRAWN) {
        shade_drawn(&run, cos_code, count, w_code, r, g, b);
        return GLINT_OK;
    }
    shade_colors(&run, cos_code, count, r, g, b);
    if (w_code != NULL)
        shade_ws(&run, cos_code, count, w_code);
    return GLINT_OK;
}
