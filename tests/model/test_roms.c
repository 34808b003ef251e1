/* What ROM 33 and ROM 9 hold, for every n, against integer arithmetic that owes nothing to
 * cmodel/roms.c: a rational compared by cross-multiplication, and a search through all cosines. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

#include "../golden.h"
#include "glint_specular.h"

/* Worked out by hand: σ = (n+1)/3 · 8192, and 2^18 less the widest 1 − cos γ that leaves t ≥ 0. */
static const struct {
    uint32_t n, sigma, limit;
} anchors[] = {
    {0, 2731, 0},            /* 2730 2/3; the highlight is wider than a quarter turn */
    {1, 5461, 0},            /* 5461 1/3 */
    {2, 8192, 0},            /* exactly 1; t = cos γ */
    {3, 10923, 65542},       /* 10922 2/3; true limit 1/4 = 65536 */
    {5, 16384, 131072},      /* exactly 2; true limit 1/2 */
    {13, 38229, 205970},     /* 38229 1/3; 11/14 = 205970.3 */
    {60, 166571, 249252},    /* 166570 2/3; 58/61 = 249251.7 */
    {100, 275797, 254358},   /* 275797 1/3; 98/101 = 254357.5 */
    {1000, 2733397, 261359}, /* 2733397 1/3; 998/1001 = 261358.4 */
    {1023, 2796203, 261376}, /* 2796202 2/3; 1021/1024 = 261376 */
};

static void anchors_by_hand(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof anchors / sizeof anchors[0]; i++) {
        assert_int_equal(glint_rom33(anchors[i].n), anchors[i].sigma);
        assert_int_equal(glint_rom9(GLINT_GATE_COSINE, anchors[i].n), anchors[i].limit);
    }
}

/* How far 3·code lies from (n+1)·2^13: three times the distance of code from σ, exact. */
static int64_t distance_from_sigma(int64_t code, uint32_t n)
{
    return llabs(3 * code - (int64_t)(n + 1) * 8192);
}

static void rom33_is_nearest_for_every_n(void **state)
{
    (void)state;
    for (uint32_t n = 0; n <= 1023; n++) {
        const int64_t code = glint_rom33(n);
        /* Half up: at equal distances the upper of two neighbours. */
        assert_true(distance_from_sigma(code, n) < distance_from_sigma(code + 1, n));
        assert_true(distance_from_sigma(code, n) <= distance_from_sigma(code - 1, n));
        assert_true(code < INT64_C(1) << GLINT_SIGMA_BITS);
    }
}

/* t ≥ 0 by the statement itself: σ(1 − cos γ) rounded half down is at most 1, that is
 * sigma·(2^18 − cosine) ≤ 2^31 + 2^12. */
static int is_inside(uint64_t sigma, uint64_t cosine)
{
    return sigma * (262144u - cosine) <= (UINT64_C(1) << 31) + 4096u;
}

static void rom9_is_the_smallest_cosine_inside_for_every_n(void **state)
{
    (void)state;
    for (uint32_t n = 0; n <= 1023; n++) {
        const uint64_t sigma = ((uint64_t)(n + 1) * 16384u + 3u) / 6u;
        uint64_t cosine = 0;
        while (!is_inside(sigma, cosine))
            cosine++;
        assert_int_equal(glint_rom9(GLINT_GATE_COSINE, n), cosine);
    }
}

/* The ROM's limit against the formula's (n−2)/(n+1). It may differ by what a third of an ulp of σ
 * moves 1/σ, by half an ulp of multiplier 7 over σ, and by the step of one code. */
static void rom9_is_near_the_true_limit(void **state)
{
    (void)state;
    for (uint32_t n = 0; n <= 1023; n++) {
        const double sigma = (n + 1.0) / 3.0;
        const double limit = n <= 2 ? 0.0 : 262144.0 * (n - 2.0) / (n + 1.0);
        const double allowed = 32.0 / 3.0 / (sigma * sigma) + 0.5 / sigma + 1.0;
        const double distance = (double)glint_rom9(GLINT_GATE_COSINE, n) - limit;
        if (distance > allowed || distance < -allowed)
            fail_msg("n = %u: %.2f codes from the true limit, %.2f allowed", n, distance, allowed);
    }
}

static void the_limit_never_falls_with_n(void **state)
{
    (void)state;
    for (uint32_t n = 1; n <= 1023; n++)
        assert_true(glint_rom9(GLINT_GATE_COSINE, n - 1) <= glint_rom9(GLINT_GATE_COSINE, n));
}

/* Gate drawn: half of one 8-bit step, 2^18/510 = 514.008; gate sign has no ROM 9. */
static void rom9_of_the_other_gates(void **state)
{
    (void)state;
    for (uint32_t n = 0; n <= 1023; n++) {
        assert_int_equal(glint_rom9(GLINT_GATE_DRAWN, n), 514);
        assert_int_equal(glint_rom9(GLINT_GATE_SIGN, n), 0);
    }
}

static void only_ten_bits_of_n_count(void **state)
{
    (void)state;
    assert_int_equal(glint_rom33(1024), glint_rom33(0));
    assert_int_equal(glint_rom33(0xfffffc00u + 60u), glint_rom33(60));
    assert_int_equal(glint_rom9(GLINT_GATE_COSINE, 1024 + 60), glint_rom9(GLINT_GATE_COSINE, 60));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(anchors_by_hand),
        cmocka_unit_test(rom33_is_nearest_for_every_n),
        cmocka_unit_test(rom9_is_the_smallest_cosine_inside_for_every_n),
        cmocka_unit_test(rom9_is_near_the_true_limit),
        cmocka_unit_test(the_limit_never_falls_with_n),
        cmocka_unit_test(rom9_of_the_other_gates),
        cmocka_unit_test(only_ten_bits_of_n_count),
    };
    return golden_run_group_tests(tests, NULL, NULL);
}
