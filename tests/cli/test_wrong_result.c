/* What a script gets of a run that fails, and what a wrong divider does to a frame: as
 * test_wrong_circuit.c, with several wrong circuits. */
#define _XOPEN_SOURCE 700

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "../scratch.h"
#include "file/json.h"
#include "run.h"

enum { WRONG_DEVICE, WRONG_DIVIDER, SILENT_DEVICE, WRONG_SPAN_UNIT, RIGHT, VERILOGS };

static char verilogs[VERILOGS][1024]; /* "": Glint's own */

static int name_verilogs(void **state)
{
    static const char *const names[RIGHT] = {"truncating", "divider_table_off_by_one", "silent",
                                             "span_unsigned"};
    const char *build = getenv("GLINT_BUILD");
    for (int i = 0; i < RIGHT; i++) {
        (void)snprintf(verilogs[i], sizeof verilogs[i], " --rtl %s/wrong/%s",
                       build != NULL ? build : "build", names[i]);
    }
    return scratch_make(state);
}

/* words: with one %s, the path for what it writes. */
static outcome run_with(int verilog, const char *words, const char *path)
{
    char command_line[2048];
    const int length = snprintf(command_line, sizeof command_line, words, path);
    (void)snprintf(command_line + length, sizeof command_line - (size_t)length, "%s",
                   verilogs[verilog]);
    return run(command_line, "");
}

static const json_t *member(const json_t *json, const char *name)
{
    return json_object_get(json, name);
}

static double number(const json_t *json, const char *name)
{
    assert_true(json_is_number(member(json, name)));
    return json_number_value(member(json, name));
}

/* The result of a run that must fail; to be deleted. */
static json_t *failed_result(outcome *done)
{
    assert_int_equal(done->status, 1);
    json_t *json = json_loads(done->out, JSON_REJECT_DUPLICATES | JSON_DECODE_ANY, NULL);
    assert_non_null(json);
    forget(done);
    return json;
}

/* The packet that a result names is there, and replays. */
static void assert_packet_of(const json_t *json, const char *path, int verilog)
{
    assert_true(json_is_string(member(json, "packet")));
    assert_string_equal(json_string_value(member(json, "packet")), path);
    outcome replayed = run_with(verilog, "replay %s", path);
    assert_int_equal(replayed.status, 1);
    assert_says(replayed.out, ": the same mismatch; ");
    forget(&replayed);
}

static void a_random_run_gives_its_mismatches(void **state)
{
    (void)state;
    outcome done = run_with(
        WRONG_DEVICE,
        "verify --gate cosine --pipeline pipelined --lanes 1 --clocks 3000 --seed 5 --json "
        "--out %s/",
        scratch_path("random"));
    json_t *json = failed_result(&done);
    const json_t *setting = json_array_get(member(json, "settings"), 0);
    const json_t *list = member(setting, "first_mismatches");
    assert_int_equal(json_array_size(list), 16);
    const json_t *first = json_array_get(list, 0);
    assert_true(number(first, "clock") >= 1 && number(first, "lane") == 0);
    assert_true(number(first, "block") >= 13 && number(first, "block") <= 15);
    assert_true(number(first, "model") != number(first, "rtl"));
    assert_true(json_is_string(member(first, "signal")));
    assert_packet_of(setting, scratch_path("random//specular_cosine_pipelined_1"), WRONG_DEVICE);
    json_decref(json);
}

static void an_exhaustive_run_gives_its_mismatches(void **state)
{
    (void)state;
    outcome done = run_with(WRONG_DEVICE,
                            "verify --exhaustive --shard 61/1024 --stride 97 --seed 4 --lanes 1 "
                            "--json --out %s",
                            scratch_path("whole"));
    json_t *json = failed_result(&done);
    const json_t *list = member(json, "first_mismatches");
    assert_int_equal(json_array_size(list), 16);
    const json_t *first = json_array_get(list, 0);
    assert_string_equal(json_string_value(member(first, "gate")), "cosine");
    assert_true(number(first, "n") == 60 && number(first, "lanes") == 1);
    assert_true(number(first, "model") - number(first, "rtl") == 1); /* cut off, not rounded */
    assert_null(member(json, "error"));
    assert_packet_of(json, scratch_path("whole/specular_cosine_pipelined_1_exhaustive"),
                     WRONG_DEVICE);
    json_decref(json);
}

/* It is summed up like any other, and --from would begin with the n that was not finished. */
static void a_circuit_that_keeps_an_answer_back_is_summed_up(void **state)
{
    (void)state;
    static const char words[] = "verify --exhaustive --from 5 --lanes 1 --threads 1 --out %s";
    outcome done = run_with(SILENT_DEVICE, words, scratch_path("silent"));
    assert_int_equal(done.status, 1);
    assert_says(done.out, "\nno verdict: nothing was compared, ");
    assert_says(done.out, " (stopped early)\n");
    assert_says(done.err, "glint verify: the circuit returned 0 of ");
    forget(&done);
    outcome again = run_with(SILENT_DEVICE,
                             "verify --exhaustive --from 5 --lanes 1 --threads 1 --json --out %s",
                             scratch_path("silent"));
    json_t *json = failed_result(&again);
    assert_true(number(json, "n_done") == 0 && number(json, "next") == 5);
    assert_true(json_is_false(member(json, "interrupted")));
    assert_int_equal(
        strncmp(json_string_value(member(json, "error")), "the circuit returned 0 of ", 26), 0);
    assert_packet_of(json, scratch_path("silent/specular_cosine_pipelined_1_exhaustive"),
                     SILENT_DEVICE);
    json_decref(json);
}

/* The table of 1/k is wrong for one k, so that most spans, and most settings, are right. */
static void a_wrong_divider_is_found_in_a_frame(void **state)
{
    (void)state;
    static const char words[] =
        "render --model teapot --shading gouraud --shifts 12 --backend both "
        "--json --out %s";
    outcome done = run_with(WRONG_DIVIDER, words, scratch_path("span.png"));
    assert_says(done.err, "divider pipelined, 12 shifts: a mismatch (frame)\n");
    assert_says(done.err, ", k 7: quotient of ");
    json_t *json = failed_result(&done);
    assert_true(number(member(json, "comparison"), "differing_pixels") > 0);
    assert_packet_of(json, scratch_path("span-failure"), WRONG_DIVIDER);
    json_decref(json);
    done = run_with(RIGHT, words, scratch_path("span.png"));
    assert_int_equal(done.status, 0);
    forget(&done);
}

/* A value below black is white: of the two components that are nearly black. */
static void a_wrong_span_unit_is_found_in_a_frame(void **state)
{
    (void)state;
    static const char words[] = "render --model sphere --density 8 --shading quadratic --ka 0 "
                                "--backend both --json --out %s";
    outcome done = run_with(WRONG_SPAN_UNIT, words, scratch_path("walk.png"));
    assert_says(done.err, "span, fraction 18: a mismatch (frame)\n");
    assert_says(done.err, " pixels after a load: ");
    assert_says(done.err, "  alone: printf 'load step start_r ");
    json_t *json = failed_result(&done);
    assert_true(number(member(json, "comparison"), "differing_pixels") > 0);
    assert_true(number(json, "spans") > 0);
    assert_packet_of(json, scratch_path("walk-failure"), WRONG_SPAN_UNIT);
    json_decref(json);
    done = run_with(RIGHT, words, scratch_path("walk.png"));
    assert_int_equal(done.status, 0);
    forget(&done);
}

/* Pictures and packet of a failure stay when it is gone, which is said. */
static void an_earlier_failure_is_told_apart(void **state)
{
    (void)state;
    static const char words[] =
        "render --model sphere --size 96x80 --lanes 1 --backend both --out %s";
    outcome done = run_with(WRONG_DEVICE, words, scratch_path("mended.png"));
    assert_int_equal(done.status, 1);
    assert_null(strstr(done.out, "earlier run"));
    forget(&done);
    done = run_with(RIGHT, words, scratch_path("mended.png"));
    assert_int_equal(done.status, 0);
    assert_says(done.out, "mended-failure is left over from an earlier run\n");
    forget(&done);
    done = run_with(RIGHT, words, scratch_path("never.png"));
    assert_null(strstr(done.out, "earlier run"));
    forget(&done);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_random_run_gives_its_mismatches),
        cmocka_unit_test(an_exhaustive_run_gives_its_mismatches),
        cmocka_unit_test(a_circuit_that_keeps_an_answer_back_is_summed_up),
        cmocka_unit_test(a_wrong_divider_is_found_in_a_frame),
        cmocka_unit_test(a_wrong_span_unit_is_found_in_a_frame),
        cmocka_unit_test(an_earlier_failure_is_told_apart),
    };
    return cmocka_run_group_tests(tests, name_verilogs, scratch_remove);
}
