/* Schlick's function by division: how its lane makes W, for unit.c. */
#include "blocks.h"
#include "glint_rivals.h"
#include "unit_rows.h"

enum {
    FRAC = GLINT_SCHLICK_FRAC_BITS,
    DEN = GLINT_SCHLICK_DEN_BITS,
    INT = GLINT_N_BITS,
    CF = GLINT_COS_FRAC_BITS,
    FIRST = 3,           /* the stage with the quotient's first bit */
    LAST = FIRST + FRAC, /* and the last */
};

/* A stage of the division: what stands in front of it, and what it makes. */
typedef struct step {
    int64_t rest, den, quotient; /* rest U10.18, below den; the bits so far */
    int64_t left, bits;          /* after it */
} step;

typedef struct lane {
    glint_unit_end end;
    int64_t reg1, mul7, s2_reg1, s2_mul7, adder8;
    step step[FRAC + 1];
} lane;

#define ROW(member, number, sort, ints, fracs, text)                                               \
    {                                                                                              \
        .name = #member, .block = number, .kind = GLINT_SIGNAL_##sort, .int_bits = ints,           \
        .frac_bits = fracs, .meaning = text, .offset = offsetof(lane, member)                      \
    }
static const glint_signal_info front[] = {
    ROW(reg1, 1, REGISTER, 1, CF, "cos gamma, saturated to 1"),
    ROW(mul7, 7, BLOCK, INT, CF, "n (1 - cos gamma)"),
    ROW(s2_reg1, 1, STAGE, 1, CF, "cos gamma, stage 2"),
    ROW(s2_mul7, 7, STAGE, INT, CF, "n (1 - cos gamma), stage 2"),
    ROW(adder8, 8, BLOCK, INT, CF, "the denominator"),
};
enum { FRONT = sizeof front / sizeof front[0], OF_STEP = 4 };

/* Of step i, which is in stage FIRST + i. */
#define STEP_ROW(i, called, member, sort, ints, fracs, text)                                       \
    {                                                                                              \
        .name = called, .block = 10, .kind = GLINT_SIGNAL_##sort, .int_bits = ints,                \
        .frac_bits = fracs, .meaning = text,                                                       \
        .offset = offsetof(lane, step) + (i) * sizeof(step) + offsetof(step, member),              \
        .path = "step[" #i "]." #member                                                            \
    }
#define STEP(i)                                                                                    \
    {                                                                                              \
        STEP_ROW(i, "step" #i "_rest", rest, STAGE, INT, CF, "what is left to divide"),            \
            STEP_ROW(i, "step" #i "_den", den, STAGE, INT, CF, "the denominator"),                 \
            STEP_ROW(i, "step" #i "_quotient", quotient, STAGE, 1, FRAC, "the quotient so far"),   \
            STEP_ROW(i, "step" #i "_bits", bits, BLOCK, 1, FRAC, "with the step's bit")            \
    }
static const glint_signal_info step_rows[FRAC + 1][OF_STEP] = {
    STEP(0), STEP(1), STEP(2), STEP(3),  STEP(4),  STEP(5), STEP(6),
    STEP(7), STEP(8), STEP(9), STEP(10), STEP(11), STEP(12)};
_Static_assert(GLINT_SCHLICK_FRAC_BITS == 12, "the rows above are of 13 steps");

static int row_count(int variant)
{
    (void)variant;
    return FRONT + OF_STEP * (FRAC + 1);
}

static glint_signal_info row(int variant, int index)
{
    (void)variant;
    const int of_steps = index - FRONT;
    return of_steps < 0 ? front[index] : step_rows[of_steps / OF_STEP][of_steps % OF_STEP];
}

static int stages(int variant)
{
    (void)variant;
    return LAST + 1;
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
    if (stage == 2) {
        s->s2_reg1 = s->reg1;
        s->s2_mul7 = s->mul7;
    } else if (stage == FIRST) {
        s->step[0] = (step){.rest = s->s2_reg1, .den = s->adder8};
    } else {
        const step *before = &s->step[stage - FIRST - 1];
        step *now = &s->step[stage - FIRST];
        now->rest = before->left;
        now->den = before->den;
        now->quotient = before->bits;
    }
}

/* One bit: the first is that of 1.0, where nothing is left for the others. */
static void divide(int index, step *now)
{
    const int64_t twice = index == 0 ? now->rest : 2 * now->rest;
    const int bit = twice >= now->den && now->quotient >> FRAC == 0;
    now->left = bit ? twice - now->den : twice;
    now->bits = now->quotient | (int64_t)bit << (FRAC - index);
}

static void settle(int variant, int stage, uint32_t n, void *of)
{
    lane *s = of;
    (void)variant;
    if (stage == 1)
        s->mul7 = (int64_t)n * ((int64_t)GLINT_COS_ONE - s->reg1);
    else if (stage == 2)
        s->adder8 = s->s2_mul7 + s->s2_reg1;
    else
        divide(stage - FIRST, &s->step[stage - FIRST]);
    if (stage == LAST)
        s->end.keys12 = s->step[FRAC].bits;
}

GLINT_UNIT_WS(lane)

static double real(int variant, uint32_t n, uint32_t cos_code)
{
    const double c = glint_unit_cosine(cos_code), den = n * (1 - c) + c;
    (void)variant;
    return den > 0 ? c / den : 1;
}

const glint_unit glint_unit_schlick = {
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
