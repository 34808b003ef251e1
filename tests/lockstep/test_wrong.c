/* The bench itself: with circuits that are wrong on purpose lockstep has to say so, name the block,
 * tell what led there, and leave a waveform that can be read. The faults: tests/lockstep/wrong. */
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
#include "lockstep/failure.h"
#include "lockstep/lockstep.h"
#include "lockstep/stimulus.h"
#include "rtl/rtl_model.h"
#include "wave/waveform.h"

extern const glint_rtl_model glint_wrong_truncating;
extern const glint_rtl_model glint_wrong_unstallable;
extern const glint_rtl_model glint_wrong_sigma_off_by_one;
extern const glint_rtl_model glint_wrong_late_limit;
extern const glint_rtl_model glint_wrong_silent;

enum { CLOCKS = 40000 };

/* A wrong circuit, and the blocks that may be named for it first. */
typedef struct fault {
    const char *name;
    const glint_rtl_model *model;
    const char *signals; /* of the first clock that differs, with a space after each */
    int first_block, last_block;
} fault;

static const fault faults[] = {
    {"truncating", &glint_wrong_truncating, "mul13 mul14 mul15 ", 13, 15},
    {"unstallable", &glint_wrong_unstallable, "reg1 ", 1, 1},
    {"sigma_off_by_one", &glint_wrong_sigma_off_by_one, "rom33 ", 33, 33},
    {"late_limit", &glint_wrong_late_limit, "rom9 ", 9, 9},
    {"silent", &glint_wrong_silent, "out_valid ", 0, 0},
};
#define FAULT_COUNT (sizeof faults / sizeof faults[0])

static const char *own_path;
static uint64_t seed;
static glint_lockstep_result result;

static char *report_text; /* here, as gcc takes the stream for a keeper of addresses */
static size_t report_size;

static int prepare(void **state)
{
    seed = seed_of_this_run();
    return scratch_make(state);
}

static glint_lockstep_options options_for(const fault *fault)
{
    return (glint_lockstep_options){
        .config = fault->model->config, .clocks = CLOCKS, .seed = seed, .model = fault->model};
}

static void run_lockstep(const glint_lockstep_options *options)
{
    glint_error err;
    memset(&result, 0x5a, sizeof result);
    if (glint_lockstep_run(options, &result, &err) != GLINT_OK) {
        fail_msg("%s", err.text);
    }
}

static bool is_named(const char *names, const char *name)
{
    char word[32];
    (void)snprintf(word, sizeof word, "%s ", name);
    return strstr(names, word) != NULL;
}

/* The inputs of a clock, 1…, once more. */
static glint_specular_inputs inputs_of(uint64_t clock)
{
    glint_stimulus stimulus;
    glint_specular_inputs inputs;
    glint_stimulus_init(&stimulus, seed, 1);
    for (uint64_t i = 0; i < clock; i++) {
        glint_stimulus_next(&stimulus, &inputs);
    }
    return inputs;
}

static int clean_up(void **state)
{
    free(report_text);
    return scratch_remove(state);
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
            assert_true(m->model != m->rtl);
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

/* The C model is right whatever the circuit: its value is what the pure function says, or follows
 * from the inputs. */
static void both_values_are_told(void **state)
{
    (void)state;
    const fault *sigma = &faults[2];
    const fault *limit = &faults[3];
    glint_lockstep_options options = options_for(sigma);
    run_lockstep(&options);
    assert_int_equal(result.mismatch[0].model, 166571);
    assert_int_equal(result.mismatch[0].rtl, 166572);
    options = options_for(limit);
    run_lockstep(&options);
    assert_int_equal(result.mismatch[0].model, 261359);
    assert_int_equal(result.mismatch[0].rtl, 261360);
}

/* What registers 2 to 5 hold before a clock. */
static glint_material material_before(uint64_t clock)
{
    glint_material material = {0};
    glint_stimulus stimulus;
    glint_stimulus_init(&stimulus, seed, 1);
    for (uint64_t i = 1; i < clock; i++) {
        glint_specular_inputs in;
        glint_stimulus_next(&stimulus, &in);
        if (in.reset) {
            material = (glint_material){0};
            continue;
        }
        if (in.en && in.n_we) {
            material.n = in.n;
        }
        if (in.en && in.rgb_we) {
            material.r = in.r;
            material.g = in.g;
            material.b = in.b;
        }
    }
    return material;
}

/* From the clock at which the oldest point in flight entered, or from the first. */
static void the_inputs_that_led_there_are_kept(void **state)
{
    (void)state;
    for (size_t f = 0; f < FAULT_COUNT; f++) {
        const glint_lockstep_options options = options_for(&faults[f]);
        int edges = 0;
        run_lockstep(&options);
        assert_in_range(result.history_count, 1, GLINT_HISTORY);
        assert_true(result.history_clock + (uint64_t)result.history_count - 1 ==
                    result.first_clock);
        for (int i = 0; i < result.history_count; i++) {
            const glint_specular_inputs expected = inputs_of(result.history_clock + (uint64_t)i);
            assert_memory_equal(&result.history[i], &expected, sizeof expected);
            edges += expected.en || expected.reset;
        }
        assert_true(edges >= GLINT_LATENCY_PIPELINED || result.history_clock == 1 ||
                    result.history_count == GLINT_HISTORY);
        const glint_material material = material_before(result.history_clock);
        assert_int_equal(result.material.n, material.n);
        assert_int_equal(result.material.r, material.r);
        assert_int_equal(result.material.g, material.g);
        assert_int_equal(result.material.b, material.b);
    }
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
        assert_true(result.mismatch[0].model == first.mismatch[0].model);
        assert_true(result.mismatch[0].rtl == first.mismatch[0].rtl);
        if (first.first_clock > 1) {
            options.clocks = first.first_clock - 1;
            run_lockstep(&options);
            assert_true(result.mismatches == 0);
        }
    }
}

/* ---- The text -----------------------------------------------------------------------------------
 */

static const char *report(const glint_lockstep_options *options)
{
    free(report_text);
    report_text = NULL;
    FILE *out = open_memstream(&report_text, &report_size);
    assert_non_null(out);
    glint_lockstep_report(out, options, &result);
    assert_int_equal(fclose(out), 0);
    return report_text;
}

static void assert_says(const char *text, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

static void assert_says(const char *text, const char *format, ...)
{
    char part[512];
    va_list args;
    va_start(args, format);
    (void)vsnprintf(part, sizeof part, format, args);
    va_end(args);
    if (strstr(text, part) == NULL) {
        fail_msg("the report does not say \"%s\":\n%s", part, text);
    }
}

static int count_lines_from(const char *text, const char *heading, const char *next_heading)
{
    int lines = 0;
    const char *at = heading != NULL ? strstr(text, heading) : text;
    assert_non_null(at);
    const char *end = next_heading != NULL ? strstr(at, next_heading) : at + strlen(at);
    assert_non_null(end);
    for (; at < end; at++) {
        lines += *at == '\n';
    }
    return lines - 1; /* the heading's own */
}

static void the_text_tells_all_of_it(void **state)
{
    (void)state;
    for (size_t f = 0; f < FAULT_COUNT; f++) {
        const glint_lockstep_options options = options_for(&faults[f]);
        run_lockstep(&options);
        const glint_mismatch *m = &result.mismatch[0];
        const char *text = report(&options);
        assert_says(text, "%" PRIu64 " mismatches of %" PRIu64, result.mismatches,
                    result.comparisons);
        assert_says(text, "gate cosine, pipeline pipelined, lanes 1");
        assert_says(text, "clock %" PRIu64 ": %s", m->clock, m->signal.name);
        if (m->signal.block != 0) {
            assert_says(text, "block %d, %s", m->signal.block, m->signal.meaning);
        }
        for (int i = 0; i < result.history_count; i++) {
            const glint_specular_inputs *in = &result.history[i];
            assert_says(text,
                        "reset %d en %d n_we %d n %u rgb_we %d rgb %u,%u,%u in_valid 0x%x cos "
                        "0x%05" PRIx32 "\n",
                        in->reset, in->en, in->n_we, in->n, in->rgb_we, in->r, in->g, in->b,
                        in->in_valid, in->cos[0]);
        }
        assert_says(text, "held n = %u, %u, %u, %u before", result.material.n, result.material.r,
                    result.material.g, result.material.b);
        assert_says(text, "  clock %" PRIu64 ": reset %d ", result.history_clock,
                    result.history[0].reset);
        assert_int_equal(count_lines_from(text, NULL, "inputs that led to the first"), result.kept);
        assert_int_equal(count_lines_from(text, "inputs that led to the first", "totals:"),
                         result.history_count);
        assert_int_equal(count_lines_from(text, "totals:", NULL), result.totals_count);
    }
}

/* Both values, in hexadecimal and as the number they stand for. */
static void the_text_shows_values_as_numbers(void **state)
{
    (void)state;
    const glint_lockstep_options options = options_for(&faults[2]);
    run_lockstep(&options);
    const char *text = report(&options);
    /* 166571 / 8192 and 166572 / 8192 */
    assert_says(text, ": rom33, block 33, ");
    assert_says(text, "model 0x028aab (20.333374), rtl 0x028aac (20.3334961)\n");
}

/* ---- The waveform -------------------------------------------------------------------------------
 */

static void full_name(const glint_signal_info *signal, char *name, size_t size)
{
    if (signal->lane >= 0) {
        (void)snprintf(name, size, "TOP.specular_device.lane[%d].u.%s", signal->lane, signal->name);
    } else {
        (void)snprintf(name, size, "TOP.specular_device.%s", signal->name);
    }
}

/* Where the marker stands: the number after the zoom in the line that starts with '*'. */
static uint64_t marker_of(const char *save_file)
{
    char *text = scratch_read(save_file, NULL);
    const char *line = strstr(text, "\n*");
    uint64_t marker = 0;
    double zoom;
    assert_non_null(line);
    assert_int_equal(sscanf(line, "\n*%lf %" SCNu64, &zoom, &marker), 2);
    free(text);
    return marker;
}

static void assert_waveform_shows(const glint_failure_files *files)
{
    glint_error err;
    glint_wave_info info;
    assert_int_equal(glint_wave_read_info(files->waveform, &info, &err), GLINT_OK);
    const uint64_t marker = marker_of(files->save_file);
    assert_true(info.signals > 40);
    assert_true(info.first_time < marker && marker < info.last_time);
    /* A window around the failure, not the whole run. */
    assert_true(info.last_time - info.first_time <= 42 * GLINT_RTL_TRACE_PERIOD);

    assert_int_equal(glint_wave_fst_to_vcd(files->waveform, scratch_path("wave.vcd"), &err),
                     GLINT_OK);
    vcd wave = vcd_read(scratch_path("wave.vcd"));
    for (int i = 0; i < result.kept && result.mismatch[i].clock == result.first_clock; i++) {
        char name[128];
        full_name(&result.mismatch[i].signal, name, sizeof name);
        assert_true(vcd_value(&wave, name, marker) == result.mismatch[i].rtl);
    }
    /* The pins of that clock, too. */
    const glint_specular_inputs in = inputs_of(result.first_clock);
    assert_int_equal(vcd_value(&wave, "TOP.specular_device.cos", marker), in.cos[0]);
    assert_int_equal(vcd_value(&wave, "TOP.specular_device.n", marker), in.n);
    assert_int_equal(vcd_value(&wave, "TOP.specular_device.in_valid", marker), in.in_valid);
    vcd_free(&wave);
}

static void a_readable_waveform_is_left(void **state)
{
    (void)state;
    for (size_t f = 0; f < FAULT_COUNT; f++) {
        static glint_failure_files files;
        char directory[64];
        glint_error err;
        const glint_lockstep_options options = options_for(&faults[f]);
        run_lockstep(&options);
        (void)snprintf(directory, sizeof directory, "%s/made", faults[f].name);
        if (glint_lockstep_failure_wave(&options, &result, scratch_path(directory), &files, &err) !=
            GLINT_OK) {
            fail_msg("%s", err.text);
        }
        assert_waveform_shows(&files);
    }
}

static void a_waveform_that_cannot_be_written_is_told(void **state)
{
    (void)state;
    static glint_failure_files files;
    glint_error err;
    const glint_lockstep_options options = options_for(&faults[0]);
    run_lockstep(&options);
    scratch_write(scratch_path("plain"), "", 0);
    assert_int_equal(
        glint_lockstep_failure_wave(&options, &result, scratch_path("plain/x"), &files, &err),
        GLINT_IO_ERROR);
    assert_non_null(strstr(err.text, "plain"));
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
    assert_int_equal(
        glint_rtl_create(&(glint_specular_config){GLINT_GATE_COSINE, GLINT_PIPELINE_PIPELINED, 1},
                         &child_rtl, &err),
        GLINT_OK);
    assert_int_equal(glint_rtl_trace_open(child_rtl, child_file, &err), GLINT_OK);
    for (int i = 0; i < 10; i++) {
        glint_rtl_clock(child_rtl, &in);
    }
    if (child_leaves) {
        _exit(7);
    }
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
    glint_error err;
    glint_wave_info info;
    const char *const argv[] = {own_path, "child", scratch_path("failed.fst"), NULL};
    assert_int_equal(child_run(argv, 60), 1);
    char *said = scratch_read(scratch_path("child.err"), NULL);
    assert_non_null(strstr(said, "is to fail"));
    free(said);
    if (glint_wave_read_info(scratch_path("failed.fst"), &info, &err) != GLINT_OK) {
        fail_msg("%s", err.text);
    }
    /* The reset of creation is clock 1; ten clocks follow, from the falling edge before the first
     * to the one after the last. */
    assert_int_equal(info.first_time, 15);
    assert_int_equal(info.last_time, 115);
    /* The control: left without closing there is nothing to read, so the above is no accident. */
    const char *const leaving[] = {own_path, "unclosed", scratch_path("left.fst"), NULL};
    assert_int_equal(child_run(leaving, 60), 7);
    assert_int_equal(glint_wave_read_info(scratch_path("left.fst"), &info, &err), GLINT_BAD_INPUT);
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
    assert_int_equal(
        glint_rtl_create_from(&glint_wrong_silent, &glint_wrong_silent.config, &rtl, &err),
        GLINT_OK);
    assert_int_equal(glint_rtl_batch(rtl, &material, cosine, 5, NULL, r, g, b, &err),
                     GLINT_DEVICE_FAULT);
    assert_string_equal(err.text, "the circuit returned 0 of 5 results");
    glint_rtl_destroy(rtl);
}

static bool find_nothing(void *instance, int lane, const char *name, const void **data, int *size)
{
    (void)instance;
    (void)lane;
    (void)name;
    (void)data;
    (void)size;
    return false;
}

static void a_missing_signal_is_a_device_fault(void **state)
{
    (void)state;
    glint_rtl_model blind = glint_wrong_silent;
    blind.find = find_nothing;
    glint_rtl *rtl;
    glint_error err;
    assert_int_equal(glint_rtl_create_from(&blind, &blind.config, &rtl, &err), GLINT_DEVICE_FAULT);
    assert_null(rtl);
    assert_non_null(strstr(err.text, "the circuit has no signal reg2"));
}

static void *create_nothing(void)
{
    return NULL;
}

static void no_memory_for_a_circuit_is_told(void **state)
{
    (void)state;
    glint_rtl_model poor = glint_wrong_silent;
    poor.create = create_nothing;
    glint_rtl *rtl;
    glint_error err;
    assert_int_equal(glint_rtl_create_from(&poor, &poor.config, &rtl, &err), GLINT_NO_MEMORY);
    assert_null(rtl);
}

int main(int argc, char **argv)
{
    if (argc == 3) {
        return run_as_child(argv[2], strcmp(argv[1], "unclosed") == 0);
    }
    own_path = argv[0];
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_fault_is_found_and_named),
        cmocka_unit_test(at_most_sixteen_are_kept_and_all_are_counted),
        cmocka_unit_test(both_values_are_told),
        cmocka_unit_test(the_inputs_that_led_there_are_kept),
        cmocka_unit_test(a_finding_can_be_replayed),
        cmocka_unit_test(the_text_tells_all_of_it),
        cmocka_unit_test(the_text_shows_values_as_numbers),
        cmocka_unit_test(a_readable_waveform_is_left),
        cmocka_unit_test(a_waveform_that_cannot_be_written_is_told),
        cmocka_unit_test(a_trace_is_closed_when_a_test_fails),
        cmocka_unit_test(lost_results_are_a_device_fault),
        cmocka_unit_test(a_missing_signal_is_a_device_fault),
        cmocka_unit_test(no_memory_for_a_circuit_is_told),
    };
    return cmocka_run_group_tests(tests, prepare, clean_up);
}
