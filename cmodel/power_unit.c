/* The power device clock by clock: how its lane makes W, for unit.c. */
#include "glint_power.h"
#include "power_blocks.h"
#include "unit_rows.h"

/* Signals of a lane. Fraction bits: those of the tables' address, or of W. */
enum { TABLE_FRAC = -1, W_FRAC = -2 };

#define SIGNALS(X)                                                                                 \
    X(reg1, 1, REGISTER, 0, GLINT_POWER_X_BITS, "x = 1 - cos gamma")                               \
    X(mul7, 7, BLOCK, GLINT_POWER_P_INT_BITS, GLINT_POWER_X_BITS, "p = n x")                       \
    X(over7, 7, BLOCK, 1, 0, "p is 16 or more")                                                    \
    X(rom9, 9, BLOCK, GLINT_POWER_L_INT_BITS, TABLE_FRAC, "g(x) = -log2(1 - x)/x")                 \
    X(s2_mul7, 7, STAGE, GLINT_POWER_L_INT_BITS, GLINT_POWER_Q_FRAC_BITS,                          \
      "q = the middle of p, stage 2")                                                              \
    X(s2_over7, 7, STAGE, 1, 0, "p is 16 or more, stage 2")                                        \
    X(s2_rom9, 9, STAGE, GLINT_POWER_L_INT_BITS, TABLE_FRAC, "g, stage 2")                         \
    X(mul10, 10, BLOCK, GLINT_POWER_V_INT_BITS, TABLE_FRAC, "v = q g")                             \
    X(cmp11, 11, BLOCK, 1, 0, "p and v are below 16")                                              \
    X(s3_mul10, 10, STAGE, GLINT_POWER_L_INT_BITS, TABLE_FRAC, "v, stage 3")                       \
    X(s3_cmp11, 11, STAGE, 1, 0, "p and v are below 16, stage 3")                                  \
    X(rom33, 33, BLOCK, 1, W_FRAC, "2^-f, f the fraction of v")

GLINT_UNIT_LANE(lane, SIGNALS)

enum { STAGES = GLINT_POWER_LATENCY_PIPELINED - 1 };

static int stages(int variant)
{
    (void)variant;
    return STAGES;
}

static int n_stages(int variant)
{
    (void)variant;
    return 1;
}

static int table_bits(int variant)
{
    return GLINT_POWER_TABLE_BITS(variant);
}

static int w_frac_bits(int variant)
{
    return GLINT_POWER_W_FRAC_BITS(variant);
}

static glint_signal_info row(int variant, int index)
{
    glint_signal_info info = rows[index];
    if (info.frac_bits == TABLE_FRAC)
        info.frac_bits = table_bits(variant);
    if (info.frac_bits == W_FRAC)
        info.frac_bits = w_frac_bits(variant);
    return info;
}

static void load(int variant, void *of, uint32_t cos_code)
{
    lane *s = of;
    (void)variant;
    s->reg1 = glint_power_block_x(cos_code);
}

static void pass(int variant, int stage, void *of)
{
    lane *s = of;
    if (stage == 2) {
        s->s2_mul7 = glint_power_block_q((uint32_t)s->mul7);
        s->s2_over7 = s->over7;
        s->s2_rom9 = s->rom9;
        return;
    }
    s->s3_mul10 = s->mul10 & ((1 << (GLINT_POWER_L_INT_BITS + table_bits(variant))) - 1);
    s->s3_cmp11 = s->cmp11;
}

static void settle_1(glint_power_accuracy accuracy, uint32_t n, lane *s)
{
    const int table = table_bits((int)accuracy);
    const uint32_t x = (uint32_t)s->reg1, p = glint_power_block_mul7(n, x);
    s->mul7 = p;
    s->over7 = glint_power_block_over7(p);
    s->rom9 = glint_power_rom9(accuracy, glint_power_block_address9(table, x));
}

static void settle_2(int table, lane *s)
{
    const uint32_t v = glint_power_block_mul10((uint32_t)s->s2_mul7, (uint32_t)s->s2_rom9);
    s->mul10 = v;
    s->cmp11 = glint_power_block_cmp11(table, (uint32_t)s->s2_over7, v);
}

static void settle_3(glint_power_accuracy accuracy, lane *s)
{
    const int table = table_bits((int)accuracy);
    const uint32_t v = (uint32_t)s->s3_mul10;
    const uint32_t power = glint_power_rom33(accuracy, glint_power_block_address33(table, v));
    s->rom33 = power;
    s->end.keys12 = glint_power_block_keys12(table, (uint32_t)s->s3_cmp11, power, v);
}

static void settle(int variant, int stage, uint32_t n, void *of)
{
    if (stage == 1)
        settle_1((glint_power_accuracy)variant, n, of);
    else if (stage == 2)
        settle_2(table_bits(variant), of);
    else
        settle_3((glint_power_accuracy)variant, of);
}

static double real(int variant, uint32_t n, uint32_t cos_code)
{
    (void)variant;
    return glint_power_real(n, cos_code);
}

const glint_unit glint_unit_power = {
    .variants = GLINT_POWER_ACCURACY_COUNT,
    .stages = stages,
    .n_stages = n_stages,
    .w_frac_bits = w_frac_bits,
    .lane_size = sizeof(lane),
    .load = load,
    .pass = pass,
    .settle = settle,
    .ws = glint_power_ws,
    .row_count = row_count,
    .row = row,
    .real = real,
};
