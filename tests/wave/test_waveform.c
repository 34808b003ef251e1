/* Waveforms of the demonstration scene: they show the circuit and exactly the requested window; the
 * save file names what is there, in the right formats; the scene contains what it promises; a full
 * disk leaves no partial files. */
#define _XOPEN_SOURCE 700

#include <inttypes.h>
#include <math.h>
#include <setjmp.h>
#include <signal.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <cmocka.h>

#include "../scratch.h"

#include "../under_way.h"
#include "circuit/circuits.h"
#include "rtl/rtl.h"
#include "saved.h"
#include "vcd.h"
#include "wave/save_file.h"
#include "wave/specular_scene.h"
#include "wave/waveform.h"

enum { LAST = GLINT_SPECULAR_SCENE_CLOCKS };

static const glint_specular_config settings[] = {
    {GLINT_GATE_COSINE, GLINT_PIPELINE_PIPELINED, 1},
    {GLINT_GATE_COSINE, GLINT_PIPELINE_COMBINATIONAL, 1},
    {GLINT_GATE_SIGN, GLINT_PIPELINE_PIPELINED, 2},
    {GLINT_GATE_SIGN, GLINT_PIPELINE_COMBINATIONAL, 4},
    {GLINT_GATE_DRAWN, GLINT_PIPELINE_PIPELINED, 8},
    {GLINT_GATE_DRAWN, GLINT_PIPELINE_COMBINATIONAL, 1},
    {GLINT_GATE_COSINE, GLINT_PIPELINE_PIPELINED, 16},
};
#define SETTING_COUNT (sizeof settings / sizeof settings[0])

/* Times of the scene's clocks: the reset of creation is the circuit's clock 1. */
static uint64_t falling_edge_before(int clock)
{
    return (uint64_t)(clock + 1) * 10 - 5;
}
static uint64_t rising_edge_of(int clock)
{
    return (uint64_t)(clock + 1) * 10;
}

static glint_status try_record(const glint_specular_config *config, glint_wave_format format,
                               int first, int last, const char *path, glint_error *err)
{
    const glint_setting setting = glint_setting_specular(config);
    const glint_setting scene_of = glint_setting_specular(&settings[0]);
    glint_wave_scene scene;
    /* A scene of a setting that there is, whatever is asked for. */
    assert_int_equal(
        glint_wave_scene_make(config->lanes <= GLINT_LANES_MAX ? &setting : &scene_of, &scene, err),
        GLINT_OK);
    assert_int_equal(scene.clocks, LAST);
    if (config->lanes <= GLINT_LANES_MAX)
        assert_int_equal(scene.marker, glint_specular_scene_centre(config->lanes));
    const glint_status status = glint_wave_record(&setting, &scene, format, first, last, path, err);
    free(scene.pins);
    return status;
}

static void record(const glint_specular_config *config, glint_wave_format format, int first,
                   int last, const char *path)
{
    glint_error err;
    if (try_record(config, format, first, last, path, &err) != GLINT_OK)
        fail_msg("%s", err.text);
}

/* ---- What is in the waveform
 * ---------------------------------------------------------------------- */

/* Every signal of the table at every clock of the scene, against the C model. */
static void the_waveform_shows_the_circuit(void **state)
{
    (void)state;
    unsigned compared = 0;
    for (size_t i = 0; i < SETTING_COUNT; i++) {
        const glint_specular_config *config = &settings[i];
        glint_specular_device *device;
        if (config->lanes > 2)
            continue;
        record(config, GLINT_WAVE_VCD, 1, LAST, scratch_path("scene.vcd"));
        vcd wave = vcd_read(scratch_path("scene.vcd"));
        assert_int_equal(glint_specular_device_create(config, &device), GLINT_OK);
        for (int clock = 1; clock <= LAST; clock++) {
            glint_specular_inputs in;
            glint_specular_scene(clock, config->lanes, &in);
            glint_specular_device_clock(device, &in);
            for (int s = 0; s < glint_specular_signal_count(config); s++) {
                const glint_signal_info info = glint_specular_signal_info(config, s);
                char name[112];
                saved_name(&info, name, sizeof name);
                const uint64_t expected =
                    glint_specular_signal_bits(config, glint_specular_device_signals(device), s);
                if (vcd_value(&wave, name, rising_edge_of(clock)) != expected)
                    fail_msg("%s at clock %d is not 0x%" PRIx64, name, clock, expected);
                compared++;
            }
        }
        glint_specular_device_destroy(device);
        vcd_free(&wave);
    }
    print_message("%u values compared\n", compared);
    assert_true(compared > 48 * 42 * 3);
}

static void the_window_is_kept(void **state)
{
    (void)state;
    static const int windows[][2] = {{1, LAST}, {1, 1}, {5, 5}, {10, 20}, {LAST, LAST}};
    for (size_t i = 0; i < SETTING_COUNT; i++) {
        for (size_t w = 0; w < sizeof windows / sizeof windows[0]; w++) {
            const int first = windows[w][0];
            const int last = windows[w][1];
            record(&settings[i], GLINT_WAVE_FST, first, last, scratch_path("window.fst"));
            vcd info = vcd_read_fst(scratch_path("window.fst"));
            assert_true(info.first_time == falling_edge_before(first));
            assert_true(info.last_time == falling_edge_before(last + 1));
            assert_true(info.signal_count > 42);

            record(&settings[i], GLINT_WAVE_VCD, first, last, scratch_path("window.vcd"));
            vcd wave = vcd_read(scratch_path("window.vcd"));
            assert_true(wave.first_time == info.first_time && wave.last_time == info.last_time);
            vcd_free(&wave);
            vcd_free(&info);
        }
    }
}

/* The same waveform in both formats. */
static void fst_and_vcd_are_the_same(void **state)
{
    (void)state;
    record(&settings[0], GLINT_WAVE_FST, 1, LAST, scratch_path("a.fst"));
    record(&settings[0], GLINT_WAVE_VCD, 1, LAST, scratch_path("b.vcd"));
    vcd a = vcd_read_fst(scratch_path("a.fst"));
    vcd b = vcd_read(scratch_path("b.vcd"));
    vcd_assert_same(&a, &b);
    vcd_free(&a);
    vcd_free(&b);
}

/* ---- The save file
 * -------------------------------------------------------------------------------- */

static void write_save_file(const glint_specular_config *config, int64_t marker, const char *path)
{
    glint_error err;
    const glint_setting setting = glint_setting_specular(config);
    const glint_gtkw_window window = {.waveform = "some/where/scene.fst",
                                      .first_time = 10,
                                      .last_time = 500,
                                      .marker_time = marker};
    assert_int_equal(glint_wave_save_file(&setting, &window, path, &err), GLINT_OK);
}

static void assert_format(const glint_specular_config *config, const saved_trace *trace)
{
    const int index = saved_signal(config, trace);
    if (index < 0)
        return;
    const glint_signal_info info = glint_specular_signal_info(config, index);
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
    for (size_t i = 0; i < SETTING_COUNT; i++) {
        record(&settings[i], GLINT_WAVE_VCD, 1, 4, scratch_path("names.vcd"));
        write_save_file(&settings[i], 120, scratch_path("names.gtkw"));
        vcd wave = vcd_read(scratch_path("names.vcd"));
        saved_read(scratch_path("names.gtkw"), &file);
        assert_true(file.count > 30);
        for (int t = 0; t < file.count; t++) {
            const vcd_signal *signal = vcd_find(&wave, file.trace[t].name);
            if (signal == NULL)
                fail_msg("the waveform has no %s", file.trace[t].name);
            assert_int_equal(signal->width, file.trace[t].width);
            assert_format(&settings[i], &file.trace[t]);
        }
        vcd_free(&wave);
    }
}

static bool is_named(const saved *file, const char *name)
{
    for (int t = 0; t < file->count; t++)
        if (strcmp(file->trace[t].name, name) == 0)
            return true;
    return false;
}

/* Every register and every block of the figure, in every lane, and every output and pin. */
static void the_save_file_leaves_no_block_out(void **state)
{
    (void)state;
    static saved file;
    static const char *const pins[] = {"clk",    "reset", "en", "n_we", "n",
                                       "rgb_we", "r",     "g",  "b",    "in_valid"};
    for (size_t i = 0; i < SETTING_COUNT; i++) {
        write_save_file(&settings[i], 120, scratch_path("blocks.gtkw"));
        saved_read(scratch_path("blocks.gtkw"), &file);
        for (int s = 0; s < glint_specular_signal_count(&settings[i]); s++) {
            const glint_signal_info info = glint_specular_signal_info(&settings[i], s);
            char name[112];
            saved_name(&info, name, sizeof name);
            if (info.kind != GLINT_SIGNAL_STAGE && strcmp(info.name, "sat10") != 0 &&
                !is_named(&file, name))
                fail_msg("%s is not in the save file", name);
        }
        for (size_t p = 0; p < sizeof pins / sizeof pins[0]; p++) {
            char name[112];
            (void)snprintf(name, sizeof name, "TOP.specular_device.%s", pins[p]);
            assert_true(is_named(&file, name));
        }
        for (int lane = 0; lane < settings[i].lanes; lane++) {
            char name[112];
            (void)snprintf(name, sizeof name, "TOP.specular_device.lane[%d].u.cos", lane);
            assert_true(is_named(&file, name));
        }
        assert_true(file.headings >= 9);
    }
}

/* The pins, then the data's way through the figure, top to bottom. */
static void the_save_file_is_in_the_order_of_the_data(void **state)
{
    (void)state;
    static saved file;
    static const char *const order[] = {"lane[0].u.cos",    "lane[0].u.out_r",  "lane[0].u.reg1",
                                        "lane[0].u.adder6", "lane[0].u.mul7",   "lane[0].u.adder8",
                                        "lane[0].u.mul10",  "lane[0].u.keys12", "lane[0].u.mul13"};
    for (size_t i = 0; i < SETTING_COUNT; i++) {
        size_t next = 0;
        write_save_file(&settings[i], 120, scratch_path("order.gtkw"));
        saved_read(scratch_path("order.gtkw"), &file);
        for (int t = 0; t < file.count && next < sizeof order / sizeof order[0]; t++) {
            char name[112];
            (void)snprintf(name, sizeof name, "TOP.specular_device.%s", order[next]);
            next += strcmp(file.trace[t].name, name) == 0;
        }
        assert_int_equal(next, sizeof order / sizeof order[0]);
    }
}

/* Twenty clocks, eight before the marker: in a window as wide as the save file asks for, less what
 * GTKWave has beside the wave. */
static void the_save_file_opens_at_the_marker(void **state)
{
    (void)state;
    static saved file;
    for (size_t i = 0; i < SETTING_COUNT; i++) {
        write_save_file(&settings[i], 350, scratch_path("view.gtkw"));
        saved_read(scratch_path("view.gtkw"), &file);
        assert_string_equal(file.dumpfile, "scene.fst");
        assert_int_equal(file.first_time, 270);
        assert_int_equal(file.marker, 350);
        assert_int_equal(file.window_width, 1600);
        assert_int_equal(file.window_height, 1000);
        const double view = saved_view(&file, 1600 - 64 - file.signals_width);
        assert_true(view > 195 && view <= 200.001);
    }
}

/* GTKWave takes no view that is not in the waveform whole: the view moves away from the marker, or
 * is all of the waveform. */
static void the_view_lies_in_the_waveform(void **state)
{
    (void)state;
    static saved file;
    static const struct {
        int64_t marker;
        uint64_t begin;
    } views[] = {{10, 10}, {50, 10}, {90, 10}, {100, 20}, {300, 220}, {390, 300}, {499, 300}};
    for (size_t i = 0; i < sizeof views / sizeof views[0]; i++) {
        write_save_file(&settings[0], views[i].marker, scratch_path("view.gtkw"));
        saved_read(scratch_path("view.gtkw"), &file);
        assert_int_equal(file.first_time, views[i].begin);
    }
}

/* Characters of a value: sign, digits, point. A fraction of f bits has f digits, and GTKWave shows
 * 16 that count. */
static int characters_of(const saved_trace *trace)
{
    const int integer = trace->width - trace->fraction;
    if (trace->fraction > 0)
        return 1 + (int)ceil(integer * log10(2)) + 1 + trace->fraction;
    return (trace->flags & SAVED_BINARY) != 0 ? trace->width
           : (trace->flags & SAVED_HEX) != 0  ? (trace->width + 3) / 4
                                              : (int)ceil(integer * log10(2)) + 1;
}

/* Names and values at the marker side by side, eight pixels a character. */
static void names_and_values_have_room(void **state)
{
    (void)state;
    static saved file;
    for (size_t i = 0; i < SETTING_COUNT; i++) {
        int name = 0;
        int value = 0;
        write_save_file(&settings[i], 120, scratch_path("room.gtkw"));
        saved_read(scratch_path("room.gtkw"), &file);
        for (int t = 0; t < file.count; t++) {
            const int length = (int)strlen(file.trace[t].label);
            const int characters = characters_of(&file.trace[t]) + 1; /* "=" */
            name = length > name ? length : name;
            value = characters > value ? characters : value;
            assert_null(strchr(file.trace[t].label, '.')); /* GTKWave cuts off what is before it */
        }
        assert_true(file.longest_heading <= 24);
        name = file.longest_heading > name ? file.longest_heading : name;
        assert_true(file.signals_width >= 8 * (name + value) + 16);
        assert_true(file.signals_width <= 440);
    }
}

/* Pins and all that comes before W are on the first screen: of 42 rows, in a window of 1000. */
static void pins_are_on_the_first_screen(void **state)
{
    (void)state;
    static saved file;
    for (size_t i = 0; i < SETTING_COUNT; i++) {
        int found = 0;
        write_save_file(&settings[i], 120, scratch_path("rows.gtkw"));
        saved_read(scratch_path("rows.gtkw"), &file);
        for (int t = 0; t < file.count; t++) {
            const saved_trace *trace = &file.trace[t];
            const char *name = strrchr(trace->name, '.') + 1;
            if (!trace->is_folded && strncmp(name, "out_", 4) == 0) {
                assert_true(trace->row < 30);
                found++;
            }
            if (!trace->is_folded && strcmp(name, "keys12") == 0) {
                assert_true(trace->row < 42);
                found++;
            }
        }
        assert_int_equal(found, 7); /* out_r is there twice */
    }
}

/* ---- The scene
 * ------------------------------------------------------------------------------------ */

typedef struct scene_counts {
    int stalled_in_flight, material_with_point, material_between_points, gaps, above_one;
    int inside, outside, centres, results, points;
} scene_counts;

static scene_counts play_scene(const glint_specular_config *config, glint_specular_device *device)
{
    scene_counts c = {0};
    const glint_specular_signals *s = glint_specular_device_signals(device);
    for (int clock = 1; clock <= LAST; clock++) {
        glint_specular_inputs in;
        const bool in_flight = (s->s1_valid | s->s2_valid | s->s3_valid) != 0;
        const bool seen_points = c.points > 0;
        glint_specular_scene(clock, config->lanes, &in);
        glint_specular_device_clock(device, &in);
        c.stalled_in_flight += !in.en && in_flight;
        c.material_with_point += in.en && in.n_we && in.rgb_we && in.in_valid != 0;
        c.material_between_points += in.en && in.n_we && in.in_valid == 0 && seen_points;
        c.gaps += in.en && in.in_valid == 0 && in_flight;
        for (int i = 0; i < config->lanes; i++) {
            c.points += in.en && (in.in_valid >> i & 1) != 0;
            c.above_one += in.en && (in.in_valid >> i & 1) != 0 && in.cos[i] > GLINT_COS_ONE;
            if (in.en && (s->out_valid >> i & 1) != 0) {
                c.results++;
                c.inside += s->lane[i].out_w != 0;
                c.outside += s->lane[i].out_w == 0;
                c.centres += s->lane[i].out_w == GLINT_W_ONE;
            }
        }
    }
    /* All came out: what is valid now has left the last stage. */
    assert_true((s->s1_valid | s->s2_valid | s->s3_valid) == 0 ||
                config->pipeline == GLINT_PIPELINE_COMBINATIONAL);
    return c;
}

static void the_scene_holds_what_it_promises(void **state)
{
    (void)state;
    for (int p = 0; p < GLINT_PIPELINE_COUNT; p++) {
        for (int lanes = 1; lanes <= GLINT_LANES_MAX; lanes *= 2) {
            const glint_specular_config config = {GLINT_GATE_COSINE, (glint_pipeline)p, lanes};
            glint_specular_device *device;
            assert_int_equal(glint_specular_device_create(&config, &device), GLINT_OK);
            const scene_counts c = play_scene(&config, device);
            glint_specular_device_destroy(device);
            print_message("%s, %2d lanes: %d points, %d inside, %d outside, %d at the centre\n",
                          glint_pipeline_name(config.pipeline), lanes, c.points, c.inside,
                          c.outside, c.centres);
            assert_true(c.points > 34 && c.results == c.points);
            assert_true(c.inside > 10 && c.outside > 3 && c.centres >= 3);
            assert_true(c.material_with_point == 1 && c.material_between_points == 1);
            assert_true(c.above_one == lanes && c.gaps > 0);
            if (lanes <= 2) /* with more, the scan is over before the stall */
                assert_true(c.stalled_in_flight > 0);
        }
    }
}

/* The edge of the highlight is crossed point by point, into it and out again. */
static void the_scan_crosses_the_edge_twice(void **state)
{
    (void)state;
    const glint_specular_config config = {GLINT_GATE_COSINE, GLINT_PIPELINE_COMBINATIONAL, 1};
    glint_specular_device *device;
    int crossings = 0;
    int last = -1;
    assert_int_equal(glint_specular_device_create(&config, &device), GLINT_OK);
    const glint_specular_signals *s = glint_specular_device_signals(device);
    for (int clock = 1; clock <= LAST && s->reg2 != 300; clock++) {
        glint_specular_inputs in;
        glint_specular_scene(clock, 1, &in);
        glint_specular_device_clock(device, &in);
        if (s->out_valid != 0 && s->reg2 != 300) {
            const int inside = s->lane[0].out_w != 0;
            crossings += last >= 0 && inside != last;
            last = inside;
        }
    }
    assert_int_equal(crossings, 2);
    assert_int_equal(s->reg2, 300);
    glint_specular_device_destroy(device);
}

/* GTKWave leaves out a fraction below 0.0001 of a code that it shows as a number: in the scene, no
 * signal ever has one. */
static void the_scene_has_no_fraction_that_gtkwave_drops(void **state)
{
    (void)state;
    int fractions = 0;
    for (size_t i = 0; i < SETTING_COUNT; i++) {
        glint_specular_device *device;
        assert_int_equal(glint_specular_device_create(&settings[i], &device), GLINT_OK);
        const glint_specular_signals *s = glint_specular_device_signals(device);
        for (int clock = 1; clock <= LAST; clock++) {
            glint_specular_inputs in;
            glint_specular_scene(clock, settings[i].lanes, &in);
            glint_specular_device_clock(device, &in);
            for (int k = 0; k < glint_specular_signal_count(&settings[i]); k++) {
                const glint_signal_info info = glint_specular_signal_info(&settings[i], k);
                const uint64_t bits = glint_specular_signal_bits(&settings[i], s, k);
                const uint64_t one = UINT64_C(1) << info.frac_bits;
                const bool is_negative =
                    info.is_signed && (bits >> (info.int_bits + info.frac_bits - 1)) != 0;
                const uint64_t fraction = (is_negative ? one - bits % one : bits) % one;
                fractions += fraction != 0;
                if (fraction != 0 && (double)fraction / (double)one < 0.0001) {
                    fail_msg("clock %d: %s has a fraction of %g", clock, info.name,
                             (double)fraction / (double)one);
                }
            }
        }
        glint_specular_device_destroy(device);
    }
    assert_true(fractions > 1000);
}

static void the_centre_is_where_it_is_said_to_be(void **state)
{
    (void)state;
    for (int lanes = 1; lanes <= GLINT_LANES_MAX; lanes *= 2) {
        const int centre = glint_specular_scene_centre(lanes);
        glint_specular_inputs in;
        bool found = false;
        assert_in_range(centre, 1, LAST);
        glint_specular_scene(centre, lanes, &in);
        for (int i = 0; i < lanes; i++)
            found |= in.en && (in.in_valid >> i & 1) != 0 && in.cos[i] == GLINT_COS_ONE;
        assert_true(found);
    }
}

/* ---- Refusals
 * ------------------------------------------------------------------------------------- */

static void what_cannot_be_written_is_told(void **state)
{
    (void)state;
    scratch_write(scratch_path("plain"), "", 0);
    for (int format = 0; format < GLINT_WAVE_FORMAT_COUNT; format++) {
        const char *const paths[] = {scratch_path("missing/a.fst"), scratch_path("plain/a.fst"),
                                     scratch_path(".")};
        for (size_t i = 0; i < sizeof paths / sizeof paths[0]; i++) {
            glint_error err = {""};
            const int before = scratch_count();
            assert_int_equal(
                try_record(&settings[0], (glint_wave_format)format, 1, 5, paths[i], &err),
                GLINT_IO_ERROR);
            if (strstr(err.text, paths[i]) == NULL)
                fail_msg("\"%s\" does not name %s", err.text, paths[i]);
            assert_int_equal(scratch_count(), before);
        }
    }
}

static void a_name_too_long_is_told(void **state)
{
    (void)state;
    static char path[5000];
    glint_error err;
    memset(path, 'x', sizeof path - 1);
    assert_int_equal(try_record(&settings[0], GLINT_WAVE_FST, 1, 5, path, &err), GLINT_IO_ERROR);
    assert_non_null(strstr(err.text, "too long"));
}

static void what_is_no_waveform_is_refused(void **state)
{
    (void)state;
    scratch_write(scratch_path("text"), "no waveform, a text", 19);
    scratch_write(scratch_path("empty"), "", 0);
    const char *const paths[] = {scratch_path("text"), scratch_path("empty"),
                                 scratch_path("missing")};
    for (size_t i = 0; i < 3; i++)
        assert_false(glint_wave_is_whole(paths[i]));
}

static void an_old_waveform_stays_when_the_new_one_fails(void **state)
{
    (void)state;
    glint_error err;
    const glint_specular_config none = {GLINT_GATE_COSINE, GLINT_PIPELINE_PIPELINED,
                                        GLINT_LANES_MAX + 1};
    scratch_write(scratch_path("old.fst"), "old", 3);
    assert_int_equal(try_record(&none, GLINT_WAVE_FST, 1, 5, scratch_path("old.fst"), &err),
                     GLINT_BAD_ARGUMENT);
    char *text = scratch_read(scratch_path("old.fst"), NULL);
    assert_string_equal(text, "old");
    free(text);
}

/* ---- A full disk ---------------------------------------------------------------------------- */

typedef glint_status work(const char *path, glint_error *err);

/* Works with no file allowed to grow beyond `limit` bytes; the status. */
static int work_within(rlim_t limit, work *work, const char *path)
{
    int status;
    fflush(NULL);
    const pid_t child = fork();
    assert_true(child >= 0);
    if (child == 0) {
        glint_error err = {""};
        const struct rlimit bound = {limit, limit};
        signal(SIGBUS, SIG_DFL); /* cmocka's own is for the parent */
        signal(SIGSEGV, SIG_DFL);
        signal(SIGABRT, SIG_DFL);
        signal(SIGXFSZ, SIG_IGN); /* so that a write fails as it does on a full disk */
        setrlimit(RLIMIT_FSIZE, &bound);
        const glint_status done = work(path, &err);
        _exit(done != GLINT_OK && err.text[0] == '\0' ? 99 : (int)done);
    }
    assert_int_equal(waitpid(child, &status, 0), child);
    if (!WIFEXITED(status))
        fail_msg("limit %lu: ended by signal %d", (unsigned long)limit, WTERMSIG(status));
    return WEXITSTATUS(status);
}

static size_t size_of(const char *path)
{
    struct stat info;
    assert_int_equal(stat(path, &info), 0);
    return (size_t)info.st_size;
}

static glint_status record_fst(const char *path, glint_error *err)
{
    return try_record(&settings[0], GLINT_WAVE_FST, 1, LAST, path, err);
}

static glint_status record_vcd(const char *path, glint_error *err)
{
    return try_record(&settings[0], GLINT_WAVE_VCD, 1, LAST, path, err);
}

/* The scene without asking for room before. */
static glint_status play_vcd(const void *context, const char *path, glint_error *err)
{
    const glint_setting setting = glint_setting_specular(&settings[0]);
    glint_rtl *rtl;
    (void)context;
    glint_status status = glint_rtl_open(&setting, GLINT_RTL_VCD, &rtl, err);
    if (status == GLINT_OK)
        status = glint_rtl_trace_open(rtl, path, err);
    for (int clock = 1; status == GLINT_OK && clock <= LAST; clock++) {
        glint_specular_inputs in;
        glint_specular_scene(clock, settings[0].lanes, &in);
        glint_rtl_clock(rtl, &in);
    }
    glint_rtl_destroy(rtl);
    return status;
}

static glint_status record_at_once(const char *path, glint_error *err)
{
    return glint_wave_write(path, GLINT_WAVE_VCD, play_vcd, NULL, err);
}

static void assert_nothing_within(rlim_t limit, work *work)
{
    const int before = scratch_count();
    const int status = work_within(limit, work, scratch_path("full"));
    if (status != GLINT_IO_ERROR)
        fail_msg("limit %lu: status %d", (unsigned long)limit, status);
    assert_int_equal(scratch_count(), before);
}

/* The whole waveform, or an error and nothing. */
static void a_full_disk_leaves_nothing(void **state)
{
    (void)state;
    static const rlim_t limits[] = {0, 1, 100, 4096, 5000, 65536, GLINT_WAVE_ROOM - 1};
    static work *const works[] = {record_fst, record_vcd};
    for (int w = 0; w < 2; w++) {
        glint_error err;
        assert_int_equal(works[w](scratch_path("whole"), &err), GLINT_OK);
        for (size_t i = 0; i < sizeof limits / sizeof limits[0]; i++)
            assert_nothing_within(limits[i], works[w]);
        assert_int_equal(work_within(GLINT_WAVE_ROOM, works[w], scratch_path("full")), GLINT_OK);
        assert_int_equal(size_of(scratch_path("full")), size_of(scratch_path("whole")));
        assert_int_equal(unlink(scratch_path("full")), 0);
    }
    /* The actual size is far below the space required. */
    assert_true(size_of(scratch_path("whole")) < GLINT_WAVE_ROOM / 10);
}

/* VCD goes out through a buffer: cut at any place, the last bytes included. */
static void a_vcd_cut_short_is_told(void **state)
{
    (void)state;
    glint_error err;
    assert_int_equal(record_at_once(scratch_path("whole.vcd"), &err), GLINT_OK);
    const size_t whole = size_of(scratch_path("whole.vcd"));
    for (size_t limit = 0; limit < whole; limit += whole / 9)
        assert_nothing_within(limit, record_at_once);
    assert_nothing_within(whole - 1, record_at_once);
    assert_int_equal(work_within(whole, record_at_once, scratch_path("full")), GLINT_OK);
    assert_int_equal(size_of(scratch_path("full")), whole);
    assert_int_equal(unlink(scratch_path("full")), 0);
}

/* If the disk fills up while an FST is written, the file is recognised as incomplete at any
 * length. */
static void an_fst_cut_short_is_refused(void **state)
{
    (void)state;
    glint_error err;
    size_t whole;
    assert_int_equal(record_fst(scratch_path("source.fst"), &err), GLINT_OK);
    char *bytes = scratch_read(scratch_path("source.fst"), &whole);
    scratch_write(scratch_path("cut.fst"), bytes, whole);
    free(bytes);
    assert_true(glint_wave_is_whole(scratch_path("cut.fst")));
    for (size_t length = whole; length-- > 0;) {
        assert_int_equal(truncate(scratch_path("cut.fst"), (off_t)length), 0);
        if (glint_wave_is_whole(scratch_path("cut.fst")))
            fail_msg("%zu of %zu bytes pass for a waveform", length, whole);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_waveform_shows_the_circuit),
        cmocka_unit_test(the_window_is_kept),
        cmocka_unit_test(fst_and_vcd_are_the_same),
        cmocka_unit_test(the_save_file_names_what_is_there),
        cmocka_unit_test(the_save_file_leaves_no_block_out),
        cmocka_unit_test(the_save_file_is_in_the_order_of_the_data),
        cmocka_unit_test(the_save_file_opens_at_the_marker),
        cmocka_unit_test(the_view_lies_in_the_waveform),
        cmocka_unit_test(names_and_values_have_room),
        cmocka_unit_test(pins_are_on_the_first_screen),
        cmocka_unit_test(the_scene_holds_what_it_promises),
        cmocka_unit_test(the_scan_crosses_the_edge_twice),
        cmocka_unit_test(the_scene_has_no_fraction_that_gtkwave_drops),
        cmocka_unit_test(the_centre_is_where_it_is_said_to_be),
        cmocka_unit_test(what_cannot_be_written_is_told),
        cmocka_unit_test(a_name_too_long_is_told),
        cmocka_unit_test(what_is_no_waveform_is_refused),
        cmocka_unit_test(an_old_waveform_stays_when_the_new_one_fails),
        cmocka_unit_test(a_full_disk_leaves_nothing),
        cmocka_unit_test(a_vcd_cut_short_is_told),
        cmocka_unit_test(an_fst_cut_short_is_refused),
    };
    return cmocka_run_group_tests(tests, scratch_make, scratch_remove);
}
