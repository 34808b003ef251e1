/* The divider as a pure function: its table and its quotients against integer arithmetic of the
 * test's own, the numbers of the thesis, the division identity, the last pixel of a span. */
#define _XOPEN_SOURCE 700

#include <inttypes.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

#include "../record.h"
#include "glint_divider.h"

enum {
    N_FIRST = 6,
    N_LAST = 16,
    K_TABLE = 16, /* the table holds 1…16 */
    K_COUNT = 256,
    D_MAX = 255,
    D_COUNT = 2 * D_MAX + 1
};

static int32_t divide(int n, int32_t difference, uint32_t k)
{
    int32_t quotient = INT32_MIN;
    bool out_of_table = true;
    assert_int_equal(glint_divide(n, difference, k, &quotient, &out_of_table), GLINT_OK);
    assert_int_equal(out_of_table, k == 0 || k > K_TABLE);
    return quotient;
}

/* ---- The table ----------------------------------------------------------------------------------
 */

static void the_ranges_are_as_stated(void **state)
{
    (void)state;
    assert_int_equal(GLINT_DIVIDER_SHIFTS_MIN, N_FIRST);
    assert_int_equal(GLINT_DIVIDER_SHIFTS_MAX, N_LAST);
    assert_int_equal(GLINT_DIVIDER_K_MAX, K_TABLE);
    assert_int_equal(1 << GLINT_DIVIDER_K_BITS, K_COUNT);
    assert_int_equal(GLINT_DIVIDER_DIFFERENCE_MAX, D_MAX);
    assert_true(D_MAX < 1 << (GLINT_DIVIDER_DIFFERENCE_BITS - 1));
}

/* b is the nearest of 2ⁿ/k, half up, if and only if b − 1/2 ≤ 2ⁿ/k < b + 1/2: no division, no
 * rounding in this test. */
static void the_table_is_the_nearest_of_the_reciprocal(void **state)
{
    (void)state;
    int entries = 0;
    for (int n = N_FIRST; n <= N_LAST; n++) {
        for (uint32_t k = 0; k < K_COUNT; k++) {
            const int64_t b = glint_divider_bits(n, k);
            assert_int_equal(glint_divider_in_table(k), k >= 1 && k <= K_TABLE);
            if (k == 0 || k > K_TABLE) {
                assert_int_equal(b, 0);
                continue;
            }
            const int64_t twice = INT64_C(2) << n;
            if (!((2 * b - 1) * (int64_t)k <= twice && twice < (2 * b + 1) * (int64_t)k))
                fail_msg("n = %d, k = %u: %" PRId64 " is not the nearest", n, k, b);
            entries++;
        }
    }
    print_message("%d entries\n", entries);
    assert_int_equal(entries, 11 * 16);
    assert_false(glint_divider_in_table(UINT32_MAX));
    assert_int_equal(glint_divider_bits(8, UINT32_MAX), 0);
}

/* 9/64 for a seventh with six shifts; the six-bit row from paper. */
static void the_table_has_the_entries_of_the_thesis(void **state)
{
    (void)state;
    static const uint32_t six[] = {0, 64, 32, 21, 16, 13, 11, 9, 8, 7, 6, 6, 5, 5, 5, 4, 4, 0};
    for (uint32_t k = 0; k < sizeof six / sizeof six[0]; k++)
        assert_int_equal(glint_divider_bits(6, k), six[k]);
    assert_int_equal(divide(6, 1, 7), 9);
}

/* i₀, of weight 1, is set only for k = 1, and then it is the only bit. */
static void the_bit_of_weight_one_is_for_one_alone(void **state)
{
    (void)state;
    for (int n = N_FIRST; n <= N_LAST; n++) {
        for (uint32_t k = 0; k < K_COUNT; k++) {
            const uint32_t bits = glint_divider_bits(n, k);
            assert_int_equal(bits >> n, k == 1);
            if (k == 1)
                assert_int_equal(bits, 1 << n);
        }
        for (int d = -D_MAX; d <= D_MAX; d++)
            assert_int_equal(divide(n, d, 1), d * (1 << n));
    }
}

/* n = 8, k = 2…16: the largest error for a difference of 255 is 0.4427, at k = 9; the relative
 * error is 0.807 % in the mean. (A table that truncates would have 0.69.) */
static void the_errors_are_those_of_the_thesis(void **state)
{
    (void)state;
    double largest = 0;
    double truncated = 0;
    double relative = 0;
    uint32_t worst = 0;
    for (uint32_t k = 2; k <= K_TABLE; k++) {
        const double exact = 255.0 / k;
        const double error = fabs(divide(8, 255, k) / 256.0 - exact);
        if (error > largest) {
            largest = error;
            worst = k;
        }
        relative += error / exact / 15;
        truncated = fmax(truncated, exact - 255.0 * (256 / k) / 256.0);
    }
    print_message("largest %.5f at k = %u, mean %.4f %%, truncated %.4f\n", largest, worst,
                  relative * 100, truncated);
    assert_int_equal(worst, 9);
    assert_true(fabs(largest - 0.4427) < 0.00005);
    assert_true(fabs(relative - 0.00807) < 0.000005);
    assert_true(fabs(truncated - 0.69) < 0.005);
}

/* ---- The quotient -------------------------------------------------------------------------------
 */

/* A wide register holds the difference with n fraction bits, and is halved once a bit; a term that
 * loses something would be odd before its halving. */
static int64_t sum_by_shifting(int n, uint32_t bits, int difference)
{
    int64_t shift_register = difference;
    int64_t sum = 0;
    for (int j = 0; j < n; j++)
        shift_register *= 2;
    for (int j = 0; j <= n; j++) {
        if (j > 0) {
            assert_true(shift_register % 2 == 0);
            shift_register /= 2;
        }
        if ((bits & 1u << (n - j)) != 0)
            sum += shift_register;
    }
    return sum;
}

static void the_quotient_is_the_sum_of_the_terms(void **state)
{
    (void)state;
    uint64_t sums = 0;
    for (int n = N_FIRST; n <= N_LAST; n++) {
        for (uint32_t k = 0; k <= K_TABLE + 1; k++) {
            const uint32_t bits = glint_divider_bits(n, k);
            for (int d = -D_MAX; d <= D_MAX; d++) {
                if (divide(n, d, k) != sum_by_shifting(n, bits, d))
                    fail_msg("n = %d: %d/%u is not the sum of its terms", n, d, k);
                sums++;
            }
        }
    }
    print_message("%" PRIu64 " quotients\n", sums);
    assert_true(sums == 11 * 18 * D_COUNT);
}

/* |q − D/k| ≤ |D|/2ⁿ⁺¹, multiplied by 2ⁿ⁺¹·k: integers only. How much of the bound is used shows
 * that it is tight. */
static void the_division_identity_holds(void **state)
{
    (void)state;
    const double begin = child_seconds();
    uint64_t quotients = 0;
    for (int n = N_FIRST; n <= N_LAST; n++) {
        double used = 0;
        for (int64_t k = 1; k <= K_TABLE; k++) {
            for (int64_t d = -D_MAX; d <= D_MAX; d++) {
                const int64_t q = divide(n, (int32_t)d, (uint32_t)k);
                const int64_t error = 2 * llabs(q * k - d * (INT64_C(1) << n));
                if (error > llabs(d) * k)
                    fail_msg("n = %d: %" PRId64 "/%" PRId64 " is outside the bound", n, d, k);
                if (d != 0)
                    used = fmax(used, (double)error / (double)(llabs(d) * k));
                quotients++;
            }
        }
        print_message("n = %2d: %.3f of the bound used\n", n, used);
        assert_true(used > 0.5 && used <= 1.0);
    }
    print_message("%" PRIu64 " quotients within |D|/2^(n+1)\n", quotients);
    assert_true(quotients == 11 * 16 * D_COUNT);
    record("model-2-divider", "C model: every quotient within |D|/2^(n+1) of the rational",
           "exact integers, whole domain", quotients, "quotients", child_seconds() - begin);
}

/* A power of two divides without error, and no sign is preferred. */
static void powers_of_two_are_exact_and_signs_mirror(void **state)
{
    (void)state;
    for (int n = N_FIRST; n <= N_LAST; n++) {
        for (int d = -D_MAX; d <= D_MAX; d++) {
            for (uint32_t shift = 0; shift <= 4; shift++)
                assert_int_equal(divide(n, d, 1u << shift) * (1 << shift), d * (1 << n));
            for (uint32_t k = 0; k <= K_TABLE; k++)
                assert_int_equal(divide(n, -d, k), -divide(n, d, k));
        }
    }
}

/* k = 0 and lengths beyond the table are flagged for every difference. */
static void out_of_the_table_is_flagged(void **state)
{
    (void)state;
    for (int n = N_FIRST; n <= N_LAST; n++) {
        for (uint32_t k = 0; k < K_COUNT; k += k == 0 ? K_TABLE + 1 : 1)
            for (int d = -D_MAX; d <= D_MAX; d += 5)
                assert_int_equal(divide(n, d, k), 0);
    }
}

/* k·|q − D/k| ≤ 1/2 at the last pixel, times 2ⁿ⁺¹: integers only. */
static bool last_pixels_are_within_half_a_level(int n, int64_t *worst)
{
    *worst = 0;
    for (int64_t k = 1; k <= K_TABLE; k++) {
        for (int64_t d = -D_MAX; d <= D_MAX; d++) {
            const int64_t error =
                llabs(divide(n, (int32_t)d, (uint32_t)k) * k - d * (INT64_C(1) << n));
            *worst = error > *worst ? error : *worst;
        }
    }
    return 2 * *worst <= INT64_C(1) << n;
}

static void the_last_pixel_is_within_half_a_level(void **state)
{
    (void)state;
    for (int n = N_FIRST; n <= N_LAST; n++) {
        int64_t worst;
        const bool within = last_pixels_are_within_half_a_level(n, &worst);
        print_message("n = %2d: the last pixel is off by %.4f levels at most\n", n,
                      (double)worst / (double)(1 << n));
        assert_int_equal(within, n >= 12);
    }
    assert_int_equal(GLINT_DIVIDER_SHIFTS_DEFAULT, 12);
}

/* ---- Arguments and the batch --------------------------------------------------------------------
 */

static void bad_arguments_are_refused(void **state)
{
    (void)state;
    static const struct {
        int shifts;
        int32_t difference;
        uint32_t k;
    } bad[] = {
        {5, 1, 1},          {17, 1, 1},         {0, 1, 1},        {-1, 1, 1},
        {INT32_MAX, 1, 1},  {INT32_MIN, 1, 1},  {12, 256, 1},     {12, -256, 1},
        {12, INT32_MAX, 1}, {12, INT32_MIN, 1}, {12, 1, K_COUNT}, {12, 1, UINT32_MAX},
    };
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        int32_t quotient = 0;
        bool out_of_table = false;
        assert_int_equal(
            glint_divide(bad[i].shifts, bad[i].difference, bad[i].k, &quotient, &out_of_table),
            GLINT_BAD_ARGUMENT);
    }
    static const int shifts[] = {5, 17, 0, -1, INT32_MAX, INT32_MIN};
    const glint_division division = {{1, 2, 3}, 1};
    for (size_t i = 0; i < sizeof shifts / sizeof shifts[0]; i++) {
        glint_quotients quotients = {{77, 77, 77}, false};
        assert_int_equal(glint_divide_batch(shifts[i], &division, 1, &quotients),
                         GLINT_BAD_ARGUMENT);
        assert_int_equal(quotients.code[0], 77);
    }
}

/* Every k that the pins can carry, every difference in every component. */
static void the_batch_is_the_single_division(void **state)
{
    (void)state;
    static glint_division divisions[D_COUNT];
    static glint_quotients quotients[D_COUNT];
    uint64_t compared = 0;
    for (int n = N_FIRST; n <= N_LAST; n++) {
        for (uint32_t k = 0; k < K_COUNT; k++) {
            for (int i = 0; i < D_COUNT; i++) {
                divisions[i].k = (uint8_t)k;
                for (int c = 0; c < GLINT_DIVIDER_COMPONENTS; c++)
                    divisions[i].difference[c] = (int16_t)((i + 170 * c) % D_COUNT - D_MAX);
            }
            assert_int_equal(glint_divide_batch(n, divisions, D_COUNT, quotients), GLINT_OK);
            for (int i = 0; i < D_COUNT; i++) {
                assert_true(quotients[i].out_of_table == (k == 0 || k > K_TABLE));
                for (int c = 0; c < GLINT_DIVIDER_COMPONENTS; c++) {
                    assert_true(quotients[i].code[c] == divide(n, divisions[i].difference[c], k));
                    compared++;
                }
            }
        }
    }
    print_message("%" PRIu64 " quotients\n", compared);
    assert_true(compared == UINT64_C(11) * K_COUNT * D_COUNT * 3);
    assert_int_equal(glint_divide_batch(12, NULL, 0, NULL), GLINT_OK);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_ranges_are_as_stated),
        cmocka_unit_test(the_table_is_the_nearest_of_the_reciprocal),
        cmocka_unit_test(the_table_has_the_entries_of_the_thesis),
        cmocka_unit_test(the_bit_of_weight_one_is_for_one_alone),
        cmocka_unit_test(the_errors_are_those_of_the_thesis),
        cmocka_unit_test(the_quotient_is_the_sum_of_the_terms),
        cmocka_unit_test(the_division_identity_holds),
        cmocka_unit_test(powers_of_two_are_exact_and_signs_mirror),
        cmocka_unit_test(out_of_the_table_is_flagged),
        cmocka_unit_test(the_last_pixel_is_within_half_a_level),
        cmocka_unit_test(bad_arguments_are_refused),
        cmocka_unit_test(the_batch_is_the_single_division),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
