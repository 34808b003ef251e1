/* The exhaustion of a circuit's domain, on the dividers: that it takes every point, finds what is
 * wrong and nothing else, can be cut in parts and stopped, and that a mismatch can be seen again.
 */
#define _XOPEN_SOURCE 700

#include <inttypes.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "../scratch.h"

#include "../wrong.h"
#include "circuit/circuits.h"
#include "failure/packet.h"
#include "lockstep/domain.h"

enum {
    SHIFTS = 12,
    DIFFERENCES = 512,
    POINTS = 256 * DIFFERENCES,
    /* Outputs: out_valid, out_of_table, three quotients; done, out_of_table, quotient. */
    OUTPUTS_PIPELINED = 5,
    OUTPUTS_SEQUENTIAL = 3,
    LATENCY = SHIFTS + 1,
    K_WRONG = 7, /* of table_off_by_one */
};

static glint_domain_result result;

static glint_domain_options options_for(glint_divider_form form)
{
    return (glint_domain_options){.setting = glint_setting_divider(form, SHIFTS),
                                  .shard = 1,
                                  .shards = 1,
                                  .stride = 1,
                                  .threads = 2};
}

static void run(const glint_domain_options *options)
{
    glint_error err;
    memset(&result, 0x5a, sizeof result);
    if (glint_domain_run(options, &result, &err) != GLINT_OK)
        fail_msg("%s", err.text);
}

/* ---- All of it ----------------------------------------------------------------------------------
 */

static uint64_t blocks_of(uint64_t points, uint64_t pace)
{
    const uint64_t each = GLINT_DOMAIN_BLOCK / pace;
    return (points + each - 1) / each;
}

/* Every point, and after it idle clocks until all has come out: at the end of a block. */
static void assert_counts(uint64_t points, uint64_t pace, uint64_t outputs)
{
    assert_int_equal(result.points_total, POINTS);
    assert_int_equal(result.points, points);
    assert_int_equal(result.clocks, points * pace + blocks_of(points, pace) * (LATENCY + 1));
    assert_int_equal(result.comparisons, result.clocks * outputs);
}

static void every_point_of_both_forms_is_equal(void **state)
{
    (void)state;
    glint_domain_options options = options_for(GLINT_DIVIDER_PIPELINED);
    run(&options);
    assert_counts(POINTS, 1, OUTPUTS_PIPELINED);
    assert_int_equal(result.mismatches, 0);
    assert_int_equal(result.next, POINTS);
    options = options_for(GLINT_DIVIDER_SEQUENTIAL);
    run(&options);
    assert_counts(POINTS, LATENCY, OUTPUTS_SEQUENTIAL);
    assert_int_equal(result.mismatches, 0);
}

/* The quotients that a table with one more for 1/7 gives: all but that of the difference 0. */
static void what_differs_is_counted_to_the_last(void **state)
{
    (void)state;
    static glint_domain_result first;
    glint_domain_options options = options_for(GLINT_DIVIDER_PIPELINED);
    options.setting.verilog = wrong_rtl("divider_table_off_by_one");
    run(&options);
    /* Each component has each difference once. */
    assert_int_equal(result.mismatches, GLINT_DIVIDER_COMPONENTS * (DIFFERENCES - 1));
    assert_int_equal(result.kept, GLINT_MISMATCHES_KEPT);
    const glint_mismatch *signal = &result.mismatch[0].signal;
    assert_int_equal(result.mismatch[0].point, K_WRONG * DIFFERENCES + LATENCY - 1);
    assert_string_equal(signal->signal.name, "quotient_r");
    assert_int_equal(signal->clock, K_WRONG * DIFFERENCES + LATENCY);
    /* Whatever the threads, the same mismatches are the first. */
    first = result;
    options.threads = 7;
    run(&options);
    for (int i = 0; i < first.kept; i++) {
        const glint_domain_mismatch *now = &result.mismatch[i], *then = &first.mismatch[i];
        assert_true(now->block == then->block && now->point == then->point);
        assert_true(now->signal.clock == then->signal.clock);
        assert_string_equal(now->signal.signal.name, then->signal.signal.name);
        assert_memory_equal(now->signal.model, then->signal.model, sizeof then->signal.model);
        assert_memory_equal(now->signal.rtl, then->signal.rtl, sizeof then->signal.rtl);
    }
    assert_int_equal(result.mismatches, first.mismatches);
}

/* ---- Parts of it --------------------------------------------------------------------------------
 */

/* The points of a part by themselves: shard − 1 + shards·(offset + stride·i), from `from` on. */
static uint64_t points_of(const glint_domain_options *options)
{
    const uint64_t first = options->shard - 1 + options->shards * glint_domain_offset(options);
    uint64_t count = 0;
    for (uint64_t p = first; p < POINTS; p += options->shards * options->stride)
        count += p >= options->from;
    return count;
}

static void parts_are_what_they_say(void **state)
{
    (void)state;
    static const struct {
        uint64_t from, shard, shards, stride;
    } parts[] = {
        {0, 1, 1, 1},          {1, 1, 1, 1},          {POINTS - 1, 1, 1, 1}, {0, 3, 3, 1},
        {1000, 2, 7, 1},       {0, 1, 1, 97},         {50000, 5, 11, 13},    {0, POINTS, POINTS, 1},
        {0, 1, 1, POINTS - 1}, {POINTS / 2, 1, 2, 1},
    };
    for (size_t i = 0; i < sizeof parts / sizeof parts[0]; i++) {
        glint_domain_options options = options_for(GLINT_DIVIDER_PIPELINED);
        options.from = parts[i].from;
        options.shard = parts[i].shard;
        options.shards = parts[i].shards;
        options.stride = parts[i].stride;
        options.seed = i;
        run(&options);
        assert_counts(points_of(&options), 1, OUTPUTS_PIPELINED);
        assert_int_equal(result.mismatches, 0);
        assert_int_equal(result.next, POINTS);
    }
}

/* The shards of a wrong circuit find together what the whole does. */
static void shards_make_up_the_whole(void **state)
{
    (void)state;
    uint64_t points = 0, mismatches = 0;
    glint_domain_options options = options_for(GLINT_DIVIDER_PIPELINED);
    options.setting.verilog = wrong_rtl("divider_table_off_by_one");
    options.shards = 5;
    for (options.shard = 1; options.shard <= options.shards; options.shard++) {
        run(&options);
        points += result.points;
        mismatches += result.mismatches;
    }
    assert_int_equal(points, POINTS);
    assert_int_equal(mismatches, GLINT_DIVIDER_COMPONENTS * (DIFFERENCES - 1));
}

static volatile bool stop;
static int told;

static void stop_at_once(void *context, uint64_t done, uint64_t total)
{
    (void)context;
    assert_true(done <= total && total > 0);
    told++;
    stop = true;
}

/* What was started is finished; the rest resumes at `next`. */
static void a_stopped_run_says_where_to_go_on(void **state)
{
    (void)state;
    glint_error err;
    glint_domain_options options = options_for(GLINT_DIVIDER_PIPELINED);
    options.threads = 1;
    options.stop = &stop;
    options.progress = stop_at_once;
    stop = false;
    told = 0;
    assert_int_equal(glint_domain_run(&options, &result, &err), GLINT_INTERRUPTED);
    assert_int_equal(told, 1);
    assert_int_equal(result.points, GLINT_DOMAIN_BLOCK);
    assert_int_equal(result.next, GLINT_DOMAIN_BLOCK);
    options = options_for(GLINT_DIVIDER_PIPELINED);
    options.from = result.next;
    run(&options);
    assert_int_equal(result.points, POINTS - GLINT_DOMAIN_BLOCK);
}

static void what_makes_no_sense_is_refused(void **state)
{
    (void)state;
    static const glint_specular_config config = {GLINT_GATE_COSINE, GLINT_PIPELINE_PIPELINED, 1};
    const glint_domain_options usual = options_for(GLINT_DIVIDER_PIPELINED);
    glint_domain_options bad[8];
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++)
        bad[i] = usual;
    bad[0].from = POINTS;
    bad[1].shard = 2;
    bad[2].shard = 0;
    bad[3].stride = 0;
    bad[4].threads = 0;
    bad[5].setting.values[GLINT_DIVIDER_SHIFTS] = 99;
    bad[6].setting = glint_setting_specular(&config); /* it names no domain */
    bad[7].shard = bad[7].shards = UINT64_MAX;
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        glint_error err = {""};
        assert_int_equal(glint_domain_run(&bad[i], &result, &err), GLINT_BAD_ARGUMENT);
        assert_true(err.text[0] != '\0' && result.points == 0);
    }
}

/* ---- What is left of a mismatch -----------------------------------------------------------------
 */

static void a_mismatch_is_seen_again(void **state)
{
    (void)state;
    static const struct {
        const char *fault;
        glint_divider_form form;
        const char *signal; /* the first to differ, of all */
    } cases[] = {{"divider_table_off_by_one", GLINT_DIVIDER_PIPELINED, "rom_bits"},
                 {"divider_late_done", GLINT_DIVIDER_SEQUENTIAL, "done"},
                 {"divider_logical_shift", GLINT_DIVIDER_SEQUENTIAL, "shifted"}};
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        glint_error err;
        glint_failure *failure, *read;
        glint_failure_finding again;
        glint_domain_options options = options_for(cases[i].form);
        options.setting.verilog = wrong_rtl(cases[i].fault);
        run(&options);
        assert_true(result.kept > 0);
        if (glint_failure_of_domain(&options, &result.mismatch[0], &failure, &err) != GLINT_OK)
            fail_msg("%s", err.text);
        assert_int_equal(failure->kind, GLINT_FAILURE_EXHAUSTIVE);
        assert_non_null(failure->pins);
        assert_true(failure->finding.clock <= result.mismatch[0].signal.clock);
        assert_string_equal(failure->finding.mismatch[0].signal.name, cases[i].signal);
        assert_int_equal(glint_packet_write(failure, NULL, scratch_path("packet"), &err), GLINT_OK);
        assert_int_equal(glint_packet_read(scratch_path("packet"), NULL, &read, &err), GLINT_OK);
        assert_true(glint_failure_same(&read->finding, &failure->finding));
        read->setting.verilog = options.setting.verilog;
        assert_int_equal(glint_failure_play(read, NULL, &again, NULL, &err), GLINT_OK);
        assert_true(glint_failure_same(&again, &failure->finding));
        read->setting.verilog = NULL;
        assert_int_equal(glint_failure_play(read, NULL, &again, NULL, &err), GLINT_OK);
        assert_false(glint_failure_differs(&again));
        glint_failure_destroy(read);
        glint_failure_destroy(failure);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_point_of_both_forms_is_equal),
        cmocka_unit_test(what_differs_is_counted_to_the_last),
        cmocka_unit_test(parts_are_what_they_say),
        cmocka_unit_test(shards_make_up_the_whole),
        cmocka_unit_test(a_stopped_run_says_where_to_go_on),
        cmocka_unit_test(what_makes_no_sense_is_refused),
        cmocka_unit_test(a_mismatch_is_seen_again),
    };
    return cmocka_run_group_tests(tests, scratch_make, scratch_remove);
}
