/* The test bench itself: lockstep must catch deliberately broken circuits and name the block. The
 * packets are tested in tests/failure; the faults are in tests/lockstep/wrong. */
#define _XOPEN_SOURCE 700

#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "../scratch.h"

#include "../child.h"
#include "../seed.h"
#include "../wave/vcd.h"
#include "../wrong.h"
#include "circuit/circuits.h"
#include "lockstep/lockstep.h"
#include "rtl/batch.h"
#include "wave/waveform.h"

enum { CLOCKS = 40000 };

/* A wrong circuit, and the blocks that may be named for it first. */
typedef struct fault {
    const char *name;
    const char *signals; /* of the first clock that differs, with a space after each */
    int first_block, last_block;
} fault;

static const fault faults[] = {
    {"truncating", "mul13 mul14 mul15 ", 13, 15},
    {"unstallable", "reg1 ", 1, 1},
    {"sigma_off_by_one", "rom33 ", 33, 33},
    {"late_limit", "rom9 ", 9, 9},
    {"silent", "out_valid ", 0, 0},
    {"late_saturation", "reg1 ", 1, 1},
};
#define FAULT_COUNT (sizeof faults / sizeof faults[0])

static const char *own_path;
static uint64_t seed;
static glint_lockstep_result result;

static int prepare(void **state)
{
    seed = seed_of_this_run();
    return scratch_make(state);
}

static const glint_specular_config config = {GLINT_GATE_COSINE, GLINT_PIPELINE_PIPELINED, 1};

static glint_setting setting_of(const char *fault)
{
    glint_setting setting = glint_setting_specular(&config);
    setting.verilog = wrong_rtl(fault);
    return setting;
}

static glint_lockstep_options options_for(const fault *fault)
{
    return (glint_lockstep_options){
        .setting = setting_of(fault->name), .clocks = CLOCKS, .seed = seed};
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

static void assert_named(const fault *fault)
{
    for (int i = 0; i < result.kept && result.mismatch[i].clock == result.first_clock; i++) {
        const glint_signal_info *signal = &result.mismatch[i].signal;
        /* What follows from a wrong value within the same clock comes after it. */
        if (i == 0 && (!is_named(fault->signals, signal->name) ||
                       signal->block < fault->first_block || signal->block > fault->last_block)) {
            fail_msg("%s, seed %" PRIu64 ": the first to differ is %s, block %d", fault->name, seed,
                     signal->name, signal->block);
        }
    }
}

static void every_fault_is_found_and_named(void **state)
{
    (void)state;
    for (size_t f = 0; f < FAULT_COUNT; f++) {
        const glint_lockstep_options options = options_for(&faults[f]);
        run_lockstep(&options);
        print_message("%-18s clock %5" PRIu64 ": %s, block %d; %" PRIu64 " mismatches\n",
                      faults[f].name, result.first_clock, result.mismatch[0].signal.name,
                      result.mismatch[0].signal.block, result.mismatches);
        assert_int_equal(result.clocks, CLOCKS);
        assert_true(result.mismatches > 0 && result.mismatches < result.comparisons);
        assert_true(result.first_clock >= 1 && result.first_clock <= CLOCKS);
        assert_named(&faults[f]);
    }
}

static void at_most_sixteen_are_kept_and_all_are_counted(void **state)
{
    (void)state;
    for (size_t f = 0; f < FAULT_COUNT; f++) {
        const glint_lockstep_options options = options_for(&faults[f]);
        uint64_t total = 0;
        run_lockstep(&options);
        assert_int_equal(GLINT_MISMATCHES_KEPT, 16);
        assert_int_equal(result.kept, result.mismatches < 16 ? (int)result.mismatches : 16);
        for (int i = 0; i < result.kept; i++) {
            const glint_mismatch *m = &result.mismatch[i];
            assert_memory_not_equal(m->model, m->rtl, sizeof m->model);
            assert_true(m->clock >= (i == 0 ? result.first_clock : m[-1].clock));
        }
        assert_true(result.mismatch[0].clock == result.first_clock);
        for (int i = 0; i < result.totals_count; i++) {
            assert_true(result.totals[i].mismatches > 0);
            total += result.totals[i].mismatches;
        }
        assert_true(total == result.mismatches);
    }
}

/* The C model is right regardless of the circuit: its value matches the pure function or follows
 * from the inputs. */
static void both_values_are_told(void **state)
{
    (void)state;
    const fault *sigma = &faults[2];
    const fault *limit = &faults[3];
    glint_lockstep_options options = options_for(sigma);
    run_lockstep(&options);
    assert_int_equal(result.mismatch[0].model[0], 166571);
    assert_int_equal(result.mismatch[0].rtl[0], 166572);
    options = options_for(limit);
    run_lockstep(&options);
    assert_int_equal(result.mismatch[0].model[0], 261359);
    assert_int_equal(result.mismatch[0].rtl[0], 261360);
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
        assert_true(result.first_clock == first.first_clock && result.mismatches > 0);
        assert_string_equal(result.mismatch[0].signal.name, first.mismatch[0].signal.name);
        assert_memory_equal(result.mismatch[0].model, first.mismatch[0].model,
                            sizeof first.mismatch[0].model);
        assert_memory_equal(result.mismatch[0].rtl, first.mismatch[0].rtl,
                            sizeof first.mismatch[0].rtl);
        if (first.first_clock > 1) {
            options.clocks = first.first_clock - 1;
            run_lockstep(&options);
            assert_true(result.mismatches == 0);
        }
    }
}

/* ---- A trace that is open when a test fails
 * -------------------------------------------------------- */

/* The program calls itself: "test_wrong child FILE" is a cmocka run of its own, whose one test
 * fails with a trace open; its teardown destroys the circuit. With "unclosed" it leaves without. */
static glint_rtl *child_rtl;
static const char *child_file;
static bool child_leaves;

static void open_a_trace_and_fail(void **state)
{
    (void)state;
    glint_error err;
    const glint_specular_inputs in = {.en = 1, .in_valid = 1, .cos = {GLINT_COS_ONE}};
    const glint_setting setting = glint_setting_specular(&config);
    assert_int_equal(glint_rtl_open(&setting, GLINT_RTL_FST, &child_rtl, &err), GLINT_OK);
    assert_int_equal(glint_rtl_trace_open(child_rtl, child_file, &err), GLINT_OK);
    for (int i = 0; i < 10; i++)
        glint_rtl_clock(child_rtl, &in);
    if (child_leaves)
        _exit(7);
    assert_string_equal("this assertion", "is to fail");
}

static int destroy_the_circuit(void **state)
{
    (void)state;
    glint_rtl_destroy(child_rtl);
    return 0;
}

static int run_as_child(const char *file, bool leaves)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_teardown(open_a_trace_and_fail, destroy_the_circuit)};
    child_file = file;
    child_leaves = leaves;
    return cmocka_run_group_tests(tests, NULL, NULL);
}

static void a_trace_is_closed_when_a_test_fails(void **state)
{
    (void)state;
    const char *const argv[] = {own_path, "child", scratch_path("failed.fst"), NULL};
    assert_int_equal(child_run(argv, 60), 1);
    char *said = scratch_read(scratch_path("child.err"), NULL);
    assert_non_null(strstr(said, "is to fail"));
    free(said);
    assert_true(glint_wave_is_whole(scratch_path("failed.fst")));
    vcd wave = vcd_read_fst(scratch_path("failed.fst"));
    /* The reset of creation is clock 1; ten clocks follow, from the falling edge before the first
     * to the one after the last. */
    assert_int_equal(wave.first_time, 15);
    assert_int_equal(wave.last_time, 115);
    vcd_free(&wave);
    /* The control: left without closing there is nothing to read, so the above is no accident. */
    const char *const leaving[] = {own_path, "unclosed", scratch_path("left.fst"), NULL};
    assert_int_equal(child_run(leaving, 60), 7);
    assert_false(glint_wave_is_whole(scratch_path("left.fst")));
}

/* ---- Circuits that do not answer
 * ------------------------------------------------------------------ */

static void lost_results_are_a_device_fault(void **state)
{
    (void)state;
    const glint_material material = {60, 255, 190, 110};
    const uint32_t cosine[5] = {GLINT_COS_ONE, GLINT_COS_ONE, GLINT_COS_ONE, GLINT_COS_ONE, 0};
    uint8_t r[5];
    uint8_t g[5];
    uint8_t b[5];
    glint_rtl *rtl;
    glint_error err;
    const glint_setting setting = setting_of("silent");
    const glint_points points = {cosine, 5, NULL, r, g, b};
    assert_int_equal(glint_rtl_open(&setting, GLINT_RTL_FAST, &rtl, &err), GLINT_OK);
    assert_int_equal(glint_rtl_shade(rtl, &material, &points, &err), GLINT_DEVICE_FAULT);
    assert_string_equal(err.text, "the circuit returned 0 of 5 results");
    glint_rtl_destroy(rtl);
}

/* Register 2 under another name: both builds are checked against the description. */
static void a_missing_signal_is_a_device_fault(void **state)
{
    (void)state;
    static char directory[1024];
    char command[8192];
    (void)snprintf(directory, sizeof directory, "%s", scratch_path("blind"));
    (void)snprintf(command, sizeof command,
                   "mkdir %s && cp rtl/*.v rtl/*.vh %s && sed 's/\\breg2\\b/register2/g' "
                   "rtl/specular_device.v > %s/specular_device.v",
                   directory, directory, directory);
    assert_int_equal(system(command), 0);
    glint_setting setting = glint_setting_specular(&config);
    setting.verilog = directory;
    for (int kind = 0; kind < 2; kind++) {
        glint_rtl *rtl;
        glint_error err;
        assert_int_equal(
            glint_rtl_open(&setting, kind == 0 ? GLINT_RTL_OBSERVED : GLINT_RTL_FAST, &rtl, &err),
            GLINT_DEVICE_FAULT);
        assert_null(rtl);
        assert_non_null(strstr(err.text, "reg2"));
    }
}

int main(int argc, char **argv)
{
    if (argc == 3)
        return run_as_child(argv[2], strcmp(argv[1], "unclosed") == 0);
    own_path = argv[0];
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_fault_is_found_and_named),
        cmocka_unit_test(at_most_sixteen_are_kept_and_all_are_counted),
        cmocka_unit_test(both_values_are_told),
        cmocka_unit_test(a_finding_can_be_replayed),
        cmocka_unit_test(a_trace_is_closed_when_a_test_fails),
        cmocka_unit_test(lost_results_are_a_device_fault),
        cmocka_unit_test(a_missing_signal_is_a_device_fault),
    };
    return cmocka_run_group_tests(tests, prepare, scratch_remove);
}
