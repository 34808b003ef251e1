/* Lyon's unit: how its lane makes W, for unit.c. */
#include <math.h>

#include "blocks.h"
#include "glint_rivals.h"
#include "unit_rows.h"

enum {
    FRAC = GLINT_LYON_FRAC_BITS,
    ONE = 1 << FRAC,
    P_BITS = GLINT_N_BITS + GLINT_COS_FRAC_BITS,
    ROWS_OF_K4 = 7, /* the third squaring is k = 8's */
};

#define SIGNALS(X)                                                                                 \
    X(reg1, 1, REGISTER, 1, GLINT_COS_FRAC_BITS, "x = 1 - cos gamma")                              \
    X(mul7, 7, BLOCK, GLINT_N_BITS, GLINT_COS_FRAC_BITS, "p = n x")                                \
    X(cmp11, 11, BLOCK, 1, 0, "p is below k")                                                      \
    X(adder8, 8, BLOCK, 1, FRAC, "t = 1 - p/k, or zero")                                           \
    X(s2_adder8, 8, STAGE, 1, FRAC, "t, stage 2")                                                  \
    X(mul10, 10, BLOCK, 1, FRAC, "t^2")                                                            \
    X(s3_mul10, 10, STAGE, 1, FRAC, "t^2, stage 3")                                                \
    X(second10, 10, BLOCK, 1, FRAC, "t^4")                                                         \
    X(s4_second10, 10, STAGE, 1, FRAC, "t^4, stage 4")

GLINT_UNIT_LANE(lane, SIGNALS)

static int count_rows(int variant)
{
    return variant == 0 ? ROWS_OF_K4 : row_count(variant);
}

static glint_signal_info row(int variant, int index)
{
    (void)variant;
    glint_signal_info info = rows[index];
    if (index == ROWS_OF_K4)
        info.path = "g_k8.second10";
    if (index == ROWS_OF_K4 + 1)
        info.path = "g_k8.s4_second10";
    return info;
}

static int stages(int variant)
{
    return 2 + GLINT_LYON_LOG2_K(variant);
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
    lane *s = of;
    (void)variant;
    s->reg1 = GLINT_COS_ONE - glint_block_saturate1(cos_code);
}

static void pass(int variant, int stage, void *of)
{
    lane *s = of;
    (void)variant;
    if (stage == 2)
        s->s2_adder8 = s->adder8;
    else if (stage == 3)
        s->s3_mul10 = s->mul10;
    else
        s->s4_second10 = s->second10;
}

static int64_t square(int64_t t)
{
    return GLINT_HALF_UP(int64_t, t * t, FRAC);
}

/* 1 − p/k, rounded half up: p has as many bits below as the cosine, and those of k. */
static int64_t line(int log2_k, int64_t p)
{
    const int dropped = GLINT_COS_FRAC_BITS + log2_k - FRAC;
    return ONE - GLINT_HALF_UP(int64_t, p, dropped);
}

static void settle_1(int variant, uint32_t n, lane *s)
{
    const int log2_k = GLINT_LYON_LOG2_K(variant);
    s->mul7 = (int64_t)n * s->reg1;
    s->cmp11 = s->mul7 >> (GLINT_COS_FRAC_BITS + log2_k) == 0;
    s->adder8 = s->cmp11 ? line(log2_k, s->mul7) : 0;
}

static void settle(int variant, int stage, uint32_t n, void *of)
{
    lane *s = of;
    switch (stage) {
    case 1:
        settle_1(variant, n, s);
        break;
    case 2:
        s->mul10 = square(s->s2_adder8);
        break;
    case 3:
        s->second10 = square(s->s3_mul10);
        s->end.keys12 = s->second10;
        break;
    default:
        s->end.keys12 = square(s->s4_second10);
    }
}

GLINT_UNIT_WS(lane)

static double real(int variant, uint32_t n, uint32_t cos_code)
{
    const double k = 1 << GLINT_LYON_LOG2_K(variant);
    return pow(fmax(0, 1 - n * (1 - glint_unit_cosine(cos_code)) / k), k);
}

const glint_unit glint_unit_lyon = {
    .variants = GLINT_LYON_VARIANTS,
    .stages = stages,
    .n_stages = n_stages,
    .w_frac_bits = w_frac_bits,
    .lane_size = sizeof(lane),
    .load = load,
    .pass = pass,
    .settle = settle,
    .ws = ws,
    .row_count = count_rows,
    .row = row,
    .real = real,
};
