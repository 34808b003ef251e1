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

/* ---- Whether every pin is looked at
 * -------------------------------------------------------------- The ports of a circuit that is
 * right, copied after each clock with one bit inverted. */

enum { PORTS_MAX = 8, PORT_BYTES = 64 };

typedef struct port {
    const uint8_t *real;
    uint8_t shown[PORT_BYTES];
    int size;
    bool is_planted;
} port;

static struct {
    const opinion *sound;
    port ports[PORTS_MAX];
    int port_count;
    const char *name; /* of the port */
    int low;          /* its first bit that is inverted, after clock 1; then bit after bit … */
    int width;        /* … of so many */
    int clock;
} planted;

static void show_ports(void)
{
    for (int i = 0; i < planted.port_count; i++) {
        port *shown = &planted.ports[i];
        memcpy(shown->shown, shown->real, (size_t)shown->size);
        if (shown->is_planted && planted.clock >= 1 && planted.clock <= planted.width) {
            const int bit = planted.low + planted.clock - 1;
            shown->shown[bit / 8] ^= (uint8_t)(1 << bit % 8);
        }
    }
}

/* In place of the port itself, its copy. */
static void take_port(const char *name, const void **data, int size)
{
    assert_true(planted.port_count < PORTS_MAX && size <= PORT_BYTES);
    port *taken = &planted.ports[planted.port_count++];
    *taken = (port){.real = *data, .size = size, .is_planted = strcmp(name, planted.name) == 0};
    *data = taken->shown;
}

static bool find_specular(void *instance, int lane, const char *name, const void **data, int *size)
{
    const bool found = planted.sound->specular->find(instance, lane, name, data, size);
    if (found) {
        take_port(name, data, *size);
    }
    return found;
}

static bool find_divider(void *instance, int stage, const char *name, const void **data, int *size)
{
    const bool found = planted.sound->divider->find(instance, stage, name, data, size);
    if (found) {
        take_port(name, data, *size);
    }
    return found;
}

static void clock_specular(void *instance, const glint_specular_inputs *inputs)
{
    planted.sound->specular->clock(instance, inputs);
    planted.clock++;
    show_ports();
}

static void clock_divider(void *instance, const glint_divider_inputs *inputs)
{
    planted.sound->divider->clock(instance, inputs);
    planted.clock++;
    show_ports();
}

static void assert_pin_looked_at(const opinion *entry, const glint_signal_info *pin)
{
    glint_rtl_model specular;
    glint_divider_model divider;
    pins_options options = {.setting = opinion_setting(entry), .seed = seed};
    pins_result found;
    glint_error err;
    const int width = pin->int_bits + pin->frac_bits;
    memset(&planted, 0, sizeof planted);
    planted.sound = entry;
    planted.name = pin->name;
    planted.low = pin->lane < 0 ? 0 : pin->lane * width;
    planted.width = width;
    if (entry->specular != NULL) {
        specular = *entry->specular;
        specular.find = find_specular;
        specular.clock = clock_specular;
        options.setting.specular_model = &specular;
    } else {
        divider = *entry->divider;
        divider.find = find_divider;
        divider.clock = clock_divider;
        options.setting.divider_model = &divider;
    }
    options.clocks = (uint64_t)width;
    assert_int_equal(pins_run(&options, &found, &err), GLINT_OK);
    if (found.mismatches != (uint64_t)width) {
        fail_msg("%s, %s, lane %d: %" PRIu64 " mismatches, %d were planted", entry->name, pin->name,
                 pin->lane, found.mismatches, width);
    }
    assert_true(found.first_clock == 1 && (found.first_model ^ found.first_circuit) == 1);
    assert_string_equal(found.first_pin, pin->name);
    assert_int_equal(found.first_lane, pin->lane);
    assert_true(found.comparisons == (uint64_t)width * (uint64_t)planted.port_count);
}

static bool is_pin(const glint_signal_info *info)
{
    return info->kind == GLINT_SIGNAL_OUTPUT || strcmp(info->name, "busy") == 0;
}

static void each_bit_of_each_pin_is_looked_at(void **state)
{
    (void)state;
    int pins = 0;
    for (int i = 0; i < opinion_count; i++) {
        const glint_setting setting = opinion_setting(&opinions[i]);
        if (kind_of(&opinions[i]) != NETLIST ||
            (!setting.is_divider && setting.specular.lanes > 1)) {
            continue; /* with several lanes one port is many pins */
        }
        for (int s = 0; s < glint_setting_signal_count(&setting); s++) {
            const glint_signal_info info = glint_setting_signal(&setting, s);
            if (is_pin(&info)) {
                assert_pin_looked_at(&opinions[i], &info);
                pins++;
            }
        }
    }
    assert_true(pins > 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(netlists_do_what_the_model_does),
        cmocka_unit_test(the_verilog_verilated_otherwise_too),
        cmocka_unit_test(every_wrong_netlist_is_found),
        cmocka_unit_test(each_bit_of_each_pin_is_looked_at),
        cmocka_unit_test(no_clocks_and_no_circuit_are_refused),
        cmocka_unit_test(a_run_stops_at_the_first_mismatch),
    };
    return cmocka_run_group_tests(tests, prepare, NULL);
}
