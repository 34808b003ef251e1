/* The thesis's quadratic: how its lane makes W, for unit.c. */
#include <math.h>

#include "blocks.h"
#include "glint_rivals.h"
#include "unit_rows.h"

enum {
    FRAC = GLINT_COS_FRAC_BITS, /* of the cosine, of the line and of W */
    A_INT = GLINT_QUADRATIC_A_INT_BITS,
    A_FRAC = GLINT_QUADRATIC_A_FRAC_BITS,
};

#define SIGNALS(X)                                                                                 \
    X(reg1, 1, REGISTER, 1, FRAC, "cos gamma, saturated to 1")                                     \
    X(rom33, 33, BLOCK, A_INT, A_FRAC, "a of n")                                                   \
    X(mul7, 7, BLOCK, A_INT, FRAC, "a (1 - cos gamma)")                                            \
    X(cmp11, 11, BLOCK, 1, 0, "the line is not negative")                                          \
    X(adder8, 8, BLOCK, 1, FRAC, "1 - a (1 - cos gamma), or zero")                                 \
    X(s2_reg1, 1, STAGE, 1, FRAC, "cos gamma, stage 2")                                            \
    X(s2_adder8, 8, STAGE, 1, FRAC, "the line, stage 2")

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
    s->s2_reg1 = s->reg1;
    s->s2_adder8 = s->adder8;
}

static void settle(int variant, int stage, uint32_t n, void *of)
{
    lane *s = of;
    const int64_t one = GLINT_COS_ONE;
    (void)variant;
    if (stage == 1) {
        s->rom33 = glint_quadratic_rom33(n);
        s->mul7 = GLINT_HALF_UP(int64_t, s->rom33 * (one - s->reg1), A_FRAC);
        s->cmp11 = s->mul7 <= one;
        s->adder8 = s->cmp11 ? one - s->mul7 : 0;
    } else {
        s->end.keys12 = GLINT_HALF_UP(int64_t, s->s2_adder8 * s->s2_reg1, FRAC);
    }
}

GLINT_UNIT_WS(lane)

static double real(int variant, uint32_t n, uint32_t cos_code)
{
    const double c = glint_unit_cosine(cos_code);
    const double t = sqrt((n - 1.0) / n);
    const double a = n <= 1 ? 0 : (pow(t, n - 1.0) - 1) / (t - 1);
    (void)variant;
    return fmax(0, c * (1 - a * (1 - c)));
}

const glint_unit glint_unit_quadratic = {
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
