/* Each block of figure 3.1 against values worked out by hand. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "../golden.h"
#include "blocks.h"

#define COUNT(array) (sizeof(array) / sizeof(array)[0])

enum {
    ONE = 262144 /* 1.0 in every format with 18 fraction bits */
};

static void register1_saturates(void **state)
{
    (void)state;
    static const uint32_t rows[][2] = {{0, 0},
                                       {1, 1},
                                       {ONE - 1, ONE - 1},
                                       {ONE, ONE},
                                       {ONE + 1, ONE},
                                       {ONE + 1000, ONE},
                                       {2 * ONE - 1, ONE}};
    for (size_t i = 0; i < COUNT(rows); i++)
        assert_int_equal(glint_block_saturate1(rows[i][0]), rows[i][1]);
}

static void adder6_takes_one_off(void **state)
{
    (void)state;
    for (uint32_t cosine = 0; cosine <= ONE; cosine++)
        assert_int_equal(glint_block_adder6(cosine), (int32_t)cosine - ONE);
}

static void multiplier7_rounds_half_up(void **state)
{
    (void)state;
    static const struct {
        uint32_t sigma;
        int32_t difference, product;
    } rows[] = {
        {8192, 0, 0},
        {8192, -ONE, -ONE}, /* 1 · −1 */
        {8192, -1, -1},
        {4096, -1, 0},              /* −1/2 goes up to 0 */
        {4096, -3, -1},             /* −3/2 goes up to −1 */
        {4095, -1, 0},              /* a little above −1/2 */
        {4097, -1, -1},             /* a little below −1/2 */
        {12288, -1, -1},            /* −3/2 */
        {2731, -3, -1},             /* −8193/8192 */
        {16384, -131073, -262146},  /* n = 5, a code below its limit */
        {2796203, -ONE, -89478496}, /* the largest: n = 1023, cosine 0; 2796203 · 32 */
        {2796203, -1, -341},        /* −341.333 */
    };
    for (size_t i = 0; i < COUNT(rows); i++)
        assert_int_equal(glint_block_mul7(rows[i].sigma, rows[i].difference), rows[i].product);
}

static void adder8_adds_one(void **state)
{
    (void)state;
    static const int32_t rows[][2] = {
        {0, ONE}, {-1, ONE - 1}, {-ONE, 0}, {-ONE - 1, -1}, {-89478496, -89216352}};
    for (size_t i = 0; i < COUNT(rows); i++)
        assert_int_equal(glint_block_adder8(rows[i][0]), rows[i][1]);
}

static void multiplier10_squares_the_low_bits(void **state)
{
    (void)state;
    static const struct {
        int32_t t;
        uint32_t square;
    } rows[] = {
        {0, 0},
        {1, 0},
        {362, 0},           /* 131044 of 262144: below a half */
        {363, 1},           /* 131769 of 262144: above */
        {131072, 65536},    /* 1/2 squared */
        {ONE - 1, ONE - 2}, /* 1 − 2ε + ε² */
        {ONE, ONE},
        {95573, 34844}, /* 9134198329 / 262144 = 34844.2 */
        {-1, 524284},   /* 19 low bits: 524287² / 2^18 = 2^20 − 4, of which 19 bits */
        {-2, 524280},
    };
    for (size_t i = 0; i < COUNT(rows); i++) {
        assert_int_equal(glint_block_mul10(rows[i].t), rows[i].square);
        assert_int_equal(glint_block_mul10_gated(GLINT_GATE_COSINE, rows[i].t), rows[i].square);
        assert_int_equal(glint_block_mul10_gated(GLINT_GATE_SIGN, rows[i].t), rows[i].square);
    }
}

static void multiplier10_drawn_squares_all_of_t(void **state)
{
    (void)state;
    static const struct {
        int32_t t;
        uint64_t square;
    } rows[] = {
        {0, 0},
        {-1, 0},
        {-363, 1},
        {131072, 65536},
        {-131072, 65536},
        {ONE, ONE},
        {-ONE, ONE},
        {-2 * ONE, 4 * ONE},
        {-89216352, UINT64_C(30363302094)}, /* the largest: 2788011² / 256 = 30363302094.2 */
    };
    for (size_t i = 0; i < COUNT(rows); i++) {
        assert_true(glint_block_mul10_drawn(rows[i].t) == rows[i].square);
        assert_true(glint_block_mul10_gated(GLINT_GATE_DRAWN, rows[i].t) == rows[i].square);
        assert_true(rows[i].square >> GLINT_W_DRAWN_BITS == 0);
    }
}

static void the_square_saturates_with_gate_drawn_only(void **state)
{
    (void)state;
    assert_int_equal(glint_block_sat10(GLINT_GATE_DRAWN, ONE - 1), ONE - 1);
    assert_int_equal(glint_block_sat10(GLINT_GATE_DRAWN, ONE), ONE);
    assert_int_equal(glint_block_sat10(GLINT_GATE_DRAWN, ONE + 1), ONE);
    assert_int_equal(glint_block_sat10(GLINT_GATE_DRAWN, UINT64_C(30363302094)), ONE);
    /* 2^32 and a little: a saturation that looks at 32 bits would let 5 pass. */
    assert_int_equal(glint_block_sat10(GLINT_GATE_DRAWN, (UINT64_C(1) << 32) + 5), ONE);
    assert_int_equal(glint_block_sat10(GLINT_GATE_COSINE, 524284), 524284);
    assert_int_equal(glint_block_sat10(GLINT_GATE_SIGN, 524284), 524284);
}

static void comparator11_of_each_gate(void **state)
{
    (void)state;
    const glint_gate cosine = GLINT_GATE_COSINE;
    const glint_gate sign = GLINT_GATE_SIGN;
    const glint_gate drawn = GLINT_GATE_DRAWN;
    assert_int_equal(glint_block_cmp11(cosine, 1000, 999, 5, 5000), 0);
    assert_int_equal(glint_block_cmp11(cosine, 1000, 1000, -5, 0), 1);
    assert_int_equal(glint_block_cmp11(cosine, 1000, 1001, -5, 0), 1);
    assert_int_equal(glint_block_cmp11(sign, 1000, 5000, -1, 5000), 0);
    assert_int_equal(glint_block_cmp11(sign, 1000, 0, 0, 0), 1);
    assert_int_equal(glint_block_cmp11(sign, 1000, 0, 1, 0), 1);
    assert_int_equal(glint_block_cmp11(drawn, 514, 5000, 5, 513), 0);
    assert_int_equal(glint_block_cmp11(drawn, 514, 0, -5, 514), 1);
    assert_int_equal(glint_block_cmp11(drawn, 514, 0, -5, UINT64_C(1) << 32), 1);
}

static void keys12_pass_or_give_zero(void **state)
{
    (void)state;
    assert_int_equal(glint_block_keys12(1, 12345), 12345);
    assert_int_equal(glint_block_keys12(0, 12345), 0);
}

static void multiplier13_rounds_half_up(void **state)
{
    (void)state;
    static const struct {
        uint32_t w;
        uint8_t color, product;
    } rows[] = {
        {0, 255, 0},    {131072, 255, 128},                /* 127.5 goes up */
        {131072, 1, 1},                                    /* 0.5 goes up */
        {131071, 1, 0}, {131072, 2, 1},     {514, 255, 0}, /* 131070 / 262144: below a half */
        {515, 255, 1},  {65536, 100, 25},   {ONE - 1, 255, 255}, {34844, 190, 25}, /* 25.25 */
    };
    for (size_t i = 0; i < COUNT(rows); i++)
        assert_int_equal(glint_block_mul_color(rows[i].w, rows[i].color), rows[i].product);
    for (unsigned color = 0; color <= 255; color++)
        assert_int_equal(glint_block_mul_color(ONE, (uint8_t)color), color);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(register1_saturates),
        cmocka_unit_test(adder6_takes_one_off),
        cmocka_unit_test(multiplier7_rounds_half_up),
        cmocka_unit_test(adder8_adds_one),
        cmocka_unit_test(multiplier10_squares_the_low_bits),
        cmocka_unit_test(multiplier10_drawn_squares_all_of_t),
        cmocka_unit_test(the_square_saturates_with_gate_drawn_only),
        cmocka_unit_test(comparator11_of_each_gate),
        cmocka_unit_test(keys12_pass_or_give_zero),
        cmocka_unit_test(multiplier13_rounds_half_up),
    };
    return golden_run_group_tests(tests, NULL, NULL);
}
