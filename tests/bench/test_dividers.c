/* The bench of divisions: its own loops divide right, and its figures belong together. */
#define _POSIX_C_SOURCE 200809L

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <time.h>

#include <cmocka.h>

#include "bench/bench.h"
#include "bench/kernels.h"
#include "bench/rounds.h"

static void the_machine_divides_every_difference(void **state)
{
    (void)state;
    for (int difference = -255; difference <= 255; difference++) {
        glint_division divisions[16];
        glint_quotients quotients[16];
        float differences[16], lengths[16], scalar[16], vector[16];
        for (int i = 0; i < 16; i++) {
            const int16_t d = (int16_t)difference;
            divisions[i] = (glint_division){{d, 0, (int16_t)-d}, (uint8_t)(i + 1)};
            differences[i] = (float)difference;
            lengths[i] = (float)(i + 1);
        }
        glint_kernel_integer_division(8, divisions, 16, quotients);
        glint_kernel_float_division(differences, lengths, 16, vector);
        glint_kernel_float_division_scalar(differences, lengths, 16, scalar);
        for (int i = 0; i < 16; i++) {
            assert_int_equal(quotients[i].code[0], 256 * difference / (i + 1));
            assert_int_equal(quotients[i].code[1], 0);
            assert_int_equal(quotients[i].code[2], -quotients[i].code[0]);
            assert_false(quotients[i].out_of_table);
            assert_true(vector[i] == (float)difference / (float)(i + 1));
            assert_true(scalar[i] == vector[i]);
        }
    }
}

static void every_candidate_has_its_figures(void **state)
{
    (void)state;
    glint_bench_divider_rates rates;
    glint_error err;
    assert_int_equal(glint_bench_dividers(NULL, 0.01, NULL, &rates, &err), GLINT_OK);
    for (int i = 0; i < GLINT_BENCH_DIVIDERS; i++) {
        const int is_circuit =
            i == GLINT_BENCH_DIVIDER_SEQUENTIAL || i == GLINT_BENCH_DIVIDER_PIPELINED;
        assert_non_null(glint_bench_divider_name((glint_bench_divider)i));
        assert_true(rates.divisions[i] > 0.0);
        assert_true(rates.to_integer[i] > 0.0 && rates.to_float[i] > 0.0);
        assert_int_equal(rates.clocks[i] > 0.0, is_circuit);
    }
    assert_true(rates.to_integer[GLINT_BENCH_INTEGER_DIVISION] == 1.0);
    assert_true(rates.to_float[GLINT_BENCH_FLOAT_DIVISION] == 1.0);
    /* At least n clocks a division of one component; nearly three components a clock. */
    const double sequential = rates.clocks[GLINT_BENCH_DIVIDER_SEQUENTIAL] /
                              rates.divisions[GLINT_BENCH_DIVIDER_SEQUENTIAL];
    const double pipelined = rates.clocks[GLINT_BENCH_DIVIDER_PIPELINED] /
                             rates.divisions[GLINT_BENCH_DIVIDER_PIPELINED];
    assert_true(sequential >= GLINT_BENCH_SHIFTS && sequential < GLINT_BENCH_SHIFTS + 3);
    assert_true(pipelined > 1.0 / 3.0 && pipelined < 0.36);
}

static void it_can_be_stopped(void **state)
{
    (void)state;
    static const volatile bool stop = true;
    glint_bench_divider_rates rates;
    glint_error err;
    assert_int_equal(glint_bench_dividers(NULL, 60.0, &stop, &rates, &err), GLINT_INTERRUPTED);
    assert_string_equal(err.text, "interrupted");
}

static glint_status sleep_a_little(void *work, int candidate, glint_error *err)
{
    (void)work, (void)candidate, (void)err;
    nanosleep(&(struct timespec){.tv_nsec = 5000000}, NULL);
    return GLINT_OK;
}

/* As it would while others have the processor: 5 ms on the wall, next to nothing of its own. */
static void waiting_is_not_measured(void **state)
{
    (void)state;
    glint_rounds rounds;
    assert_int_equal(glint_rounds_measure(sleep_a_little, NULL, 1, 1, 0.07, NULL, &rounds, NULL),
                     GLINT_OK);
    assert_true(glint_rounds_rate(&rounds, 0) > 3.0 / 0.005);
}

static void medians_are_of_rounds(void **state)
{
    (void)state;
    static const glint_rounds rounds = {
        {{1, 9, 2, 8, 3, 7, 4}, {2, 18, 4, 16, 6, 14, 8}, {9, 1, 9, 1, 9, 1, 9}}};
    assert_true(glint_rounds_rate(&rounds, 0) == 4.0);
    assert_true(glint_rounds_rate(&rounds, 2) == 9.0);
    assert_true(glint_rounds_ratio(&rounds, 1, 0) == 2.0);
    assert_true(glint_rounds_ratio(&rounds, 0, 1) == 0.5);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_machine_divides_every_difference),
        cmocka_unit_test(every_candidate_has_its_figures),
        cmocka_unit_test(it_can_be_stopped),
        cmocka_unit_test(waiting_is_not_measured),
        cmocka_unit_test(medians_are_of_rounds),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
