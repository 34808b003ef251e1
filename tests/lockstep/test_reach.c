/* How deep random runs get: the reported coverage matches their pins and the documentation, and
 * circuits that fail only at that depth are caught. */
#include <inttypes.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "../seed.h"
#include "../wrong.h"
#include "circuit/circuits.h"
#include "circuit/model.h"
#include "circuit/random_pins.h"
#include "lockstep/lockstep.h"
#include "lockstep/reach.h"

enum { USUAL = 100000, LONG = 1200000, DEEP = 1 << 16, DEEPER = 1 << 20, LONG_STALL = 64 };

static uint64_t seed;

static int draw_seed(void **state)
{
    (void)state;
    seed = seed_of_this_run();
    return 0;
}

static const struct {
    bool is_divider;
    glint_specular_config specular;
    glint_divider_form form;
    int shifts;
} described[] = {
    {.specular = {GLINT_GATE_COSINE, GLINT_PIPELINE_PIPELINED, 1}},
    {.specular = {GLINT_GATE_COSINE, GLINT_PIPELINE_COMBINATIONAL, 1}},
    {.specular = {GLINT_GATE_COSINE, GLINT_PIPELINE_PIPELINED, 4}},
    {.specular = {GLINT_GATE_COSINE, GLINT_PIPELINE_PIPELINED, 16}},
    {.is_divider = true, .form = GLINT_DIVIDER_SEQUENTIAL, .shifts = 6},
    {.is_divider = true, .form = GLINT_DIVIDER_SEQUENTIAL, .shifts = 16},
    {.is_divider = true, .form = GLINT_DIVIDER_PIPELINED, .shifts = 12},
};
#define SETTINGS (sizeof described / sizeof described[0])
static glint_setting settings[SETTINGS];

static int prepare(void **state)
{
    for (size_t i = 0; i < SETTINGS; i++) {
        settings[i] = described[i].is_divider
                          ? glint_setting_divider(described[i].form, described[i].shifts)
                          : glint_setting_specular(&described[i].specular);
    }
    return draw_seed(state);
}

static bool is_divider(const glint_setting *setting)
{
    return setting->circuit == &glint_circuit_divider;
}

static bool is_sequential(const glint_setting *setting)
{
    return is_divider(setting) && setting->values[GLINT_DIVIDER_FORM] == GLINT_DIVIDER_SEQUENTIAL;
}

static int lanes_of(const glint_setting *setting)
{
    return is_divider(setting) ? 0 : setting->values[GLINT_SPECULAR_LANES];
}

static void drive(const glint_setting *setting, uint64_t clocks, glint_reach_count *count)
{
    glint_random_pins source;
    glint_random_pins_begin(&source, setting, seed);
    glint_reach_begin(count, setting);
    for (uint64_t clock = 0; clock < clocks; clock++) {
        glint_pins pins;
        glint_random_pins_next(&source, &pins);
        glint_reach_clock(count, &pins);
    }
}

/* ---- The count ----------------------------------------------------------------------------------
 */

/* The same from the C model, which knows what is on its way, and from lists of all clocks. */
enum { RECOUNTED = 30000 };

typedef struct recount {
    bool reset[RECOUNTED], en[RECOUNTED], in_flight[RECOUNTED];
    bool changed[RECOUNTED], ignored[RECOUNTED], taken[RECOUNTED];
    bool pattern[1 << GLINT_REACH_PATTERN_LANES];
} recount;

/* Whether a point or a division has not come out yet: with the result at the output only, or in no
 * stage, there is none. */
static bool device_holds_points(const glint_setting *setting, const glint_specular_signals *s)
{
    return setting->values[GLINT_SPECULAR_PIPELINE] == GLINT_PIPELINE_PIPELINED &&
           (s->s1_valid != 0 || s->s2_valid != 0 || s->s3_valid != 0);
}

static bool divider_holds_divisions(const glint_setting *setting,
                                    const glint_divider_device *device)
{
    if (is_sequential(setting))
        return glint_divider_device_sequential(device)->busy != 0;
    const glint_divider_pipelined_signals *s = glint_divider_device_pipelined(device);
    bool holds = s->s0_valid != 0;
    for (int j = 1; j < setting->values[GLINT_DIVIDER_SHIFTS]; j++)
        holds |= s->stage[j].valid != 0;
    return holds;
}

static void note_specular(recount *all, int clock, const glint_specular_inputs *in)
{
    const bool runs = in->en && !in->reset;
    all->reset[clock] = in->reset;
    all->en[clock] = in->en;
    all->changed[clock] = runs && (in->n_we || in->rgb_we);
    all->taken[clock] = runs && in->in_valid != 0;
    all->pattern[runs ? in->in_valid : 0] = true;
}

static void note_division(recount *all, int clock, const glint_divider_inputs *in, bool waits)
{
    const bool runs = in->en && !in->reset;
    all->reset[clock] = in->reset;
    all->en[clock] = in->en;
    all->ignored[clock] = runs && in->start && waits;
    all->taken[clock] = runs && in->start && !waits;
}

static void note_all(recount *all, const glint_setting *setting)
{
    glint_random_pins source;
    void *model;
    memset(all, 0, sizeof *all);
    assert_int_equal(glint_model_create(setting, &model, NULL), GLINT_OK);
    glint_random_pins_begin(&source, setting, seed);
    for (int clock = 0; clock < RECOUNTED; clock++) {
        glint_pins pins;
        glint_specular_inputs specular;
        glint_divider_inputs divider;
        glint_random_pins_next(&source, &pins);
        memcpy(&specular, &pins, sizeof specular);
        memcpy(&divider, &pins, sizeof divider);
        if (is_divider(setting)) {
            all->in_flight[clock] = divider_holds_divisions(setting, model);
            note_division(all, clock, &divider, is_sequential(setting) && all->in_flight[clock]);
        } else {
            all->in_flight[clock] =
                device_holds_points(setting, glint_specular_device_signals(model));
            note_specular(all, clock, &specular);
        }
        glint_model_clock(setting, model, &pins);
    }
    glint_model_destroy(setting, model);
}

static uint64_t sum(const bool *what, const bool *and)
{
    uint64_t count = 0;
    for (int i = 0; i < RECOUNTED; i++)
        count += what[i] && (and == NULL || and[i]);
    return count;
}

/* The longest row of clocks none of which ends it, and of those in it the ones that count. */
static uint64_t longest(const bool *ends, const bool *counts)
{
    uint64_t most = 0;
    for (int first = 0; first < RECOUNTED; first++) {
        uint64_t row = 0;
        for (; first < RECOUNTED && !ends[first]; first++)
            row += counts == NULL || counts[first];
        most = row > most ? row : most;
    }
    return most;
}

static void assert_counted(const recount *all, const glint_setting *setting,
                           const glint_reach *found)
{
    static bool ends_stall[RECOUNTED];
    const int lanes = lanes_of(setting);
    uint64_t patterns = 0;
    int alone = 0;
    for (int i = 0; i < RECOUNTED; i++)
        ends_stall[i] = all->en[i] || all->reset[i];
    for (uint32_t i = 1; i < 1u << lanes; i++)
        patterns += all->pattern[i];
    for (int i = 0; i < lanes; i++)
        alone += all->pattern[1u << i];
    assert_int_equal(found->run, longest(all->reset, NULL));
    assert_int_equal(found->run_enabled, longest(all->reset, all->en));
    assert_int_equal(found->stall, longest(ends_stall, NULL));
    assert_int_equal(found->resets, sum(all->reset, NULL));
    assert_int_equal(found->resets_in_flight, sum(all->reset, all->in_flight));
    assert_int_equal(found->taken, sum(all->taken, NULL));
    assert_int_equal(found->changes, sum(all->changed, NULL));
    assert_int_equal(found->changes_in_flight, sum(all->changed, all->in_flight));
    assert_int_equal(found->ignored, sum(all->ignored, NULL));
    assert_int_equal(found->patterns, patterns);
    assert_int_equal(found->lanes_alone, alone);
    assert_true(found->taken > 0 && found->resets > 0);
}

static void what_is_said_to_be_reached_was_at_the_pins(void **state)
{
    (void)state;
    static recount all;
    static glint_reach_count count;
    for (size_t i = 0; i < SETTINGS; i++) {
        note_all(&all, &settings[i]);
        drive(&settings[i], RECOUNTED, &count);
        assert_counted(&all, &settings[i], &count.reach);
    }
}

/* A run tells of the pins that it drove, and of no others. */
static void a_run_tells_what_it_reached(void **state)
{
    (void)state;
    static glint_lockstep_result result;
    static glint_reach_count count;
    for (size_t i = 0; i < SETTINGS; i++) {
        glint_error err;
        const glint_lockstep_options options = {
            .setting = settings[i], .clocks = 5000, .seed = seed};
        memset(&result, 0x5a, sizeof result);
        assert_int_equal(glint_lockstep_run(&options, &result, &err), GLINT_OK);
        drive(&settings[i], 5000, &count);
        assert_memory_equal(&result.reach, &count.reach, sizeof count.reach);
    }
}

/* Hand-written pins whose counts are easy to check. */
static void a_count_by_hand(void **state)
{
    (void)state;
    static glint_reach_count count;
    static const glint_specular_inputs clocks[] = {
        {.en = 1, .in_valid = 2},              /* lane 1 alone */
        {.en = 1, .n_we = 1},                  /* a change, with that point in flight */
        {.en = 0, .in_valid = 1, .rgb_we = 1}, /* nothing: a stall */
        {.en = 0},                             /* two in a row */
        {.en = 1},                             /* */
        {.en = 1, .rgb_we = 1},                /* in flight still: its result is not out before */
        {.en = 1, .rgb_we = 1},                /* a change with nothing in flight */
        {.en = 1, .in_valid = 3},              /* */
        {.reset = 1, .en = 1, .in_valid = 1},  /* a reset that meets two points */
        {.reset = 1},                          /* one that meets none */
        {.en = 1, .in_valid = 3, .n_we = 1},   /* a pattern that was there; nothing in flight */
    };
    const glint_setting setting = glint_setting_specular(
        &(glint_specular_config){GLINT_GATE_SIGN, GLINT_PIPELINE_PIPELINED, 2});
    glint_reach_begin(&count, &setting);
    for (size_t i = 0; i < sizeof clocks / sizeof clocks[0]; i++) {
        glint_pins pins = {{0}};
        memcpy(&pins, &clocks[i], sizeof clocks[i]);
        glint_reach_clock(&count, &pins);
    }
    assert_int_equal(count.reach.run, 8);
    assert_int_equal(count.reach.run_enabled, 6);
    assert_int_equal(count.reach.stall, 2);
    assert_int_equal(count.reach.resets, 2);
    assert_int_equal(count.reach.resets_in_flight, 1);
    assert_int_equal(count.reach.taken, 3);
    assert_int_equal(count.reach.changes, 4);
    assert_int_equal(count.reach.changes_in_flight, 2);
    assert_int_equal(count.reach.patterns, 2);
    assert_int_equal(count.reach.lanes_alone, 1);
}

/* ---- Roles that the thesis's circuits have not --------------------------------------------------
 */

typedef struct odd_pins {
    uint8_t reset_n, take;
    uint32_t lanes; /* as many bits as values[0] says; 0: there is no such pin */
} odd_pins;

static int odd_pin_count(const int *values)
{
    return values[0] != 0 ? 3 : values[1] != 0 ? 2 : 1;
}

/* An active-low reset; where values[1] is set, a pin that takes; where values[0] is, lanes' bits.
 */
static glint_pin_info odd_pin(const int *values, int index)
{
    const glint_pin_info pins[] = {
        {.name = "reset_n", .role = GLINT_PIN_RESET_LOW, .int_bits = 1, .lane = -1, .size = 1},
        {.name = "take",
         .role = values[0] != 0 ? GLINT_PIN_STROBE : GLINT_PIN_VALID,
         .int_bits = 1,
         .lane = -1,
         .offset = offsetof(odd_pins, take),
         .size = 1},
        {.name = "lanes",
         .role = GLINT_PIN_VALID,
         .int_bits = values[0],
         .lane = -1,
         .offset = offsetof(odd_pins, lanes),
         .size = 4}};
    return pins[index];
}

static int odd_latency(const int *values)
{
    return values[2];
}

static int odd_pace(const int *values)
{
    return values[3];
}

static const glint_circuit odd = {.name = "odd",
                                  .pin_count = odd_pin_count,
                                  .pin = odd_pin,
                                  .pins_size = sizeof(odd_pins),
                                  .latency = odd_latency,
                                  .pace = odd_pace};

static void count_odd(const glint_setting *setting, const odd_pins *clocks, size_t number,
                      glint_reach_count *count)
{
    glint_reach_begin(count, setting);
    for (size_t i = 0; i < number; i++) {
        glint_pins pins = {{0}};
        memcpy(&pins, &clocks[i], sizeof clocks[i]);
        glint_reach_clock(count, &pins);
    }
}

/* Neither enable nor valid: every clock out of reset is enabled and takes. */
static void without_enable_and_valid_every_clock_takes(void **state)
{
    (void)state;
    static glint_reach_count count;
    static const odd_pins clocks[] = {{.reset_n = 1}, {.reset_n = 1}, {.reset_n = 0},
                                      {.reset_n = 0}, {.reset_n = 1}, {.reset_n = 1},
                                      {.reset_n = 1}};
    /* With a latency of 100 what was taken is still on its way; with 0 or 1 nothing ever is. */
    static const int latencies[] = {0, 1, 100};
    for (size_t i = 0; i < sizeof latencies / sizeof latencies[0]; i++) {
        const glint_setting setting = {.circuit = &odd, .values = {0, 0, latencies[i], 1}};
        count_odd(&setting, clocks, sizeof clocks / sizeof clocks[0], &count);
        assert_int_equal(count.reach.run, 3);
        assert_int_equal(count.reach.run_enabled, 3);
        assert_int_equal(count.reach.stall, 0);
        assert_int_equal(count.reach.resets, 2);
        assert_int_equal(count.reach.resets_in_flight, latencies[i] > 1);
        assert_int_equal(count.reach.taken, 5);
        assert_int_equal(count.reach.ignored, 0);
    }
}

/* Three clocks long it takes nothing: the fourth is taken again. */
static void a_busy_circuit_ignores_what_comes(void **state)
{
    (void)state;
    static glint_reach_count count;
    static const odd_pins clocks[] = {
        {.reset_n = 1, .take = 1}, {.reset_n = 1, .take = 1}, {.reset_n = 1},
        {.reset_n = 1, .take = 1}, {.reset_n = 1, .take = 1}, {.reset_n = 1, .take = 1},
    };
    const glint_setting setting = {.circuit = &odd, .values = {0, 1, 5, 4}};
    count_odd(&setting, clocks, sizeof clocks / sizeof clocks[0], &count);
    assert_int_equal(count.reach.taken, 2);
    assert_int_equal(count.reach.ignored, 3);
}

/* Of 32 lanes each alone is counted, and no patterns, of which there are too many. */
static void thirty_two_lanes_are_counted_alone(void **state)
{
    (void)state;
    static glint_reach_count count;
    static odd_pins clocks[34];
    const glint_setting setting = {.circuit = &odd, .values = {32, 1, 2, 1}};
    for (uint32_t i = 0; i < 34; i++)
        clocks[i] = (odd_pins){.reset_n = 1, .take = i % 2, .lanes = UINT32_C(1) << i % 32};
    clocks[7].lanes = 0xffffffff;
    assert_int_equal(glint_reach_lanes(&setting), 32);
    count_odd(&setting, clocks, 34, &count);
    assert_int_equal(count.reach.lanes_alone, 31); /* all but lane 7 */
    assert_int_equal(count.reach.patterns, 0);
    assert_int_equal(count.reach.taken, 34);
    assert_int_equal(count.reach.changes, 17);
    assert_int_equal(count.reach.changes_in_flight, 17);
}

/* ---- How far ------------------------------------------------------------------------------------
 */

#define ASSERT_AT_LEAST(value, least)                                                              \
    if ((uint64_t)(value) < (uint64_t)(least))                                                     \
        fail_msg("seed %" PRIu64 ", setting %zu: " #value " is %" PRIu64 ", not " #least, seed, i, \
                 (uint64_t)(value));

static void assert_mixed(size_t i, const glint_reach *reach)
{
    ASSERT_AT_LEAST(reach->stall, LONG_STALL);
    ASSERT_AT_LEAST(reach->resets, 100);
    if (!is_divider(&settings[i])) {
        ASSERT_AT_LEAST(reach->changes, 10000);
        ASSERT_AT_LEAST(reach->lanes_alone, lanes_of(&settings[i]));
    }
    if (glint_setting_latency(&settings[i]) > 1)
        ASSERT_AT_LEAST(reach->resets_in_flight, 20);
    if (!is_divider(&settings[i]) && glint_setting_latency(&settings[i]) > 1)
        ASSERT_AT_LEAST(reach->changes_in_flight, 1000);
}

static void the_usual_run_reaches_65536_enabled_clocks_without_reset(void **state)
{
    (void)state;
    static glint_reach_count count;
    for (size_t i = 0; i < SETTINGS; i++) {
        drive(&settings[i], USUAL, &count);
        ASSERT_AT_LEAST(count.reach.run_enabled, DEEP);
        assert_mixed(i, &count.reach);
    }
}

static void a_long_run_reaches_1048576_enabled_clocks_without_reset(void **state)
{
    (void)state;
    static glint_reach_count count;
    for (size_t i = 0; i < SETTINGS; i++) {
        drive(&settings[i], LONG, &count);
        ASSERT_AT_LEAST(count.reach.run_enabled, DEEPER);
        assert_mixed(i, &count.reach);
    }
}

/* And so on: about a quarter of all clocks, while resets go on as well. */
static void the_longest_stretch_grows_with_the_run(void **state)
{
    (void)state;
    static glint_reach_count count;
    const size_t i = 0;
    glint_random_pins source;
    uint64_t resets = 0;
    glint_random_pins_begin(&source, &settings[i], seed);
    glint_reach_begin(&count, &settings[i]);
    for (uint64_t clock = 1; clock <= 10 * LONG; clock++) {
        glint_pins pins;
        glint_random_pins_next(&source, &pins);
        glint_reach_clock(&count, &pins);
        if (clock % LONG == 0)
            ASSERT_AT_LEAST(count.reach.run, clock / 4 - clock / 50);
    }
    resets = count.reach.resets;
    ASSERT_AT_LEAST(resets, 10000);
}

/* ---- Circuits that go wrong only there ----------------------------------------------------------
 */

typedef struct deep_fault {
    const char *name;
    bool is_divider;
    const char *signal; /* the first to differ */
    uint64_t clocks;    /* in which it must be found */
    uint64_t earliest;  /* clock at which it can show */
} deep_fault;

static const deep_fault faults[] = {
    {"impatient", false, "s1_valid", 20000, LONG_STALL},
    {"tired", false, "reg3", USUAL, DEEP},
    {"divider_tired", true, "out_of_table", USUAL, DEEP},
    {"worn_out", false, "reg4", LONG, DEEPER},
};

static glint_setting setting_of(const deep_fault *fault)
{
    glint_setting setting = fault->is_divider ? glint_setting_divider(GLINT_DIVIDER_SEQUENTIAL, 12)
                                              : glint_setting_specular(&described[0].specular);
    setting.verilog = wrong_rtl(fault->name);
    return setting;
}

static void what_goes_wrong_late_is_found(void **state)
{
    (void)state;
    static glint_lockstep_result result;
    for (size_t i = 0; i < sizeof faults / sizeof faults[0]; i++) {
        glint_error err;
        const glint_lockstep_options options = {
            .setting = setting_of(&faults[i]), .clocks = faults[i].clocks, .seed = seed};
        assert_int_equal(glint_lockstep_run(&options, &result, &err), GLINT_OK);
        if (result.mismatches == 0) {
            fail_msg("%s, seed %" PRIu64 ": not found in %" PRIu64 " clocks", faults[i].name, seed,
                     options.clocks);
        }
        print_message("%-14s clock %7" PRIu64 ": %s\n", faults[i].name, result.first_clock,
                      result.mismatch[0].signal.name);
        assert_string_equal(result.mismatch[0].signal.name, faults[i].signal);
        assert_true(result.first_clock > faults[i].earliest);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_count_by_hand),
        cmocka_unit_test(without_enable_and_valid_every_clock_takes),
        cmocka_unit_test(a_busy_circuit_ignores_what_comes),
        cmocka_unit_test(thirty_two_lanes_are_counted_alone),
        cmocka_unit_test(what_is_said_to_be_reached_was_at_the_pins),
        cmocka_unit_test(a_run_tells_what_it_reached),
        cmocka_unit_test(the_usual_run_reaches_65536_enabled_clocks_without_reset),
        cmocka_unit_test(a_long_run_reaches_1048576_enabled_clocks_without_reset),
        cmocka_unit_test(the_longest_stretch_grows_with_the_run),
        cmocka_unit_test(what_goes_wrong_late_is_found),
    };
    return cmocka_run_group_tests(tests, prepare, NULL);
}
