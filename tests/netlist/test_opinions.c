/* Second opinions: netlists out of synthesis, and the Verilog Verilated in other ways, against the
 * C model. This program is linked twice, with the short list for make test, and with all of them
 * for make netlist. GLINT_NETLIST_CLOCKS: how many clocks for each circuit. */
#include <inttypes.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "../seed.h"
#include "lockstep/lockstep.h"
#include "opinions.h"
#include "pins.h"

static uint64_t seed;
static uint64_t clocks = 20000;

typedef enum opinion_kind {
    NETLIST, /* its pins are compared */
    SECOND,  /* the Verilog Verilated in another way: every signal is compared */
    WRONG,   /* a netlist with a fault, which has to be found */
} opinion_kind;

/* As the name has it. */
static opinion_kind kind_of(const opinion *opinion)
{
    const char *const end = strchr(opinion->name, ':');
    const char *const fault = strchr(opinion->name, '-');
    if (fault != NULL && fault < end) {
        return WRONG;
    }
    return strncmp(opinion->name, "nodfg", 5) == 0 || strncmp(opinion->name, "plain", 5) == 0
               ? SECOND
               : NETLIST;
}

/* What came of one circuit, or of all of a kind. */
typedef struct tally {
    uint64_t clocks, comparisons, mismatches;
} tally;

static int prepare(void **state)
{
    (void)state;
    const char *given = getenv("GLINT_NETLIST_CLOCKS");
    seed = seed_of_this_run();
    clocks = given != NULL ? strtoull(given, NULL, 10) : clocks;
    return clocks != 0 ? 0 : -1;
}

static tally compare_pins(const opinion *entry)
{
    const pins_options options = {
        .setting = opinion_setting(entry), .clocks = clocks, .seed = seed};
    pins_result r;
    glint_error err;
    if (pins_run(&options, &r, &err) != GLINT_OK) {
        fail_msg("%s: %s", entry->name, err.text);
    }
    if (r.mismatches != 0) {
        print_message(
            "%s: clock %" PRIu64 ", pin %s, lane %d: model 0x%" PRIx64 ", netlist 0x%" PRIx64 "\n",
            entry->name, r.first_clock, r.first_pin, r.first_lane, r.first_model, r.first_circuit);
    }
    return (tally){r.clocks, r.comparisons, r.mismatches};
}

static tally compare_signals(const opinion *entry)
{
    static glint_lockstep_result found;
    const glint_lockstep_options options = {
        .setting = opinion_setting(entry), .clocks = clocks, .seed = seed};
    glint_error err;
    if (glint_lockstep_run(&options, &found, &err) != GLINT_OK) {
        fail_msg("%s: %s", entry->name, err.text);
    }
    if (found.mismatches != 0) {
        print_message("%s: clock %" PRIu64 ", %s\n", entry->name, found.first_clock,
                      found.mismatch[0].signal.name);
    }
    return (tally){found.clocks, found.comparisons, found.mismatches};
}

/* All circuits of a kind; the number that differ. */
static int compare_all(opinion_kind kind, const char *what, tally *sum, int *circuits)
{
    int differ = 0;
    *sum = (tally){0};
    *circuits = 0;
    for (int i = 0; i < opinion_count; i++) {
        const opinion *entry = &opinions[i];
        if (kind_of(entry) != kind) {
            continue;
        }
        const tally one = kind == SECOND ? compare_signals(entry) : compare_pins(entry);
        print_message("%-44s %" PRIu64 " mismatches of %" PRIu64 "\n", entry->name, one.mismatches,
                      one.comparisons);
        assert_true(one.clocks == clocks && one.comparisons >= 4 * clocks);
        sum->clocks += one.clocks;
        sum->comparisons += one.comparisons;
        sum->mismatches += one.mismatches;
        differ += one.mismatches != 0;
        ++*circuits;
    }
    print_message("%s: %" PRIu64 " mismatches of %" PRIu64 " comparisons, %" PRIu64
                  " clocks, %d circuits, %d differ\n",
                  what, sum->mismatches, sum->comparisons, sum->clocks, *circuits, differ);
    assert_true(*circuits > 0);
    return differ;
}

static void netlists_do_what_the_model_does(void **state)
{
    (void)state;
    tally sum;
    int circuits;
    assert_int_equal(compare_all(NETLIST, "netlists", &sum, &circuits), 0);
}

static void the_verilog_verilated_otherwise_too(void **state)
{
    (void)state;
    tally sum;
    int circuits;
    assert_int_equal(compare_all(SECOND, "second builds", &sum, &circuits), 0);
}

static void every_wrong_netlist_is_found(void **state)
{
    (void)state;
    tally sum;
    int circuits;
    const int differ = compare_all(WRONG, "wrong netlists", &sum, &circuits);
    assert_int_equal(differ, circuits);
}

static void no_clocks_and_no_circuit_are_refused(void **state)
{
    (void)state;
    pins_options options = {.setting = opinion_setting(&opinions[0])};
    pins_result result;
    glint_error err;
    assert_int_equal(pins_run(&options, &result, &err), GLINT_BAD_ARGUMENT);
    options.clocks = 1;
    assert_int_equal(pins_run(&options, &result, &err), GLINT_OK);
    options.setting.specular_model = NULL;
    options.setting.divider_model = NULL;
    assert_int_equal(pins_run(&options, &result, &err), GLINT_BAD_ARGUMENT);
}

/* A run that is to end with the first mismatch does, and is the same up to there. */
static void a_run_stops_at_the_first_mismatch(void **state)
{
    (void)state;
    int runs = 0;
    for (int i = 0; i < opinion_count; i++) {
        const opinion *entry = &opinions[i];
        if (kind_of(entry) != WRONG) {
            continue;
        }
        pins_options options = {.setting = opinion_setting(entry), .clocks = clocks, .seed = seed};
        pins_result all, first;
        glint_error err;
        assert_int_equal(pins_run(&options, &all, &err), GLINT_OK);
        options.stop_at_first = true;
        assert_int_equal(pins_run(&options, &first, &err), GLINT_OK);
        assert_true(all.mismatches > first.mismatches && first.mismatches > 0);
        assert_true(first.clocks == first.first_clock && first.first_clock == all.first_clock);
        assert_string_equal(first.first_pin, all.first_pin);
        runs++;
    }
    assert_true(runs > 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(netlists_do_what_the_model_does),
        cmocka_unit_test(the_verilog_verilated_otherwise_too),
        cmocka_unit_test(every_wrong_netlist_is_found),
        cmocka_unit_test(no_clocks_and_no_circuit_are_refused),
        cmocka_unit_test(a_run_stops_at_the_first_mismatch),
    };
    return cmocka_run_group_tests(tests, prepare, NULL);
}
