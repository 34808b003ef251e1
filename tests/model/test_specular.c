/* One point through the whole device: every block's value in each gate, worked out by hand; the
 * centre of the highlight for every n and colour; the real formula; what is refused. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "../golden.h"
#include "glint_specular.h"

enum {
    ONE = 262144 /* 1.0 in every format with 18 fraction bits */
};

typedef struct vector {
    glint_gate gate;
    glint_material material;
    uint32_t cosine;
    glint_specular_values expected;
} vector;

#define WHITE 255, 255, 255

/* Values in the order of glint_specular_values: reg1, rom33, rom9, adder6, mul7, adder8, mul10,
 * sat10, cmp11, keys12, mul13, mul14, mul15. */
static const vector vectors[] = {
    /* n = 2, σ = 1: t is the cosine itself. 1/4 of 255, 100, 2: 63.75, 25, 0.5. */
    {GLINT_GATE_COSINE,
     {2, 255, 100, 2},
     131072,
     {131072, 8192, 0, -131072, -131072, 131072, 65536, 65536, 1, 65536, 64, 25, 1}},
    {GLINT_GATE_SIGN,
     {2, 255, 100, 2},
     131072,
     {131072, 8192, 0, -131072, -131072, 131072, 65536, 65536, 1, 65536, 64, 25, 1}},
    {GLINT_GATE_DRAWN,
     {2, 255, 100, 2},
     131072,
     {131072, 8192, 514, -131072, -131072, 131072, 65536, 65536, 1, 65536, 64, 25, 1}},
    /* n = 5, σ = 2, at its edge, cosine 1/2: t is 0. Inside for the first two, not for the third.
     */
    {GLINT_GATE_COSINE,
     {5, WHITE},
     131072,
     {131072, 16384, 131072, -131072, -ONE, 0, 0, 0, 1, 0, 0, 0, 0}},
    {GLINT_GATE_SIGN,
     {5, WHITE},
     131072,
     {131072, 16384, 0, -131072, -ONE, 0, 0, 0, 1, 0, 0, 0, 0}},
    {GLINT_GATE_DRAWN,
     {5, WHITE},
     131072,
     {131072, 16384, 514, -131072, -ONE, 0, 0, 0, 0, 0, 0, 0, 0}},
    /* A code below: t = −2 ulp, whose low bits squared are no W; the gate closes. */
    {GLINT_GATE_COSINE,
     {5, WHITE},
     131071,
     {131071, 16384, 131072, -131073, -262146, -2, 524280, 524280, 0, 0, 0, 0, 0}},
    {GLINT_GATE_SIGN,
     {5, WHITE},
     131071,
     {131071, 16384, 0, -131073, -262146, -2, 524280, 524280, 0, 0, 0, 0, 0}},
    {GLINT_GATE_DRAWN,
     {5, WHITE},
     131071,
     {131071, 16384, 514, -131073, -262146, -2, 0, 0, 0, 0, 0, 0, 0}},
    /* Cosine 0: t = −1. As drawn, the back lobe passes with W = 1. */
    {GLINT_GATE_COSINE,
     {5, WHITE},
     0,
     {0, 16384, 131072, -ONE, -2 * ONE, -ONE, ONE, ONE, 0, 0, 0, 0, 0}},
    {GLINT_GATE_DRAWN,
     {5, 9, 8, 7},
     0,
     {0, 16384, 514, -ONE, -2 * ONE, -ONE, ONE, ONE, 1, ONE, 9, 8, 7}},
    /* As drawn, the widest square there is saturates to 1. */
    {GLINT_GATE_DRAWN,
     {1023, 255, 128, 1},
     0,
     {0, 2796203, 514, -ONE, -89478496, -89216352, UINT64_C(30363302094), ONE, 1, ONE, 255, 128,
      1}},
    /* n = 60, cosine 1 − 2^−5: σ·2^−5 is 166571 ulps exactly; 34.39+½, 25.25+½, 14.62+½. */
    {GLINT_GATE_COSINE,
     {60, 255, 190, 110},
     253952,
     {253952, 166571, 249252, -8192, -166571, 95573, 34844, 34844, 1, 34844, 34, 25, 15}},
    /* A code above 1.0 saturates. */
    {GLINT_GATE_COSINE,
     {60, 255, 190, 110},
     ONE + 1000,
     {ONE, 166571, 249252, 0, 0, ONE, ONE, ONE, 1, ONE, 255, 190, 110}},
    {GLINT_GATE_SIGN,
     {0, 255, 190, 110},
     GLINT_COS_CODE_MAX,
     {ONE, 2731, 0, 0, 0, ONE, ONE, ONE, 1, ONE, 255, 190, 110}},
    {GLINT_GATE_DRAWN,
     {1000, 255, 190, 110},
     ONE + 1,
     {ONE, 2733397, 514, 0, 0, ONE, ONE, ONE, 1, ONE, 255, 190, 110}},
};

static void assert_values(const vector *v, const glint_specular_values *found)
{
    const glint_specular_values *e = &v->expected;
    assert_int_equal(found->reg1, e->reg1);
    assert_int_equal(found->rom33, e->rom33);
    assert_int_equal(found->rom9, e->rom9);
    assert_int_equal(found->adder6, e->adder6);
    assert_int_equal(found->mul7, e->mul7);
    assert_int_equal(found->adder8, e->adder8);
    assert_true(found->mul10 == e->mul10);
    assert_int_equal(found->sat10, e->sat10);
    assert_int_equal(found->cmp11, e->cmp11);
    assert_int_equal(found->keys12, e->keys12);
    assert_int_equal(found->mul13, e->mul13);
    assert_int_equal(found->mul14, e->mul14);
    assert_int_equal(found->mul15, e->mul15);
}

static void vectors_by_hand(void **state)
{
    (void)state;
    glint_specular_values found;
    for (size_t i = 0; i < sizeof vectors / sizeof vectors[0]; i++) {
        const vector *v = &vectors[i];
        assert_int_equal(glint_specular_eval(v->gate, &v->material, v->cosine, &found), GLINT_OK);
        assert_values(v, &found);
    }
}

/* W(cos γ = 1) is exactly 1, so every colour passes unchanged for every n and gate. */
static void the_centre_passes_every_colour(void **state)
{
    (void)state;
    glint_specular_values v;
    unsigned points = 0;
    for (int gate = 0; gate < GLINT_GATE_COUNT; gate++) {
        for (unsigned n = 0; n <= 1023; n++) {
            for (unsigned color = 0; color <= 255; color++) {
                const glint_material material = {(uint16_t)n, (uint8_t)color,
                                                 (uint8_t)(255 - color), (uint8_t)(color ^ 85)};
                assert_int_equal(glint_specular_eval((glint_gate)gate, &material, ONE, &v),
                                 GLINT_OK);
                if (v.keys12 != ONE || v.mul13 != material.r || v.mul14 != material.g ||
                    v.mul15 != material.b) {
                    fail_msg("gate %d, n %u: W %u, %d %d %d from %d %d %d", gate, n, v.keys12,
                             v.mul13, v.mul14, v.mul15, material.r, material.g, material.b);
                }
                points++;
            }
        }
    }
    assert_int_equal(points, 3 * 1024 * 256);
}

static void codes_above_one_are_the_centre(void **state)
{
    (void)state;
    glint_specular_values at_one;
    glint_specular_values above;
    for (int gate = 0; gate < GLINT_GATE_COUNT; gate++) {
        const glint_material material = {300, 120, 200, 255};
        assert_int_equal(glint_specular_eval((glint_gate)gate, &material, ONE, &at_one), GLINT_OK);
        for (uint32_t code = ONE + 1; code <= GLINT_COS_CODE_MAX; code += 257) {
            /* Padding is compared too, so it must start out the same. */
            above = at_one;
            memset(&above.mul13, 0, 3);
            assert_int_equal(glint_specular_eval((glint_gate)gate, &material, code, &above),
                             GLINT_OK);
            assert_int_equal(above.reg1, ONE);
            assert_int_equal(above.keys12, at_one.keys12);
            assert_int_equal(above.mul13, at_one.mul13);
            assert_int_equal(above.mul14, at_one.mul14);
            assert_int_equal(above.mul15, at_one.mul15);
        }
    }
}

static void bad_arguments_are_refused(void **state)
{
    (void)state;
    const glint_material good = {1023, WHITE};
    const glint_material bad = {1024, WHITE};
    const glint_material worse = {65535, WHITE};
    glint_specular_values v;
    memset(&v, 0x5a, sizeof v);
    const glint_specular_values untouched = v;
    assert_int_equal(glint_specular_eval(GLINT_GATE_COUNT, &good, 0, &v), GLINT_BAD_ARGUMENT);
    assert_int_equal(glint_specular_eval((glint_gate)-1, &good, 0, &v), GLINT_BAD_ARGUMENT);
    assert_int_equal(glint_specular_eval(GLINT_GATE_SIGN, &bad, 0, &v), GLINT_BAD_ARGUMENT);
    assert_int_equal(glint_specular_eval(GLINT_GATE_SIGN, &worse, 0, &v), GLINT_BAD_ARGUMENT);
    assert_int_equal(glint_specular_eval(GLINT_GATE_SIGN, &good, 2 * ONE, &v), GLINT_BAD_ARGUMENT);
    assert_int_equal(glint_specular_eval(GLINT_GATE_SIGN, &good, UINT32_MAX, &v),
                     GLINT_BAD_ARGUMENT);
    assert_memory_equal(&v, &untouched, sizeof v);
    assert_int_equal(glint_specular_eval(GLINT_GATE_SIGN, &good, 2 * ONE - 1, &v), GLINT_OK);
}

static void cosine_codes_round_half_up_and_clamp(void **state)
{
    (void)state;
    const double ulp = 1.0 / ONE;
    assert_int_equal(glint_cos_code(0.0), 0);
    assert_int_equal(glint_cos_code(-0.0), 0);
    assert_int_equal(glint_cos_code(-1.0), 0);
    assert_int_equal(glint_cos_code(-INFINITY), 0);
    assert_int_equal(glint_cos_code(NAN), 0);
    assert_int_equal(glint_cos_code(0.5), 131072);
    assert_int_equal(glint_cos_code(0.5 * ulp), 1);
    assert_int_equal(glint_cos_code(nextafter(0.5 * ulp, 0.0)), 0);
    assert_int_equal(glint_cos_code(1.5 * ulp), 2);
    assert_int_equal(glint_cos_code(1.0 - ulp), ONE - 1);
    assert_int_equal(glint_cos_code(1.0 - 0.5 * ulp), ONE);
    assert_int_equal(glint_cos_code(1.0), ONE);
    assert_int_equal(glint_cos_code(1.5), ONE);
    assert_int_equal(glint_cos_code(INFINITY), ONE);
    for (uint32_t code = 0; code <= ONE; code++)
        assert_int_equal(glint_cos_code(code * ulp), code);
}

static void assert_real(glint_gate gate, uint32_t n, uint32_t cosine, double expected)
{
    const double found = glint_specular_real(gate, n, cosine);
    if (!(fabs(found - expected) <= 1e-14)) {
        fail_msg("gate %d, n %u, code %u: %.17g, expected %.17g", (int)gate, n, cosine, found,
                 expected);
    }
}

static void the_real_formula_at_points_known_by_hand(void **state)
{
    (void)state;
    assert_real(GLINT_GATE_COSINE, 2, 131072, 0.25);
    assert_real(GLINT_GATE_SIGN, 2, 65536, 0.0625);
    assert_real(GLINT_GATE_COSINE, 0, 0, 4.0 / 9.0);
    assert_real(GLINT_GATE_COSINE, 1, 0, 1.0 / 9.0);
    assert_real(GLINT_GATE_COSINE, 5, 131072, 0.0);
    assert_real(GLINT_GATE_COSINE, 5, 0, 0.0);
    assert_real(GLINT_GATE_SIGN, 5, 131071, 0.0);
    assert_real(GLINT_GATE_DRAWN, 5, 0, 1.0);      /* the back lobe */
    assert_real(GLINT_GATE_DRAWN, 8, 0, 1.0);      /* t² = 4, saturated */
    assert_real(GLINT_GATE_DRAWN, 5, 131072, 0.0); /* below half a step */
    assert_real(GLINT_GATE_DRAWN, 5, 131072 + 8192, 1.0 / 256.0);
    assert_real(GLINT_GATE_DRAWN, 5, 131072 + 4096, 0.0); /* 1/1024 < 1/510 */
    assert_real(GLINT_GATE_COSINE, 5, 131072 + 4096, 1.0 / 1024.0);
    assert_real(GLINT_GATE_COSINE, 1000, ONE, 1.0);
    assert_real(GLINT_GATE_COSINE, 1000, ONE + 5, 1.0); /* saturated as the device does */
}

/* ---- The real formula in whole numbers
 * ----------------------------------------------------------- t = ((n+1)(c − 1) + 3)/3 with c =
 * code/2^18 is m/(3·2^18), m a whole number; so W ≥ 1/510, half a step of the eight bits of a
 * colour, is 510·m² ≥ (3·2^18)², and t ≥ 0 is m ≥ 0. */

enum { T_ONE = 3 * ONE };

static int64_t whole_t(uint32_t n, uint32_t code)
{
    return ((int64_t)n + 1) * ((int64_t)code - ONE) + T_ONE;
}

static double exact_w(glint_gate gate, int64_t t)
{
    const int64_t size = t < 0 ? -t : t;
    const double w = (double)size / T_ONE * ((double)size / T_ONE);
    if (gate != GLINT_GATE_DRAWN)
        return t < 0 ? 0.0 : w;
    if (size > T_ONE)
        return 1.0;
    return 510 * size * size >= (int64_t)T_ONE * T_ONE ? w : 0.0;
}

static void assert_real_w(glint_gate gate, uint32_t n, uint32_t code)
{
    const double expected = exact_w(gate, whole_t(n, code));
    const double found = glint_specular_real(gate, n, code);
    /* What is shut out is 0, and what is not is not. */
    if ((found == 0.0) != (expected == 0.0) || !(fabs(found - expected) <= 1e-13)) {
        fail_msg("gate %d, n %u, code %u: %.17g, expected %.17g", (int)gate, n, code, found,
                 expected);
    }
}

/* The codes around the one at which t is `least`, a real number. */
static void assert_real_about(glint_gate gate, uint32_t n, double least)
{
    const double code = ONE + (least - 1.0) * T_ONE / (n + 1.0);
    for (int i = -3; i <= 4; i++) {
        const double at = floor(code) + i;
        if (at >= 0 && at <= ONE)
            assert_real_w(gate, n, (uint32_t)at);
    }
}

/* Where each gate begins and ends to shut out, in the highlight and in the back lobe, of every n;
 * and all over the domain. */
static void the_real_limits_are_exact(void **state)
{
    (void)state;
    const double half_step = sqrt(1.0 / 510.0);
    for (uint32_t n = 0; n <= GLINT_N_MAX; n++) {
        for (int gate = 0; gate < GLINT_GATE_COUNT; gate++) {
            assert_real_about((glint_gate)gate, n, half_step);
            assert_real_about((glint_gate)gate, n, -half_step);
            assert_real_about((glint_gate)gate, n, -1.0);
            if (n > 2 && gate != GLINT_GATE_DRAWN) {
                /* t = 0 itself is let through, as 0. */
                const uint32_t edge = ONE - T_ONE / (n + 1);
                for (uint32_t code = edge - 2; code <= edge + 2; code++) {
                    const double found = glint_specular_real((glint_gate)gate, n, code);
                    assert_true((found != 0.0) == (whole_t(n, code) > 0));
                }
            }
            for (uint32_t code = n % 499; code <= ONE; code += 499) {
                assert_true(fabs(glint_specular_real((glint_gate)gate, n, code) -
                                 exact_w((glint_gate)gate, whole_t(n, code))) <= 1e-12);
            }
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(vectors_by_hand),
        cmocka_unit_test(the_centre_passes_every_colour),
        cmocka_unit_test(codes_above_one_are_the_centre),
        cmocka_unit_test(bad_arguments_are_refused),
        cmocka_unit_test(cosine_codes_round_half_up_and_clamp),
        cmocka_unit_test(the_real_formula_at_points_known_by_hand),
        cmocka_unit_test(the_real_limits_are_exact),
    };
    return golden_run_group_tests(tests, NULL, NULL);
}
