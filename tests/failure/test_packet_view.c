/* How a packet's waveform opens in GTKWave, for any place of the mismatch and any window: the
 * marker is in view, and a difference in the last place is readable next to the names. */
#define _XOPEN_SOURCE 700

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "../scratch.h"

#include "../wave/gtkwave.h"
#include "../wave/saved.h"
#include "../wave/vcd.h"
#include "circuit/circuits.h"
#include "failure/wave.h"

/* A capture made up: both sides are the same but for one signal, which is one last place larger in
 * the Verilog from the failing clock on. */
typedef struct shape {
    const char *name;
    glint_setting (*setting)(void);
    const char *signal;
    int lane;
    uint64_t code; /* of the model */
    uint64_t first_clock;
    int count, failing;
} shape;

static glint_setting one_lane(void)
{
    return glint_setting_specular(
        &(glint_specular_config){GLINT_GATE_COSINE, GLINT_PIPELINE_PIPELINED, 1});
}

static glint_setting sixteen(void)
{
    return glint_setting_specular(
        &(glint_specular_config){GLINT_GATE_COSINE, GLINT_PIPELINE_PIPELINED, 16});
}

static glint_setting sequential(void)
{
    return glint_setting_divider(GLINT_DIVIDER_SEQUENTIAL, 12);
}

static glint_setting pipelined_16(void)
{
    return glint_setting_divider(GLINT_DIVIDER_PIPELINED, 16);
}

static const shape shapes[] = {
    {"first of many", one_lane, "reg1", 0, 0x40000, 1, 41, 0},
    {"the only one", one_lane, "mul7", 0, 0xfffffff, 77, 1, 0},
    {"as usual", one_lane, "reg1", 0, 0x40000, 583, 41, 32},
    {"the run's last", one_lane, "reg1", 0, 0x40000, 99968, 33, 32},
    {"the last of few", one_lane, "adder6", 0, 0, 1, 12, 11},
    {"the last of sixteen lanes", sixteen, "mul7", 15, 0xfffffff, 1000000, 33, 32},
    {"a divider's last", sequential, "acc_rg", -1, 0x1fffff, 40, 33, 32},
    {"a stage's last", pipelined_16, "acc_b", 16, 0x1ffffff, 40, 33, 32},
};
#define SHAPE_COUNT (sizeof shapes / sizeof shapes[0])

static int signal_of(const shape *shape)
{
    const glint_setting setting = shape->setting();
    for (int i = 0; i < glint_setting_signal_count(&setting); i++) {
        const glint_signal_info signal = glint_setting_signal(&setting, i);
        if (signal.lane == shape->lane && strcmp(signal.name, shape->signal) == 0)
            return i;
    }
    fail_msg("no signal %s", shape->signal);
    return 0;
}

static uint64_t mask_of(const shape *shape, int index)
{
    const glint_setting setting = shape->setting();
    const glint_signal_info signal = glint_setting_signal(&setting, index);
    return (UINT64_C(1) << (signal.int_bits + signal.frac_bits)) - 1;
}

static glint_capture *capture_of(const shape *shape)
{
    const int index = signal_of(shape);
    glint_capture *capture = calloc(1, sizeof *capture);
    assert_non_null(capture);
    glint_error err;
    capture->setting = shape->setting();
    assert_int_equal(glint_signals_find(&capture->setting, &capture->signals, &err), GLINT_OK);
    capture->count = shape->count;
    capture->failing = shape->failing;
    for (int i = 0; i < shape->count; i++) {
        glint_capture_clock *clock = &capture->clock[i];
        clock->clock = shape->first_clock + (uint64_t)i;
        clock->model[index] = clock->rtl[index] = shape->code;
        if (i >= shape->failing)
            clock->rtl[index] = (shape->code + 1) & mask_of(shape, index);
    }
    return capture;
}

static void write_view(const shape *shape)
{
    glint_error err;
    glint_capture *capture = capture_of(shape);
    assert_int_equal(glint_failure_write_wave(capture, scratch_path("wave.vcd"), &err), GLINT_OK);
    assert_int_equal(
        glint_failure_write_save_file(capture, "wave.vcd", scratch_path("wave.gtkw"), &err),
        GLINT_OK);
    free(capture);
}

/* GTKWave's rule, from its source: the view begins where the save file says if it then ends within
 * the waveform, else at the waveform's beginning. */
static void assert_marker_in_view(const shape *shape, const saved *file, const vcd *wave,
                                  uint64_t view)
{
    const bool taken =
        file->first_time >= wave->first_time && file->first_time + view <= wave->last_time;
    const uint64_t begin = taken ? file->first_time : wave->first_time;
    const uint64_t marker = (uint64_t)file->marker;
    if (marker < begin || marker >= begin + view) {
        fail_msg("%s: marker at %lu, a view of %lu ns begins at %lu", shape->name,
                 (unsigned long)marker, (unsigned long)view, (unsigned long)begin);
    }
}

/* Windows of ten clocks to a hundred. */
static void the_marker_is_in_view_in_every_window(void **state)
{
    (void)state;
    static saved file;
    for (size_t i = 0; i < SHAPE_COUNT; i++) {
        write_view(&shapes[i]);
        saved_read(scratch_path("wave.gtkw"), &file);
        vcd wave = vcd_read(scratch_path("wave.vcd"));
        assert_int_equal(file.marker, (shapes[i].first_clock + (uint64_t)shapes[i].failing) * 10);
        assert_in_range(file.first_time, wave.first_time, wave.last_time);
        for (uint64_t view = 100; view <= 1000; view++)
            assert_marker_in_view(&shapes[i], &file, &wave, view);
        /* In its own window all of the view is in the waveform. */
        assert_true(file.first_time + 200 <= wave.last_time);
        vcd_free(&wave);
    }
}

/* Row of a trace by its label. */
static int row_of(const gtkwave_shown *shown, const char *label)
{
    for (int row = 0; row < shown->count; row++)
        if (strcmp(shown->name[row], label) == 0)
            return row;
    fail_msg("GTKWave does not show %s", label);
    return 0;
}

/* Both codes in hex, one last place apart, and both numbers, which must not be the same text. */
static void assert_difference_is_read(const shape *shape, const gtkwave_shown *shown)
{
    const glint_setting setting = shape->setting();
    const glint_signal_info signal = glint_setting_signal(&setting, signal_of(shape));
    const uint64_t mask = mask_of(shape, signal_of(shape));
    const bool has_place = signal.lane >= 0 && (setting.circuit == &glint_circuit_divider ||
                                                setting.values[GLINT_SPECULAR_LANES] > 1);
    char stem[64];
    char label[96];
    (void)snprintf(stem, sizeof stem, "%s", signal.name);
    if (has_place) {
        (void)snprintf(stem, sizeof stem, "%s%d %s", glint_setting_lane_name(&setting), signal.lane,
                       signal.name);
    }
    double number[2];
    for (int side = 0; side < 2; side++) {
        const char *ending = side == 0 ? "rtl" : "model";
        const uint64_t code = side == 0 ? (shape->code + 1) & mask : shape->code;
        (void)snprintf(label, sizeof label, "%s_%s", stem, ending);
        assert_true(strtoull(shown->value[row_of(shown, label)], NULL, 16) == code);
        (void)snprintf(label, sizeof label, "%s_%s_real", stem, ending);
        number[side] = strtod(shown->value[row_of(shown, label)], NULL);
    }
    assert_true(number[0] - number[1] == ldexp(1, -signal.frac_bits));
    (void)snprintf(label, sizeof label, "%s_differs", stem);
    assert_string_equal(shown->value[row_of(shown, label)], "1");
    assert_string_equal(shown->value[row_of(shown, "mismatch")], "1");
}

/* No value beside the names is cut: eight pixels a character. */
static void assert_pane_is_wide_enough(const saved *file, const gtkwave_shown *shown)
{
    size_t name = 0;
    size_t value = 0;
    for (int row = 0; row < shown->count; row++) {
        const size_t n = strlen(shown->name[row]);
        const size_t v = strlen(shown->value[row]) + 1;
        name = n > name ? n : name;
        value = v > value ? v : value;
    }
    assert_true((size_t)file->signals_width >= 8 * (name + value));
}

static void check(const shape *shape, int width, int height)
{
    static saved file;
    static gtkwave_shown shown;
    write_view(shape);
    saved_read(scratch_path("wave.gtkw"), &file);
    gtkwave_open("wave.vcd", "wave.gtkw", width, height, &shown);
    print_message("%s, %d pixels wide: marker %ld, view %ld to %ld of %ld to %ld\n", shape->name,
                  width, (long)shown.marker, (long)shown.from, (long)shown.to, (long)shown.first,
                  (long)shown.last);
    assert_int_equal(shown.marker, file.marker);
    assert_true(shown.from <= shown.marker && shown.marker < shown.to);
    assert_pane_is_wide_enough(&file, &shown);
    assert_difference_is_read(shape, &shown);
}

static void it_opens_at_the_mismatch(void **state)
{
    (void)state;
    for (size_t i = 0; i < SHAPE_COUNT; i++)
        check(&shapes[i], 1280, 800);
}

static void it_opens_at_the_mismatch_in_large_windows(void **state)
{
    (void)state;
    check(&shapes[3], 1600, 1000);
    check(&shapes[3], 2560, 1400);
    check(&shapes[3], 3840, 2100);
}

static int prepare(void **state)
{
    return scratch_make(state) != 0 ? -1 : gtkwave_prepare();
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_marker_is_in_view_in_every_window),
        cmocka_unit_test(it_opens_at_the_mismatch),
        cmocka_unit_test(it_opens_at_the_mismatch_in_large_windows),
    };
    return cmocka_run_group_tests(tests, prepare, scratch_remove);
}
