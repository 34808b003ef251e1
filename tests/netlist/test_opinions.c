/* Second opinions: netlists out of synthesis, and the Verilog Verilated in other ways, against the
 * C model. The list is the short one of make test, or that of GLINT_OPINIONS: make netlist has all
 * of them. GLINT_NETLIST_CLOCKS: how many clocks for each circuit. */
#include <inttypes.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "../planted/planted.h"
#include "../seed.h"
#include "lockstep/lockstep.h"
#include "opinions.h"
#include "pins.h"

static uint64_t seed;
static uint64_t clocks = 20000;
static opinion opinions[OPINIONS_MAX];
static int opinion_count;

typedef enum opinion_kind {
    NETLIST, /* its pins are compared */
    SECOND,  /* the Verilog Verilated in another way: every signal is compared */
    WRONG,   /* a netlist with a fault, which has to be found */
} opinion_kind;

/* As the name has it. */
static opinion_kind kind_of(const opinion *opinion)
{
    const char *const end = strchr(opinion->name, '/');
    const char *const fault = strchr(opinion->name, '-');
    if (fault != NULL && fault < end)
        return WRONG;
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
    opinion_count = opinions_read("netlist/short", opinions);
    return clocks != 0 && opinion_count > 0 ? 0 : -1;
}

/* Of a netlist its pins, of others every signal. */
static glint_setting setting_of(const opinion *entry)
{
    return kind_of(entry) == SECOND ? entry->setting : pins_setting(&entry->setting);
}

/* The power device gets more of them, so that its netlist shows every bit of its ROMs
 * (tests/power/test_power_domain.c). */
static uint64_t clocks_of(const opinion *entry)
{
    const bool is_power = strcmp(entry->setting.circuit->name, "power") == 0;
    return kind_of(entry) == NETLIST && is_power ? 8 * clocks : clocks;
}

static void run_lockstep(const opinion *entry, const glint_setting *setting, uint64_t count,
                         glint_lockstep_result *found)
{
    const glint_lockstep_options options = {.setting = *setting, .clocks = count, .seed = seed};
    glint_error err;
    assert_true(opinion_choose(entry));
    if (glint_lockstep_run(&options, found, &err) != GLINT_OK)
        fail_msg("%s: %s", entry->name, err.text);
}

static tally compare(const opinion *entry)
{
    static glint_lockstep_result found;
    const glint_setting setting = setting_of(entry);
    run_lockstep(entry, &setting, clocks_of(entry), &found);
    if (found.mismatches != 0) {
        const glint_mismatch *first = &found.mismatch[0];
        print_message("%s: clock %" PRIu64 ", %s, lane %d: model 0x%" PRIx64 ", circuit 0x%" PRIx64
                      "\n",
                      entry->name, found.first_clock, first->signal.name, first->signal.lane,
                      first->model[0], first->rtl[0]);
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
        if (kind_of(entry) != kind)
            continue;
        const tally one = compare(entry);
        print_message("%-44s %" PRIu64 " mismatches of %" PRIu64 "\n", entry->name, one.mismatches,
                      one.comparisons);
        assert_true(one.clocks == clocks_of(entry) && one.comparisons >= 4 * one.clocks);
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

/* A netlist has no more than its pins, and no fewer. */
static void a_netlist_is_looked_at_by_its_pins(void **state)
{
    (void)state;
    for (int i = 0; i < opinion_count; i++) {
        const glint_setting *whole = &opinions[i].setting;
        const glint_setting netlist = pins_setting(whole);
        int outputs = 0;
        for (int s = 0; s < netlist.circuit->signal_count(netlist.values); s++) {
            const glint_signal_info info = netlist.circuit->signal(netlist.values, s);
            assert_int_equal(info.kind, GLINT_SIGNAL_OUTPUT);
        }
        for (int s = 0; s < whole->circuit->signal_count(whole->values); s++)
            outputs += whole->circuit->signal(whole->values, s).kind == GLINT_SIGNAL_OUTPUT;
        const bool busy = whole->circuit == &glint_circuit_divider &&
                          whole->values[GLINT_DIVIDER_FORM] == GLINT_DIVIDER_SEQUENTIAL;
        assert_int_equal(netlist.circuit->signal_count(netlist.values), outputs + busy);
    }
}

/* ---- Whether every pin is looked at -----------------------------------------------------------
 */

/* Bit c − 1 after clock c: each bit of a pin, from the lowest on. */
static uint64_t bit_after_bit(uint64_t clock)
{
    return clock <= 63 ? UINT64_C(1) << (clock - 1) : 0;
}

static void assert_pin_looked_at(const opinion *entry, const glint_setting *netlist, int index)
{
    static glint_lockstep_result found;
    const glint_signal_info pin = netlist->circuit->signal(netlist->values, index);
    const int width = pin.int_bits + pin.frac_bits;
    plant = (planted){.signal = index, .inverted = bit_after_bit, .answer = PLANTED_NOWHERE};
    run_lockstep(entry, netlist, (uint64_t)width, &found);
    if (found.mismatches != (uint64_t)width) {
        fail_msg("%s, %s, lane %d: %" PRIu64 " mismatches, %d were planted", entry->name, pin.name,
                 pin.lane, found.mismatches, width);
    }
    assert_true(found.first_clock == 1 &&
                (found.mismatch[0].model[0] ^ found.mismatch[0].rtl[0]) == 1);
    assert_string_equal(found.mismatch[0].signal.name, pin.name);
    assert_int_equal(found.mismatch[0].signal.lane, pin.lane);
    assert_true(found.comparisons ==
                (uint64_t)width * (uint64_t)netlist->circuit->signal_count(netlist->values));
}

static void each_bit_of_each_pin_is_looked_at(void **state)
{
    (void)state;
    int pins = 0;
    for (int i = 0; i < opinion_count; i++) {
        if (kind_of(&opinions[i]) != NETLIST)
            continue;
        const glint_setting netlist = pins_setting(&opinions[i].setting);
        for (int s = 0; s < netlist.circuit->signal_count(netlist.values); s++) {
            assert_pin_looked_at(&opinions[i], &netlist, s);
            pins++;
        }
    }
    assert_true(pins > 0);
}

static int pull_out(void **state)
{
    (void)state;
    plant.signal = PLANTED_NOWHERE;
    return 0;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(netlists_do_what_the_model_does),
        cmocka_unit_test(the_verilog_verilated_otherwise_too),
        cmocka_unit_test(every_wrong_netlist_is_found),
        cmocka_unit_test(a_netlist_is_looked_at_by_its_pins),
        cmocka_unit_test_teardown(each_bit_of_each_pin_is_looked_at, pull_out),
    };
    return cmocka_run_group_tests(tests, prepare, NULL);
}
