/* The span unit's Verilog: in lockstep with the C model, over its whole domain, and wrong on
 * purpose (tests/span/wrong), which lockstep and the domain must notice and name. */
#define _XOPEN_SOURCE 700

#include <inttypes.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "../scratch.h"

#include "../seed.h"
#include "../wrong.h"
#include "circuit/circuits.h"
#include "failure/packet.h"
#include "glint_quadratic_span.h"
#include "lockstep/answer.h"
#include "lockstep/domain.h"
#include "lockstep/lockstep.h"

enum { CLOCKS = 30000 };

/* The listed ones, and those on both sides of 32 bits a number. */
static const int fractions[] = {GLINT_QUADRATIC_SPAN_FRACTION_MIN,
                                GLINT_QUADRATIC_SPAN_FRACTION_DEFAULT, 22, 23,
                                GLINT_QUADRATIC_SPAN_FRACTION_MAX};
#define FRACTIONS (sizeof fractions / sizeof fractions[0])

static uint64_t seed;
static glint_lockstep_result result;
static glint_domain_result of_domain;

static int prepare(void **state)
{
    seed = seed_of_this_run();
    return scratch_make(state);
}

static void assert_done(glint_status status, const glint_error *err)
{
    if (status != GLINT_OK)
        fail_msg("%s", err->text);
}

static glint_lockstep_options lockstep_of(int fraction, const char *wrong)
{
    glint_lockstep_options options = {
        .setting = glint_setting_span(fraction), .clocks = CLOCKS, .seed = seed};
    options.setting.verilog = wrong != NULL ? wrong_rtl(wrong) : NULL;
    return options;
}

static void run_domain(int fraction, const char *wrong)
{
    glint_error err;
    glint_domain_options options = {.setting = glint_setting_span(fraction),
                                    .shard = 1,
                                    .shards = 1,
                                    .stride = 1,
                                    .threads = 1};
    options.setting.verilog = wrong != NULL ? wrong_rtl(wrong) : NULL;
    assert_done(glint_domain_run(&options, &of_domain, &err), &err);
}

static void every_signal_equals_the_model(void **state)
{
    (void)state;
    uint64_t comparisons = 0;
    for (size_t i = 0; i < FRACTIONS; i++) {
        glint_error err;
        const glint_lockstep_options options = lockstep_of(fractions[i], NULL);
        assert_done(glint_lockstep_run(&options, &result, &err), &err);
        if (result.mismatches != 0)
            fail_msg("fraction %d, seed %" PRIu64 ": %s differs at clock %" PRIu64, fractions[i],
                     seed, result.mismatch[0].signal.name, result.first_clock);
        comparisons += result.comparisons;
    }
    assert_true(comparisons > 0);
    print_message("0 mismatches of %" PRIu64 " comparisons\n", comparisons);
}

static void the_domain_is_equal(void **state)
{
    (void)state;
    for (size_t i = 0; i < FRACTIONS; i++) {
        run_domain(fractions[i], NULL);
        assert_int_equal(of_domain.mismatches, 0);
        assert_int_equal(of_domain.points, of_domain.points_total);
        assert_true(of_domain.comparisons > of_domain.points);
    }
}

/* ---- Wrong circuits ---- */

/* The first to differ: its name without the component. */
typedef struct fault {
    const char *name, *first;
    bool in_domain; /* shows without a stall */
} fault;

static const fault faults[] = {
    {"span_unrounded", "level_", true},    {"span_unsigned", "clamped_", true},
    {"span_curve_unheld", "curve_", true}, {"span_step_first", "value_", true},
    {"span_stalled_out", "", false},
};
#define FAULTS (sizeof faults / sizeof faults[0])

/* The packet as it was written, by the Verilog of `wrong`, or the right one. */
static void replay(const char *wrong, glint_failure_finding *found)
{
    glint_failure *failure;
    glint_capture *capture = NULL;
    glint_error err;
    assert_done(glint_packet_read(scratch_path("packet"), NULL, &failure, &err), &err);
    failure->setting.verilog = wrong != NULL ? wrong_rtl(wrong) : NULL;
    assert_done(glint_failure_play(failure, NULL, found, &capture, &err), &err);
    free(capture);
    glint_failure_destroy(failure);
}

static void check_fault(const fault *fault)
{
    const glint_lockstep_options options =
        lockstep_of(GLINT_QUADRATIC_SPAN_FRACTION_DEFAULT, fault->name);
    glint_failure *failure = NULL;
    glint_failure_finding found;
    glint_error err;
    assert_done(glint_lockstep_run(&options, &result, &err), &err);
    assert_true(result.mismatches > 0 && result.mismatches < result.comparisons);
    const char *const first = result.mismatch[0].signal.name;
    print_message("%-18s clock %4" PRIu64 ": %s; %" PRIu64 " mismatches of %" PRIu64 "\n",
                  fault->name, result.first_clock, first, result.mismatches, result.comparisons);
    assert_memory_equal(first, fault->first, strlen(fault->first));
    assert_done(glint_failure_of_lockstep(&options, &result, &failure, &err), &err);
    assert_done(glint_packet_write(failure, NULL, scratch_path("packet"), &err), &err);
    glint_failure_destroy(failure);
    replay(fault->name, &found);
    assert_true(found.lockstep_differs && found.count > 0);
    assert_string_equal(found.mismatch[0].signal.name, first);
    replay(NULL, &found);
    assert_true(!found.lockstep_differs && found.count == 0);
    run_domain(GLINT_QUADRATIC_SPAN_FRACTION_DEFAULT, fault->name);
    assert_true((of_domain.mismatches > 0) == fault->in_domain);
}

static void every_fault_is_noticed_and_its_packet_replays(void **state)
{
    (void)state;
    for (size_t f = 0; f < FAULTS; f++)
        check_fault(&faults[f]);
}

/* ---- An answer asked again, for a packet ---- */

enum { LONG = 300 };

static glint_span_step steps[LONG];
static uint8_t of_model[GLINT_QUADRATIC_SPAN_COMPONENTS * LONG];

/* One span of 300 pixels, with a second load in it. */
static void make_steps(int fraction)
{
    const int64_t one = INT64_C(1) << fraction;
    const glint_quadratic_walk walk = {.start = {20 * one, 250 * one, -3 * one},
                                       .first = {one, -one, one / 3},
                                       .second = {9, -5, 1}};
    for (int i = 0; i < LONG; i++)
        steps[i] = (glint_span_step){i == 0 || i == 120, walk};
    assert_int_equal(glint_quadratic_span(fraction, &walk, 120, of_model), GLINT_OK);
    assert_int_equal(glint_quadratic_span(fraction, &walk, LONG - 120,
                                          of_model + 120 * GLINT_QUADRATIC_SPAN_COMPONENTS),
                     GLINT_OK);
}

static void ask(const glint_answer *answer, const glint_setting *setting, int expected)
{
    int32_t model, rtl;
    glint_error err;
    assert_done(glint_answer_ask(answer, setting, &model, &rtl, &err), &err);
    assert_int_equal(model, expected);
    assert_int_equal(rtl, expected);
}

/* Kept with its neighbours and alone, a pixel has the intensity that it had in the whole run,
 * though the load may be left out. */
static void an_answer_can_be_asked_again(void **state)
{
    (void)state;
    static const size_t places[] = {0, 1, 31, 32, 33, 119, 120, 121, 200, LONG - 1};
    static glint_answer answer, alone;
    for (size_t p = 0; p < sizeof places / sizeof places[0]; p++)
        for (int c = 0; c < GLINT_QUADRATIC_SPAN_COMPONENTS; c++) {
            const int fraction = fractions[p % FRACTIONS];
            const glint_setting setting = glint_setting_span(fraction);
            make_steps(fraction);
            const int expected = of_model[GLINT_QUADRATIC_SPAN_COMPONENTS * places[p] + (size_t)c];
            answer = (glint_answer){.value = (glint_answer_value)(GLINT_ANSWER_R + c)};
            glint_answer_keep_steps(&answer, fraction, steps, LONG, places[p]);
            assert_true(answer.step[0].load && answer.at < answer.count);
            ask(&answer, &setting, expected);
            glint_answer_alone(&answer, &setting, &alone);
            assert_true(alone.step[0].load && alone.count <= 2);
            ask(&alone, &setting, expected);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_signal_equals_the_model),
        cmocka_unit_test(the_domain_is_equal),
        cmocka_unit_test(an_answer_can_be_asked_again),
        cmocka_unit_test(every_fault_is_noticed_and_its_packet_replays),
    };
    return cmocka_run_group_tests(tests, prepare, scratch_remove);
}
