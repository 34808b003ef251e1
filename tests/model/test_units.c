/* The highlight units as functions: each against its own formula in floating point, the power
 * device against cosⁿ, its tables against a tie, and its batch against its blocks.
 *
 * Every n with every 211th code, and the ends. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

#include "glint.h"
#include "glint_rivals.h"

enum { STEP = 211 };

/* What a unit may differ by, in 1/255 of W: from its own formula, and from cosⁿ for n = 1…1000. */
typedef struct bound {
    const glint_unit *unit;
    int variant;
    double own, power;
    uint32_t falls; /* last places that W may fall by where it should rise */
} bound;

static const bound bounds[] = {
    {&glint_unit_power, GLINT_POWER_HALF, 0.5, 0.5, 0},
    {&glint_unit_power, GLINT_POWER_QUARTER, 0.25, 0.25, 0},
    {&glint_unit_lyon, 0, 0.014, 81, 0},
    {&glint_unit_lyon, 1, 0.028, 88, 0},
    {&glint_unit_schlick, 0, 0.0623, 52, 0}, /* one last place, cut off */
    {&glint_unit_newton, 0, 0.04, 52, 0},
    {&glint_unit_log2, 0, 0.5, 0.5, 0},
    {&glint_unit_quadratic, 0, 0.005, 72, 0},
    {&glint_unit_bipartite, 0, 0.43, 0.43, 1},
    {&glint_unit_bipartite, 1, 0.43, 0.43, 1},
    {&glint_unit_bipartite, 2, 0.43, 0.43, 1},
};
enum { UNITS = sizeof bounds / sizeof bounds[0] };

static uint32_t w_of(const bound *of, uint32_t n, uint32_t code)
{
    uint32_t w = 0;
    assert_int_equal(glint_unit_eval(of->unit, of->variant, n, code, NULL, &w), GLINT_OK);
    return w;
}

/* Whether W is to be cosⁿ of this n. */
static int is_for(const bound *of, uint32_t n)
{
    return of->unit->fixed_n != NULL ? n == of->unit->fixed_n(of->variant) : n >= 1 && n <= 1000;
}

static void check_point(const bound *of, uint32_t n, uint32_t code, uint32_t w)
{
    const double one = 1 << of->unit->w_frac_bits(of->variant);
    const double own = of->unit->real(of->variant, n, code);
    if (fabs(w / one - own) * 255 > of->own)
        fail_msg("n = %u, code %u: W = %u of %.0f, by its formula %.6f", n, code, w, one, own);
    const double power = glint_power_real(n, code);
    if (is_for(of, n) && fabs(w / one - power) * 255 > of->power)
        fail_msg("n = %u, code %u: W = %u of %.0f, the power is %.6f", n, code, w, one, power);
}

/* Within its bounds, rising with the cosine, 1 at 1. */
static void check_unit(const bound *of)
{
    for (uint32_t n = 0; n <= GLINT_N_MAX; n++) {
        uint32_t before = 0;
        for (uint32_t code = 0; code <= GLINT_COS_ONE; code += STEP) {
            const uint32_t w = w_of(of, n, code);
            check_point(of, n, code, w);
            if (w + of->falls < before)
                fail_msg("n = %u, code %u: W = %u falls from %u", n, code, w, before);
            before = w;
        }
        assert_int_equal(w_of(of, n, GLINT_COS_ONE), 1 << of->unit->w_frac_bits(of->variant));
        assert_int_equal(w_of(of, n, GLINT_COS_CODE_MAX), w_of(of, n, GLINT_COS_ONE));
    }
}

static void test_bounds(void **state)
{
    (void)state;
    for (int i = 0; i < UNITS; i++)
        check_unit(&bounds[i]);
}

/* With places of W rounded off it still rises, is 1 at 1, and is half a last place further off. */
static void check_rounded(const bound *of, int drop)
{
    enum { COUNT = GLINT_COS_ONE / STEP + 2 };
    static uint32_t code[COUNT], w[COUNT];
    static uint8_t r[COUNT], g[COUNT], b[COUNT];
    const glint_unit_config config = {.unit = of->unit, .variant = of->variant, .w_drop = drop};
    const double one = 1 << glint_unit_w_frac_bits(&config);
    assert_true(one == ldexp(1, of->unit->w_frac_bits(of->variant) - drop));
    for (uint32_t i = 0; i < COUNT; i++)
        code[i] = i + 1 < COUNT ? i * STEP : GLINT_COS_ONE;
    for (uint32_t n = 0; n <= GLINT_N_MAX; n += 33) {
        const glint_material material = {(uint16_t)n, 255, 3, 200};
        assert_int_equal(glint_unit_batch(&config, &material, code, COUNT, w, r, g, b), GLINT_OK);
        for (uint32_t i = 0; i < COUNT; i++) {
            const double own = of->unit->real(of->variant, n, code[i]);
            assert_true(fabs(w[i] / one - own) * 255 <= of->own + 255 * 0.5 / one);
            assert_true(i == 0 || w[i] + of->falls >= w[i - 1]);
            assert_int_equal(g[i], (int)floor(w[i] * 3 / one + 0.5));
        }
        assert_true(w[COUNT - 1] == one && r[COUNT - 1] == 255 && b[COUNT - 1] == 200);
    }
}

static void test_rounded(void **state)
{
    (void)state;
    for (int i = 0; i < UNITS; i++)
        for (int drop = 0; drop <= 4; drop++)
            check_rounded(&bounds[i], drop);
}

/* An error is an error: a bound that a right unit does not keep is noticed. */
static void test_bounds_are_tight(void **state)
{
    (void)state;
    for (int i = 0; i < UNITS; i++) {
        double worst = 0;
        const double one = 1 << bounds[i].unit->w_frac_bits(bounds[i].variant);
        for (uint32_t n = 1; n <= 1000; n++)
            for (uint32_t code = 0; is_for(&bounds[i], n) && code <= GLINT_COS_ONE; code += STEP)
                worst =
                    fmax(worst, fabs(w_of(&bounds[i], n, code) / one - glint_power_real(n, code)));
        assert_true(worst * 255 > bounds[i].power / 2);
    }
}

static void test_power_batch(void **state)
{
    (void)state;
    enum { COUNT = GLINT_COS_CODE_MAX / 97 + 1 };
    static uint32_t code[COUNT], w[COUNT];
    static uint8_t r[COUNT], g[COUNT], b[COUNT];
    for (uint32_t i = 0; i < COUNT; i++)
        code[i] = i * 97;
    for (int a = 0; a < GLINT_POWER_ACCURACY_COUNT; a++)
        for (uint32_t n = 0; n <= GLINT_N_MAX; n += 31) {
            const glint_material material = {(uint16_t)n, 255, (uint8_t)(3 * n), (uint8_t)n};
            const glint_power_accuracy accuracy = (glint_power_accuracy)a;
            assert_int_equal(glint_power_batch(accuracy, &material, code, COUNT, w, r, g, b),
                             GLINT_OK);
            for (uint32_t i = 0; i < COUNT; i++) {
                glint_power_values values;
                assert_int_equal(glint_power_eval(accuracy, &material, code[i], &values), GLINT_OK);
                assert_int_equal(w[i], values.keys12);
                assert_int_equal(r[i], values.mul13);
                assert_int_equal(g[i], values.mul14);
                assert_int_equal(b[i], values.mul15);
            }
        }
}

/* So far from a tie that no libm decides it otherwise. */
static void check_entry(double exact, uint32_t entry)
{
    assert_true(fabs(exact - entry) < 0.4999999);
}

static void test_power_tables(void **state)
{
    (void)state;
    for (int a = 0; a < GLINT_POWER_ACCURACY_COUNT; a++) {
        const glint_power_accuracy accuracy = (glint_power_accuracy)a;
        const uint32_t count = 1u << GLINT_POWER_TABLE_BITS(accuracy);
        for (uint32_t i = 0; i < count; i++) {
            const long double x = (i + 0.5L) / count;
            check_entry((double)(-log2l(1 - x) / x * count), glint_power_rom9(accuracy, i));
            check_entry(
                (double)(exp2l(-(long double)i / count) * (1 << GLINT_POWER_W_FRAC_BITS(accuracy))),
                glint_power_rom33(accuracy, i));
        }
    }
}

static void test_out_of_range(void **state)
{
    (void)state;
    uint32_t w;
    glint_unit_device *device;
    for (int i = 0; i < UNITS; i++) {
        const glint_unit *unit = bounds[i].unit;
        assert_int_equal(glint_unit_eval(unit, unit->variants, 1, 1, NULL, &w), GLINT_BAD_ARGUMENT);
        assert_int_equal(glint_unit_eval(unit, 0, GLINT_N_COUNT, 1, NULL, &w), GLINT_BAD_ARGUMENT);
        assert_int_equal(glint_unit_eval(unit, 0, 1, GLINT_COS_CODE_MAX + 1, NULL, &w),
                         GLINT_BAD_ARGUMENT);
        glint_unit_config config = {.unit = unit, .pipeline = GLINT_PIPELINE_PIPELINED};
        assert_int_equal(glint_unit_device_create(&config, &device), GLINT_BAD_ARGUMENT);
        assert_null(device);
        config.lanes = 1;
        config.w_drop = unit->w_frac_bits(0) - GLINT_UNIT_W_FRAC_MIN + 1;
        assert_int_equal(glint_unit_device_create(&config, &device), GLINT_BAD_ARGUMENT);
        assert_null(device);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_bounds),           cmocka_unit_test(test_rounded),
        cmocka_unit_test(test_bounds_are_tight), cmocka_unit_test(test_power_batch),
        cmocka_unit_test(test_power_tables),     cmocka_unit_test(test_out_of_range),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
