/* `glint verify` as a user runs it: what it prints, its exit status, Ctrl-C. */
#define _XOPEN_SOURCE 700

#include <inttypes.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <cjson/cJSON.h>
#include <cmocka.h>

#include "../scratch.h"

#include "../child.h"
#include "../cli/run.h"
#include "glint_specular_device.h"

enum {
    SECONDS = 120 /* a fraction of one; a busy machine, many times that */
};

/* Signals of all settings of a gate and a pipeline together. */
static uint64_t signals_of(glint_gate gate, glint_pipeline pipeline)
{
    uint64_t signals = 0;
    for (int lanes = 1; lanes <= GLINT_LANES_MAX; lanes *= 2) {
        const glint_specular_config config = {gate, pipeline, lanes};
        signals += (uint64_t)glint_specular_signal_count(&config);
    }
    return signals;
}

typedef struct summary {
    uint64_t mismatches, comparisons, clocks, seed;
    int settings;
} summary;

static summary read_summary(const char *out)
{
    summary s;
    if (sscanf(out,
               "%" SCNu64 " mismatches of %" SCNu64
               " comparisons: every register and named value, %" SCNu64
               " clocks, %d settings, seed %" SCNu64,
               &s.mismatches, &s.comparisons, &s.clocks, &s.settings, &s.seed) != 5) {
        fail_msg("not a summary: \"%s\"", out);
    }
    return s;
}

static void all_settings_are_verified(void **state)
{
    (void)state;
    outcome done = run("verify --circuit specular --clocks 2000 --seed 77", "");
    uint64_t signals = 0;
    assert_outcome(&done, 0, "");
    const summary s = read_summary(done.out);
    for (int gate = 0; gate < GLINT_GATE_COUNT; gate++) {
        for (int pipeline = 0; pipeline < GLINT_PIPELINE_COUNT; pipeline++) {
            signals += signals_of((glint_gate)gate, (glint_pipeline)pipeline);
        }
    }
    assert_true(s.mismatches == 0 && s.settings == 30 && s.seed == 77);
    assert_true(s.clocks == 30 * 2000);
    assert_true(s.comparisons == 2000 * signals);
    forget(&done);
}

/* Without --circuit the divider's settings come on top. */
static void every_circuit_is_verified(void **state)
{
    (void)state;
    outcome all = run("verify --clocks 100 --seed 77", "");
    outcome specular = run("verify --circuit specular --clocks 100 --seed 77", "");
    outcome divider = run("verify --circuit divider --clocks 100 --seed 77", "");
    assert_outcome(&all, 0, "");
    assert_outcome(&specular, 0, "");
    assert_outcome(&divider, 0, "");
    const summary a = read_summary(all.out);
    const summary s = read_summary(specular.out);
    const summary d = read_summary(divider.out);
    assert_true(d.settings > 0 && d.comparisons > 0);
    assert_int_equal(a.settings, s.settings + d.settings);
    assert_true(a.comparisons == s.comparisons + d.comparisons);
    forget(&all);
    forget(&specular);
    forget(&divider);
}

static void one_setting_can_be_chosen(void **state)
{
    (void)state;
    const glint_specular_config config = {GLINT_GATE_SIGN, GLINT_PIPELINE_DRAWN, 4};
    outcome done =
        run("verify --circuit specular --gate sign --pipeline drawn --lanes 4 --clocks 100 "
            "--seed 0 --threads 1",
            "");
    assert_outcome(&done, 0, "");
    const summary s = read_summary(done.out);
    assert_int_equal(s.settings, 1);
    assert_true(s.comparisons == 100 * (uint64_t)glint_specular_signal_count(&config));
    forget(&done);
}

/* Without --seed the run prints the one it took. */
static void the_seed_is_printed(void **state)
{
    (void)state;
    outcome done = run("verify --clocks 10 --lanes 1", "");
    assert_outcome(&done, 0, "");
    assert_true(read_summary(done.out).seed > 0);
    forget(&done);
}

static double number(const cJSON *json, const char *name)
{
    const cJSON *item = cJSON_GetObjectItemCaseSensitive(json, name);
    assert_true(cJSON_IsNumber(item));
    return item->valuedouble;
}

static void json_says_the_same(void **state)
{
    (void)state;
    outcome done = run(
        "verify --circuit specular --clocks 500 --gate cosine --seed 9007199254740993 --json", "");
    assert_outcome(&done, 0, "");
    cJSON *json = cJSON_Parse(done.out);
    assert_non_null(json);
    const double signals = (double)(signals_of(GLINT_GATE_COSINE, GLINT_PIPELINE_DRAWN) +
                                    signals_of(GLINT_GATE_COSINE, GLINT_PIPELINE_PIPELINED));
    assert_true(number(json, "mismatches") == 0);
    assert_true(number(json, "comparisons") == 500 * signals);
    assert_true(number(json, "clocks") == 5000);
    assert_string_equal(cJSON_GetStringValue(cJSON_GetObjectItemCaseSensitive(json, "seed")),
                        "9007199254740993");
    assert_true(cJSON_IsFalse(cJSON_GetObjectItemCaseSensitive(json, "interrupted")));
    assert_int_equal(cJSON_GetArraySize(cJSON_GetObjectItemCaseSensitive(json, "settings")), 10);
    cJSON_Delete(json);
    forget(&done);
}

static void what_makes_no_sense_is_refused(void **state)
{
    (void)state;
    static const char *const lines[] = {
        "verify --clocks 0",     "verify --clocks -1", "verify --clocks many", "verify --lanes 3",
        "verify --lanes 17",     "verify --seed -1",   "verify --gate all2",   "verify --pipeline",
        "verify --threads 0",    "verify extra",       "verify --shifts 5",    "verify --shifts 17",
        "verify --circuit none",
    };
    for (size_t i = 0; i < sizeof lines / sizeof lines[0]; i++) {
        outcome done = run(lines[i], "");
        if (done.status != 2 || strncmp(done.err, "glint verify: ", 14) != 0 ||
            done.out[0] != '\0') {
            fail_msg("%s: exit status %d, \"%s\"", lines[i], done.status, done.err);
        }
        forget(&done);
    }
}

static void nothing_is_left_when_all_is_well(void **state)
{
    (void)state;
    char command_line[600];
    (void)snprintf(command_line, sizeof command_line, "verify --clocks 100 --out %s",
                   scratch_path("failure"));
    outcome done = run(command_line, "");
    assert_outcome(&done, 0, "");
    assert_int_equal(access(scratch_path("failure"), F_OK), -1);
    forget(&done);
}

/* ---- Ctrl-C -------------------------------------------------------------------------------------
 */

/* Starts a run that would take hours, and interrupts it once it listens. */
static char *interrupt_verify(const char *last_argument)
{
    const char *const argv[] = {glint_under_test(), "verify", "--clocks",    "1000000000000",
                                "--seed",           "5",      last_argument, NULL};
    const pid_t child = child_start(argv, scratch_path("verify.out"), scratch_path("verify.err"));
    child_wait_for_handler(child, SECONDS);
    for (int i = 0; i < 10; i++) {
        child_pause();
    }
    assert_int_equal(kill(child, SIGINT), 0);
    assert_int_equal(child_wait(child, SECONDS), 2);
    return scratch_read(scratch_path("verify.out"), NULL);
}

static void an_interrupted_run_is_summed_up(void **state)
{
    (void)state;
    char *out = interrupt_verify(NULL);
    const summary s = read_summary(out);
    assert_true(s.mismatches == 0 && s.comparisons > 0 && s.clocks > 0 && s.seed == 5);
    assert_true(s.settings >= 1);
    assert_says(out, " (interrupted)\n");
    free(out);
}

static void an_interrupted_run_is_summed_up_in_json(void **state)
{
    (void)state;
    char *out = interrupt_verify("--json");
    cJSON *json = cJSON_Parse(out);
    assert_non_null(json);
    assert_true(cJSON_IsTrue(cJSON_GetObjectItemCaseSensitive(json, "interrupted")));
    assert_true(number(json, "comparisons") > 0);
    cJSON_Delete(json);
    free(out);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(all_settings_are_verified),
        cmocka_unit_test(every_circuit_is_verified),
        cmocka_unit_test(one_setting_can_be_chosen),
        cmocka_unit_test(the_seed_is_printed),
        cmocka_unit_test(json_says_the_same),
        cmocka_unit_test(what_makes_no_sense_is_refused),
        cmocka_unit_test(nothing_is_left_when_all_is_well),
        cmocka_unit_test(an_interrupted_run_is_summed_up),
        cmocka_unit_test(an_interrupted_run_is_summed_up_in_json),
    };
    return cmocka_run_group_tests(tests, scratch_make, scratch_remove);
}
