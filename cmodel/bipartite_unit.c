/* cosⁿ of a fixed n by a bipartite table: how its lane makes W, for unit.c. */
#include "blocks.h"
#include "glint_power.h"
#include "glint_rivals.h"
#include "unit_rows.h"

enum {
    CF = GLINT_COS_FRAC_BITS,
    FRAC = GLINT_BIPARTITE_FRAC_BITS,
    B = GLINT_BIPARTITE_B_BITS,
    C = GLINT_BIPARTITE_C_BITS,
    OFFSET = GLINT_BIPARTITE_OFFSET_BITS,
};

#define SIGNALS(X)                                                                                 \
    X(reg1, 1, REGISTER, 1, CF, "cos gamma, saturated to 1")                                       \
    X(rom9, 9, BLOCK, 0, FRAC, "the value where the interval begins")                              \
    X(rom33, 33, BLOCK, OFFSET, 0, "how much is added within it, last places")                     \
    X(cmp11, 11, BLOCK, 1, 0, "the cosine is 1")                                                   \
    X(s2_rom9, 9, STAGE, 0, FRAC, "the value, stage 2")                                            \
    X(s2_rom33, 33, STAGE, OFFSET, 0, "what is added, stage 2")                                    \
    X(s2_cmp11, 11, STAGE, 1, 0, "the cosine is 1, stage 2")                                       \
    X(adder8, 8, BLOCK, 1, FRAC, "the sum")

GLINT_UNIT_LANE(lane, SIGNALS)

static glint_signal_info row(int variant, int index)
{
    (void)variant;
    return rows[index];
}

static int stages(int variant)
{
    (void)variant;
    return 3;
}

static int n_stages(int variant)
{
    (void)variant;
    return 1;
}

static int w_frac_bits(int variant)
{
    (void)variant;
    return FRAC;
}

static uint32_t fixed_n(int variant)
{
    return GLINT_BIPARTITE_N(variant);
}

static void load(int variant, void *of, uint32_t cos_code)
{
    (void)variant;
    ((lane *)of)->reg1 = glint_block_saturate1(cos_code);
}

static void pass(int variant, int stage, void *of)
{
    lane *s = of;
    (void)variant;
    (void)stage;
    s->s2_rom9 = s->rom9;
    s->s2_rom33 = s->rom33;
    s->s2_cmp11 = s->cmp11;
}

/* The first a + b + c bits of the fraction; both tables leave one of the parts away. */
static void look_up(int variant, lane *s)
{
    const int bits = GLINT_BIPARTITE_A_BITS + variant + B + C;
    const uint32_t fraction = (uint32_t)s->reg1 & (GLINT_COS_ONE - 1u);
    const uint32_t abc = fraction >> (CF - bits),
                   ac = abc >> (B + C) << C | (abc & ((1u << C) - 1));
    s->rom9 = glint_bipartite_value(variant, abc >> C);
    s->rom33 = glint_bipartite_offset(variant, ac);
    s->cmp11 = s->reg1 >> CF;
}

static void settle(int variant, int stage, uint32_t n, void *of)
{
    lane *s = of;
    (void)n;
    if (stage == 1) {
        look_up(variant, s);
        return;
    }
    s->adder8 = s->s2_rom9 + s->s2_rom33;
    s->end.keys12 = s->s2_cmp11 ? 1 << FRAC : s->adder8;
}

GLINT_UNIT_WS(lane)

static double real(int variant, uint32_t n, uint32_t cos_code)
{
    (void)n;
    return glint_power_real(fixed_n(variant), cos_code);
}

const glint_unit glint_unit_bipartite = {
    .variants = GLINT_BIPARTITE_VARIANTS,
    .stages = stages,
    .n_stages = n_stages,
    .w_frac_bits = w_frac_bits,
    .lane_size = sizeof(lane),
    .load = load,
    .pass = pass,
    .settle = settle,
    .ws = ws,
    .row_count = row_count,
    .row = row,
    .real = real,
    .fixed_n = fixed_n,
};
