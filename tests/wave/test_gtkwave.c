/* GTKWave itself opens what `glint wave` writes, on a display of its own, and tells by a script
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
#include "saved.h"
#include "wave/waveform.h"

enum {
    TRACES_MAX = 1024,
    SECONDS = 120 /* it takes one; a busy machine, many times that */
};

/* What GTKWave says of itself. */
typedef struct shown {
    char name[TRACES_MAX][64]; /* without its scopes; "" for room below a curve */
    char value[TRACES_MAX][64];
    int count;
    int64_t from, to, marker;
} shown;

static const char script[] =
    "set out [open $::env(GLINT_GTKWAVE_REPORT) w]\n"
    "puts $out \"window [gtkwave::getWindowStartTime] [gtkwave::getWindowEndTime] "
    "[gtkwave::getMarker]\"\n"
    "for {set i 0} {$i < [gtkwave::getTotalNumTraces]} {incr i} {\n"
    "  puts $out \"|[gtkwave::getTraceNameFromIndex $i]|"
    "[gtkwave::getTraceValueAtMarkerFromIndex $i]|\"\n"
    "}\n"
    "close $out\n"
    "gtkwave::/File/Quit\n";

static int prepare(void **state)
{
    if (scratch_make(state) != 0) {
        return -1;
    }
    scratch_write(scratch_path("ask.tcl"), script, sizeof script - 1);
    /* No settings of whoever runs this. */
    return setenv("HOME", scratch_directory, 1) |
           setenv("GLINT_GTKWAVE_REPORT", scratch_path("report"), 1);
}

/* "|name|value|"; groups and headings have no value, and neither has what a folded group hides. */
static void read_line(shown *shown, const char *line)
{
    const char *value = strchr(line + 1, '|') + 1;
    const int name_length = (int)(value - line - 2);
    const int value_length = (int)(strrchr(value, '|') - value);
    assert_true(shown->count < TRACES_MAX);
    assert_true(name_length < 64 && value_length < 64);
    (void)snprintf(shown->name[shown->count], 64, "%.*s", name_length, line + 1);
    (void)snprintf(shown->value[shown->count], 64, "%.*s", value_length, value);
    shown->count++;
}

static void read_report(shown *shown)
{
    char line[512];
    FILE *stream = fopen(scratch_path("report"), "r");
    assert_non_null(stream);
    memset(shown, 0, sizeof *shown);
    assert_non_null(fgets(line, sizeof line, stream));
    assert_int_equal(sscanf(line, "window %" SCNd64 " %" SCNd64 " %" SCNd64, &shown->from,
                            &shown->to, &shown->marker),
                     3);
    while (fgets(line, sizeof line, stream) != NULL) {
        read_line(shown, line);
    }
    fclose(stream);
}

static void assert_silent(const char *file)
{
    static const char *const complaints[] = {"not found", "rror",  "arning",
                                             "ould not",  "annot", "nvalid"};
    char *said = scratch_read(file, NULL);
    for (size_t i = 0; i < sizeof complaints / sizeof complaints[0]; i++) {
        if (strstr(said, complaints[i]) != NULL) {
            fail_msg("GTKWave says:\n%s", said);
        }
    }
    free(said);
}

/* The two names are of files in the scratch directory. */
static void open_in_gtkwave(const char *waveform, const char *save_file, shown *shown)
{
    char paths[3][1024];
    (void)snprintf(paths[0], sizeof paths[0], "%s", scratch_path("ask.tcl"));
    (void)snprintf(paths[1], sizeof paths[1], "%s", scratch_path(waveform));
    (void)snprintf(paths[2], sizeof paths[2], "%s", scratch_path(save_file));
    const char *const argv[] = {"xvfb-run", "-a",     "gtkwave", "-S",
                                paths[0],   paths[1], paths[2],  NULL};
    (void)remove(scratch_path("report"));
    const int status = child_run(argv, SECONDS);
    if (status != 0) {
        fail_msg("gtkwave %s %s: status %d; installed by sim/deps.sh gtkwave", waveform, save_file,
                 status);
    }
    assert_silent(scratch_path("child.out"));
    assert_silent(scratch_path("child.err"));
    read_report(shown);
}

/* "reg1[18:0]" of "TOP.specular_device.lane[0].u.reg1" with 19 bits; a single bit may have brackets
 * or none. */
static bool is_name_of(const char *name, const saved_trace *trace)
{
    char expected[64];
    const char *last = strrchr(trace->name, '.') + 1;
    (void)snprintf(expected, sizeof expected, "%s[%d:0]", last, trace->width - 1);
    if (trace->width > 1) {
        return strcmp(name, expected) == 0;
    }
    return strncmp(name, last, strlen(last)) == 0 &&
           (name[strlen(last)] == '\0' || strcmp(name + strlen(last), "[0]") == 0);
}

/* Index of the next shown row that is `trace`, from row *next on; the rest are headings. */
static int row_of(const shown *shown, const saved_trace *trace, int *next)
{
    while (*next < shown->count) {
        const int row = (*next)++;
        if (is_name_of(shown->name[row], trace)) {
            return row;
        }
    }
    return -1;
}

static double number_of(const glint_signal_info *info, uint64_t bits)
{
    const int width = info->int_bits + info->frac_bits;
    double value = (double)bits;
    if (info->is_signed && (bits >> (width - 1) & 1) != 0) {
        value -= ldexp(1.0, width);
    }
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
    if (!(fabs(found - expected) <= 1e-9)) {
        fail_msg("%s: GTKWave shows %s, the model has %.12g", info.name, value, expected);
    }
}

static glint_specular_device *play_until(const glint_specular_config *config, int last)
{
    glint_specular_device *device;
    assert_int_equal(glint_specular_device_create(config, &device), GLINT_OK);
    for (int clock = 1; clock <= last; clock++) {
        glint_specular_inputs in;
        glint_wave_scene(clock, config->lanes, &in);
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

static void check_setting(const glint_specular_config *config, const char *format)
{
    static saved file;
    static shown shown;
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
    open_in_gtkwave(waveform, save_file, &shown);

    const int centre = glint_wave_scene_centre(config->lanes);
    assert_int_equal(shown.marker, file.marker);
    assert_int_equal(shown.marker, (centre + 1) * 10);
    /* The whole scene is in sight: its clocks, and not much else. */
    assert_true(shown.from <= 20 && shown.to >= (GLINT_WAVE_SCENE_CLOCKS + 1) * 10);
    assert_true(shown.to <= 2 * GLINT_WAVE_SCENE_CLOCKS * 10);

    glint_specular_device *device = play_until(config, centre);
    for (int t = 0; t < file.count; t++) {
        const int row = row_of(&shown, &file.trace[t], &next);
        if (row < 0) {
            fail_msg("GTKWave does not show %s", file.trace[t].name);
        }
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
    check_setting(&(glint_specular_config){GLINT_GATE_COSINE, GLINT_PIPELINE_DRAWN, 1}, "fst");
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
    static shown shown;
    char glint[1024];
    int next = 0;
    int differing = 0;
    const char *build = getenv("GLINT_BUILD");
    (void)snprintf(glint, sizeof glint, "%s/wrong/glint", build != NULL ? build : "build");
    const char *const argv[] = {glint,  "verify", "--circuit", "specular", "--clocks",
                                "3000", "--seed", "5",         "--out",    scratch_directory,
                                NULL};
    assert_int_equal(child_run(argv, SECONDS), 1);
    saved_read(scratch_path("specular_cosine_pipelined_1/wave.gtkw"), &file);
    open_in_gtkwave("specular_cosine_pipelined_1/wave.fst", "specular_cosine_pipelined_1/wave.gtkw",
                    &shown);
    assert_int_equal(shown.marker, file.marker);
    assert_true(shown.from < shown.marker && shown.marker < shown.to);
    for (int t = 0; t < file.count; t++) {
        const int row = row_of(&shown, &file.trace[t], &next);
        const size_t length = strlen(file.trace[t].name);
        if (row < 0) {
            fail_msg("GTKWave does not show %s", file.trace[t].name);
        }
        if (t == 0) {
            assert_string_equal(shown.value[row], "1");
        }
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
    static shown shown;
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
    open_in_gtkwave("specular_cosine_pipelined.fst", "wrong.gtkw", &shown);
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
