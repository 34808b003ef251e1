/* `glint wave` as a user runs it: the files, the command it prints, a directory that cannot be
 * written, a full disk. */
#define _XOPEN_SOURCE 700

#include <inttypes.h>
#include <setjmp.h>
#include <signal.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <sys/resource.h>

#include <cmocka.h>

#include "../scratch.h"
#include "file/json.h"

#include "../cli/run.h"
#include "saved.h"
#include "vcd.h"

/* Runs "wave --circuit specular --out DIR …" for a directory of the scratch directory. */
static outcome run_wave(const char *directory, const char *arguments)
{
    char command_line[1024];
    (void)snprintf(command_line, sizeof command_line, "wave --circuit specular --out %s %s",
                   scratch_path(directory), arguments);
    return run(command_line, "");
}

static int count_entries(const char *path)
{
    int count = -2; /* "." and ".." */
    DIR *directory = opendir(path);
    assert_non_null(directory);
    while (readdir(directory) != NULL)
        count++;
    closedir(directory);
    return count;
}

static void both_pipelines_are_written(void **state)
{
    (void)state;
    static saved file;
    static const char *const names[] = {"specular_cosine_pipelined",
                                        "specular_cosine_combinational"};
    outcome done = run_wave("new/directory", "");
    assert_outcome(&done, 0, "");
    assert_int_equal(count_entries(scratch_path("new/directory")), 4);
    for (int i = 0; i < 2; i++) {
        char waveform[256];
        char save_file[256];
        char command[2200];
        (void)snprintf(waveform, sizeof waveform, "new/directory/%s.fst", names[i]);
        (void)snprintf(save_file, sizeof save_file, "new/directory/%s.gtkw", names[i]);
        (void)snprintf(command, sizeof command, "gtkwave %s %s\n", scratch_path(waveform),
                       scratch_path(save_file));
        assert_says(done.out, command);
        vcd wave = vcd_read_fst(scratch_path(waveform));
        saved_read(scratch_path(save_file), &file);
        assert_string_equal(file.dumpfile, strrchr(waveform, '/') + 1);
        assert_true((uint64_t)file.marker > wave.first_time);
        assert_true((uint64_t)file.marker < wave.last_time);
        assert_true(file.first_time >= wave.first_time);
        assert_true(file.first_time + 200 <= wave.last_time);
        vcd_free(&wave);
    }
    forget(&done);
}

static void the_window_can_be_chosen(void **state)
{
    (void)state;
    outcome done = run_wave("window", "--pipeline pipelined --gate sign --from 8 --to 12");
    assert_outcome(&done, 0, "");
    vcd wave = vcd_read_fst(scratch_path("window/specular_sign_pipelined.fst"));
    /* Clock 8 is the circuit's clock 9: from its falling edge to the one after clock 12. */
    assert_int_equal(wave.first_time, 85);
    assert_int_equal(wave.last_time, 135);
    vcd_free(&wave);
    /* The centre, clock 14, is not in it: the marker stands on the nearest clock. */
    static saved file;
    saved_read(scratch_path("window/specular_sign_pipelined.gtkw"), &file);
    assert_int_equal(file.marker, 130);
    assert_int_equal(file.first_time, 85);
    forget(&done);
}

static void vcd_on_request(void **state)
{
    (void)state;
    outcome done = run_wave("vcd", "--pipeline combinational --format vcd --lanes 2");
    assert_outcome(&done, 0, "");
    assert_int_equal(count_entries(scratch_path("vcd")), 2);
    vcd wave = vcd_read(scratch_path("vcd/specular_cosine_combinational.vcd"));
    assert_non_null(vcd_find(&wave, "TOP.specular_device.lane[1].u.keys12"));
    vcd_free(&wave);
    forget(&done);
}

static void json_names_the_files(void **state)
{
    (void)state;
    outcome done = run_wave("json", "--json");
    assert_outcome(&done, 0, "");
    json_t *json = json_loads(done.out, JSON_REJECT_DUPLICATES | JSON_DECODE_ANY, NULL);
    const json_t *files = json_object_get(json, "files");
    assert_int_equal(json_array_size(files), 2);
    const json_t *file;
    glint_json_each(file, files)
    {
        const char *waveform = json_string_value(json_object_get(file, "waveform"));
        const char *save_file = json_string_value(json_object_get(file, "save_file"));
        assert_true(waveform != NULL && save_file != NULL);
        assert_int_equal(access(waveform, R_OK), 0);
        assert_int_equal(access(save_file, R_OK), 0);
    }
    json_decref(json);
    forget(&done);
}

static void what_makes_no_sense_is_refused(void **state)
{
    (void)state;
    static const char *const arguments[] = {"--lanes 33",       "--lanes -1",  "--from 0",
                                            "--from 9 --to 8",  "--to 100000", "--format ghw",
                                            "--pipeline third", "extra"};
    for (size_t i = 0; i < sizeof arguments / sizeof arguments[0]; i++) {
        outcome done = run_wave("refused", arguments[i]);
        if (done.status != 2 || strncmp(done.err, "glint wave: ", 12) != 0)
            fail_msg("%s: exit status %d, \"%s\"", arguments[i], done.status, done.err);
        assert_int_equal(access(scratch_path("refused"), F_OK), -1);
        forget(&done);
    }
}

static void a_directory_that_cannot_be_made_is_told(void **state)
{
    (void)state;
    scratch_write(scratch_path("plain"), "", 0);
    outcome done = run_wave("plain/below", "");
    assert_outcome(&done, 2, NULL);
    assert_string_equal(done.out, "");
    assert_says(done.err, "glint wave: ");
    assert_says(done.err, "plain");
    forget(&done);
}

/* A limit on the size of files, which the command inherits, stands for the full disk. With 1000
 * bytes there is room for the message. */
static outcome run_wave_within(rlim_t limit, const char *arguments)
{
    struct rlimit before;
    assert_int_equal(getrlimit(RLIMIT_FSIZE, &before), 0);
    const struct rlimit bound = {limit, before.rlim_max};
    signal(SIGXFSZ, SIG_IGN);
    assert_int_equal(setrlimit(RLIMIT_FSIZE, &bound), 0);
    outcome done = run_wave("full", arguments);
    assert_int_equal(setrlimit(RLIMIT_FSIZE, &before), 0);
    signal(SIGXFSZ, SIG_DFL);
    return done;
}

static void a_full_disk_is_told_and_leaves_nothing(void **state)
{
    (void)state;
    static const rlim_t limits[] = {1000, 5000, 100000};
    static const char *const formats[] = {"--format fst", "--format vcd"};
    outcome built = run_wave("built", "--format vcd"); /* of FST, by the tests before */
    assert_outcome(&built, 0, "");
    forget(&built);
    for (int i = 0; i < 6; i++) {
        outcome done = run_wave_within(limits[i / 2], formats[i % 2]);
        assert_outcome(&done, 2, NULL);
        assert_says(done.err, "glint wave: cannot write ");
        assert_says(done.err, "/full/specular_cosine_pipelined.");
        assert_string_equal(done.out, "");
        assert_int_equal(count_entries(scratch_path("full")), 0);
        forget(&done);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(both_pipelines_are_written),
        cmocka_unit_test(the_window_can_be_chosen),
        cmocka_unit_test(vcd_on_request),
        cmocka_unit_test(json_names_the_files),
        cmocka_unit_test(what_makes_no_sense_is_refused),
        cmocka_unit_test(a_directory_that_cannot_be_made_is_told),
        cmocka_unit_test(a_full_disk_is_told_and_leaves_nothing),
    };
    return cmocka_run_group_tests(tests, scratch_make, scratch_remove);
}
