/* Whether lockstep checks everything: in each setting of the thesis's circuits, and in one of
 * each other, each bit of each signal differs once, at its own clock, and exactly that must be
 * found, counted and named, and again by the replays that write and read a packet. */
#include <inttypes.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "../seed.h"
#include "failure/failure.h"
#include "lockstep/lockstep.h"
#include "planted.h"

static uint64_t seed;
static glint_setting settings[PLANTED_SETTINGS_MAX];
static int count; /* of them */
static glint_lockstep_result result;

static int find_settings(void **state)
{
    (void)state;
    seed = seed_of_this_run();
    count = planted_settings(true, settings);
    return count > 0 ? 0 : -1;
}

static int pull_out(void **state)
{
    (void)state;
    plant.signal = PLANTED_NOWHERE;
    return 0;
}

static int width_of(const glint_signal_info *info)
{
    return info->int_bits + info->frac_bits;
}

static void run_lockstep(const glint_setting *setting, uint64_t clocks)
{
    glint_error err;
    const glint_lockstep_options options = {.setting = *setting, .clocks = clocks, .seed = seed};
    memset(&result, 0x5a, sizeof result);
    if (glint_lockstep_run(&options, &result, &err) != GLINT_OK)
        fail_msg("%s", err.text);
    assert_true(result.clocks == clocks);
    assert_true(result.comparisons == clocks * (uint64_t)glint_setting_signal_count(setting));
}

static void assert_signal(const glint_signal_info *found, const glint_signal_info *planted)
{
    assert_string_equal(found->name, planted->name);
    assert_int_equal(found->lane, planted->lane);
    assert_int_equal(found->block, planted->block);
    assert_int_equal(width_of(found), width_of(planted));
}

/* ---- Lockstep -----------------------------------------------------------------------------------
 */

/* Bit c − 1 after clock c: each bit of a signal, from the lowest on. */
static uint64_t bit_after_bit(uint64_t clock)
{
    return clock <= 63 ? UINT64_C(1) << (clock - 1) : 0;
}

static void assert_each_bit_found(const glint_setting *setting, int index)
{
    const glint_signal_info info = glint_setting_signal(setting, index);
    const int width = width_of(&info);
    char name[GLINT_SETTING_TEXT];
    plant = (planted){.signal = index, .inverted = bit_after_bit, .answer = PLANTED_NOWHERE};
    run_lockstep(setting, (uint64_t)width); /* the last clock has its highest bit */
    if (result.mismatches != (uint64_t)width) {
        glint_setting_name(setting, name);
        fail_msg("%s, %s, lane %d: %" PRIu64 " mismatches, %d were planted", name, info.name,
                 info.lane, result.mismatches, width);
    }
    assert_true(result.first_clock == 1);
    assert_int_equal(result.kept, width < GLINT_MISMATCHES_KEPT ? width : GLINT_MISMATCHES_KEPT);
    for (int i = 0; i < result.kept; i++) {
        const glint_mismatch *found = &result.mismatch[i];
        assert_true(found->clock == (uint64_t)i + 1);
        assert_true((found->model[0] ^ found->rtl[0]) == UINT64_C(1) << i);
        assert_signal(&found->signal, &info);
    }
    assert_int_equal(result.totals_count, 1);
    assert_string_equal(result.totals[0].name, info.name);
    assert_int_equal(result.totals[0].block, info.block);
    assert_true(result.totals[0].mismatches == (uint64_t)width);
}

static void each_bit_of_each_signal_of_each_setting_is_looked_at(void **state)
{
    (void)state;
    int signals = 0, of_thesis = 0, settings_of_thesis = 0;
    for (int s = 0; s < count; s++) {
        const int here = glint_setting_signal_count(&settings[s]);
        for (int i = 0; i < here; i++)
            assert_each_bit_found(&settings[s], i);
        signals += here;
        if (planted_in_thesis(&settings[s])) {
            of_thesis += here;
            settings_of_thesis++;
        }
    }
    print_message("%d signals of %d settings, each bit of them\n", signals, count);
    assert_int_equal(of_thesis, THESIS_SIGNALS);
    assert_int_equal(settings_of_thesis, THESIS_SETTINGS);
}

static uint64_t lowest_bit(uint64_t clock)
{
    (void)clock;
    return 1;
}

/* No clock is left out, also behind the first 1024, where a run looks whether it is to stop. */
static void each_clock_is_looked_at(void **state)
{
    (void)state;
    for (int s = 0; s < count; s++) {
        uint64_t total = 0;
        plant = (planted){
            .signal = PLANTED_EVERYWHERE, .inverted = lowest_bit, .answer = PLANTED_NOWHERE};
        run_lockstep(&settings[s], 2100);
        assert_true(result.mismatches == result.comparisons);
        assert_true(result.first_clock == 1);
        for (int i = 0; i < result.totals_count; i++)
            total += result.totals[i].mismatches;
        assert_true(total == result.mismatches);
    }
}

/* The control: with nothing planted nothing is found. */
static void nothing_planted_is_nothing_found(void **state)
{
    (void)state;
    for (int s = 0; s < count; s++) {
        plant.signal = PLANTED_NOWHERE;
        run_lockstep(&settings[s], 100);
        assert_true(result.mismatches == 0);
    }
}

/* ---- What becomes a packet, and its replay ------------------------------------------------------
 */

enum { PLANTED_AT = 5 };

static uint64_t lowest_bit_at_a_clock(uint64_t clock)
{
    return clock == PLANTED_AT;
}

static void assert_one_found(const glint_failure_finding *found, const glint_signal_info *info)
{
    assert_true(found->lockstep_differs && !found->answer_differs);
    assert_true(found->clock == PLANTED_AT);
    assert_int_equal(found->count, 1);
    assert_true(found->mismatch[0].clock == PLANTED_AT);
    assert_true((found->mismatch[0].model[0] ^ found->mismatch[0].rtl[0]) == 1);
    assert_signal(&found->mismatch[0].signal, info);
}

/* Where both sides of a capture differ: in that signal after that clock, and nowhere else. */
static void assert_one_captured(const glint_capture *capture, int index)
{
    const int signals = glint_setting_signal_count(&capture->setting);
    for (int c = 0; c < capture->count; c++) {
        for (int i = 0; i < signals; i++) {
            const glint_capture_clock *at = &capture->clock[c];
            assert_int_equal(at->model[i] != at->rtl[i], at->clock == PLANTED_AT && i == index);
        }
    }
}

static void assert_played(const glint_setting *setting, int index)
{
    const glint_signal_info info = glint_setting_signal(setting, index);
    const glint_lockstep_options options = {.setting = *setting, .clocks = 20, .seed = seed};
    glint_failure *failure;
    glint_failure_finding found;
    glint_capture *capture;
    glint_error err;
    plant =
        (planted){.signal = index, .inverted = lowest_bit_at_a_clock, .answer = PLANTED_NOWHERE};
    run_lockstep(setting, options.clocks);
    assert_true(result.mismatches == 1);
    assert_int_equal(glint_failure_of_lockstep(&options, &result, &failure, &err), GLINT_OK);
    assert_one_found(&failure->finding, &info);
    assert_one_captured(failure->capture, index);
    assert_int_equal(glint_failure_play(failure, NULL, &found, &capture, &err), GLINT_OK);
    assert_one_found(&found, &info);
    assert_one_captured(capture, index);
    assert_true(capture->found.mismatches == 1);
    assert_true(glint_failure_same(&found, &failure->finding));
    free(capture);
    plant.signal = PLANTED_NOWHERE;
    assert_int_equal(glint_failure_play(failure, NULL, &found, NULL, &err), GLINT_OK);
    assert_false(glint_failure_differs(&found));
    assert_int_equal(found.count, 0);
    assert_false(glint_failure_same(&found, &failure->finding));
    glint_failure_destroy(failure);
}

static void a_replay_looks_at_each_signal_of_each_setting(void **state)
{
    (void)state;
    for (int s = 0; s < count; s++)
        for (int i = 0; i < glint_setting_signal_count(&settings[s]); i++)
            assert_played(&settings[s], i);
}

/* Two findings are the same only if all that was found is. */
static void findings_are_compared_in_everything(void **state)
{
    (void)state;
    const glint_setting *setting = &settings[0];
    const glint_failure_finding a = {
        .answer_differs = true,
        .model = 3,
        .rtl = 4,
        .lockstep_differs = true,
        .clock = 5,
        .count = 2,
        .mismatch = {{5, glint_setting_signal(setting, 0), {1}, {2}},
                     {5, glint_setting_signal(setting, 20), {3}, {4}}},
    };
    glint_failure_finding b[12];
    for (int i = 0; i < 12; i++)
        b[i] = a;
    assert_true(glint_failure_same(&a, &b[0]));
    b[0].answer_differs = false;
    b[1].model++;
    b[2].rtl++;
    b[3].lockstep_differs = false;
    b[4].clock++;
    b[5].count--;
    b[6].mismatch[0].signal = glint_setting_signal(setting, 1);
    b[7].mismatch[1].signal.lane++;
    b[8].mismatch[0].model[0]++;
    b[9].mismatch[0].rtl[0]++;
    b[10].mismatch[1].model[0]++;
    b[11].mismatch[1].rtl[0]++;
    for (int i = 0; i < 12; i++)
        if (glint_failure_same(&a, &b[i]) || glint_failure_same(&b[i], &a))
            fail_msg("alteration %d makes no difference", i);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_teardown(each_bit_of_each_signal_of_each_setting_is_looked_at, pull_out),
        cmocka_unit_test_teardown(each_clock_is_looked_at, pull_out),
        cmocka_unit_test_teardown(nothing_planted_is_nothing_found, pull_out),
        cmocka_unit_test_teardown(a_replay_looks_at_each_signal_of_each_setting, pull_out),
        cmocka_unit_test(findings_are_compared_in_everything),
    };
    return cmocka_run_group_tests(tests, find_settings, NULL);
}
