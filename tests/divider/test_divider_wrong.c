/* Lockstep itself: with dividers that are wrong on purpose it has to say so, with clock, signal and
 * values, tell what led there, and leave a waveform that can be read. The faults:
 * tests/divider/wrong. */
#define _XOPEN_SOURCE 700

#include <inttypes.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "../scratch.h"

#include "../seed.h"
#include "../wave/saved.h"
#include "../wave/vcd.h"
#include "lockstep/divider_failure.h"
#include "lockstep/divider_lockstep.h"
#include "rtl/divider_model.h"
#include "rtl/rtl.h"
#include "signal_name.h"
#include "wave/waveform.h"

extern const glint_divider_model glint_wrong_divider_logical_shift;
extern const glint_divider_model glint_wrong_divider_late_done;
extern const glint_divider_model glint_wrong_divider_restarting;
extern const glint_divider_model glint_wrong_divider_table_off_by_one;
extern const glint_divider_model glint_wrong_divider_unsigned_stage;

enum { CLOCKS = 20000, SHIFTS = 12 };

/* A wrong circuit, and the signals that may be named for it first. */
typedef struct fault {
    const char *name;
    const glint_divider_model *model;
    const char *signals; /* with a space after each */
} fault;

static const fault faults[] = {
    {"logical_shift", &glint_wrong_divider_logical_shift, "shifted "},
    {"late_done", &glint_wrong_divider_late_done, "done "},
    {"restarting", &glint_wrong_divider_restarting, "busy bits_rg left "},
    {"table_off_by_one", &glint_wrong_divider_table_off_by_one, "rom_bits "},
    {"unsigned_stage", &glint_wrong_divider_unsigned_stage, "quotient_g acc_g "},
};
#define FAULT_COUNT (sizeof faults / sizeof faults[0])

static uint64_t seed;
static glint_divider_lockstep_result result;

static char *report_text; /* here, as gcc takes the stream for a keeper of addresses */
static size_t report_size;

static int prepare(void **state)
{
    seed = seed_of_this_run();
    return scratch_make(state);
}

static int clean_up(void **state)
{
    free(report_text);
    return scratch_remove(state);
}

static glint_divider_lockstep_options options_for(const fault *fault)
{
    return (glint_divider_lockstep_options){.form = fault->model->form,
                                            .shifts = fault->model->shifts,
                                            .clocks = CLOCKS,
                                            .seed = seed,
                                            .model = fault->model};
}

static void run_lockstep(const glint_divider_lockstep_options *options)
{
    glint_error err;
    memset(&result, 0x5a, sizeof result);
    if (glint_divider_lockstep_run(options, &result, &err) != GLINT_OK) {
        fail_msg("%s", err.text);
    }
}

static bool is_named(const char *names, const char *name)
{
    char word[32];
    (void)snprintf(word, sizeof word, "%s ", name);
    return strstr(names, word) != NULL;
}

/* The pins of a clock, 1…, once more. */
static glint_divider_inputs inputs_of(uint64_t clock)
{
    glint_divider_stimulus stimulus;
    glint_divider_inputs inputs;
    glint_divider_stimulus_init(&stimulus, seed);
    for (uint64_t i = 0; i < clock; i++) {
        glint_divider_stimulus_next(&stimulus, &inputs);
    }
    return inputs;
}

/* ---- The finding --------------------------------------------------------------------------------
 */

static void every_fault_is_found_and_named(void **state)
{
    (void)state;
    for (size_t f = 0; f < FAULT_COUNT; f++) {
        const glint_divider_lockstep_options options = options_for(&faults[f]);
        run_lockstep(&options);
        const glint_lockstep_result *found = &result.found;
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
        const glint_divider_lockstep_options options = options_for(&faults[f]);
        uint64_t total = 0;
        run_lockstep(&options);
        const glint_lockstep_result *found = &result.found;
        assert_int_equal(found->kept, found->mismatches < 16 ? (int)found->mismatches : 16);
        for (int i = 0; i < found->kept; i++) {
            const glint_mismatch *m = &found->mismatch[i];
            assert_true(m->model != m->rtl);
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

/* The model's value is right whatever the circuit does. */
static void both_values_are_told(void **state)
{
    (void)state;
    glint_divider_lockstep_options options = options_for(&faults[3]);
    run_lockstep(&options);
    assert_int_equal(result.found.mismatch[0].model, 585);
    assert_int_equal(result.found.mismatch[0].rtl, 586);
    options = options_for(&faults[1]);
    run_lockstep(&options);
    assert_int_equal(result.found.mismatch[0].model, 1);
    assert_int_equal(result.found.mismatch[0].rtl, 0);
    /* 0 instead of the sign from the left: they differ in the highest bit alone. */
    options = options_for(&faults[0]);
    run_lockstep(&options);
    assert_true((result.found.mismatch[0].model ^ result.found.mismatch[0].rtl) ==
                UINT64_C(1) << (GLINT_DIVIDER_DIFFERENCE_BITS + SHIFTS - 1));
}

/* The pins of the last clocks, the one that failed included. */
static void the_inputs_that_led_there_are_kept(void **state)
{
    (void)state;
    for (size_t f = 0; f < FAULT_COUNT; f++) {
        const glint_divider_lockstep_options options = options_for(&faults[f]);
        run_lockstep(&options);
        const uint64_t first = result.found.first_clock;
        /* As far back as latency + 1 edges that were not stalled, or to the first clock. */
        const int wanted = glint_divider_latency(options.shifts) + 1;
        int edges = 0;
        for (int i = 0; i < result.history_count; i++) {
            edges += result.history[i].en != 0 || result.history[i].reset != 0;
        }
        assert_true(result.history_count > 0 && edges <= wanted);
        if ((uint64_t)result.history_count < first) {
            assert_int_equal(edges, wanted);
            assert_true(result.history[0].en != 0 || result.history[0].reset != 0);
        }
        for (int i = 0; i < result.history_count; i++) {
            const glint_divider_inputs expected =
                inputs_of(first - (uint64_t)(result.history_count - 1 - i));
            assert_memory_equal(&result.history[i], &expected, sizeof expected);
        }
    }
}

/* The seed and the number of clocks are all it takes: the same again; nothing a clock earlier. */
static void a_finding_can_be_replayed(void **state)
{
    (void)state;
    static glint_divider_lockstep_result first;
    for (size_t f = 0; f < FAULT_COUNT; f++) {
        glint_divider_lockstep_options options = options_for(&faults[f]);
        run_lockstep(&options);
        first = result;
        options.clocks = first.found.first_clock;
        run_lockstep(&options);
        assert_true(result.found.first_clock == options.clocks && result.found.mismatches > 0);
        assert_string_equal(result.found.mismatch[0].signal.name,
                            first.found.mismatch[0].signal.name);
        assert_true(result.found.mismatch[0].model == first.found.mismatch[0].model);
        assert_true(result.found.mismatch[0].rtl == first.found.mismatch[0].rtl);
        if (options.clocks > 1) {
            options.clocks--;
            run_lockstep(&options);
            assert_true(result.found.mismatches == 0);
        }
    }
}

/* ---- The text -----------------------------------------------------------------------------------
 */

static const char *report(const glint_divider_lockstep_options *options)
{
    free(report_text);
    report_text = NULL;
    FILE *out = open_memstream(&report_text, &report_size);
    assert_non_null(out);
    glint_divider_lockstep_report(out, options, &result);
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

static int count_lines(const char *text)
{
    int lines = 0;
    for (; *text != '\0'; text++) {
        lines += *text == '\n';
    }
    return lines;
}

static void the_text_tells_all_of_it(void **state)
{
    (void)state;
    for (size_t f = 0; f < FAULT_COUNT; f++) {
        const glint_divider_lockstep_options options = options_for(&faults[f]);
        run_lockstep(&options);
        const glint_lockstep_result *found = &result.found;
        const glint_mismatch *m = &found->mismatch[0];
        const char *text = report(&options);
        assert_says(text, "divider %s, 12 shifts: %" PRIu64 " mismatches of %" PRIu64 "\n",
                    glint_divider_form_name(options.form), found->mismatches, found->comparisons);
        if (m->signal.lane >= 0) {
            assert_says(text, "clock %" PRIu64 ": %s, stage %d, %s: model 0x", m->clock,
                        m->signal.name, m->signal.lane, m->signal.meaning);
        } else {
            assert_says(text, "clock %" PRIu64 ": %s, %s: model 0x", m->clock, m->signal.name,
                        m->signal.meaning);
        }
        for (int i = 0; i < result.history_count; i++) {
            const glint_divider_inputs *in = &result.history[i];
            assert_says(
                text, "  clock %" PRIu64 ": reset %d en %d start %d k %d difference %d,%d,%d\n",
                found->first_clock - (uint64_t)(result.history_count - 1 - i), in->reset, in->en,
                in->start, in->k, in->difference[0], in->difference[1], in->difference[2]);
        }
        /* The heading, "inputs that led to the first" and "totals". */
        assert_int_equal(count_lines(text),
                         3 + found->kept + result.history_count + found->totals_count);
    }
}

/* Both values, in hexadecimal and as the number they stand for. */
static void the_text_shows_values_as_numbers(void **state)
{
    (void)state;
    glint_divider_lockstep_options options = options_for(&faults[3]);
    run_lockstep(&options);
    assert_says(report(&options), ": rom_bits, %s: model 0x0249 (585), rtl 0x024a (586)\n",
                result.found.mismatch[0].signal.meaning);
    options = options_for(&faults[0]);
    run_lockstep(&options);
    /* Signed, with twelve fraction bits. */
    const glint_mismatch *m = &result.found.mismatch[0];
    assert_says(report(&options), "model 0x%06" PRIx64 " (%.9g), rtl 0x%06" PRIx64 " (%.9g)\n",
                m->model, ((double)m->model - 2097152.0) / 4096.0, m->rtl, (double)m->rtl / 4096.0);
}

/* ---- The waveform -------------------------------------------------------------------------------
 */

static void assert_waveform_shows(const glint_divider_lockstep_options *options,
                                  const glint_failure_files *files)
{
    static saved save_file;
    glint_error err;
    glint_wave_info info;
    assert_int_equal(glint_wave_read_info(files->waveform, &info, &err), GLINT_OK);
    saved_read(files->save_file, &save_file);
    const uint64_t marker = (uint64_t)save_file.marker;
    /* The reset of creation is the circuit's first clock. */
    assert_int_equal(marker, (result.found.first_clock + 1) * GLINT_RTL_TRACE_PERIOD);
    assert_true(info.first_time < marker && marker < info.last_time);
    assert_true(info.last_time - info.first_time <= 42 * GLINT_RTL_TRACE_PERIOD);
    assert_non_null(strstr(files->waveform, save_file.dumpfile));

    assert_int_equal(glint_wave_fst_to_vcd(files->waveform, scratch_path("wave.vcd"), &err),
                     GLINT_OK);
    vcd wave = vcd_read(scratch_path("wave.vcd"));
    for (int t = 0; t < save_file.count; t++) {
        const vcd_signal *signal = vcd_find(&wave, save_file.trace[t].name);
        assert_non_null(signal);
        assert_int_equal(signal->width, save_file.trace[t].width);
    }
    for (int i = 0; i < result.found.kept; i++) {
        const glint_mismatch *m = &result.found.mismatch[i];
        char name[112];
        if (m->clock != result.found.first_clock) {
            break;
        }
        divider_signal_name(options->form, &m->signal, name, sizeof name);
        assert_true(vcd_value(&wave, name, marker) == m->rtl);
    }
    /* The pins of that clock, too. */
    const glint_divider_inputs in = inputs_of(result.found.first_clock);
    const bool sequential = options->form == GLINT_DIVIDER_SEQUENTIAL;
    const char *top = divider_top(options->form);
    char name[112];
    (void)snprintf(name, sizeof name, "%s.k", top);
    assert_int_equal(vcd_value(&wave, name, marker), in.k);
    (void)snprintf(name, sizeof name, "%s.%s", top, sequential ? "start" : "in_valid");
    assert_int_equal(vcd_value(&wave, name, marker), in.start);
    (void)snprintf(name, sizeof name, "%s.%s", top, sequential ? "difference" : "difference_r");
    assert_int_equal(vcd_value(&wave, name, marker), in.difference[0] & 511);
    vcd_free(&wave);
}

static void a_readable_waveform_is_left(void **state)
{
    (void)state;
    for (size_t f = 0; f < FAULT_COUNT; f++) {
        static glint_failure_files files;
        char directory[64];
        char name[128];
        glint_error err;
        const glint_divider_lockstep_options options = options_for(&faults[f]);
        run_lockstep(&options);
        (void)snprintf(directory, sizeof directory, "%s/made", faults[f].name);
        if (glint_divider_failure_wave(&options, &result, scratch_path(directory), &files, &err) !=
            GLINT_OK) {
            fail_msg("%s", err.text);
        }
        (void)snprintf(name, sizeof name, "%s/mismatch_divider_%s_12.fst", directory,
                       glint_divider_form_name(options.form));
        assert_string_equal(files.waveform, scratch_path(name));
        assert_waveform_shows(&options, &files);
    }
}

static void a_waveform_that_cannot_be_written_is_told(void **state)
{
    (void)state;
    static glint_failure_files files;
    glint_error err;
    const glint_divider_lockstep_options options = options_for(&faults[0]);
    run_lockstep(&options);
    scratch_write(scratch_path("plain"), "", 0);
    assert_int_equal(
        glint_divider_failure_wave(&options, &result, scratch_path("plain/x"), &files, &err),
        GLINT_IO_ERROR);
    assert_non_null(strstr(err.text, "plain"));
}

int main(void)
{
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
    };
    return cmocka_run_group_tests(tests, prepare, clean_up);
}
