/* Waveforms of the dividers: that they show the circuit clock by clock, that the save file names
 * what is there in its formats, that the scene holds what it promises. */
#define _XOPEN_SOURCE 700

#include <inttypes.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "../scratch.h"

#include "../wave/saved.h"
#include "../wave/vcd.h"
#include "circuit/circuits.h"
#include "rtl/rtl.h"
#include "signal_name.h"
#include "wave/divider_scene.h"
#include "wave/save_file.h"
#include "wave/waveform.h"

enum { N_FIRST = 6, N_LAST = 16 };

static const int shifts[] = {6, 8, 12, 16};
#define SHIFTS_COUNT (sizeof shifts / sizeof shifts[0])

static uint64_t rising_edge_of(int clock)
{
    return (uint64_t)(clock + 1) * GLINT_RTL_TRACE_PERIOD;
}

static glint_status try_record(glint_divider_form form, int n, glint_wave_format format,
                               const char *path, glint_error *err)
{
    const glint_setting setting = glint_setting_divider(form, n);
    glint_wave_scene scene;
    assert_int_equal(glint_wave_scene_make(&setting, &scene, err), GLINT_OK);
    assert_int_equal(scene.clocks, glint_divider_scene_clocks(form, n));
    const glint_status status =
        glint_wave_record(&setting, &scene, format, 1, scene.clocks, path, err);
    free(scene.pins);
    return status;
}

static void record(glint_divider_form form, int n, glint_wave_format format, const char *path)
{
    glint_error err;
    if (try_record(form, n, format, path, &err) != GLINT_OK)
        fail_msg("%s", err.text);
}

static glint_divider_device *create(glint_divider_form form, int n)
{
    glint_divider_device *device;
    assert_int_equal(glint_divider_device_create(form, n, &device), GLINT_OK);
    return device;
}

/* ---- What is in the waveform --------------------------------------------------------------------
 */

/* Every signal of the table after every clock of the scene, against the C model. */
static unsigned compare_scene(glint_divider_form form, int n, const vcd *wave)
{
    glint_divider_device *device = create(form, n);
    unsigned compared = 0;
    for (int clock = 1; clock <= glint_divider_scene_clocks(form, n); clock++) {
        glint_divider_inputs in;
        glint_divider_scene(form, n, clock, &in);
        glint_divider_device_clock(device, &in);
        for (int i = 0; i < glint_divider_signal_count(form, n); i++) {
            const glint_signal_info info = glint_divider_signal_info(form, n, i);
            const uint64_t expected = glint_divider_signal_bits(device, i);
            char name[112];
            divider_signal_name(form, &info, name, sizeof name);
            if (vcd_value(wave, name, rising_edge_of(clock)) != expected)
                fail_msg("%s, n = %d, at clock %d is not 0x%" PRIx64, name, n, clock, expected);
            compared++;
        }
    }
    glint_divider_device_destroy(device);
    return compared;
}

static void the_waveform_shows_the_circuit(void **state)
{
    (void)state;
    unsigned compared = 0;
    for (size_t i = 0; i < SHIFTS_COUNT; i++) {
        for (int f = 0; f < GLINT_DIVIDER_FORM_COUNT; f++) {
            const glint_divider_form form = (glint_divider_form)f;
            if (form == GLINT_DIVIDER_PIPELINED && shifts[i] > 8)
                continue; /* thousands of values more; lockstep has them all */
            record(form, shifts[i], GLINT_WAVE_VCD, scratch_path("scene.vcd"));
            vcd wave = vcd_read(scratch_path("scene.vcd"));
            compared += compare_scene(form, shifts[i], &wave);
            vcd_free(&wave);
        }
    }
    print_message("%u values compared\n", compared);
    assert_true(compared > 3000);
}

/* The same waveform in both formats, from the first clock to the last of the scene. */
static void fst_and_vcd_are_the_same(void **state)
{
    (void)state;
    for (size_t i = 0; i < SHIFTS_COUNT; i++) {
        for (int f = 0; f < GLINT_DIVIDER_FORM_COUNT; f++) {
            const glint_divider_form form = (glint_divider_form)f;
            record(form, shifts[i], GLINT_WAVE_FST, scratch_path("a.fst"));
            record(form, shifts[i], GLINT_WAVE_VCD, scratch_path("b.vcd"));
            vcd a = vcd_read_fst(scratch_path("a.fst"));
            vcd b = vcd_read(scratch_path("b.vcd"));
            assert_true(a.first_time < rising_edge_of(1));
            assert_true(a.last_time > rising_edge_of(glint_divider_scene_clocks(form, shifts[i])));
            vcd_assert_same(&a, &b);
            vcd_free(&a);
            vcd_free(&b);
        }
    }
}

/* ---- The save file ------------------------------------------------------------------------------
 */

static void write_save_file(glint_divider_form form, int n, const char *path)
{
    glint_error err;
    const glint_gtkw_window window = {
        .waveform = "some/where/scene.fst", .first_time = 10, .last_time = 500, .marker_time = 120};
    const glint_setting setting = glint_setting_divider(form, n);
    assert_int_equal(glint_wave_save_file(&setting, &window, path, &err), GLINT_OK);
}

/* The signal that a trace shows; −1: a pin. */
static int signal_of(glint_divider_form form, int n, const saved_trace *trace)
{
    for (int i = 0; i < glint_divider_signal_count(form, n); i++) {
        const glint_signal_info info = glint_divider_signal_info(form, n, i);
        char name[112];
        divider_signal_name(form, &info, name, sizeof name);
        if (strcmp(name, trace->name) == 0)
            return i;
    }
    return -1;
}

static void assert_format(glint_divider_form form, int n, const saved_trace *trace)
{
    const int index = signal_of(form, n, trace);
    if (index < 0) {
        assert_int_equal((trace->flags & SAVED_SIGNED) != 0,
                         strstr(trace->name, "difference") != NULL);
        return;
    }
    const glint_signal_info info = glint_divider_signal_info(form, n, index);
    assert_int_equal(trace->width, info.int_bits + info.frac_bits);
    assert_int_equal(trace->fraction, info.frac_bits);
    assert_int_equal((trace->flags & SAVED_FIXED_POINT) != 0, info.frac_bits > 0);
    assert_int_equal((trace->flags & SAVED_SIGNED) != 0, info.is_signed);
}

/* The waveform has every signal that the save file names, with the same width. */
static void the_save_file_names_what_is_there(void **state)
{
    (void)state;
    static saved file;
    for (int n = N_FIRST; n <= N_LAST; n++) {
        for (int f = 0; f < GLINT_DIVIDER_FORM_COUNT; f++) {
            const glint_divider_form form = (glint_divider_form)f;
            record(form, n, GLINT_WAVE_VCD, scratch_path("names.vcd"));
            write_save_file(form, n, scratch_path("names.gtkw"));
            vcd wave = vcd_read(scratch_path("names.vcd"));
            saved_read(scratch_path("names.gtkw"), &file);
            for (int t = 0; t < file.count; t++) {
                const vcd_signal *signal = vcd_find(&wave, file.trace[t].name);
                if (signal == NULL)
                    fail_msg("the waveform has no %s", file.trace[t].name);
                assert_int_equal(signal->width, file.trace[t].width);
                assert_format(form, n, &file.trace[t]);
            }
            vcd_free(&wave);
        }
    }
}

static bool is_named(const saved *file, const char *name)
{
    for (int t = 0; t < file->count; t++)
        if (strcmp(file->trace[t].name, name) == 0)
            return true;
    return false;
}

/* Every signal of the table and every pin. */
static void the_save_file_leaves_nothing_out(void **state)
{
    (void)state;
    static saved file;
    static const char *const pins[2][9] = {
        {"clk", "reset", "en", "start", "k", "difference"},
        {"clk", "reset", "en", "in_valid", "k", "difference_r", "difference_g", "difference_b"}};
    for (int n = N_FIRST; n <= N_LAST; n++) {
        for (int f = 0; f < GLINT_DIVIDER_FORM_COUNT; f++) {
            const glint_divider_form form = (glint_divider_form)f;
            char name[112];
            write_save_file(form, n, scratch_path("all.gtkw"));
            saved_read(scratch_path("all.gtkw"), &file);
            for (int i = 0; i < glint_divider_signal_count(form, n); i++) {
                const glint_signal_info info = glint_divider_signal_info(form, n, i);
                divider_signal_name(form, &info, name, sizeof name);
                if (!is_named(&file, name))
                    fail_msg("%s is not in the save file", name);
            }
            for (int p = 0; pins[f][p] != NULL; p++) {
                (void)snprintf(name, sizeof name, "%s.%s", divider_top(form), pins[f][p]);
                assert_true(is_named(&file, name));
            }
            assert_string_equal(file.dumpfile, "scene.fst");
            assert_int_equal(file.first_time, 40);
            assert_int_equal(file.marker, 120);
            assert_true(file.longest_heading <= 24);
            assert_true(file.headings >= 5);
        }
    }
}

/* ---- The scene ----------------------------------------------------------------------------------
 */

static const struct {
    int difference[GLINT_DIVIDER_COMPONENTS];
    uint32_t k;
} promised[] = {{{255, 128, -7}, 7},
                {{-255, 90, 9}, 9},
                {{100, -100, 1}, 1},
                {{200, 16, -16}, 16},
                {{37, 1, -1}, 17}};
enum { PROMISED = sizeof promised / sizeof promised[0] };

typedef struct scene_counts {
    int taken, results, stalled_in_second, ignored, misses, first_result;
} scene_counts;

static void assert_result(int n, int result, int component, int64_t code)
{
    assert_in_range(result, 0, PROMISED - 1);
    assert_int_equal(code, (int32_t)glint_divider_bits(n, promised[result].k) *
                               promised[result].difference[component]);
}

static void count_sequential(scene_counts *c, int n, int clock, const glint_divider_inputs *in,
                             const glint_divider_sequential_signals *s, bool was_busy)
{
    c->stalled_in_second += !in->en && was_busy && c->taken == 2;
    c->ignored += in->en && in->start && was_busy;
    c->taken += in->en && in->start && !was_busy;
    if (in->en && s->done) {
        assert_result(n, c->results, 0, s->quotient);
        c->misses += s->out_of_table != 0;
        c->first_result = c->results++ == 0 ? clock : c->first_result;
    }
}

static void count_pipelined(scene_counts *c, int n, int clock, const glint_divider_inputs *in,
                            const glint_divider_pipelined_signals *s)
{
    c->stalled_in_second += !in->en && c->taken == 2;
    c->taken += in->en && in->start;
    if (in->en && s->out_valid) {
        assert_result(n, c->results, 0, s->quotient_r);
        assert_result(n, c->results, 1, s->quotient_g);
        assert_result(n, c->results, 2, s->quotient_b);
        c->misses += s->out_of_table != 0;
        c->first_result = c->results++ == 0 ? clock : c->first_result;
    }
}

static scene_counts play_scene(glint_divider_form form, int n)
{
    scene_counts c = {0};
    glint_divider_device *device = create(form, n);
    const glint_divider_sequential_signals *s = glint_divider_device_sequential(device);
    const glint_divider_pipelined_signals *p = glint_divider_device_pipelined(device);
    for (int clock = 1; clock <= glint_divider_scene_clocks(form, n); clock++) {
        const bool was_busy = s != NULL && s->busy;
        glint_divider_inputs in;
        glint_divider_scene(form, n, clock, &in);
        glint_divider_device_clock(device, &in);
        if (s != NULL)
            count_sequential(&c, n, clock, &in, s, was_busy);
        else
            count_pipelined(&c, n, clock, &in, p);
    }
    glint_divider_device_destroy(device);
    return c;
}

static void the_scene_holds_what_it_promises(void **state)
{
    (void)state;
    assert_int_equal(PROMISED, GLINT_DIVIDER_SCENE_DIVISIONS);
    for (int n = N_FIRST; n <= N_LAST; n++) {
        for (int f = 0; f < GLINT_DIVIDER_FORM_COUNT; f++) {
            const glint_divider_form form = (glint_divider_form)f;
            const scene_counts c = play_scene(form, n);
            assert_int_equal(c.taken, PROMISED);
            assert_int_equal(c.results, PROMISED);
            assert_int_equal(c.misses, 1);
            assert_int_equal(c.ignored, form == GLINT_DIVIDER_SEQUENTIAL);
            assert_int_equal(c.stalled_in_second, 3);
            /* Counted by the circuit's clock, whose first is the reset of creation. */
            assert_int_equal(glint_divider_scene_first_result(form, n), c.first_result + 1);
        }
    }
}

/* ---- Refusals -----------------------------------------------------------------------------------
 */

static void what_cannot_be_written_is_told(void **state)
{
    (void)state;
    glint_error err = {""};
    scratch_write(scratch_path("plain"), "", 0);
    const char *const paths[] = {scratch_path("missing/a"), scratch_path("plain/a")};
    for (int f = 0; f < GLINT_DIVIDER_FORM_COUNT; f++) {
        const glint_divider_form form = (glint_divider_form)f;
        for (size_t i = 0; i < 2; i++) {
            const glint_gtkw_window window = {"a.fst", 10, 20, -1};
            const glint_setting setting = glint_setting_divider(form, 8);
            assert_int_equal(try_record(form, 8, GLINT_WAVE_FST, paths[i], &err), GLINT_IO_ERROR);
            assert_non_null(strstr(err.text, paths[i]));
            assert_int_equal(glint_wave_save_file(&setting, &window, paths[i], &err),
                             GLINT_IO_ERROR);
            assert_non_null(strstr(err.text, paths[i]));
        }
        assert_int_equal(try_record(form, 5, GLINT_WAVE_FST, scratch_path("no"), &err),
                         GLINT_BAD_ARGUMENT);
        assert_int_equal(access(scratch_path("no"), F_OK), -1);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_waveform_shows_the_circuit),
        cmocka_unit_test(fst_and_vcd_are_the_same),
        cmocka_unit_test(the_save_file_names_what_is_there),
        cmocka_unit_test(the_save_file_leaves_nothing_out),
        cmocka_unit_test(the_scene_holds_what_it_promises),
        cmocka_unit_test(what_cannot_be_written_is_told),
    };
    return cmocka_run_group_tests(tests, scratch_make, scratch_remove);
}
