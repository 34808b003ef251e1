/* Packets of random runs: for each deliberately broken circuit, the few clocks kept must reproduce
 * the mismatch, and the text, the waveform and the save file must be right. */
#define _XOPEN_SOURCE 700

#include <inttypes.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "../scratch.h"

#include "../lockstep/mock_rtl.h"
#include "../record.h"
#include "../seed.h"
#include "../wave/saved.h"
#include "../wave/vcd.h"
#include "circuit/random_pins.h"
#include "failure/packet.h"
#include "failure/report.h"
#include "faults.h"
#include "lockstep/twin.h"

enum { CLOCKS = 40000 };

static uint64_t seed;

/* The case at hand: of one fault. */
static glint_lockstep_options options;
static glint_lockstep_result result;
static glint_failure *failure;
static glint_capture *capture;
static char *text; /* here, as gcc takes the stream for a keeper of addresses */
static size_t text_size;

static int prepare(void **state)
{
    seed = seed_of_this_run();
    return scratch_make(state);
}

static int clean_up(void **state)
{
    free(text);
    free(capture);
    glint_failure_destroy(failure);
    return scratch_remove(state);
}

static void assert_done(glint_status status, const glint_error *err)
{
    if (status != GLINT_OK)
        fail_msg("%s", err->text);
}

/* Runs lockstep on a setting, and makes the case of what it finds. */
static void find_in(const glint_setting *setting, uint64_t clocks)
{
    glint_error err;
    glint_failure_finding again;
    free(capture);
    glint_failure_destroy(failure);
    capture = NULL;
    failure = NULL;
    options = (glint_lockstep_options){.setting = *setting, .clocks = clocks, .seed = seed};
    assert_done(glint_lockstep_run(&options, &result, &err), &err);
    assert_true(result.mismatches != 0);
    assert_done(glint_failure_of_lockstep(&options, &result, &failure, &err), &err);
    (void)snprintf(failure->command, sizeof failure->command, "build/glint verify whole");
    assert_done(glint_failure_play(failure, NULL, &again, &capture, &err), &err);
}

static void find(const fault *fault)
{
    const glint_setting setting = setting_of(fault, true);
    find_in(&setting, CLOCKS);
}

/* ---- The clocks that are kept ------------------------------------------------------------------
 */

/* The number at a pin of the thesis's circuits. */
static int64_t pin_value(const glint_pins *pins, int index)
{
    uint64_t words[GLINT_VALUE_WORDS];
    const glint_pin_info pin = glint_setting_pin(&options.setting, index);
    glint_pin_get(&pin, pins, words);
    const bool is_negative = pin.is_signed && (words[0] >> (glint_pin_width(&pin) - 1) & 1) != 0;
    return (int64_t)words[0] - (is_negative ? INT64_C(1) << glint_pin_width(&pin) : 0);
}

/* The model and the pins of the whole run, from clock 1 on, against what was kept. */
static void assert_as_in_the_run(void)
{
    glint_random_pins source;
    glint_twin *twin;
    glint_error err;
    int row = 0;
    assert_done(glint_twin_create(&options.setting, &twin, &err), &err);
    const size_t size = (size_t)glint_twin_signals(twin)->words * sizeof(uint64_t);
    glint_random_pins_begin(&source, &options.setting, seed);
    for (uint64_t clock = 1; row < capture->count; clock++) {
        glint_pins pins;
        uint64_t model[GLINT_SIGNAL_WORDS_MAX], rtl[GLINT_SIGNAL_WORDS_MAX];
        glint_random_pins_next(&source, &pins);
        glint_twin_clock(twin, &pins);
        if (clock < capture->clock[row].clock)
            continue;
        const glint_capture_clock *kept = &capture->clock[row++];
        glint_twin_read(twin, model, rtl);
        assert_int_equal(kept->clock, clock);
        assert_memory_equal(kept->model, model, size);
        assert_memory_equal(kept->rtl, rtl, size);
        for (int i = 0; i < glint_setting_pin_count(&options.setting); i++)
            assert_int_equal(pin_value(&kept->pins, i), pin_value(&pins, i));
    }
    glint_twin_destroy(twin);
}

static void a_few_clocks_show_it_again(void **state)
{
    (void)state;
    for (size_t f = 0; f < FAULT_COUNT; f++) {
        glint_failure_finding again;
        glint_error err;
        find(&faults[f]);
        const uint64_t failing = result.first_clock;
        print_message("%-18s clock %5" PRIu64 ": %zu clocks kept\n", faults[f].name, failing,
                      failure->pin_count);
        assert_true(failure->finding.clock == failing);
        assert_non_null(failure->pins);
        assert_true(failure->first_clock + failure->pin_count - 1 == failing + 8);
        assert_done(glint_failure_play(failure, NULL, &again, NULL, &err), &err);
        assert_true(glint_failure_same(&again, &failure->finding));
        assert_true(capture->clock[capture->failing].clock == failing);
        assert_int_equal(capture->failing, failing > 32 ? 32 : (int)failing - 1);
        assert_int_equal(capture->count, capture->failing + 9);
        assert_as_in_the_run();
    }
}

/* ---- A circuit that remembers what cannot be seen -----------------------------------------------
 */

/* Right, but for the clock LATE after its creation, when the lowest bit of out_r is inverted. */
enum { LATE = 20000 };
static int clocks_run, true_place;

static void start_counting(void)
{
    clocks_run = 0;
}

static void clock_counting(glint_rtl *rtl, const void *pins)
{
    __real_glint_rtl_clock(rtl, pins);
    clocks_run++;
}

static void read_counting(const glint_rtl *rtl, uint64_t *words)
{
    __real_glint_rtl_read(rtl, words);
    words[true_place] ^= clocks_run == LATE;
}

/* Where out_r has its word. */
static int place_of_out_r(const glint_setting *setting)
{
    static glint_signals signals;
    glint_error err;
    int i = 0;
    assert_done(glint_signals_find(setting, &signals, &err), &err);
    while (strcmp(signals.info[i].name, "out_r") != 0)
        i++;
    return signals.place[i];
}

static void without_a_shorter_way_the_whole_run_is_played(void **state)
{
    (void)state;
    glint_error err;
    glint_failure_finding again;
    glint_setting setting = specular_setting(GLINT_GATE_SIGN, GLINT_PIPELINE_COMBINATIONAL, 1);
    setting.verilog = mock_verilog;
    true_place = place_of_out_r(&setting);
    mock = (mock_rtl){.opened = start_counting, .clock = clock_counting, .read = read_counting};
    find_in(&setting, LATE + 100);
    assert_true(result.first_clock == LATE);
    assert_null(failure->pins);
    assert_int_equal(failure->first_clock, 1);
    assert_true(capture->clock[capture->failing].clock == LATE);
    assert_done(glint_packet_write(failure, NULL, scratch_path("whole"), &err), &err);
    char *report = scratch_read(scratch_path("whole/" GLINT_PACKET_REPORT), NULL);
    assert_non_null(strstr(report, "replayed from clock 1: no shorter part of the run"));
    free(report);
    glint_failure *read;
    assert_done(glint_packet_read(scratch_path("whole"), NULL, &read, &err), &err);
    assert_string_equal(read->rtl, mock_verilog);
    assert_null(read->setting.verilog);
    read->setting.verilog = mock_verilog;
    assert_done(glint_failure_play(read, NULL, &again, NULL, &err), &err);
    assert_true(glint_failure_same(&again, &read->finding));
    static const volatile bool stop = true;
    const glint_capture_control stopped = {.stop = &stop};
    assert_int_equal(glint_failure_play(read, &stopped, &again, NULL, &err), GLINT_INTERRUPTED);
    glint_failure_destroy(read);
    mock = (mock_rtl){0};
}

/* ---- The text ----------------------------------------------------------------------------------
 */

static void write_report(void)
{
    free(text);
    text = NULL;
    FILE *out = open_memstream(&text, &text_size);
    assert_non_null(out);
    glint_failure_report(out, failure, capture, "some/where");
    assert_int_equal(fclose(out), 0);
}

static void assert_says(const char *format, ...) __attribute__((format(printf, 1, 2)));

static void assert_says(const char *format, ...)
{
    char part[512];
    va_list args;
    va_start(args, format);
    (void)vsnprintf(part, sizeof part, format, args);
    va_end(args);
    if (strstr(text, part) == NULL)
        fail_msg("the report does not say \"%s\":\n%s", part, text);
}

/* The rows below the table's heading: the pins, numbers in any base, and both values. */
static void assert_table(void)
{
    const glint_setting *setting = &options.setting;
    const char *line = strstr(text, "\n       clock ");
    const int first = capture->failing < 32 ? 0 : capture->failing - 31;
    int signal = 0;
    assert_non_null(line);
    while (capture->clock[capture->failing].model[signal] ==
           capture->clock[capture->failing].rtl[signal])
        signal++;
    line = strchr(line + 1, '\n') + 1;
    for (int row = first; row <= capture->failing; row++, line = strchr(line, '\n') + 1) {
        const glint_capture_clock *clock = &capture->clock[row];
        char *end;
        assert_int_equal(line[0], row == capture->failing ? '>' : ' ');
        assert_true(strtoull(line + 1, &end, 10) == clock->clock);
        for (int i = 0; i < glint_setting_pin_count(setting); i++)
            assert_int_equal(strtoll(end, &end, 0), pin_value(&clock->pins, i));
        assert_true(strtoull(end, &end, 16) == clock->model[signal]);
        assert_true(strtoull(end, &end, 16) == clock->rtl[signal]);
        assert_int_equal(*end, '\n');
    }
    assert_true(*line != ' ' && *line != '>');
}

static void the_text_tells_all_of_it(void **state)
{
    (void)state;
    for (size_t f = 0; f < FAULT_COUNT; f++) {
        char name[GLINT_SETTING_TEXT];
        find(&faults[f]);
        write_report();
        glint_setting_describe(&options.setting, name);
        const glint_mismatch *m = &result.mismatch[0];
        assert_says("%s: %" PRIu64 " mismatches of %" PRIu64 "\n", name, result.mismatches,
                    result.comparisons);
        assert_says("  clock %" PRIu64 ": %s, ", m->clock, m->signal.name);
        assert_says("%s: model 0x", m->signal.meaning);
        assert_table();
        assert_says("\nseed: %" PRIu64 "\n", seed);
        assert_says("\nreplayed from clock %" PRIu64 ", %zu clocks\n", failure->first_clock,
                    failure->pin_count);
        assert_says("\nwhole:  build/glint verify whole\n");
        assert_says("\nlook:   gtkwave some/where/wave.vcd some/where/wave.gtkw\n");
        assert_says("\nreplay: build/glint replay some/where --rtl %s\n",
                    wrong_rtl(faults[f].name));
        for (int i = 0; i < result.totals_count; i++)
            assert_says(" %" PRIu64 "\n", result.totals[i].mismatches);
    }
}

/* Both values, in hexadecimal and as the number they stand for. */
static void the_text_shows_values_as_numbers(void **state)
{
    (void)state;
    find(&faults[2]); /* 166571 / 8192 and 166572 / 8192 */
    write_report();
    assert_says(": rom33, block 33, sigma = (n+1)/3: model 0x028aab (20.333374), rtl 0x028aac "
                "(20.3334961)\n");
    find(&faults[8]);
    write_report();
    assert_says(": rom_bits, table: bits i0 ... in of 1/k: model 0x0249 (585), rtl 0x024a (586)\n");
    find(&faults[5]);
    write_report();
    /* Signed, with twelve fraction bits. */
    const glint_mismatch *m = &result.mismatch[0];
    assert_says("model 0x%06" PRIx64 " (%.9g), rtl 0x%06" PRIx64 " (%.9g)\n", m->model[0],
                ((double)m->model[0] - 2097152.0) / 4096.0, m->rtl[0], (double)m->rtl[0] / 4096.0);
}

/* ---- The waveform ------------------------------------------------------------------------------
 */

static void variable_name(int lane, const char *name, const char *ending, char *full, size_t size)
{
    if (lane >= 0) {
        (void)snprintf(full, size, "TOP.%s[%d].%s%s", glint_setting_lane_name(&options.setting),
                       lane, name, ending);
    } else {
        (void)snprintf(full, size, "TOP.%s%s", name, ending);
    }
}

static uint64_t value_at(const vcd *wave, int lane, const char *name, const char *ending,
                         uint64_t time)
{
    char full[112];
    variable_name(lane, name, ending, full, sizeof full);
    return vcd_value(wave, full, time);
}

/* The number next to a fixed-point code has enough digits to distinguish it from the next
 * code's. */
static void assert_number(const vcd *wave, int lane, const char *name, const char *ending,
                          uint64_t time, double expected)
{
    char full[112];
    char variable[24];
    char text[64];
    char *end;
    (void)snprintf(variable, sizeof variable, "%s_real", ending);
    variable_name(lane, name, variable, full, sizeof full);
    vcd_text(wave, full, time, text, sizeof text);
    assert_null(strpbrk(text, "eE"));
    if (strtod(text, &end) != expected || *end != '\0')
        fail_msg("%s is %s, not %.17g", full, text, expected);
}

static double number_of(const glint_signal_info *signal, uint64_t bits)
{
    const int width = signal->int_bits + signal->frac_bits;
    const bool is_negative = signal->is_signed && (bits >> (width - 1)) != 0;
    return ldexp((double)bits - (is_negative ? ldexp(1, width) : 0), -signal->frac_bits);
}

/* Every pin and both sides of every signal in one clock. */
static void assert_clock(const vcd *wave, const glint_capture_clock *clock)
{
    const glint_setting *setting = &options.setting;
    const uint64_t edge = clock->clock * 10;
    bool differs = false;
    for (int i = 0; i < glint_setting_signal_count(setting); i++) {
        const glint_signal_info signal = glint_setting_signal(setting, i);
        assert_true(value_at(wave, signal.lane, signal.name, "_rtl", edge) == clock->rtl[i]);
        assert_true(value_at(wave, signal.lane, signal.name, "_model", edge) == clock->model[i]);
        differs |= clock->rtl[i] != clock->model[i];
        if (signal.frac_bits > 0) {
            assert_number(wave, signal.lane, signal.name, "_rtl", edge,
                          number_of(&signal, clock->rtl[i]));
            assert_number(wave, signal.lane, signal.name, "_model", edge,
                          number_of(&signal, clock->model[i]));
        }
    }
    for (int i = 0; i < glint_setting_pin_count(setting); i++) {
        const glint_pin_info pin = glint_setting_pin(setting, i);
        const uint64_t mask = (UINT64_C(1) << glint_pin_width(&pin)) - 1;
        const uint64_t value = (uint64_t)pin_value(&clock->pins, i) & mask;
        assert_true(value_at(wave, pin.lane, pin.name, "", edge) == value);
        assert_true(value_at(wave, pin.lane, pin.name, "", edge - 5) == value);
        if (pin.frac_bits > 0)
            assert_number(wave, pin.lane, pin.name, "", edge, ldexp((double)value, -pin.frac_bits));
    }
    assert_int_equal(vcd_value(wave, "TOP.mismatch", edge), differs);
    assert_true(vcd_value(wave, "TOP.clock", edge) == clock->clock);
    assert_int_equal(vcd_value(wave, "TOP.clk", edge), 1);
    assert_int_equal(vcd_value(wave, "TOP.clk", edge - 5), 0);
}

/* A flag for the signals that differ, and for no other. */
static void assert_flags(const vcd *wave)
{
    for (int i = 0; i < glint_setting_signal_count(&options.setting); i++) {
        const glint_signal_info signal = glint_setting_signal(&options.setting, i);
        char full[112];
        bool ever = false;
        variable_name(signal.lane, signal.name, "_differs", full, sizeof full);
        const bool there = vcd_find(wave, full) != NULL;
        for (int row = 0; row < capture->count; row++) {
            const glint_capture_clock *clock = &capture->clock[row];
            const bool differs = clock->rtl[i] != clock->model[i];
            ever |= differs;
            if (there)
                assert_int_equal(vcd_value(wave, full, clock->clock * 10), differs);
        }
        assert_int_equal(there, ever);
    }
}

/* Behind the last clock, where the waveform goes on, nothing is known. */
static void assert_end(const vcd *wave)
{
    const uint64_t last = capture->clock[capture->count - 1].clock * 10;
    char text[64];
    assert_true(wave->last_time >= last + 5);
    if (wave->last_time == last + 5)
        return;
    for (int i = 0; i < wave->signal_count; i++) {
        vcd_text(wave, wave->signals[i].name, last + 10, text, sizeof text);
        assert_int_equal(strspn(text, "x"), strlen(text));
    }
}

/* GTKWave drops a fraction below 0.0001, and cuts off what has no room in a clock: no code is shown
 * as a number with a fraction, and long ones in hex. The number is a row of its own. */
static void assert_trace_hides_nothing(const saved *file, int t)
{
    const saved_trace *trace = &file->trace[t];
    const char *name = strrchr(trace->name, '.') + 1;
    assert_int_equal(trace->flags & SAVED_FIXED_POINT, 0);
    assert_int_equal(trace->fraction, 0);
    assert_true(trace->width <= 8 || (trace->flags & SAVED_BINARY) == 0);
    for (int i = 0; i < glint_setting_signal_count(&options.setting); i++) {
        const glint_signal_info signal = glint_setting_signal(&options.setting, i);
        char side[128];
        (void)snprintf(side, sizeof side, "%s_rtl", signal.name);
        if (signal.frac_bits == 0 || strcmp(name, side) != 0)
            continue;
        const int number = strstr(file->trace[t + 2].name, "_differs") != NULL ? t + 3 : t + 2;
        assert_true((trace->flags & SAVED_HEX) != 0);
        (void)snprintf(side, sizeof side, "%s_real", trace->name);
        assert_string_equal(file->trace[number].name, side);
        return;
    }
}

/* Both sides of a signal one below the other, in their format; all of the file in the waveform; the
 * first signal to differ in the first group. */
static void assert_save_file(const saved *file, const vcd *wave)
{
    const glint_mismatch *first = &failure->finding.mismatch[0];
    bool found = false;
    assert_string_equal(file->dumpfile, GLINT_PACKET_WAVE);
    assert_true((uint64_t)file->marker == first->clock * 10);
    assert_string_equal(file->trace[0].name, "TOP.mismatch");
    for (int t = 0; t < file->count; t++) {
        const saved_trace *trace = &file->trace[t];
        const vcd_signal *variable = vcd_find(wave, trace->name);
        assert_non_null(variable);
        assert_int_equal(variable->width, variable->width == 0 ? 0 : trace->width);
        assert_trace_hides_nothing(file, t);
        char *ending = strrchr(trace->name, '_');
        if (ending == NULL || strcmp(ending, "_rtl") != 0)
            continue;
        const int stem = (int)(ending - trace->name);
        assert_int_equal(strncmp(trace[1].name, trace->name, (size_t)stem), 0);
        assert_string_equal(trace[1].name + stem, "_model");
        assert_int_equal(trace->flags, trace[1].flags);
        assert_int_equal(trace->fraction, trace[1].fraction);
    }
    for (int t = 3; t < file->count && strncmp(file->trace[t].name, "TOP.reset", 9) != 0; t++) {
        char full[112];
        variable_name(first->signal.lane, first->signal.name, "_rtl", full, sizeof full);
        if (strcmp(file->trace[t].name, full) == 0) {
            found = true;
            assert_int_equal((file->trace[t].flags & SAVED_SIGNED) != 0,
                             first->signal.is_signed && first->signal.frac_bits == 0);
        }
    }
    assert_true(found);
}

static void the_waveform_has_both_sides(void **state)
{
    (void)state;
    for (size_t f = 0; f < FAULT_COUNT; f++) {
        static saved file;
        char directory[64], wave_name[128], save_name[128];
        glint_error err;
        find(&faults[f]);
        (void)snprintf(directory, sizeof directory, "%s/made", faults[f].name);
        (void)snprintf(wave_name, sizeof wave_name, "%s/%s", directory, GLINT_PACKET_WAVE);
        (void)snprintf(save_name, sizeof save_name, "%s/%s", directory, GLINT_PACKET_SAVE_FILE);
        assert_done(glint_packet_write(failure, NULL, scratch_path(directory), &err), &err);
        vcd wave = vcd_read(scratch_path(wave_name));
        assert_true(wave.first_time == capture->clock[0].clock * 10 - 5);
        assert_end(&wave);
        for (int row = 0; row < capture->count; row += 4)
            assert_clock(&wave, &capture->clock[row]);
        assert_clock(&wave, &capture->clock[capture->failing]);
        assert_flags(&wave);
        saved_read(scratch_path(save_name), &file);
        assert_save_file(&file, &wave);
        vcd_free(&wave);
    }
}

/* Sixteen lanes: each signal of each lane is there, under the lane's own scope. */
static void every_lane_is_there(void **state)
{
    (void)state;
    static saved file;
    glint_error err;
    const int lanes = 16;
    const glint_setting setting =
        specular_setting(GLINT_GATE_COSINE, GLINT_PIPELINE_PIPELINED, lanes);
    const glint_material material = {20, 255, 255, 255};
    uint32_t cos_code[100];
    glint_answer answer = {.value = GLINT_ANSWER_R};
    for (uint32_t i = 0; i < 100; i++)
        cos_code[i] = GLINT_COS_ONE - i;
    glint_answer_keep_points(&answer, lanes, &material, cos_code, 100, 37);
    glint_failure_destroy(failure);
    assert_done(
        glint_failure_of_answer(GLINT_FAILURE_EXHAUSTIVE, &setting, &answer, &failure, &err), &err);
    assert_false(glint_failure_differs(&failure->finding));
    assert_done(glint_packet_write(failure, NULL, scratch_path("lanes"), &err), &err);
    vcd wave = vcd_read(scratch_path("lanes/" GLINT_PACKET_WAVE));
    saved_read(scratch_path("lanes/" GLINT_PACKET_SAVE_FILE), &file);
    for (int lane = 0; lane < lanes; lane++) {
        char name[64];
        (void)snprintf(name, sizeof name, "TOP.lane[%d].cos", lane);
        /* The third clock takes points 32 to 47. */
        assert_int_equal(vcd_value(&wave, name, 30), cos_code[32 + lane]);
        (void)snprintf(name, sizeof name, "TOP.lane[%d].mul13_model", lane);
        assert_non_null(vcd_find(&wave, name));
    }
    int numbers = lanes; /* of the cosines, and of what else is fixed-point */
    for (int i = 0; i < glint_setting_signal_count(&setting); i++)
        numbers += glint_setting_signal(&setting, i).frac_bits > 0;
    /* mismatch, clock, clk; the pins; both sides of all signals */
    assert_int_equal(file.count, 3 + glint_setting_pin_count(&setting) +
                                     2 * glint_setting_signal_count(&setting) + numbers);
    vcd_free(&wave);
}

/* ---- The packet --------------------------------------------------------------------------------
 */

static void a_packet_is_read_and_played(void **state)
{
    (void)state;
    const double begin = child_seconds();
    for (size_t f = 0; f < FAULT_COUNT; f++) {
        glint_error err;
        glint_failure *read;
        glint_failure_finding again;
        find(&faults[f]);
        assert_done(glint_packet_write(failure, NULL, scratch_path("packet"), &err), &err);
        assert_done(glint_packet_read(scratch_path("packet"), NULL, &read, &err), &err);
        assert_true(read->seed == seed && read->pin_count == failure->pin_count);
        assert_true(glint_failure_same(&read->finding, &failure->finding));
        assert_string_equal(read->command, failure->command);
        /* Replayed with the broken circuit it recurs; with the correct one it is gone. */
        read->setting = setting_of(&faults[f], true);
        assert_done(glint_failure_play(read, NULL, &again, NULL, &err), &err);
        assert_true(glint_failure_same(&again, &read->finding));
        read->setting = setting_of(&faults[f], false);
        assert_done(glint_failure_play(read, NULL, &again, NULL, &err), &err);
        assert_false(glint_failure_differs(&again));
        glint_failure_destroy(read);
    }
    record("rtl-9-packet",
           "a failure packet reproduces its mismatch, and shows none with the correct circuit",
           "deliberately broken circuits", FAULT_COUNT, "circuits", child_seconds() - begin);
}

static void nothing_but_a_packet_is_replaced(void **state)
{
    (void)state;
    glint_error err;
    find(&faults[0]);
    const int before = scratch_count();
    assert_done(glint_packet_write(failure, NULL, scratch_path("old"), &err), &err);
    assert_done(glint_packet_write(failure, NULL, scratch_path("old/"), &err), &err);
    assert_int_equal(scratch_count(), before + 1);
    /* Older versions wrote the waveform in another format: that is replaced too. */
    scratch_write(scratch_path("old/" GLINT_PACKET_OLD_WAVE), "x", 1);
    assert_done(glint_packet_write(failure, NULL, scratch_path("old"), &err), &err);
    assert_int_equal(access(scratch_path("old/" GLINT_PACKET_OLD_WAVE), F_OK), -1);
    scratch_write(scratch_path("old/mine"), "x", 1);
    assert_int_equal(glint_packet_write(failure, NULL, scratch_path("old"), &err), GLINT_IO_ERROR);
    assert_non_null(strstr(err.text, "old: not replaced, because it contains mine"));
    assert_int_equal(access(scratch_path("old/" GLINT_PACKET_WAVE), R_OK), 0);
    assert_int_equal(scratch_count(), before + 1);
}

/* A link in the packet's place, and what it leads to, stay as they are. */
static void no_link_is_replaced(void **state)
{
    (void)state;
    glint_error err;
    find(&faults[0]);
    assert_int_equal(glint_packet_write(failure, NULL, scratch_path("linked"), &err), GLINT_OK);
    assert_int_equal(symlink("linked", scratch_path("link")), 0);
    const int before = scratch_count();
    assert_int_equal(glint_packet_write(failure, NULL, scratch_path("link"), &err), GLINT_IO_ERROR);
    assert_non_null(strstr(err.text, "link: not replaced, because it is a link"));
    assert_int_equal(access(scratch_path("linked/" GLINT_PACKET_DATA), F_OK), 0);
    assert_int_equal(scratch_count(), before);
    assert_int_equal(unlink(scratch_path("link")), 0);
}

static void a_packet_that_cannot_be_written_is_told(void **state)
{
    (void)state;
    glint_error err;
    find(&faults[0]);
    scratch_write(scratch_path("plain"), "", 0);
    const int before = scratch_count();
    assert_int_equal(glint_packet_write(failure, NULL, scratch_path("plain"), &err),
                     GLINT_IO_ERROR);
    assert_non_null(strstr(err.text, "plain"));
    assert_int_equal(glint_packet_write(failure, NULL, scratch_path("plain/x"), &err),
                     GLINT_IO_ERROR);
    assert_non_null(strstr(err.text, "plain"));
    assert_int_equal(scratch_count(), before);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_few_clocks_show_it_again),
        cmocka_unit_test(without_a_shorter_way_the_whole_run_is_played),
        cmocka_unit_test(the_text_tells_all_of_it),
        cmocka_unit_test(the_text_shows_values_as_numbers),
        cmocka_unit_test(the_waveform_has_both_sides),
        cmocka_unit_test(every_lane_is_there),
        cmocka_unit_test(a_packet_is_read_and_played),
        cmocka_unit_test(nothing_but_a_packet_is_replaced),
        cmocka_unit_test(no_link_is_replaced),
        cmocka_unit_test(a_packet_that_cannot_be_written_is_told),
    };
    return cmocka_run_group_tests(tests, prepare, clean_up);
}
