/* The C model and the real circuits in lockstep, in every setting that is listed; and that the
 * random inputs reach what they are said to reach. */
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "../seed.h"
#include "../under_way.h"
#include "circuit/circuits.h"
#include "circuit/stimulus.h"
#include "lockstep/lockstep.h"

enum {
    CLOCKS = 6000,
    SETTINGS = 30, /* 3 gates, 2 pipelines, 1 to 16 lanes */
    SIGNALS_MAX = 512
};

static uint64_t seed;

static int draw_seed(void **state)
{
    (void)state;
    seed = seed_of_this_run();
    return 0;
}

/* The settings that are tried unasked, by number. */
static bool listed(int number, glint_setting *setting, glint_specular_config *config)
{
    const bool there = glint_setting_listed(&glint_circuit_specular, number, setting);
    if (there)
        *config = glint_specular_config_of(setting->values);
    return there;
}

static void every_setting_is_listed_once(void **state)
{
    (void)state;
    int count = 0;
    glint_setting setting, other;
    for (; glint_setting_listed(&glint_circuit_specular, count, &setting); count++) {
        for (int i = 0; i < count; i++) {
            assert_true(glint_setting_listed(&glint_circuit_specular, i, &other));
            assert_false(glint_setting_equal(&setting, &other));
        }
    }
    assert_int_equal(count, SETTINGS);
}

static void the_circuits_equal_the_model(void **state)
{
    (void)state;
    static glint_lockstep_result result;
    uint64_t comparisons = 0;
    glint_setting setting;
    glint_specular_config config;
    for (int i = 0; listed(i, &setting, &config); i++) {
        glint_error err;
        const glint_lockstep_options options = {.setting = setting, .clocks = CLOCKS, .seed = seed};
        assert_int_equal(glint_lockstep_run(&options, &result, &err), GLINT_OK);
        if (result.mismatches != 0) {
            fail_msg("gate %s, pipeline %s, %d lanes, seed %" PRIu64 ": %" PRIu64
                     " mismatches, the first in %s at clock %" PRIu64,
                     glint_gate_name(config.gate), glint_pipeline_name(config.pipeline),
                     config.lanes, seed, result.mismatches, result.mismatch[0].signal.name,
                     result.first_clock);
        }
        assert_int_equal(result.clocks, CLOCKS);
        assert_true(result.comparisons ==
                    (uint64_t)CLOCKS * (uint64_t)glint_specular_signal_count(&config));
        assert_int_equal(result.kept, 0);
        assert_int_equal(result.totals_count, 0);
        comparisons += result.comparisons;
    }
    print_message("0 mismatches of %" PRIu64 " comparisons\n", comparisons);
    assert_true(comparisons > 0);
}

/* ---- Refusals and interruption ------------------------------------------------------------------
 */

static const glint_specular_config usual_config = {GLINT_GATE_COSINE, GLINT_PIPELINE_PIPELINED, 1};

enum { USUAL_CLOCKS = 5000 };

static glint_lockstep_options usual(void)
{
    return (glint_lockstep_options){
        .setting = glint_setting_specular(&usual_config), .clocks = USUAL_CLOCKS, .seed = 1};
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

static void a_setting_that_does_not_exist_is_refused(void **state)
{
    (void)state;
    static glint_lockstep_result result;
    glint_error err;
    glint_lockstep_options options = usual();
    options.setting.values[GLINT_SPECULAR_LANES] = GLINT_LANES_MAX + 1;
    assert_int_equal(glint_lockstep_run(&options, &result, &err), GLINT_BAD_ARGUMENT);
    assert_int_equal(result.comparisons, 0);
    assert_true(err.text[0] != '\0');
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
    volatile bool stop = true;
    glint_error err;
    glint_lockstep_options options = usual();
    options.stop = &stop;
    assert_int_equal(glint_lockstep_run(&options, &result, &err), GLINT_INTERRUPTED);
    assert_true(result.clocks == 0 && result.comparisons == 0);
    stop = false;
    options.progress = stop_now;
    options.progress_context = (void *)(uintptr_t)&stop;
    assert_int_equal(glint_lockstep_run(&options, &result, &err), GLINT_INTERRUPTED);
    assert_true(result.clocks > 0 && result.clocks < options.clocks);
    assert_true(result.comparisons ==
                result.clocks * (uint64_t)glint_specular_signal_count(&usual_config));
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
static int count_equal_inputs(uint64_t seed_a, uint64_t seed_b, int lanes)
{
    glint_stimulus a;
    glint_stimulus b;
    int equal = 0;
    glint_stimulus_init(&a, seed_a, lanes);
    glint_stimulus_init(&b, seed_b, lanes);
    for (int clock = 0; clock < CLOCKS; clock++) {
        glint_specular_inputs in_a;
        glint_specular_inputs in_b;
        glint_stimulus_next(&a, &in_a);
        glint_stimulus_next(&b, &in_b);
        equal += memcmp(&in_a, &in_b, sizeof in_a) == 0;
    }
    return equal;
}

static void a_seed_gives_the_same_inputs_again(void **state)
{
    (void)state;
    for (int lanes = 1; lanes <= GLINT_LANES_MAX; lanes *= 2)
        assert_int_equal(count_equal_inputs(seed, seed, lanes), CLOCKS);
}

static void another_seed_gives_other_inputs(void **state)
{
    (void)state;
    for (uint64_t other = seed + 1; other <= seed + 20; other++)
        assert_true(count_equal_inputs(seed, other, 1) < CLOCKS / 10);
}

/* Situations that the stimulus promises, and how often each occurred. */
#define SITUATIONS(X)                                                                              \
    X(stall)                                                                                       \
    X(stall_with_points_under_way)                                                                 \
    X(stall_with_a_point_at_the_pins)                                                              \
    X(stall_with_a_material_at_the_pins)                                                           \
    X(reset)                                                                                       \
    X(reset_with_points_under_way)                                                                 \
    X(reset_while_stalled)                                                                         \
    X(material_with_a_point)                                                                       \
    X(material_without_a_point)                                                                    \
    X(material_while_points_are_under_way)                                                         \
    X(n_alone)                                                                                     \
    X(colors_alone)                                                                                \
    X(gap)                                                                                         \
    X(all_lanes_valid)                                                                             \
    X(twenty_clocks_without_a_gap)                                                                 \
    X(cosine_above_one)                                                                            \
    X(cosine_one)                                                                                  \
    X(cosine_zero)                                                                                 \
    X(cosine_at_the_limit)                                                                         \
    X(cosine_below_the_limit)                                                                      \
    X(gate_open)                                                                                   \
    X(gate_closed)                                                                                 \
    X(w_one)                                                                                       \
    X(n_zero)                                                                                      \
    X(n_largest)                                                                                   \
    X(n_thousand)                                                                                  \
    X(color_white)                                                                                 \
    X(color_black)

#define COUNTER(name) uint64_t name;
typedef struct situations {
    SITUATIONS(COUNTER)
    uint64_t some_lanes_valid; /* with several lanes only */
} situations;

static void count_controls(situations *c, const glint_specular_inputs *in, bool under_way,
                           uint32_t all_lanes)
{
    const bool material = in->n_we || in->rgb_we;
    const bool runs = in->en && !in->reset;
    static int dense;
    c->stall += !in->en && !in->reset;
    c->stall_with_points_under_way += !in->en && !in->reset && under_way;
    c->stall_with_a_point_at_the_pins += !in->en && !in->reset && in->in_valid != 0;
    c->stall_with_a_material_at_the_pins += !in->en && !in->reset && material;
    c->reset += in->reset;
    c->reset_with_points_under_way += in->reset && under_way;
    c->reset_while_stalled += in->reset && !in->en;
    c->material_with_a_point += runs && material && in->in_valid != 0;
    c->material_without_a_point += runs && material && in->in_valid == 0;
    c->material_while_points_are_under_way += runs && material && under_way;
    c->n_alone += runs && in->n_we && !in->rgb_we;
    c->colors_alone += runs && !in->n_we && in->rgb_we;
    c->gap += runs && in->in_valid == 0;
    c->all_lanes_valid += runs && in->in_valid == all_lanes;
    c->some_lanes_valid += runs && in->in_valid != 0 && in->in_valid != all_lanes;
    dense = runs && in->in_valid == all_lanes ? dense + 1 : 0;
    c->twenty_clocks_without_a_gap += dense >= 20;
}

static void count_points(situations *c, const glint_specular_inputs *in,
                         const glint_specular_signals *after, int lanes)
{
    const uint32_t limit = glint_rom9(GLINT_GATE_COSINE, (uint32_t)after->reg2);
    c->n_zero += after->reg2 == 0;
    c->n_largest += after->reg2 == GLINT_N_MAX;
    c->n_thousand += after->reg2 == 1000;
    c->color_white += after->reg3 == 255;
    c->color_black += after->reg3 == 0;
    for (int i = 0; i < lanes; i++) {
        if (in->en && !in->reset && (in->in_valid >> i & 1) != 0) {
            c->cosine_above_one += in->cos[i] > GLINT_COS_ONE;
            c->cosine_one += in->cos[i] == GLINT_COS_ONE;
            c->cosine_zero += in->cos[i] == 0;
            c->cosine_at_the_limit += in->cos[i] == limit;
            c->cosine_below_the_limit += in->cos[i] + 1 == limit;
        }
        if ((after->out_valid >> i & 1) != 0) {
            c->gate_open += after->lane[i].out_w != 0;
            c->gate_closed += after->lane[i].out_w == 0;
            c->w_one += after->lane[i].out_w == GLINT_W_ONE;
        }
    }
}

#define ASSERT_CAME(name)                                                                          \
    if (counted.name == 0)                                                                         \
        fail_msg("%d lanes, seed %" PRIu64 ": " #name " never came", config.lanes, seed);

static void the_stimulus_reaches_every_situation(void **state)
{
    (void)state;
    for (int lanes = 1; lanes <= GLINT_LANES_MAX; lanes *= 2) {
        const glint_specular_config config = {GLINT_GATE_COSINE, GLINT_PIPELINE_PIPELINED, lanes};
        situations counted = {0};
        glint_stimulus stimulus;
        glint_specular_device *device;
        glint_stimulus_init(&stimulus, seed, lanes);
        assert_int_equal(glint_specular_device_create(&config, &device), GLINT_OK);
        const glint_specular_signals *signals = glint_specular_device_signals(device);
        for (int clock = 0; clock < 20000; clock++) {
            glint_specular_inputs in;
            glint_stimulus_next(&stimulus, &in);
            assert_true((uint64_t)in.in_valid >> lanes == 0);
            count_controls(&counted, &in, points_are_under_way(&config, signals),
                           (uint32_t)((UINT64_C(1) << lanes) - 1));
            glint_specular_device_clock(device, &in);
            count_points(&counted, &in, signals, lanes);
        }
        glint_specular_device_destroy(device);
        SITUATIONS(ASSERT_CAME)
        assert_int_equal(counted.some_lanes_valid > 0, lanes > 1);
    }
}

/* Signals that no input can move in a setting. */
static bool is_constant(const glint_specular_config *config, const char *name)
{
    const bool rom9 = strstr(name, "rom9") != NULL;
    if (config->gate == GLINT_GATE_COSINE)
        return false;
    if (config->gate == GLINT_GATE_SIGN)
        return rom9;
    /* Gate drawn: one limit, in a register that a reset clears; the comparison waits for the
     * square, so it goes through no register. */
    return strstr(name, "_cmp11") != NULL ||
           (rom9 &&
            (config->pipeline == GLINT_PIPELINE_COMBINATIONAL || strcmp(name, "rom9") == 0));
}

/* Every signal changes at some clock: what is compared is alive. */
static void every_signal_moves(void **state)
{
    (void)state;
    static uint64_t ones[SIGNALS_MAX];
    static uint64_t zeros[SIGNALS_MAX];
    glint_setting setting;
    glint_specular_config of_number;
    for (int number = 0; listed(number, &setting, &of_number); number++) {
        const glint_specular_config *config = &of_number;
        const int count = glint_specular_signal_count(config);
        glint_stimulus stimulus;
        glint_specular_device *device;
        assert_true(count <= SIGNALS_MAX);
        memset(ones, 0, sizeof ones);
        memset(zeros, 0, sizeof zeros);
        glint_stimulus_init(&stimulus, seed, config->lanes);
        assert_int_equal(glint_specular_device_create(config, &device), GLINT_OK);
        /* From the reset of creation on: some registers move at a reset only, and not every run has
         * another. */
        for (int clock = 0; clock < 4000; clock++) {
            glint_specular_inputs in;
            for (int i = 0; i < count; i++) {
                const uint64_t bits =
                    glint_specular_signal_bits(config, glint_specular_device_signals(device), i);
                ones[i] |= bits;
                zeros[i] |= ~bits;
            }
            glint_stimulus_next(&stimulus, &in);
            glint_specular_device_clock(device, &in);
        }
        glint_specular_device_destroy(device);
        for (int i = 0; i < count; i++) {
            const glint_signal_info info = glint_specular_signal_info(config, i);
            if ((ones[i] & zeros[i]) == 0 && !is_constant(config, info.name)) {
                fail_msg("gate %s, pipeline %s, %d lanes: %s, lane %d, never moves",
                         glint_gate_name(config->gate), glint_pipeline_name(config->pipeline),
                         config->lanes, info.name, info.lane);
            }
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_setting_is_listed_once),
        cmocka_unit_test(the_circuits_equal_the_model),
        cmocka_unit_test(zero_clocks_are_refused),
        cmocka_unit_test(a_setting_that_does_not_exist_is_refused),
        cmocka_unit_test(a_stop_ends_the_run_with_what_was_compared),
        cmocka_unit_test(progress_is_told),
        cmocka_unit_test(a_seed_gives_the_same_inputs_again),
        cmocka_unit_test(another_seed_gives_other_inputs),
        cmocka_unit_test(the_stimulus_reaches_every_situation),
        cmocka_unit_test(every_signal_moves),
    };
    return cmocka_run_group_tests(tests, draw_seed, NULL);
}
