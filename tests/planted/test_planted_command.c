/* Whether the command loses any finding on the way from its threads to its output:
 * $GLINT_BUILD/planted/glint reads one planted difference of each circuit, or of one frame. */
#define _XOPEN_SOURCE 700

#include <inttypes.h>
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
#include "file/json.h"

#include "../cli/run.h"
#include "planted.h"

enum { PLANTED_AT = 7, CLOCKS = 50 };

static char planted_command[1024];
static int settings; /* that `verify` tries */
static long signals; /* of all of them */

static int choose_command(void **state)
{
    static glint_setting each[PLANTED_SETTINGS_MAX];
    settings = planted_settings(false, each);
    for (int i = 0; i < settings; i++)
        signals += each[i].circuit->signal_count(each[i].values);
    const char *build = getenv("GLINT_BUILD");
    (void)snprintf(planted_command, sizeof planted_command, "GLINT=%s/planted/glint",
                   build != NULL ? build : "build");
    return settings > 0 && putenv(planted_command) == 0 ? scratch_make(state) : -1;
}

static void plant_number(const char *name, long number)
{
    char text[32];
    (void)snprintf(text, sizeof text, "%ld", number);
    assert_int_equal(setenv(name, text, 1), 0);
}

static int pull_out(void **state)
{
    (void)state;
    return unsetenv("GLINT_PLANTED_SIGNAL") | unsetenv("GLINT_PLANTED_CLOCK") |
           unsetenv("GLINT_PLANTED_ANSWER") | unsetenv("GLINT_PLANTED_VALUE");
}

static double number(const json_t *json, const char *name)
{
    const json_t *item = json_object_get(json, name);
    assert_true(json_is_number(item));
    return json_number_value(item);
}

/* ---- A random run -------------------------------------------------------------------------------
 */

static json_t *verify(int threads, int signal)
{
    char line[600];
    plant_number("GLINT_PLANTED_SIGNAL", signal);
    plant_number("GLINT_PLANTED_CLOCK", PLANTED_AT);
    (void)snprintf(line, sizeof line, "verify --clocks %d --seed 3 --threads %d --json --out %s",
                   CLOCKS, threads, scratch_path("packets"));
    outcome done = run(line, "");
    assert_int_equal(done.status, 1);
    json_t *json = json_loads(done.out, JSON_REJECT_DUPLICATES | JSON_DECODE_ANY, NULL);
    assert_non_null(json);
    forget(&done);
    return json;
}

/* One per setting of each circuit, none lost or duplicated, whichever thread had it. */
static void each_thread_s_mismatches_are_told(void **state)
{
    (void)state;
    static const int threads[] = {1, 2, 5, 64};
    for (size_t t = 0; t < sizeof threads / sizeof threads[0]; t++) {
        const int signal = (int)t;
        json_t *json = verify(threads[t], signal);
        const json_t *list = json_object_get(json, "settings");
        double comparisons = 0;
        assert_true(number(json, "mismatches") == settings);
        assert_int_equal(json_array_size(list), settings);
        for (int i = 0; i < settings; i++) {
            const json_t *entry = json_array_get(list, (size_t)i);
            const json_t *found = json_object_get(entry, "first_mismatches");
            assert_true(number(entry, "mismatches") == 1);
            assert_int_equal(json_array_size(found), 1);
            assert_true(number(json_array_get(found, 0), "clock") == PLANTED_AT);
            comparisons += number(entry, "comparisons");
        }
        assert_true(number(json, "comparisons") == comparisons &&
                    comparisons == (double)signals * CLOCKS);
        json_decref(json);
    }
}

/* In words as well; and a packet of each, which shows it again. */
static void each_setting_s_mismatch_leaves_a_packet(void **state)
{
    (void)state;
    char line[600];
    json_t *json = verify(2, 0);
    const json_t *entry;
    int packets = 0;
    glint_json_each(entry, json_object_get(json, "settings"))
    {
        const json_t *packet = json_object_get(entry, "packet");
        assert_true(json_is_string(packet));
        (void)snprintf(line, sizeof line, "replay %s", json_string_value(packet));
        outcome again = run(line, "");
        assert_int_equal(again.status, 1);
        assert_says(again.out, ": the same mismatch; ");
        forget(&again);
        packets++;
    }
    assert_int_equal(packets, settings);
    json_decref(json);
    (void)snprintf(line, sizeof line, "verify --clocks %d --seed 3 --out %s", CLOCKS,
                   scratch_path("packets"));
    outcome told = run(line, "");
    assert_int_equal(told.status, 1);
    (void)snprintf(line, sizeof line, "\n%d mismatches of %ld comparisons: ", settings,
                   signals * CLOCKS);
    assert_says(told.out, line);
    forget(&told);
}

/* ---- Exhaustion ---------------------------------------------------------------------------------
 */

enum { CIRCUITS = 6, POINTS = 272 }; /* of each circuit, with one n and this stride */

/* Answers are numbered through: one thread asks the circuits one after the other. */
static json_t *exhaust(long answer, int value)
{
    char line[600];
    plant_number("GLINT_PLANTED_ANSWER", answer);
    plant_number("GLINT_PLANTED_VALUE", value);
    (void)snprintf(line, sizeof line,
                   "verify --exhaustive --gate all --pipeline all --shard 5/1024 --stride 4096 "
                   "--threads 1 --seed 3 --json --out %s",
                   scratch_path("packets"));
    outcome done = run(line, "");
    assert_int_equal(done.status, 1);
    json_t *json = json_loads(done.out, JSON_REJECT_DUPLICATES | JSON_DECODE_ANY, NULL);
    assert_non_null(json);
    forget(&done);
    return json;
}

/* Each value of a point in each circuit, counted there and nowhere else. */
static void each_circuit_s_mismatch_is_told(void **state)
{
    (void)state;
    for (int c = 0; c < CIRCUITS; c++) {
        for (int value = 0; value < GLINT_ANSWER_VALUES; value++) {
            json_t *json = exhaust((long)c * POINTS + 50, value);
            const json_t *list = json_object_get(json, "circuits");
            assert_int_equal(json_array_size(list), CIRCUITS);
            for (int i = 0; i < CIRCUITS; i++) {
                const json_t *circuit = json_array_get(list, (size_t)i);
                assert_true(number(circuit, "points") == POINTS);
                assert_true(number(circuit, "mismatches") == (i == c));
            }
            assert_true(number(json, "mismatches") == 1);
            assert_true(number(json, "comparisons") == 4 * CIRCUITS * POINTS);
            json_decref(json);
        }
    }
}

/* ---- A frame ------------------------------------------------------------------------------------
 */

/* Highlights and nothing else, with the light where the eye is, so that each is seen and a
 * difference of one shows in its pixel. */
static json_t *render(bool planted, long answer, int value)
{
    char line[600];
    if (planted) {
        plant_number("GLINT_PLANTED_ANSWER", answer);
        plant_number("GLINT_PLANTED_VALUE", value);
    } else {
        (void)pull_out(NULL);
    }
    (void)snprintf(
        line, sizeof line,
        "render --model sphere --size 40x30 --ka 0 --kd 0 --light 0,0,1 --yaw 0 --pitch 0 "
        "--threads 1 --backend both "
        "--json --out %s",
        scratch_path("frame.png"));
    outcome done = run(line, "");
    assert_int_equal(done.status, planted);
    json_t *json = json_loads(done.out, JSON_REJECT_DUPLICATES | JSON_DECODE_ANY, NULL);
    assert_non_null(json);
    forget(&done);
    return json;
}

static void each_value_of_a_frame_is_looked_at(void **state)
{
    (void)state;
    json_t *json = render(false, 0, 0);
    const long points = (long)number(json, "highlights");
    assert_true(points > 100);
    json_decref(json);
    const long answers[] = {0, 1, points / 2, points - 1};
    for (size_t a = 0; a < sizeof answers / sizeof answers[0]; a++) {
        for (int value = 1; value <= 3; value++) { /* red, green, blue */
            json = render(true, answers[a], value);
            const json_t *found = json_object_get(json, "comparison");
            assert_true(number(found, "pixels") == 1200);
            assert_true(number(found, "differing_pixels") == 1);
            assert_true(number(found, "largest") == 1);
            json_decref(json);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_teardown(each_thread_s_mismatches_are_told, pull_out),
        cmocka_unit_test_teardown(each_setting_s_mismatch_leaves_a_packet, pull_out),
        cmocka_unit_test_teardown(each_circuit_s_mismatch_is_told, pull_out),
        cmocka_unit_test_teardown(each_value_of_a_frame_is_looked_at, pull_out),
    };
    return cmocka_run_group_tests(tests, choose_command, scratch_remove);
}
