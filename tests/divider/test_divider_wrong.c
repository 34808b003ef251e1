/* Lockstep itself: it must catch deliberately broken dividers and name clock, signal and values.
 * The packets are tested in tests/failure; the faults are in tests/divider/wrong. */
#define _XOPEN_SOURCE 700

#include <inttypes.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "../seed.h"
#include "../wrong.h"
#include "circuit/circuits.h"
#include "lockstep/lockstep.h"

enum { CLOCKS = 20000, SHIFTS = 12 };

/* A wrong circuit, and the signals that may be named for it first. */
typedef struct fault {
    const char *name;
    glint_divider_form form;
    const char *signals; /* with a space after each */
} fault;

static const fault faults[] = {
    {"divider_logical_shift", GLINT_DIVIDER_SEQUENTIAL, "shifted "},
    {"divider_late_done", GLINT_DIVIDER_SEQUENTIAL, "done "},
    {"divider_restarting", GLINT_DIVIDER_SEQUENTIAL, "busy bits_rg left "},
    {"divider_table_off_by_one", GLINT_DIVIDER_PIPELINED, "rom_bits "},
    {"divider_unsigned_stage", GLINT_DIVIDER_PIPELINED, "quotient_g acc_g "},
};
#define FAULT_COUNT (sizeof faults / sizeof faults[0])

static uint64_t seed;
static glint_lockstep_result result;

static int draw_seed(void **state)
{
    (void)state;
    seed = seed_of_this_run();
    return 0;
}

static glint_lockstep_options options_for(const fault *fault)
{
    glint_setting setting = glint_setting_divider(fault->form, SHIFTS);
    setting.verilog = wrong_rtl(fault->name);
    return (glint_lockstep_options){.setting = setting, .clocks = CLOCKS, .seed = seed};
}

static void run_lockstep(const glint_lockstep_options *options)
{
    glint_error err;
    memset(&result, 0x5a, sizeof result);
    if (glint_lockstep_run(options, &result, &err) != GLINT_OK)
        fail_msg("%s", err.text);
}

static bool is_named(const char *names, const char *name)
{
    char word[32];
    (void)snprintf(word, sizeof word, "%s ", name);
    return strstr(names, word) != NULL;
}

/* ---- The finding --------------------------------------------------------------------------------
 */

static void every_fault_is_found_and_named(void **state)
{
    (void)state;
    for (size_t f = 0; f < FAULT_COUNT; f++) {
        const glint_lockstep_options options = options_for(&faults[f]);
        run_lockstep(&options);
        const glint_lockstep_result *found = &result;
        const glint_signal_info *first = &found->mismatch[0].signal;
        print_message("%-18s clock %5" PRIu64 ": %s; %" PRIu64 " mismatches of %" PRIu64 "\n",
                      faults[f].name, found->first_clock, first->name, found->mismatches,
                      found->comparisons);
        assert_int_equal(found->clocks, CLOCKS);
        assert_true(found->mismatches > 0 && found->mismatches < found->comparisons);
        assert_true(found->first_clock >= 1 && found->first_clock <= CLOCKS);
        if (!is_named(faults[f].signals, first->name)) {
            fail_msg("%s, seed %" PRIu64 ": the first to differ is %s", faults[f].name, seed,
                     first->name);
        }
    }
}

static void at_most_sixteen_are_kept_and_all_are_counted(void **state)
{
    (void)state;
    for (size_t f = 0; f < FAULT_COUNT; f++) {
        const glint_lockstep_options options = options_for(&faults[f]);
        uint64_t total = 0;
        run_lockstep(&options);
        const glint_lockstep_result *found = &result;
        assert_int_equal(found->kept, found->mismatches < 16 ? (int)found->mismatches : 16);
        for (int i = 0; i < found->kept; i++) {
            const glint_mismatch *m = &found->mismatch[i];
            assert_memory_not_equal(m->model, m->rtl, sizeof m->model);
            assert_true(m->clock >= (i == 0 ? found->first_clock : m[-1].clock));
        }
        assert_true(found->mismatch[0].clock == found->first_clock);
        for (int i = 0; i < found->totals_count; i++) {
            assert_true(found->totals[i].mismatches > 0);
            total += found->totals[i].mismatches;
        }
        assert_true(total == found->mismatches);
    }
}

/* The model's value is right regardless of the circuit. */
static void both_values_are_told(void **state)
{
    (void)state;
    glint_lockstep_options options = options_for(&faults[3]);
    run_lockstep(&options);
    assert_int_equal(result.mismatch[0].model[0], 585);
    assert_int_equal(result.mismatch[0].rtl[0], 586);
    options = options_for(&faults[1]);
    run_lockstep(&options);
    assert_int_equal(result.mismatch[0].model[0], 1);
    assert_int_equal(result.mismatch[0].rtl[0], 0);
    /* 0 instead of the sign from the left: they differ in the highest bit alone. */
    options = options_for(&faults[0]);
    run_lockstep(&options);
    assert_true((result.mismatch[0].model[0] ^ result.mismatch[0].rtl[0]) ==
                UINT64_C(1) << (GLINT_DIVIDER_DIFFERENCE_BITS + SHIFTS - 1));
}

/* The seed and the number of clocks are all it takes: the same again; nothing a clock earlier. */
static void a_finding_can_be_replayed(void **state)
{
    (void)state;
    static glint_lockstep_result first;
    for (size_t f = 0; f < FAULT_COUNT; f++) {
        glint_lockstep_options options = options_for(&faults[f]);
        run_lockstep(&options);
        first = result;
        options.clocks = first.first_clock;
        run_lockstep(&options);
        assert_true(result.first_clock == options.clocks && result.mismatches > 0);
        assert_string_equal(result.mismatch[0].signal.name, first.mismatch[0].signal.name);
        assert_memory_equal(result.mismatch[0].model, first.mismatch[0].model,
                            sizeof first.mismatch[0].model);
        assert_memory_equal(result.mismatch[0].rtl, first.mismatch[0].rtl,
                            sizeof first.mismatch[0].rtl);
        if (options.clocks > 1) {
            options.clocks--;
            run_lockstep(&options);
            assert_true(result.mismatches == 0);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_fault_is_found_and_named),
        cmocka_unit_test(at_most_sixteen_are_kept_and_all_are_counted),
        cmocka_unit_test(both_values_are_told),
        cmocka_unit_test(a_finding_can_be_replayed),
    };
    return cmocka_run_group_tests(tests, draw_seed, NULL);
}
