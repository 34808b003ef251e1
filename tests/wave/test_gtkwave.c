/* GTKWave itself opens the output of `glint wave` on a private display and reports through a script
 * what it shows: every trace of the save file, in its order, and at the marker the numbers that the
 * C model has there, fixed-point values as real ones. */
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

#include "../child.h"
#include "gtkwave.h"
#include "saved.h"
#include "wave/specular_scene.h"

enum { SECONDS = 120 };

static int prepare(void **state)
{
    return scratch_make(state) != 0 ? -1 : gtkwave_prepare();
}

/* Index of the next shown row that is `trace`, from row *next on; the rest are headings. */
static int row_of(const gtkwave_shown *shown, const saved_trace *trace, int *next)
{
    while (*next < shown->count) {
        const int row = (*next)++;
        if (strcmp(shown->name[row], trace->label) == 0)
            return row;
    }
    return -1;
}

static double number_of(const glint_signal_info *info, uint64_t bits)
{
    const int width = info->int_bits + info->frac_bits;
    double value = (double)bits;
    if (info->is_signed && (bits >> (width - 1) & 1) != 0)
        value -= ldexp(1.0, width);
    return ldexp(value, -info->frac_bits);
}

/* The value shown, in decimal, or in binary for valid bits and single bits. */
static void assert_value(const glint_specular_config *config, const glint_specular_signals *signals,
                         int index, const char *value)
{
    const glint_signal_info info = glint_specular_signal_info(config, index);
    const int base = info.block == 0 ? 2 : 10;
    const double expected = number_of(&info, glint_specular_signal_bits(config, signals, index));
    const double found = base == 2 ? (double)strtoull(value, NULL, 2) : strtod(value, NULL);
    if (!(fabs(found - expected) <= 1e-9))
        fail_msg("%s: GTKWave shows %s, the model has %.12g", info.name, value, expected);
}

static glint_specular_device *play_until(const glint_specular_config *config, int last)
{
    glint_specular_device *device;
    assert_int_equal(glint_specular_device_create(config, &device), GLINT_OK);
    for (int clock = 1; clock <= last; clock++) {
        glint_specular_inputs in;
        glint_specular_scene(clock, config->lanes, &in);
        glint_specular_device_clock(device, &in);
    }
    return device;
}

static void write_waveform(const glint_specular_config *config, const char *format)
{
    char lanes[8];
    const char *glint = getenv("GLINT");
    const char *const argv[] = {glint != NULL ? glint : "build/glint",
                                "wave",
                                "--circuit",
                                "specular",
                                "--out",
                                scratch_directory,
                                "--gate",
                                glint_gate_name(config->gate),
                                "--pipeline",
                                glint_pipeline_name(config->pipeline),
                                "--lanes",
                                lanes,
                                "--format",
                                format,
                                NULL};
    (void)snprintf(lanes, sizeof lanes, "%d", config->lanes);
    assert_int_equal(child_run(argv, SECONDS), 0);
}

/* About twenty clocks with the marker among them, each wide enough for eight characters of the font
 * that GTKWave has for values, and the outputs above the fold. */
static void assert_first_look(const gtkwave_shown *shown, const saved *file)
{
    const int64_t clocks = (shown->to - shown->from) / 10;
    int outputs = 0;
    assert_in_range(clocks, 19, 21);
    assert_true(shown->from <= shown->marker && shown->marker <= shown->to - 50);
    assert_true(shown->wave_width / clocks >= 8 * 6 + 4);
    for (int t = 0; t < file->count; t++) {
        const saved_trace *trace = &file->trace[t];
        const int rows =
            shown->wave_height / shown->row_height - 1; /* less the one with the time */
        if (!trace->is_folded && strstr(trace->name, ".out_") != NULL) {
            assert_true(trace->row < rows);
            outputs++;
        }
    }
    assert_int_equal(outputs, 6);
}

static void check_setting(const glint_specular_config *config, const char *format)
{
    static saved file;
    static gtkwave_shown shown;
    char waveform[64];
    char save_file[64];
    int next = 0;
    int values = 0;
    (void)snprintf(waveform, sizeof waveform, "specular_%s_%s.%s", glint_gate_name(config->gate),
                   glint_pipeline_name(config->pipeline), format);
    (void)snprintf(save_file, sizeof save_file, "specular_%s_%s.gtkw",
                   glint_gate_name(config->gate), glint_pipeline_name(config->pipeline));
    write_waveform(config, format);
    saved_read(scratch_path(save_file), &file);
    gtkwave_open(waveform, save_file, 0, 0, &shown);

    const int centre = glint_specular_scene_centre(config->lanes);
    assert_int_equal(shown.marker, file.marker);
    assert_int_equal(shown.marker, (centre + 1) * 10);
    assert_first_look(&shown, &file);

    glint_specular_device *device = play_until(config, centre);
    for (int t = 0; t < file.count; t++) {
        const int row = row_of(&shown, &file.trace[t], &next);
        if (row < 0)
            fail_msg("GTKWave does not show %s", file.trace[t].name);
        const int index = saved_signal(config, &file.trace[t]);
        if (index >= 0 && shown.value[row][0] != '\0') {
            assert_value(config, glint_specular_device_signals(device), index, shown.value[row]);
            values++;
        }
    }
    glint_specular_device_destroy(device);
    print_message("%s, %d lanes: %d traces, %d values\n", waveform, config->lanes, file.count,
                  values);
    assert_true(values > 15);
}

static void it_opens_the_default_waveforms(void **state)
{
    (void)state;
    check_setting(&(glint_specular_config){GLINT_GATE_COSINE, GLINT_PIPELINE_PIPELINED, 1}, "fst");
    check_setting(&(glint_specular_config){GLINT_GATE_COSINE, GLINT_PIPELINE_COMBINATIONAL, 1},
                  "fst");
}

static void it_opens_several_lanes_and_another_gate(void **state)
{
    (void)state;
    check_setting(&(glint_specular_config){GLINT_GATE_DRAWN, GLINT_PIPELINE_PIPELINED, 4}, "fst");
}

static void it_opens_vcd_as_well(void **state)
{
    (void)state;
    check_setting(&(glint_specular_config){GLINT_GATE_SIGN, GLINT_PIPELINE_PIPELINED, 2}, "vcd");
}

/* What is left of a mismatch opens too: at the marker the flag stands, and of each signal both
 * values that the packet names. */
static void it_opens_a_failure_packet(void **state)
{
    (void)state;
    static saved file;
    static gtkwave_shown shown;
    char wrong[1024];
    int next = 0;
    int differing = 0;
    const char *build = getenv("GLINT_BUILD");
    const char *glint = getenv("GLINT");
    (void)snprintf(wrong, sizeof wrong, "%s/wrong/truncating", build != NULL ? build : "build");
    const char *const argv[] = {glint != NULL ? glint : "build/glint",
                                "verify",
                                "--gate",
                                "cosine",
                                "--pipeline",
                                "pipelined",
                                "--lanes",
                                "1",
                                "--clocks",
                                "3000",
                                "--seed",
                                "5",
                                "--rtl",
                                wrong,
                                "--out",
                                scratch_directory,
                                NULL};
    assert_int_equal(child_run(argv, SECONDS), 1);
    saved_read(scratch_path("specular_cosine_pipelined_1/wave.gtkw"), &file);
    gtkwave_open("specular_cosine_pipelined_1/wave.vcd", "specular_cosine_pipelined_1/wave.gtkw", 0,
                 0, &shown);
    assert_int_equal(shown.marker, file.marker);
    assert_true(shown.from < shown.marker && shown.marker < shown.to);
    for (int t = 0; t < file.count; t++) {
        const int row = row_of(&shown, &file.trace[t], &next);
        const size_t length = strlen(file.trace[t].name);
        if (row < 0)
            fail_msg("GTKWave does not show %s", file.trace[t].name);
        if (t == 0)
            assert_string_equal(shown.value[row], "1");
        if (length > 8 && strcmp(file.trace[t].name + length - 8, "_differs") == 0) {
            /* The two rows above it are the two sides. */
            const bool differs = strcmp(shown.value[row], "1") == 0;
            assert_int_equal(strcmp(shown.value[row - 2], shown.value[row - 1]) != 0, differs);
            differing += differs;
        }
    }
    assert_true(differing > 0);
}

/* The control: a name that is not in the waveform is not shown, so the tests above would see it. */
static void a_name_that_is_not_there_is_missed(void **state)
{
    (void)state;
    static saved file;
    static gtkwave_shown shown;
    int next = 0;
    int missed = 0;
    const glint_specular_config config = {GLINT_GATE_COSINE, GLINT_PIPELINE_PIPELINED, 1};
    write_waveform(&config, "fst");
    char *text = scratch_read(scratch_path("specular_cosine_pipelined.gtkw"), NULL);
    char *name = strstr(text, ".mul7[");
    assert_non_null(name);
    name[4] = '8';
    scratch_write(scratch_path("wrong.gtkw"), text, strlen(text));
    free(text);
    saved_read(scratch_path("wrong.gtkw"), &file);
    gtkwave_open("specular_cosine_pipelined.fst", "wrong.gtkw", 0, 0, &shown);
    for (int t = 0; t < file.count; t++) {
        const int at = next;
        if (row_of(&shown, &file.trace[t], &next) < 0) {
            assert_string_equal(file.trace[t].name, "TOP.specular_device.lane[0].u.mul8");
            next = at;
            missed++;
        }
    }
    assert_int_equal(missed, 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(it_opens_the_default_waveforms),
        cmocka_unit_test(it_opens_several_lanes_and_another_gate),
        cmocka_unit_test(it_opens_vcd_as_well),
        cmocka_unit_test(it_opens_a_failure_packet),
        cmocka_unit_test(a_name_that_is_not_there_is_missed),
    };
    return cmocka_run_group_tests(tests, prepare, scratch_remove);
}
