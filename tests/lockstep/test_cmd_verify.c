/* `glint verify` as a user runs it: what it prints, its exit status, Ctrl-C. */
#define _XOPEN_SOURCE 700

#include <inttypes.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "../scratch.h"
#include "file/json.h"

#include "../child.h"
#include "../cli/run.h"
#include "circuit/circuits.h"
#include "circuit/random_pins.h"
#include "glint_specular_device.h"
#include "lockstep/reach.h"

enum {
    SECONDS = 120 /* a fraction of one; a busy machine, many times that */
};

/* Signals of all settings of a gate and a pipeline together. */
static uint64_t signals_of(glint_gate gate, glint_pipeline pipeline)
{
    uint64_t signals = 0;
    for (int lanes = 1; lanes <= 16; lanes *= 2) { /* those tried unasked */
        const glint_specular_config config = {gate, pipeline, lanes};
        signals += (uint64_t)glint_specular_signal_count(&config);
    }
    return signals;
}

typedef struct summary {
    uint64_t mismatches, comparisons, clocks, seed;
    int settings;
} summary;

/* The first verdicts before the total: one line per circuit with more than one setting. */
static const char *skip_first_verdicts(const char *out, int *count)
{
    static const char first[] = "first verdict: ";
    *count = 0;
    for (; strncmp(out, first, sizeof first - 1) == 0; out = strchr(out, '\n') + 1)
        ++*count;
    return out;
}

static summary read_summary(const char *out)
{
    summary s;
    int firsts;
    const char *sum = skip_first_verdicts(out, &firsts);
    const char *plural = strstr(sum, " settings, seed ");
    if (sscanf(sum,
               "%" SCNu64 " mismatches of %" SCNu64
               " comparisons: every register and named value, %" SCNu64 " clocks, %d setting",
               &s.mismatches, &s.comparisons, &s.clocks, &s.settings) != 4 ||
        sscanf(strstr(sum, ", seed "), ", seed %" SCNu64, &s.seed) != 1 ||
        (plural != NULL) != (s.settings != 1))
        fail_msg("not a summary: \"%s\"", out);
    return s;
}

static void all_settings_are_verified(void **state)
{
    (void)state;
    outcome done = run("verify --circuit specular --clocks 2000 --seed 77", "");
    uint64_t signals = 0;
    assert_outcome(&done, 0, "");
    const summary s = read_summary(done.out);
    for (int gate = 0; gate < GLINT_GATE_COUNT; gate++)
        for (int pipeline = 0; pipeline < GLINT_PIPELINE_COUNT; pipeline++)
            signals += signals_of((glint_gate)gate, (glint_pipeline)pipeline);
    assert_true(s.mismatches == 0 && s.settings == 30 && s.seed == 77);
    assert_true(s.clocks == 30 * 2000);
    assert_true(s.comparisons == 2000 * signals);
    forget(&done);
}

/* Without --circuit, the divider's settings are added, and what is on request is named; nothing is
 * where a circuit is. */
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
    const char *not_tried = strstr(all.out, "\nnot tried: ");
    assert_non_null(not_tried);
    const glint_circuit *circuit;
    for (int i = 0; (circuit = glint_circuit_number(i)) != NULL; i++)
        assert_int_equal(strstr(not_tried, circuit->name) != NULL, circuit->on_request);
    assert_null(strstr(specular.out, "not tried"));
    forget(&all);
    forget(&specular);
    forget(&divider);
}

static void assert_verified(const char *line, int settings)
{
    outcome done = run(line, "");
    assert_outcome(&done, 0, "");
    assert_int_equal(read_summary(done.out).settings, settings);
    assert_null(strstr(done.out, "not tried"));
    forget(&done);
}

/* By its name, by an option of its own, or with all others. */
static void what_is_on_request_can_be_verified(void **state)
{
    (void)state;
    assert_verified("verify --circuit power --accuracy half --w-drop 0 --pipeline pipelined "
                    "--lanes 1 --clocks 100",
                    1);
    /* W as it is and at the common width. */
    assert_verified("verify --accuracy half --pipeline pipelined --lanes 1 --clocks 100", 2);
    assert_verified("verify --circuit all --accuracy half --pipeline pipelined --lanes 1 "
                    "--clocks 100",
                    2);
    /* Against the specular device's own model. */
    assert_verified("verify --circuit lean --lanes 1 --clocks 2000", 6);
    assert_verified("verify --circuit narrow --lanes 1 --clocks 2000", 2);
}

static void one_setting_can_be_chosen(void **state)
{
    (void)state;
    const glint_specular_config config = {GLINT_GATE_SIGN, GLINT_PIPELINE_COMBINATIONAL, 4};
    outcome done =
        run("verify --circuit specular --gate sign --pipeline combinational --lanes 4 --clocks 100 "
            "--seed 0 --threads 1",
            "");
    assert_outcome(&done, 0, "");
    const summary s = read_summary(done.out);
    assert_int_equal(s.settings, 1);
    assert_true(s.comparisons == 100 * (uint64_t)glint_specular_signal_count(&config));
    forget(&done);
}

/* Without --seed the run prints the one it took. */
/* The default setting of each circuit comes first, with the number of those that are left; not
 * where a script reads the result. One alone is its own verdict. */
static void the_first_verdict_comes_first(void **state)
{
    (void)state;
    static const char of_specular[] = "first verdict: gate cosine, pipeline pipelined, lanes 1: 0 "
                                      "mismatches of 3500 comparisons, ";
    static const char of_divider[] =
        "first verdict: divider pipelined, 12 shifts: 0 mismatches of ";
    int firsts;
    outcome all = run("verify --clocks 100 --seed 1", "");
    outcome json = run("verify --clocks 100 --seed 1 --json", "");
    outcome one =
        run("verify --clocks 100 --seed 1 --circuit divider --form sequential --shifts 9", "");
    assert_outcome(&all, 0, "");
    assert_outcome(&json, 0, "");
    assert_outcome(&one, 0, "");
    const char *second = strchr(all.out, '\n') + 1;
    (void)skip_first_verdicts(all.out, &firsts);
    assert_int_equal(firsts, 2);
    assert_memory_equal(all.out, of_specular, sizeof of_specular - 1);
    assert_memory_equal(second, of_divider, sizeof of_divider - 1);
    assert_says(all.out, " s; 51 settings to go\n");
    assert_says(second, " s; 50 settings to go\n");
    assert_int_equal(json.out[0], '{');
    (void)skip_first_verdicts(one.out, &firsts);
    assert_int_equal(firsts, 0);
    assert_int_equal(read_summary(one.out).settings, 1);
    forget(&all);
    forget(&json);
    forget(&one);
}

/* A value that is not listed is taken where it is named. */
static void any_value_in_range_is_verified(void **state)
{
    (void)state;
    const glint_specular_config config = {GLINT_GATE_COSINE, GLINT_PIPELINE_PIPELINED, 3};
    outcome done = run("verify --lanes 3 --gate cosine --pipeline pipelined --clocks 100", "");
    assert_outcome(&done, 0, "");
    assert_true(read_summary(done.out).comparisons ==
                100 * (uint64_t)glint_specular_signal_count(&config));
    forget(&done);
}

/* Said once, before the other circuits are done; the rest of its own settings are not tried. */
static void a_circuit_that_does_not_build_is_told_at_once(void **state)
{
    (void)state;
    char line[2200];
    (void)snprintf(line, sizeof line, "cp -r rtl '%s' && echo 'module' >> '%s/color_multiplier.v'",
                   scratch_path("broken"), scratch_path("broken"));
    assert_int_equal(system(line), 0);
    (void)snprintf(line, sizeof line, "verify --clocks 100 --seed 1 --rtl %s",
                   scratch_path("broken"));
    outcome done = run(line, "");
    assert_outcome(&done, 2, NULL);
    assert_memory_equal(done.err, "glint verify: ", 14);
    assert_says(done.err, "/color_multiplier.v:");
    assert_null(strchr(strchr(done.err, '\n') + 1, '\n'));
    assert_int_equal(read_summary(done.out).settings, 22);
    assert_says(done.out, "\nskipped: 29 settings of specular, after its first one failed\n");
    forget(&done);
    (void)snprintf(line, sizeof line, "verify --circuit specular --rtl %s", scratch_path("broken"));
    done = run(line, "");
    assert_outcome(&done, 2, NULL);
    assert_string_equal(done.out, "");
    assert_null(strchr(strchr(done.err, '\n') + 1, '\n'));
    forget(&done);
}

static void the_seed_is_printed(void **state)
{
    (void)state;
    outcome done = run("verify --clocks 10 --lanes 1", "");
    assert_outcome(&done, 0, "");
    assert_true(read_summary(done.out).seed > 0);
    forget(&done);
}

static double number(const json_t *json, const char *name)
{
    const json_t *item = json_object_get(json, name);
    assert_true(json_is_number(item));
    return json_number_value(item);
}

static void json_says_the_same(void **state)
{
    (void)state;
    outcome done = run(
        "verify --circuit specular --clocks 500 --gate cosine --seed 9007199254740993 --json", "");
    assert_outcome(&done, 0, "");
    json_t *json = json_loads(done.out, JSON_REJECT_DUPLICATES | JSON_DECODE_ANY, NULL);
    assert_non_null(json);
    const double signals = (double)(signals_of(GLINT_GATE_COSINE, GLINT_PIPELINE_COMBINATIONAL) +
                                    signals_of(GLINT_GATE_COSINE, GLINT_PIPELINE_PIPELINED));
    assert_true(number(json, "mismatches") == 0);
    assert_true(number(json, "comparisons") == 500 * signals);
    assert_true(number(json, "clocks") == 5000);
    assert_string_equal(json_string_value(json_object_get(json, "seed")), "9007199254740993");
    assert_true(json_is_false(json_object_get(json, "interrupted")));
    assert_int_equal(json_array_size(json_object_get(json, "settings")), 10);
    json_decref(json);
    forget(&done);
}

/* What the pins of a setting reached, from a run of its own: to hold the command's words against.
 */
static glint_reach reach_of(const glint_setting *setting, uint64_t clocks, uint64_t seed)
{
    static glint_reach_count count;
    glint_random_pins source;
    glint_random_pins_begin(&source, setting, seed);
    glint_reach_begin(&count, setting);
    for (uint64_t clock = 0; clock < clocks; clock++) {
        glint_pins pins;
        glint_random_pins_next(&source, &pins);
        glint_reach_clock(&count, &pins);
    }
    return count.reach;
}

static void assert_reach(const json_t *entry, const glint_reach *depth, const glint_reach *counts)
{
    const json_t *json = json_object_get(entry, "reach");
    assert_true(number(json, "clocks_without_reset") == (double)depth->run);
    assert_true(number(json, "enabled_clocks_without_reset") == (double)depth->run_enabled);
    assert_true(number(json, "stalls_in_a_row") == (double)depth->stall);
    assert_true(number(json, "resets") == (double)counts->resets);
    assert_true(number(json, "resets_in_flight") == (double)counts->resets_in_flight);
    assert_true(number(json, "material_changes") == (double)counts->changes);
    assert_true(number(json, "material_changes_in_flight") == (double)counts->changes_in_flight);
}

enum { REACH_CLOCKS = 30000, REACH_SEED = 12 };

/* Of each setting in JSON, of all together there and in words: the least depth, the sum of counts.
 */
static void what_was_reached_is_told(void **state)
{
    (void)state;
    char words[600];
    glint_reach least = {0};
    glint_reach sum = {0};
    outcome told = run("verify --gate sign --pipeline pipelined --clocks 30000 --seed 12", "");
    outcome done =
        run("verify --gate sign --pipeline pipelined --clocks 30000 --seed 12 --json", "");
    uint64_t patterns = 0;
    assert_outcome(&told, 0, "");
    assert_outcome(&done, 0, "");
    json_t *json = json_loads(done.out, JSON_REJECT_DUPLICATES | JSON_DECODE_ANY, NULL);
    const json_t *list = json_object_get(json, "settings");
    for (int i = 0; i < 5; i++) {
        const glint_setting setting = glint_setting_specular(
            &(glint_specular_config){GLINT_GATE_SIGN, GLINT_PIPELINE_PIPELINED, 1 << i});
        const glint_reach reach = reach_of(&setting, REACH_CLOCKS, REACH_SEED);
        const json_t *entry = json_array_get(list, (size_t)i);
        assert_true(number(entry, "lanes") == 1 << i);
        assert_reach(entry, &reach, &reach);
        least.run = i == 0 || reach.run < least.run ? reach.run : least.run;
        least.run_enabled =
            i == 0 || reach.run_enabled < least.run_enabled ? reach.run_enabled : least.run_enabled;
        least.stall = i == 0 || reach.stall < least.stall ? reach.stall : least.stall;
        sum.resets += reach.resets;
        sum.resets_in_flight += reach.resets_in_flight;
        sum.changes += reach.changes;
        sum.changes_in_flight += reach.changes_in_flight;
        patterns = reach.patterns;
        const json_t *told_of = json_object_get(entry, "reach");
        assert_true(number(told_of, "lanes_alone") == 1 << i);
        assert_true(number(told_of, "lane_patterns") == (double)patterns);
        assert_true(number(told_of, "lane_patterns_possible") == (1 << (1 << i)) - 1);
    }
    assert_reach(json, &least, &sum);
    (void)snprintf(words, sizeof words,
                   "reached in every setting: %" PRIu64 " clocks without a reset, %" PRIu64
                   " enabled; %" PRIu64 " stalls in a row\nin total: %" PRIu64 " resets, %" PRIu64
                   " of them mid-flow; %" PRIu64 " changes of material, %" PRIu64
                   " with points in flight\n"
                   "valid lanes: each alone, %" PRIu64 " of 65535 patterns of 16\n",
                   least.run, least.run_enabled, least.stall, sum.resets, sum.resets_in_flight,
                   sum.changes, sum.changes_in_flight, patterns);
    assert_says(told.out, words);
    json_decref(json);
    forget(&told);
    forget(&done);
}

/* Starts ignored by a busy divider are reported only for the form that can be busy. */
static void what_a_divider_reached_is_told(void **state)
{
    (void)state;
    char words[100];
    const glint_setting setting = glint_setting_divider(GLINT_DIVIDER_SEQUENTIAL, 7);
    const glint_reach reach = reach_of(&setting, REACH_CLOCKS, REACH_SEED);
    outcome told = run("verify --shifts 7 --clocks 30000 --seed 12", "");
    outcome done = run("verify --shifts 7 --clocks 30000 --seed 12 --json", "");
    assert_outcome(&told, 0, "");
    assert_outcome(&done, 0, "");
    (void)snprintf(words, sizeof words, " of them mid-flow; %" PRIu64 " starts while busy\n",
                   reach.ignored);
    assert_says(told.out, words);
    json_t *json = json_loads(done.out, JSON_REJECT_DUPLICATES | JSON_DECODE_ANY, NULL);
    const json_t *list = json_object_get(json, "settings");
    for (int i = 0; i < 2; i++) {
        const json_t *entry = json_array_get(list, (size_t)i);
        const json_t *of = json_object_get(entry, "reach");
        const bool waits =
            strcmp(json_string_value(json_object_get(entry, "form")), "sequential") == 0;
        assert_int_equal((json_object_get(of, "starts_while_busy") != NULL), waits);
        assert_true(!waits || number(of, "starts_while_busy") == (double)reach.ignored);
    }
    json_decref(json);
    forget(&told);
    forget(&done);
}

static void what_makes_no_sense_is_refused(void **state)
{
    (void)state;
    static const char *const lines[] = {
        "verify --clocks 0",     "verify --clocks -1", "verify --clocks many", "verify --lanes 33",
        "verify --lanes -1",     "verify --seed -1",   "verify --gate all2",   "verify --pipeline",
        "verify --threads 0",    "verify extra",       "verify --shifts 5",    "verify --shifts 17",
        "verify --circuit none",
    };
    for (size_t i = 0; i < sizeof lines / sizeof lines[0]; i++) {
        outcome done = run(lines[i], "");
        if (done.status != 2 || strncmp(done.err, "glint verify: ", 14) != 0 || done.out[0] != '\0')
            fail_msg("%s: exit status %d, \"%s\"", lines[i], done.status, done.err);
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
    assert_true(read_summary(done.out).mismatches == 0);
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
    child_wait_for_handler(child);
    for (int i = 0; i < 10; i++)
        child_pause();
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
    json_t *json = json_loads(out, JSON_REJECT_DUPLICATES | JSON_DECODE_ANY, NULL);
    assert_non_null(json);
    assert_true(json_is_true(json_object_get(json, "interrupted")));
    assert_true(number(json, "comparisons") > 0);
    json_decref(json);
    free(out);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(all_settings_are_verified),
        cmocka_unit_test(every_circuit_is_verified),
        cmocka_unit_test(what_is_on_request_can_be_verified),
        cmocka_unit_test(one_setting_can_be_chosen),
        cmocka_unit_test(the_first_verdict_comes_first),
        cmocka_unit_test(any_value_in_range_is_verified),
        cmocka_unit_test(a_circuit_that_does_not_build_is_told_at_once),
        cmocka_unit_test(the_seed_is_printed),
        cmocka_unit_test(json_says_the_same),
        cmocka_unit_test(what_was_reached_is_told),
        cmocka_unit_test(what_a_divider_reached_is_told),
        cmocka_unit_test(what_makes_no_sense_is_refused),
        cmocka_unit_test(nothing_is_left_when_all_is_well),
        cmocka_unit_test(an_interrupted_run_is_summed_up),
        cmocka_unit_test(an_interrupted_run_is_summed_up_in_json),
    };
    return cmocka_run_group_tests(tests, scratch_make, scratch_remove);
}
