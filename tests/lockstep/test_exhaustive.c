/* `glint verify --exhaustive`: it covers what it says, finds faults, and can be split into parts.
 * `make test-full` runs the whole domain. */
#define _XOPEN_SOURCE 700

#include <inttypes.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "../scratch.h"
#include "file/json.h"
#include "glint_specular.h"

#include "../child.h"
#include "../cli/run.h"
#include "../terminal.h"
#include "../wrong.h"

enum {
    CODES = GLINT_COS_CODE_MAX + 1, /* of the cosine pin */
    SECONDS = 120                   /* it takes one; a busy machine, many times that */
};

static double number(const json_t *json, const char *name)
{
    const json_t *item = json_object_get(json, name);
    assert_true(json_is_number(item));
    return json_number_value(item);
}

/* The result of a run that must end with this status; to be deleted. */
static json_t *result_of(const char *options, int status)
{
    char command_line[600];
    (void)snprintf(command_line, sizeof command_line, "verify --exhaustive --json %s", options);
    outcome done = run(command_line, "");
    assert_int_equal(done.status, status);
    json_t *json = json_loads(done.out, JSON_REJECT_DUPLICATES | JSON_DECODE_ANY, NULL);
    assert_non_null(json);
    forget(&done);
    return json;
}

/* One n whole: both colours at every cosine code, and its part of the multipliers' pairs. */
static void one_n_is_covered_whole(void **state)
{
    (void)state;
    json_t *json = result_of("--shard 81/1024", 0);
    const json_t *circuit = json_array_get(json_object_get(json, "circuits"), 0);
    assert_true(number(json, "n_done") == 1);
    assert_true(number(json, "mismatches") == 0);
    assert_true(number(json, "points") == 2.0 * CODES + number(circuit, "pairs"));
    assert_true(number(json, "comparisons") == 4 * number(json, "points"));
    assert_true(number(circuit, "pairs") > 0);
    json_decref(json);
}

static void every_gate_and_pipeline_is_equal(void **state)
{
    (void)state;
    json_t *json = result_of("--gate all --pipeline all --stride 4093 --seed 1", 0);
    assert_true(number(json, "n_done") == 1024);
    assert_true(number(json, "mismatches") == 0);
    assert_true(number(json, "comparisons") == 4 * number(json, "points"));
    const json_t *circuit;
    glint_json_each(circuit, json_object_get(json, "circuits"))
    {
        assert_true(number(circuit, "points") >= 2.0 * 1024 * (CODES / 4093));
    }
    assert_int_equal(json_array_size(json_object_get(json, "circuits")), 6);
    json_decref(json);
}

/* Each lane sees all that one of them would. */
static void every_lane_takes_every_code(void **state)
{
    (void)state;
    json_t *turning = result_of("--shard 81/1024", 0);
    json_t *every = result_of("--shard 81/1024 --every-lane", 0);
    assert_true(number(every, "points") == 16 * number(turning, "points"));
    assert_true(number(every, "comparisons") == 4 * number(every, "points"));
    assert_true(json_is_true(json_object_get(every, "every_lane")));
    assert_true(json_is_false(json_object_get(turning, "every_lane")));
    json_decref(turning);
    json_decref(every);
}

/* "0 mismatches" comes with what was searched and what was not. */
static void a_result_says_what_it_reaches(void **state)
{
    (void)state;
    static const struct {
        const char *options, *codes, *lanes;
    } cases[] = {
        {"", "all", "each lane saw 1 in 16 of them, different ones for each n\n"},
        {" --every-lane", "all", "each lane saw all of them\n"},
        {" --lanes 1", "all", "each lane saw all of them\n"},
        {" --lanes 4", "all", "each lane saw 1 in 4 of them, different ones for each n\n"},
        {" --stride 97 --seed 1", "1 in 97",
         "each lane saw 1 in 16 of them, different ones for each n\n"},
    };
    static const char not [] =
        "not reached: material changes in flight, partly valid lanes, stalls, resets, registers\n";
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        char command_line[128], reached[128];
        (void)snprintf(command_line, sizeof command_line, "verify --exhaustive --shard 9/1024%s",
                       cases[i].options);
        outcome done = run(command_line, "");
        assert_outcome(&done, 0, "");
        (void)snprintf(reached, sizeof reached, "reached: %s of the 524288 codes of the cosine ",
                       cases[i].codes);
        assert_says(done.out, reached);
        assert_says(done.out, cases[i].lanes);
        assert_says(done.out, not );
        forget(&done);
    }
    outcome help = run("verify --exhaustive --help", "");
    assert_says(help.out, "partly valid lanes, ");
    forget(&help);
    json_t *json = result_of("--shard 9/1024 --stride 97 --seed 1", 0);
    const json_t *said = json_object_get(json, "not_reached");
    assert_true(json_is_string(said));
    assert_non_null(strstr(not, json_string_value(said)));
    json_decref(json);
}

/* The shards together are the whole. */
static void shards_make_up_the_domain(void **state)
{
    (void)state;
    double points = 0, done = 0;
    json_t *whole = result_of("--stride 4093 --seed 9", 0);
    for (int shard = 1; shard <= 3; shard++) {
        char options[64];
        (void)snprintf(options, sizeof options, "--stride 4093 --seed 9 --shard %d/3", shard);
        json_t *json = result_of(options, 0);
        points += number(json, "points");
        done += number(json, "n_done");
        json_decref(json);
    }
    assert_true(done == number(whole, "n_done"));
    assert_true(points == number(whole, "points"));
    json_decref(whole);
}

/* What --from leaves out is what an interrupted run had done. */
static void a_run_can_be_resumed(void **state)
{
    (void)state;
    json_t *rest = result_of("--from 1000 --stride 4093 --seed 9", 0);
    assert_true(number(rest, "n_done") == 24);
    json_decref(rest);
}

/* ---- Ctrl-C -------------------------------------------------------------------------------------
 */

/* Starts a run on a terminal of its own, waits until it shows progress, and interrupts it: its
 * standard output, to be freed. shown: what stood on the terminal. */
static char *interrupt_run(const char *options, char *shown, size_t size)
{
    char words[512];
    char *argv[RUN_ARGUMENTS_MAX + 2] = {(char *)(uintptr_t)glint_under_test()};
    (void)snprintf(words, sizeof words, "verify --exhaustive %s", options);
    split_words(words, argv + 1);
    terminal terminal = terminal_open();
    const pid_t child =
        child_start((const char *const *)argv, scratch_path("interrupted.out"), terminal.name);
    terminal_wait_for(&terminal, child, " s left", shown, size);
    assert_int_equal(kill(child, SIGINT), 0);
    assert_int_equal(child_wait(child, SECONDS), 2);
    terminal_close(&terminal);
    return scratch_read(scratch_path("interrupted.out"), NULL);
}

/* A number in front of `word` in a text; fails the test when it is not there. */
static double number_before(const char *text, const char *word)
{
    const char *at = strstr(text, word);
    assert_non_null(at);
    while (at > text && strchr("0123456789.", at[-1]) != NULL)
        at--;
    return strtod(at, NULL);
}

/* What an interrupted run did and what its own resume command does make up the whole. */
static void an_interrupted_run_says_how_to_go_on(void **state)
{
    (void)state;
    static const char options[] =
        "--every-lane --gate all --pipeline all --stride 997 --seed 9 --threads 1 --out a$b";
    char shown[4096];
    char resume[512];
    json_t *whole = result_of(options, 0);
    char *part = interrupt_run(options, shown, sizeof shown);
    assert_says(part, " (interrupted)\n");
    const double points = number_before(part, " points,");
    const double n = number_before(part, " values of n,");
    assert_true(points > 0 && points < number(whole, "points"));
    assert_true(n > 0 && n < 1024);
    const char *line = strstr(part, "\nresume: ");
    assert_non_null(line);
    line = strstr(line, " verify --exhaustive ");
    assert_non_null(line);
    line += strlen(" verify --exhaustive ");
    (void)snprintf(resume, sizeof resume, "%.*s", (int)strcspn(line, "\n"), line);
    assert_says(resume, " --every-lane ");
    assert_says(resume, " --threads 1 --out 'a$b'");
    *strstr(resume, " --out") = '\0'; /* the quotes are for a shell */
    json_t *rest = result_of(resume, 0);
    assert_true(points + number(rest, "points") == number(whole, "points"));
    assert_true(n + number(rest, "n_done") == 1024);
    json_decref(rest);
    json_decref(whole);
    free(part);
}

/* On a terminal: how much, how fast, how long still; the line is wiped at the end. */
static void progress_tells_rate_and_time_left(void **state)
{
    (void)state;
    char shown[4096];
    char *out = interrupt_run("--threads 2", shown, sizeof shown);
    assert_says(shown, "\rglint verify: ");
    assert_says(shown, " points, ");
    const double total = number_before(shown, " points, ");
    const double rate = number_before(shown, " million per second, ");
    const double left = number_before(shown, " s left");
    assert_true(rate > 0);
    /* The first line comes after one value of n: the time left is that of nearly all points. */
    assert_true(left <= total / (rate - 0.06) / 1e6 + 1);
    assert_true(left >= 0.9 * total / (rate + 0.06) / 1e6 - 1);
    assert_null(strstr(out, "left"));
    free(out);
}

static void threads_change_nothing(void **state)
{
    (void)state;
    json_t *one = result_of("--threads 1 --stride 4093 --seed 2", 0);
    json_t *five = result_of("--threads 5 --stride 4093 --seed 2", 0);
    assert_true(number(one, "points") == number(five, "points"));
    json_decref(one);
    json_decref(five);
}

static void what_makes_no_sense_is_refused(void **state)
{
    (void)state;
    static const char *const options[] = {"--shard 3/2", "--shard 0/2", "--shard x", "--from 1024",
                                          "--stride 0",  "--seed 1",    "--lanes 33"};
    for (size_t i = 0; i < sizeof options / sizeof options[0]; i++) {
        char command_line[128];
        (void)snprintf(command_line, sizeof command_line, "verify --exhaustive %s", options[i]);
        outcome done = run(command_line, "");
        if (done.status != 2)
            fail_msg("%s: exit status %d", options[i], done.status);
        assert_string_equal(done.out, "");
        forget(&done);
    }
}

/* The command with the circuit whose multipliers 13, 14, 15 cut off: it must be found, with threads
 * that each have a circuit of their own, and each mismatch must name the point. */
static void a_wrong_circuit_is_found(void **state)
{
    (void)state;
    char command_line[1024];
    (void)snprintf(command_line, sizeof command_line,
                   "verify --exhaustive --stride 4093 --seed 3 --threads 4 --rtl %s --out %s",
                   wrong_rtl("truncating"), scratch_path("found"));
    outcome done = run(command_line, "");
    assert_int_equal(done.status, 1);
    assert_says(done.out, "the first mismatches:");
    assert_says(done.out, "red: model ");
    assert_says(done.out, "replay: ");
    forget(&done);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(one_n_is_covered_whole),
        cmocka_unit_test(every_gate_and_pipeline_is_equal),
        cmocka_unit_test(every_lane_takes_every_code),
        cmocka_unit_test(a_result_says_what_it_reaches),
        cmocka_unit_test(shards_make_up_the_domain),
        cmocka_unit_test(a_run_can_be_resumed),
        cmocka_unit_test(an_interrupted_run_says_how_to_go_on),
        cmocka_unit_test(progress_tells_rate_and_time_left),
        cmocka_unit_test(threads_change_nothing),
        cmocka_unit_test(what_makes_no_sense_is_refused),
        cmocka_unit_test(a_wrong_circuit_is_found),
    };
    return cmocka_run_group_tests(tests, scratch_make, scratch_remove);
}
