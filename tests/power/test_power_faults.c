/* The power device, wrong on purpose (tests/power/wrong): lockstep names the register or block that
 * is at fault first, and a packet of what it found is replayed, by the wrong circuit with the same
 * mismatch and by the right one with none. */
#define _XOPEN_SOURCE 700

#include <inttypes.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "../scratch.h"

#include "../seed.h"
#include "../wrong.h"
#include "circuit/circuits.h"
#include "failure/packet.h"
#include "glint_power.h"
#include "lockstep/exhaustive.h"
#include "lockstep/lockstep.h"

enum { CLOCKS = 40000 };

/* A wrong circuit, and the signals that may be named for it first, with a space after each. */
typedef struct fault {
    const char *name, *signals;
} fault;

static const fault faults[] = {
    {"power_late_log", "rom9 "},
    {"power_early_power", "rom33 "},
    {"power_no_half", "mul10 "},
    {"power_stalled_colors", "reg3 reg4 reg5 "},
    {"power_unheld_colors", "out_r out_g out_b "},
};
#define FAULT_COUNT (sizeof faults / sizeof faults[0])

static uint64_t seed;
static glint_lockstep_result result;

static int prepare(void **state)
{
    seed = seed_of_this_run();
    return scratch_make(state);
}

static glint_setting setting_of(const char *wrong)
{
    glint_setting setting = glint_setting_unit(glint_circuit_named("power"), GLINT_POWER_HALF, 0,
                                               GLINT_PIPELINE_PIPELINED, 1);
    setting.verilog = wrong != NULL ? wrong_rtl(wrong) : NULL;
    return setting;
}

static bool is_named(const char *names, const char *name)
{
    char word[32];
    (void)snprintf(word, sizeof word, "%s ", name);
    return strstr(names, word) != NULL;
}

static void assert_done(glint_status status, const glint_error *err)
{
    if (status != GLINT_OK)
        fail_msg("%s", err->text);
}

/* The packet as it was written, by the Verilog of `wrong`, or the right one. */
static void replay(const char *wrong, glint_failure_finding *found)
{
    glint_failure *failure;
    glint_capture *capture = NULL;
    glint_error err;
    assert_done(glint_packet_read(scratch_path("packet"), NULL, &failure, &err), &err);
    failure->setting.verilog = wrong != NULL ? wrong_rtl(wrong) : NULL;
    assert_done(glint_failure_play(failure, NULL, found, &capture, &err), &err);
    free(capture);
    glint_failure_destroy(failure);
}

static void check_fault(const fault *fault)
{
    const glint_lockstep_options options = {
        .setting = setting_of(fault->name), .clocks = CLOCKS, .seed = seed};
    glint_failure *failure = NULL;
    glint_failure_finding found;
    glint_error err;
    assert_done(glint_lockstep_run(&options, &result, &err), &err);
    assert_true(result.mismatches > 0 && result.mismatches < result.comparisons);
    const char *const first = result.mismatch[0].signal.name;
    print_message("%-22s clock %5" PRIu64 ": %s; %" PRIu64 " mismatches of %" PRIu64 "\n",
                  fault->name, result.first_clock, first, result.mismatches, result.comparisons);
    if (!is_named(fault->signals, first))
        fail_msg("%s, seed %" PRIu64 ": the first to differ is %s", fault->name, seed, first);
    assert_done(glint_failure_of_lockstep(&options, &result, &failure, &err), &err);
    assert_done(glint_packet_write(failure, NULL, scratch_path("packet"), &err), &err);
    glint_failure_destroy(failure);
    replay(fault->name, &found);
    assert_true(found.lockstep_differs && found.count > 0);
    assert_string_equal(found.mismatch[0].signal.name, first);
    replay(NULL, &found);
    assert_true(!found.lockstep_differs && found.count == 0);
}

static void every_fault_is_named_and_its_packet_replays(void **state)
{
    (void)state;
    for (size_t f = 0; f < FAULT_COUNT; f++)
        check_fault(&faults[f]);
}

/* By the exhaustive run, which asks the fast build: what its steady flow shows is found with this
 * n, and replayed to the same signals; the rest only lockstep reaches. */
static void the_exhaustive_run_finds_what_a_steady_flow_shows(void **state)
{
    (void)state;
    static const bool shows[FAULT_COUNT] = {true, true, true, false, false};
    for (size_t f = 0; f < FAULT_COUNT; f++) {
        static glint_exhaustive_result found;
        const glint_exhaustive_options options = {
            .setting = {setting_of(faults[f].name)},
            .settings = 1,
            .shard = 3, /* n = 2: the ROMs give most of their words */
            .shards = GLINT_N_COUNT,
            .stride = 1,
            .threads = 1,
            .keep_history = true};
        glint_failure *failure = NULL;
        glint_error err;
        assert_done(glint_exhaustive_run(&options, &found, &err), &err);
        print_message("%-22s %" PRIu64 " mismatches of %" PRIu64 "\n", faults[f].name,
                      found.circuit[0].mismatches, found.circuit[0].comparisons);
        assert_int_equal(found.circuit[0].mismatches > 0, shows[f]);
        assert_int_equal(found.kept > 0, shows[f]);
        if (!shows[f])
            continue;
        assert_ptr_equal(found.mismatch[0].setting.circuit, options.setting[0].circuit);
        assert_done(glint_failure_of_history(GLINT_FAILURE_EXHAUSTIVE, &options.setting[0],
                                             &found.mismatch[0].answer, found.history, NULL,
                                             &failure, &err),
                    &err);
        assert_true(failure->finding.lockstep_differs && failure->finding.count > 0);
        if (!is_named(faults[f].signals, failure->finding.mismatch[0].signal.name))
            fail_msg("%s: the first to differ is %s", faults[f].name,
                     failure->finding.mismatch[0].signal.name);
        glint_failure_destroy(failure);
        glint_history_destroy(found.history);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_fault_is_named_and_its_packet_replays),
        cmocka_unit_test(the_exhaustive_run_finds_what_a_steady_flow_shows),
    };
    return cmocka_run_group_tests(tests, prepare, scratch_remove);
}
