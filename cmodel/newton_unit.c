/* Schlick's function by a reciprocal and a step of Newton's: how its lane makes W, for unit.c. */
#include "blocks.h"
#include "glint_rivals.h"
#include "unit_rows.h"

enum {
    FRAC = GLINT_NEWTON_FRAC_BITS,
    CF = GLINT_COS_FRAC_BITS,
    DEN = GLINT_N_BITS + CF, /* bits of the denominator, U10.18 */
    SEED = GLINT_NEWTON_SEED_BITS,
    M = GLINT_NEWTON_M_BITS,
    LEAD_BITS = 5,
    PRODUCT_FRAC = CF + M, /* of cos γ times the reciprocal of m */
    /* den is m·2^(GLINT_N_BITS − 1 − lead). */
    SHIFT = PRODUCT_FRAC + GLINT_N_BITS - 1 - FRAC,
};

#define SIGNALS(X)                                                                                 \
    X(reg1, 1, REGISTER, 1, CF, "cos gamma, saturated to 1")                                       \
    X(mul7, 7, BLOCK, GLINT_N_BITS, CF, "n (1 - cos gamma)")                                       \
    X(s2_reg1, 1, STAGE, 1, CF, "cos gamma, stage 2")                                              \
    X(s2_mul7, 7, STAGE, GLINT_N_BITS, CF, "n (1 - cos gamma), stage 2")                           \
    X(adder8, 8, BLOCK, GLINT_N_BITS, CF, "the denominator")                                       \
    X(s3_reg1, 1, STAGE, 1, CF, "cos gamma, stage 3")                                              \
    X(s3_adder8, 8, STAGE, GLINT_N_BITS, CF, "the denominator, stage 3")                           \
    X(lead, 9, BLOCK, LEAD_BITS, 0, "zeros before its first 1")                                    \
    X(m, 9, BLOCK, 1, M, "the denominator, normalised")                                            \
    X(s4_reg1, 1, STAGE, 1, CF, "cos gamma, stage 4")                                              \
    X(s4_lead, 9, STAGE, LEAD_BITS, 0, "zeros, stage 4")                                           \
    X(s4_m, 9, STAGE, 1, M, "m, stage 4")                                                          \
    X(rom33, 33, BLOCK, 0, SEED, "y = 1/m from the table")                                         \
    X(s5_reg1, 1, STAGE, 1, CF, "cos gamma, stage 5")                                              \
    X(s5_lead, 9, STAGE, LEAD_BITS, 0, "zeros, stage 5")                                           \
    X(s5_m, 9, STAGE, 1, M, "m, stage 5")                                                          \
    X(s5_rom33, 33, STAGE, 0, SEED, "y, stage 5")                                                  \
    X(error10, 10, BLOCK, 1, M, "2 - m y")                                                         \
    X(s6_reg1, 1, STAGE, 1, CF, "cos gamma, stage 6")                                              \
    X(s6_lead, 9, STAGE, LEAD_BITS, 0, "zeros, stage 6")                                           \
    X(s6_rom33, 33, STAGE, 0, SEED, "y, stage 6")                                                  \
    X(s6_error10, 10, STAGE, 1, M, "2 - m y, stage 6")                                             \
    X(newton10, 10, BLOCK, 1, M, "y (2 - m y)")                                                    \
    X(s7_reg1, 1, STAGE, 1, CF, "cos gamma, stage 7")                                              \
    X(s7_lead, 9, STAGE, LEAD_BITS, 0, "zeros, stage 7")                                           \
    X(s7_newton10, 10, STAGE, 1, M, "1/m, stage 7")                                                \
    X(mul10, 10, BLOCK, 2, PRODUCT_FRAC, "cos gamma / m")                                          \
    X(s8_lead, 9, STAGE, LEAD_BITS, 0, "zeros, stage 8")                                           \
    X(s8_mul10, 10, STAGE, 2, PRODUCT_FRAC, "cos gamma / m, stage 8")

GLINT_UNIT_LANE(lane, SIGNALS)

static glint_signal_info row(int variant, int index)
{
    (void)variant;
    return rows[index];
}

static int stages(int variant)
{
    (void)variant;
    return 9;
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

static void load(int variant, void *of, uint32_t cos_code)
{
    (void)variant;
    ((lane *)of)->reg1 = glint_block_saturate1(cos_code);
}

static void pass(int variant, int stage, void *of)
{
    lane *s = of;
    (void)variant;
    switch (stage) {
    case 2:
        s->s2_reg1 = s->reg1;
        s->s2_mul7 = s->mul7;
        break;
    case 3:
        /* 0/0, at cos γ = n = 0, is a last place by a last place. */
        s->s3_reg1 = s->s2_reg1 | (s->adder8 == 0);
        s->s3_adder8 = s->adder8 | (s->adder8 == 0);
        break;
    case 4:
        s->s4_reg1 = s->s3_reg1;
        s->s4_lead = s->lead;
        s->s4_m = s->m;
        break;
    case 5:
        s->s5_reg1 = s->s4_reg1;
        s->s5_lead = s->s4_lead;
        s->s5_m = s->s4_m;
        s->s5_rom33 = s->rom33;
        break;
    case 6:
        s->s6_reg1 = s->s5_reg1;
        s->s6_lead = s->s5_lead;
        s->s6_rom33 = s->s5_rom33;
        s->s6_error10 = s->error10;
        break;
    case 7:
        s->s7_reg1 = s->s6_reg1;
        s->s7_lead = s->s6_lead;
        s->s7_newton10 = s->newton10;
        break;
    default:
        s->s8_lead = s->s7_lead;
        s->s8_mul10 = s->mul10;
    }
}

/* Zeros before the first 1 of the denominator; of what is behind it m keeps M bits. */
static void normalise(lane *s)
{
    int lead = 0;
    while (lead < DEN - 1 && s->s3_adder8 >> (DEN - 1 - lead) == 0)
        lead++;
    s->lead = lead;
    s->m = s->s3_adder8 << lead >> (DEN - 1 - M);
}

/* Rounded half up; at most 1. */
static void shift_back(lane *s)
{
    const int64_t rounded = (s->s8_mul10 >> (SHIFT - s->s8_lead - 1)) + 1;
    const int64_t w = rounded >> 1;
    s->end.keys12 = w >> FRAC != 0 ? 1 << FRAC : w;
}

static void settle(int variant, int stage, uint32_t n, void *of)
{
    lane *s = of;
    (void)variant;
    switch (stage) {
    case 1:
        s->mul7 = (int64_t)n * ((int64_t)GLINT_COS_ONE - s->reg1);
        break;
    case 2:
        s->adder8 = s->s2_mul7 + s->s2_reg1;
        break;
    case 3:
        normalise(s);
        break;
    case 4:
        s->rom33 = glint_newton_seed((uint32_t)s->s4_m >> (M - GLINT_NEWTON_TABLE_BITS));
        break;
    case 5:
        s->error10 = (2 << M) - (s->s5_m * s->s5_rom33 >> SEED);
        s->error10 &= (2 << M) - 1;
        break;
    case 6:
        s->newton10 = s->s6_error10 * s->s6_rom33 >> SEED;
        break;
    case 7:
        s->mul10 = s->s7_reg1 * s->s7_newton10;
        break;
    default:
        shift_back(s);
    }
}

GLINT_UNIT_WS(lane)

static double real(int variant, uint32_t n, uint32_t cos_code)
{
    return glint_unit_schlick.real(variant, n, cos_code);
}

const glint_unit glint_unit_newton = {
    .variants = 1,
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
};
