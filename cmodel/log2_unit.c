/* The power by logarithm and exponential: how its lane makes W, for unit.c. */
#include <math.h>

#include "blocks.h"
#include "glint_power.h"
#include "glint_rivals.h"
#include "unit_rows.h"

enum {
    CF = GLINT_COS_FRAC_BITS,
    M = CF - 1, /* fraction bits of the normalised cosine */
    LF = GLINT_LOG2_FRAC_BITS,
    LI = GLINT_LOG2_L_INT_BITS,
    TABLE = GLINT_LOG2_TABLE_BITS,
    LOW = M - TABLE, /* bits within an interval */
    CUT = GLINT_LOG2_SLOPE_FRAC + LOW - LF,
    RISE_BITS = GLINT_LOG2_SLOPE_BITS + LOW - CUT,
    P_INT = GLINT_N_BITS + LI,
    EXP = 8, /* address bits of ROM 33 of the power device, accuracy half */
    V_INT = GLINT_POWER_L_INT_BITS,
    FRAC = GLINT_LOG2_W_FRAC_BITS,
    LEAD_BITS = 5,
};

#define SIGNALS(X)                                                                                 \
    X(reg1, 1, REGISTER, 1, CF, "cos gamma, saturated to 1")                                       \
    X(lead, 6, BLOCK, LEAD_BITS, 0, "zeros before its first 1")                                    \
    X(m, 6, BLOCK, 0, M, "the cosine normalised, without its first 1")                             \
    X(end6, 6, BLOCK, 2, 0, "bit 0: the cosine is 1; bit 1: it is 0")                              \
    X(s2_lead, 6, STAGE, LEAD_BITS, 0, "zeros, stage 2")                                           \
    X(s2_m, 6, STAGE, 0, M, "m, stage 2")                                                          \
    X(s2_end6, 6, STAGE, 2, 0, "cosine 1 or 0, stage 2")                                           \
    X(rom9, 9, BLOCK, 1, LF, "where the line of log2 begins")                                      \
    X(slope9, 9, BLOCK, 0, GLINT_LOG2_SLOPE_BITS, "how far it rises")                              \
    X(s3_lead, 6, STAGE, LEAD_BITS, 0, "zeros, stage 3")                                           \
    X(s3_low, 6, STAGE, 0, LOW, "place in the interval, stage 3")                                  \
    X(s3_end6, 6, STAGE, 2, 0, "cosine 1 or 0, stage 3")                                           \
    X(s3_rom9, 9, STAGE, 1, LF, "the line's beginning, stage 3")                                   \
    X(s3_slope9, 9, STAGE, 0, GLINT_LOG2_SLOPE_BITS, "its rise, stage 3")                          \
    X(rise7, 7, BLOCK, 0, RISE_BITS, "slope times place")                                          \
    X(adder8, 8, BLOCK, LI, LF, "L = -log2 cos gamma")                                             \
    X(s4_adder8, 8, STAGE, LI, LF, "L, stage 4")                                                   \
    X(mul10, 10, BLOCK, P_INT, LF, "n L")                                                          \
    X(s5_mul10, 10, STAGE, P_INT, LF, "n L, stage 5")                                              \
    X(v, 10, BLOCK, V_INT, EXP, "n L, rounded")                                                    \
    X(cmp11, 11, BLOCK, 1, 0, "n L is below 16")                                                   \
    X(s6_v, 10, STAGE, V_INT, EXP, "n L, stage 6")                                                 \
    X(s6_cmp11, 11, STAGE, 1, 0, "n L is below 16, stage 6")                                       \
    X(rom33, 33, BLOCK, 1, FRAC, "2^-f, f the fraction of v")

GLINT_UNIT_LANE(lane, SIGNALS)

static glint_signal_info row(int variant, int index)
{
    (void)variant;
    return rows[index];
}

static int stages(int variant)
{
    (void)variant;
    return 7;
}

static int n_stages(int variant)
{
    (void)variant;
    return 4;
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
        s->s2_lead = s->lead;
        s->s2_m = s->m;
        s->s2_end6 = s->end6;
        break;
    case 3:
        s->s3_lead = s->s2_lead;
        s->s3_low = s->s2_m & ((1 << LOW) - 1);
        s->s3_end6 = s->s2_end6;
        s->s3_rom9 = s->rom9;
        s->s3_slope9 = s->slope9;
        break;
    case 4:
        s->s4_adder8 = s->adder8;
        break;
    case 5:
        s->s5_mul10 = s->mul10;
        break;
    default:
        s->s6_v = s->v;
        s->s6_cmp11 = s->cmp11;
    }
}

/* The 18 fraction bits of the cosine shifted until their first is 1: the cosine is
 * (1.m)·2^(−1 − lead). */
static void normalise(lane *s)
{
    const uint32_t fraction = (uint32_t)s->reg1 & (GLINT_COS_ONE - 1u);
    uint32_t lead = 0;
    while (lead < CF - 1 && fraction >> (CF - 1 - lead) == 0)
        lead++;
    s->lead = lead;
    s->m = fraction << lead & ((1u << M) - 1u);
    s->end6 = (s->reg1 == GLINT_COS_ONE ? 1 : 0) | (s->reg1 == 0 ? 2 : 0);
}

/* L; a logarithm above 1 is 1. Of cosine 1 it is 0, of cosine 0 all ones. */
static void add_up(lane *s)
{
    s->rise7 = s->s3_slope9 * s->s3_low >> CUT;
    const int64_t sum = s->s3_rom9 + s->rise7, one = INT64_C(1) << LF;
    const int64_t logarithm = sum > one ? one : sum;
    const int64_t l = ((s->s3_lead + 1) << LF) - logarithm;
    s->adder8 = s->s3_end6 & 1 ? 0 : s->s3_end6 & 2 ? (INT64_C(1) << (LI + LF)) - 1 : l;
}

static void round_off(lane *s)
{
    const int64_t rounded = GLINT_HALF_UP(int64_t, s->s5_mul10, LF - EXP);
    s->v = rounded & ((1 << (V_INT + EXP)) - 1);
    s->cmp11 = rounded >> (V_INT + EXP) == 0;
}

static void raise(lane *s)
{
    const uint32_t power =
        glint_power_rom33(GLINT_POWER_HALF, (uint32_t)s->s6_v & ((1u << EXP) - 1u));
    s->rom33 = power;
    s->end.keys12 = s->s6_cmp11 ? power >> (s->s6_v >> EXP) : 0;
}

static void settle(int variant, int stage, uint32_t n, void *of)
{
    lane *s = of;
    (void)variant;
    switch (stage) {
    case 1:
        normalise(s);
        break;
    case 2:
        s->rom9 = glint_log2_base((uint32_t)s->s2_m >> LOW);
        s->slope9 = glint_log2_slope((uint32_t)s->s2_m >> LOW);
        break;
    case 3:
        add_up(s);
        break;
    case 4:
        s->mul10 = (int64_t)n * s->s4_adder8;
        break;
    case 5:
        round_off(s);
        break;
    default:
        raise(s);
    }
}

GLINT_UNIT_WS(lane)

static double real(int variant, uint32_t n, uint32_t cos_code)
{
    (void)variant;
    return glint_power_real(n, cos_code);
}

const glint_unit glint_unit_log2 = {
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
