/* Both forms of the divider in lockstep with the C model, for every number of shifts; and that the
 * random inputs reach what they are said to reach. */
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "../seed.h"
#include "circuit/circuits.h"
#include "circuit/divider_stimulus.h"
#include "lockstep/lockstep.h"
#include "rtl/rtl.h"

enum { N_FIRST = 6, N_LAST = 16, K_TABLE = 16, CLOCKS = 6000, SIGNALS_MAX = 256 };

static uint64_t seed;

static int draw_seed(void **state)
{
    (void)state;
    seed = seed_of_this_run();
    return 0;
}

static uint64_t compare_build(glint_divider_form form, int n)
{
    static glint_lockstep_result result;
    glint_error err;
    const glint_lockstep_options options = {
        .setting = glint_setting_divider(form, n), .clocks = CLOCKS, .seed = seed};
    memset(&result, 0x5a, sizeof result);
    if (glint_lockstep_run(&options, &result, &err) != GLINT_OK)
        fail_msg("%s", err.text);
    const glint_lockstep_result *found = &result;
    if (found->mismatches != 0) {
        fail_msg("%s, n = %d, seed %" PRIu64 ": %" PRIu64
                 " mismatches, the first in %s at clock %" PRIu64,
                 glint_divider_form_name(form), n, seed, found->mismatches,
                 found->mismatch[0].signal.name, found->first_clock);
    }
    assert_int_equal(found->clocks, CLOCKS);
    assert_true(found->comparisons ==
                (uint64_t)CLOCKS * (uint64_t)glint_divider_signal_count(form, n));
    assert_int_equal(found->kept, 0);
    assert_int_equal(found->totals_count, 0);
    return found->comparisons;
}

static void the_circuits_equal_the_model(void **state)
{
    (void)state;
    uint64_t comparisons = 0;
    int builds = 0;
    for (int f = 0; f < GLINT_DIVIDER_FORM_COUNT; f++) {
        for (int n = N_FIRST; n <= N_LAST; n++) {
            comparisons += compare_build((glint_divider_form)f, n);
            builds++;
        }
    }
    print_message("0 mismatches of %" PRIu64 " comparisons, %d builds, %d clocks each\n",
                  comparisons, builds, CLOCKS);
    assert_int_equal(builds, 22);
    assert_true(comparisons > 0);
}

/* ---- Refusals and interruption ------------------------------------------------------------------
 */

enum { USUAL_SHIFTS = 8, USUAL_CLOCKS = 5000 };

static glint_lockstep_options usual(void)
{
    return (glint_lockstep_options){
        .setting = glint_setting_divider(GLINT_DIVIDER_PIPELINED, USUAL_SHIFTS),
        .clocks = USUAL_CLOCKS,
        .seed = 1};
}

static void zero_clocks_are_refused(void **state)
{
    (void)state;
    static glint_lockstep_result result;
    glint_error err;
    glint_lockstep_options options = usual();
    options.clocks = 0;
    assert_int_equal(glint_lockstep_run(&options, &result, &err), GLINT_BAD_ARGUMENT);
    assert_string_equal(err.text, "nothing to compare: 0 clocks");
}

static void what_does_not_exist_is_refused(void **state)
{
    (void)state;
    static glint_lockstep_result result;
    static const int shifts[] = {5, 17, 0, -1};
    for (size_t i = 0; i < sizeof shifts / sizeof shifts[0]; i++) {
        glint_error err = {""};
        glint_rtl *rtl;
        glint_lockstep_options options = usual();
        options.setting.values[GLINT_DIVIDER_SHIFTS] = shifts[i];
        assert_int_equal(glint_lockstep_run(&options, &result, &err), GLINT_BAD_ARGUMENT);
        assert_true(result.comparisons == 0 && err.text[0] != '\0');
        assert_int_equal(glint_rtl_open(&options.setting, GLINT_RTL_FAST, &rtl, &err),
                         GLINT_BAD_ARGUMENT);
        assert_null(rtl);
        assert_non_null(strstr(err.text, "shifts"));
    }
    glint_rtl_destroy(NULL);
}

static void stop_now(void *context, uint64_t done, uint64_t total)
{
    (void)done, (void)total;
    *(volatile bool *)context = true;
}

static void a_stop_ends_the_run_with_what_was_compared(void **state)
{
    (void)state;
    static glint_lockstep_result result;
    volatile bool stop = false;
    glint_error err;
    glint_lockstep_options options = usual();
    options.stop = &stop;
    options.progress = stop_now;
    options.progress_context = (void *)(uintptr_t)&stop;
    assert_int_equal(glint_lockstep_run(&options, &result, &err), GLINT_INTERRUPTED);
    assert_true(result.clocks > 0 && result.clocks < options.clocks);
    assert_true(result.comparisons == result.clocks * (uint64_t)glint_divider_signal_count(
                                                          GLINT_DIVIDER_PIPELINED, USUAL_SHIFTS));
    assert_int_equal(result.mismatches, 0);
}

static void note_progress(void *context, uint64_t done, uint64_t total)
{
    uint64_t *last = context;
    assert_true(done > *last && done <= total);
    assert_true(total == USUAL_CLOCKS);
    *last = done;
}

static void progress_is_told(void **state)
{
    (void)state;
    static glint_lockstep_result result;
    uint64_t last = 0;
    glint_error err;
    glint_lockstep_options options = usual();
    options.progress = note_progress;
    options.progress_context = &last;
    assert_int_equal(glint_lockstep_run(&options, &result, &err), GLINT_OK);
    assert_true(last > 0);
}

/* ---- The stimulus -------------------------------------------------------------------------------
 */

/* How many clocks two seeds give the same inputs. */
static int count_equal_inputs(uint64_t seed_a, uint64_t seed_b)
{
    glint_divider_stimulus a;
    glint_divider_stimulus b;
    int equal = 0;
    glint_divider_stimulus_init(&a, seed_a);
    glint_divider_stimulus_init(&b, seed_b);
    for (int clock = 0; clock < CLOCKS; clock++) {
        glint_divider_inputs in_a;
        glint_divider_inputs in_b;
        glint_divider_stimulus_next(&a, &in_a);
        glint_divider_stimulus_next(&b, &in_b);
        equal += memcmp(&in_a, &in_b, sizeof in_a) == 0;
    }
    return equal;
}

static void a_seed_gives_the_same_inputs_again(void **state)
{
    (void)state;
    assert_int_equal(count_equal_inputs(seed, seed), CLOCKS);
    for (uint64_t other = seed + 1; other <= seed + 20; other++)
        assert_true(count_equal_inputs(seed, other) < CLOCKS / 10);
}

/* Situations that the stimulus promises, and how often each occurred. */
#define SITUATIONS(X)                                                                              \
    X(division)                                                                                    \
    X(start_while_busy)                                                                            \
    X(start_with_done)                                                                             \
    X(done_without_start)                                                                          \
    X(idle)                                                                                        \
    X(stall)                                                                                       \
    X(stall_while_busy)                                                                            \
    X(stall_with_done)                                                                             \
    X(stall_with_a_start)                                                                          \
    X(reset)                                                                                       \
    X(reset_while_busy)                                                                            \
    X(reset_while_stalled)                                                                         \
    X(reset_with_a_start)                                                                          \
    X(k_zero)                                                                                      \
    X(k_seventeen)                                                                                 \
    X(k_far_beyond)                                                                                \
    X(every_k_of_the_table)                                                                        \
    X(difference_zero)                                                                             \
    X(difference_one)                                                                              \
    X(difference_minus_one)                                                                        \
    X(difference_largest)                                                                          \
    X(difference_smallest)                                                                         \
    X(difference_negative)                                                                         \
    X(quotient_negative)                                                                           \
    X(pipeline_full)                                                                               \
    X(pipeline_with_a_gap)                                                                         \
    X(stall_with_a_full_pipeline)                                                                  \
    X(reset_with_a_full_pipeline)                                                                  \
    X(a_miss_among_hits)

#define COUNTER(name) uint64_t name;
typedef struct situations {
    SITUATIONS(COUNTER)
} situations;

/* What is at the pins, and what the sequential form is doing before the edge. */
static void count_sequential(situations *c, const glint_divider_inputs *in,
                             const glint_divider_sequential_signals *s)
{
    const bool runs = in->en && !in->reset;
    c->division += runs && in->start && !s->busy;
    c->start_while_busy += runs && in->start && s->busy;
    c->start_with_done += runs && in->start && s->done;
    c->done_without_start += runs && !in->start && s->done;
    c->idle += runs && !in->start && !s->busy && !s->done;
    c->stall += !in->en && !in->reset;
    c->stall_while_busy += !in->en && !in->reset && s->busy;
    c->stall_with_done += !in->en && !in->reset && s->done;
    c->stall_with_a_start += !in->en && !in->reset && in->start;
    c->reset += in->reset;
    c->reset_while_busy += in->reset && s->busy;
    c->reset_while_stalled += in->reset && !in->en;
    c->reset_with_a_start += in->reset && in->start;
    c->quotient_negative += s->done && s->quotient < 0;
}

/* What the sequential form takes. */
static void count_operands(situations *c, const glint_divider_inputs *in, uint32_t *seen_k)
{
    const int difference = in->difference[0];
    c->k_zero += in->k == 0;
    c->k_seventeen += in->k == K_TABLE + 1;
    c->k_far_beyond += in->k > 128;
    if (in->k <= K_TABLE)
        *seen_k |= 1u << in->k;
    c->every_k_of_the_table += *seen_k == (1u << (K_TABLE + 1)) - 1;
    c->difference_zero += difference == 0;
    c->difference_one += difference == 1;
    c->difference_minus_one += difference == -1;
    c->difference_largest += difference == 255;
    c->difference_smallest += difference == -255;
    c->difference_negative += difference < -1 && difference > -255;
}

static void count_pipelined(situations *c, const glint_divider_inputs *in,
                            const glint_divider_pipelined_signals *s, int n)
{
    int full = 0;
    int misses = 0;
    for (int j = 1; j <= n; j++) {
        full += s->stage[j].valid != 0;
        misses += s->stage[j].valid && s->stage[j].miss;
    }
    c->pipeline_full += full == n;
    c->pipeline_with_a_gap += full > 0 && full < n;
    c->stall_with_a_full_pipeline += full == n && !in->en && !in->reset;
    c->reset_with_a_full_pipeline += full == n && in->reset;
    c->a_miss_among_hits += misses > 0 && misses < full;
}

#define ASSERT_CAME(name)                                                                          \
    if (counted.name == 0)                                                                         \
        fail_msg("n = %d, seed %" PRIu64 ": " #name " never came", n, seed);
#define PRINT_COUNT(name) print_message("%8" PRIu64 " " #name "\n", counted.name);

static void the_stimulus_reaches_every_situation(void **state)
{
    (void)state;
    for (int n = N_FIRST; n <= N_LAST; n++) {
        situations counted = {0};
        uint32_t seen_k = 0;
        glint_divider_stimulus stimulus;
        glint_divider_device *sequential;
        glint_divider_device *pipelined;
        glint_divider_stimulus_init(&stimulus, seed);
        assert_int_equal(glint_divider_device_create(GLINT_DIVIDER_SEQUENTIAL, n, &sequential),
                         GLINT_OK);
        assert_int_equal(glint_divider_device_create(GLINT_DIVIDER_PIPELINED, n, &pipelined),
                         GLINT_OK);
        const glint_divider_sequential_signals *s = glint_divider_device_sequential(sequential);
        for (int clock = 0; clock < 60000; clock++) {
            glint_divider_inputs in;
            glint_divider_stimulus_next(&stimulus, &in);
            count_sequential(&counted, &in, s);
            count_pipelined(&counted, &in, glint_divider_device_pipelined(pipelined), n);
            if (in.en && !in.reset && in.start && !s->busy)
                count_operands(&counted, &in, &seen_k);
            glint_divider_device_clock(sequential, &in);
            glint_divider_device_clock(pipelined, &in);
        }
        glint_divider_device_destroy(sequential);
        glint_divider_device_destroy(pipelined);
        if (n == N_LAST) {
            print_message("n = %d, of 60000 clocks:\n", n);
            SITUATIONS(PRINT_COUNT)
        }
        SITUATIONS(ASSERT_CAME)
    }
}

/* The bits of a signal that some input moves. */
static uint64_t moving_bits(const glint_signal_info *info, int n)
{
    const uint64_t all = (UINT64_C(1) << (info->int_bits + info->frac_bits)) - 1;
    if (strcmp(info->name, "left") == 0) /* n…0 */
        return n == 16 ? 31 : n >= 8 ? 15 : 7;
    /* Behind stage j nothing has been shifted further than j places. */
    return strncmp(info->name, "acc_", 4) == 0 && info->lane > 0
               ? all & ~((UINT64_C(1) << (n - info->lane)) - 1)
               : all;
}

/* Every bit of every signal is 0 at some clock and 1 at another: what is compared is alive. */
static void every_signal_moves(void **state)
{
    (void)state;
    for (int f = 0; f < GLINT_DIVIDER_FORM_COUNT; f++) {
        for (int n = N_FIRST; n <= N_LAST; n++) {
            const glint_divider_form form = (glint_divider_form)f;
            const int count = glint_divider_signal_count(form, n);
            uint64_t ones[SIGNALS_MAX] = {0};
            uint64_t zeros[SIGNALS_MAX] = {0};
            glint_divider_stimulus stimulus;
            glint_divider_device *device;
            assert_in_range(count, 1, SIGNALS_MAX);
            glint_divider_stimulus_init(&stimulus, seed);
            assert_int_equal(glint_divider_device_create(form, n, &device), GLINT_OK);
            for (int clock = 0; clock < 20000; clock++) {
                glint_divider_inputs in;
                glint_divider_stimulus_next(&stimulus, &in);
                glint_divider_device_clock(device, &in);
                for (int i = 0; i < count; i++) {
                    const uint64_t bits = glint_divider_signal_bits(device, i);
                    ones[i] |= bits;
                    zeros[i] |= ~bits;
                }
            }
            glint_divider_device_destroy(device);
            for (int i = 0; i < count; i++) {
                const glint_signal_info info = glint_divider_signal_info(form, n, i);
                const uint64_t still = moving_bits(&info, n) & ~(ones[i] & zeros[i]);
                if (still != 0) {
                    fail_msg("%s, n = %d, seed %" PRIu64 ": bits 0x%" PRIx64
                             " of %s (stage %d) never move",
                             glint_divider_form_name(form), n, seed, still, info.name, info.lane);
                }
            }
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_circuits_equal_the_model),
        cmocka_unit_test(zero_clocks_are_refused),
        cmocka_unit_test(what_does_not_exist_is_refused),
        cmocka_unit_test(a_stop_ends_the_run_with_what_was_compared),
        cmocka_unit_test(progress_is_told),
        cmocka_unit_test(a_seed_gives_the_same_inputs_again),
        cmocka_unit_test(the_stimulus_reaches_every_situation),
        cmocka_unit_test(every_signal_moves),
    };
    return cmocka_run_group_tests(tests, draw_seed, NULL);
}
