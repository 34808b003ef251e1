/* Whole runs of fragments: the circuits' batches, as built for lockstep and as built for speed, and
 * each kind of backend, against the pure function; lengths around multiples of the lanes.
 *
 * Circuits built for speed take long to build: 17 of them here, of 34 that make test-full, by
 * GLINT_EVERY_SETTING=1, goes through. Built for lockstep, every listed one is tried here too. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "../seed.h"
#include "backend/backend.h"
#include "circuit/circuits.h"
#include "circuit/random.h"

enum { LONGEST = 600, FILLER = 0xa5 };

typedef struct run {
    uint32_t cosine[LONGEST], w[LONGEST];
    uint8_t r[LONGEST], g[LONGEST], b[LONGEST];
} run;

static glint_random draw;

static int seed_draw(void **state)
{
    (void)state;
    draw.state = seed_of_this_run();
    return 0;
}

static glint_material draw_material(void)
{
    const uint32_t color = (uint32_t)glint_random_bits(&draw);
    return (glint_material){(uint16_t)glint_random_below(&draw, GLINT_N_COUNT), (uint8_t)color,
                            (uint8_t)(color >> 8), (uint8_t)(color >> 16)};
}

static void draw_cosines(uint32_t n, run *run)
{
    const uint32_t limit = glint_rom9(GLINT_GATE_COSINE, n);
    for (size_t i = 0; i < LONGEST; i++) {
        run->cosine[i] = glint_random_chance(&draw, 64)
                             ? glint_random_below(&draw, GLINT_COS_CODE_MAX + 1)
                             : limit + glint_random_below(&draw, GLINT_COS_ONE - limit + 1);
    }
}

/* What a run of count has to hold; what lies behind it stays as it is. */
static run expected_run(glint_gate gate, const glint_material *material, const run *before,
                        size_t count, bool with_w)
{
    run expected = *before;
    for (size_t i = 0; i < count; i++) {
        glint_specular_values v;
        assert_int_equal(glint_specular_eval(gate, material, before->cosine[i], &v), GLINT_OK);
        if (with_w)
            expected.w[i] = v.keys12;
        expected.r[i] = v.mul13;
        expected.g[i] = v.mul14;
        expected.b[i] = v.mul15;
    }
    return expected;
}

static glint_points points_of(run *run, size_t count, bool with_w)
{
    return (glint_points){run->cosine, count, with_w ? run->w : NULL, run->r, run->g, run->b};
}

/* Nothing, less than a clock's worth, whole clocks, one more, one less, and long. */
static int lengths_for(int lanes, size_t *lengths)
{
    const size_t l = (size_t)lanes;
    const size_t candidates[] = {0,     1,         l - 1,     l,     l + 1,       2 * l - 1,
                                 2 * l, 2 * l + 1, 5 * l - 1, 5 * l, LONGEST - 1, LONGEST};
    const int count = (int)(sizeof candidates / sizeof candidates[0]);
    memcpy(lengths, candidates, sizeof candidates);
    return count;
}

/* ---- The circuits' batches ----------------------------------------------------------------------
 */

static void check_batch(glint_rtl *rtl, const glint_specular_config *config, size_t count,
                        bool with_w)
{
    static run found;
    const glint_material material = draw_material();
    glint_error err;
    memset(&found, FILLER, sizeof found);
    draw_cosines(material.n, &found);
    const run expected = expected_run(config->gate, &material, &found, count, with_w);
    const uint64_t clocks = glint_rtl_clocks(rtl);
    const glint_points points = points_of(&found, count, with_w);
    if (glint_rtl_shade(rtl, &material, &points, &err) != GLINT_OK)
        fail_msg("%s", err.text);
    if (memcmp(&found, &expected, sizeof found) != 0) {
        fail_msg("gate %s, pipeline %s, %d lanes: %zu points of n %u",
                 glint_gate_name(config->gate), glint_pipeline_name(config->pipeline),
                 config->lanes, count, material.n);
    }
    /* `lanes` a clock without a gap, and what it takes the last ones to come out. */
    const size_t lanes = (size_t)config->lanes;
    assert_true(glint_rtl_clocks(rtl) - clocks ==
                (count + lanes - 1) / lanes + (size_t)glint_specular_latency(config->pipeline) - 1);
}

static void check_circuit(glint_setting setting)
{
    const glint_specular_config config = glint_specular_config_of(setting.values);
    size_t lengths[16];
    const int count = lengths_for(config.lanes, lengths);
    glint_rtl *rtl;
    glint_error err;
    if (glint_rtl_open(&setting, GLINT_RTL_FAST, &rtl, &err) != GLINT_OK)
        fail_msg("%s", err.text);
    assert_true(glint_rtl_clocks(rtl) == 1);
    for (int i = 0; i < 2 * count; i++)
        check_batch(rtl, &config, lengths[i / 2], i % 2 == 0);
    glint_rtl_destroy(rtl);
}

static bool every_setting(void)
{
    return getenv("GLINT_EVERY_SETTING") != NULL;
}

/* Of those built for speed: every gate and pipeline with one lane and with four, and every width of
 * one of them. */
static bool is_built_for_speed(const glint_specular_config *config)
{
    return every_setting() || config->lanes == 1 || config->lanes == 4 ||
           (config->gate == GLINT_GATE_COSINE && config->pipeline == GLINT_PIPELINE_PIPELINED);
}

/* Lanes that are not listed; 3 and 32 suffice for a start. */
static void batches_of_any_number_of_lanes(void **state)
{
    (void)state;
    static const int lanes[] = {3, 32, 5, 31};
    const size_t count = every_setting() ? 4 : 2;
    for (size_t i = 0; i < count; i++) {
        const glint_specular_config config = {GLINT_GATE_COSINE, GLINT_PIPELINE_PIPELINED,
                                              lanes[i]};
        check_circuit(glint_setting_specular(&config));
    }
}

static void batches_of_circuits_built_for_speed(void **state)
{
    (void)state;
    glint_setting setting;
    int checked = 0;
    for (int i = 0; glint_setting_listed(&glint_circuit_specular, i, &setting); i++) {
        const glint_specular_config config = glint_specular_config_of(setting.values);
        if (!is_built_for_speed(&config))
            continue;
        check_circuit(setting);
        checked++;
    }
    assert_int_equal(checked, every_setting() ? 30 : 15);
}

static void circuits_share_nothing(void **state)
{
    (void)state;
    const glint_specular_config config = {GLINT_GATE_COSINE, GLINT_PIPELINE_PIPELINED, 1};
    const glint_specular_inputs material = {.en = 1, .n_we = 1, .n = 77};
    glint_rtl *a;
    glint_rtl *b;
    glint_error err;
    const glint_setting setting = glint_setting_specular(&config);
    static uint64_t of_a[GLINT_SIGNAL_WORDS_MAX], of_b[GLINT_SIGNAL_WORDS_MAX];
    assert_int_equal(glint_rtl_open(&setting, GLINT_RTL_OBSERVED, &a, &err), GLINT_OK);
    assert_int_equal(glint_rtl_open(&setting, GLINT_RTL_OBSERVED, &b, &err), GLINT_OK);
    assert_string_equal(glint_specular_signal_info(&config, 0).name, "reg2");
    glint_rtl_clock(a, &material);
    glint_rtl_read(a, of_a);
    glint_rtl_read(b, of_b);
    assert_true(of_a[0] == 77 && of_b[0] == 0);
    assert_true(glint_rtl_clocks(a) == 2 && glint_rtl_clocks(b) == 1);
    glint_rtl_destroy(a);
    glint_rtl_destroy(b);
    glint_rtl_destroy(NULL);
}

static void an_n_out_of_range_is_refused(void **state)
{
    (void)state;
    const glint_material bad = {1024, 1, 1, 1};
    const uint32_t cosine = 0;
    uint8_t r = FILLER;
    uint8_t g = FILLER;
    uint8_t b = FILLER;
    glint_error err;
    const glint_points point = {&cosine, 1, NULL, &r, &g, &b};
    for (int kind = 0; kind < GLINT_BACKEND_COUNT; kind++) {
        const glint_backend_config config = {.kind = (glint_backend_kind)kind,
                                             .gate = GLINT_GATE_COSINE,
                                             .pipeline = GLINT_PIPELINE_PIPELINED,
                                             .lanes = 1};
        glint_backend *backend;
        assert_int_equal(glint_backend_create(&config, &backend, &err), GLINT_OK);
        assert_int_equal(glint_backend_shade(backend, &bad, &point, &err), GLINT_BAD_ARGUMENT);
        assert_non_null(strstr(err.text, "1024"));
        assert_true(r == FILLER && g == FILLER && b == FILLER);
        glint_backend_destroy(backend);
    }
    glint_rtl *rtl;
    const glint_specular_config config = {GLINT_GATE_COSINE, GLINT_PIPELINE_PIPELINED, 1};
    const glint_setting setting = glint_setting_specular(&config);
    assert_int_equal(glint_rtl_open(&setting, GLINT_RTL_FAST, &rtl, &err), GLINT_OK);
    assert_int_equal(glint_rtl_shade(rtl, &bad, &point, &err), GLINT_BAD_ARGUMENT);
    glint_rtl_destroy(rtl);
}

/* ---- The backends -------------------------------------------------------------------------------
 */

/* The formula in floating point, rounded half up. */
static void to_real(glint_gate gate, const glint_material *material, size_t count, bool with_w,
                    run *expected)
{
    for (size_t i = 0; i < count; i++) {
        const double w = glint_specular_real(gate, material->n, expected->cosine[i]);
        if (with_w)
            expected->w[i] = (uint32_t)floor(w * GLINT_W_ONE + 0.5);
        expected->r[i] = (uint8_t)floor(w * material->r + 0.5);
        expected->g[i] = (uint8_t)floor(w * material->g + 0.5);
        expected->b[i] = (uint8_t)floor(w * material->b + 0.5);
    }
}

static void check_shade(glint_backend *backend, const glint_backend_config *config, size_t count,
                        bool with_w)
{
    static run found;
    const glint_material material = draw_material();
    glint_error err;
    memset(&found, FILLER, sizeof found);
    draw_cosines(material.n, &found);
    run expected = expected_run(config->gate, &material, &found, count, with_w);
    if (config->kind == GLINT_BACKEND_REAL)
        to_real(config->gate, &material, count, with_w, &expected);
    const glint_points points = points_of(&found, count, with_w);
    assert_int_equal(glint_backend_shade(backend, &material, &points, &err), GLINT_OK);
    if (memcmp(&found, &expected, sizeof found) != 0) {
        fail_msg("backend %d, gate %s, pipeline %s, %d lanes: %zu points of n %u",
                 (int)config->kind, glint_gate_name(config->gate),
                 glint_pipeline_name(config->pipeline), config->lanes, count, material.n);
    }
}

static void check_backend(const glint_backend_config *config)
{
    size_t lengths[16];
    const int count = lengths_for(config->lanes != 0 ? config->lanes : GLINT_LANES_MAX, lengths);
    glint_backend *backend;
    glint_error err;
    assert_int_equal(glint_backend_create(config, &backend, &err), GLINT_OK);
    const uint64_t before = glint_backend_clocks(backend);
    for (int i = 0; i < 2 * count; i++)
        check_shade(backend, config, lengths[i / 2], i % 2 == 0);
    assert_true((glint_backend_clocks(backend) > before) == (config->kind == GLINT_BACKEND_RTL));
    glint_backend_destroy(backend);
}

/* Of the circuits, those of the test above. */
static bool is_affordable(const glint_backend_config *config)
{
    const glint_specular_config circuit = {config->gate, config->pipeline, config->lanes};
    return config->kind != GLINT_BACKEND_RTL || is_built_for_speed(&circuit);
}

static void every_backend_in_its_settings(void **state)
{
    (void)state;
    static const int lanes[] = {0, 1, 2, 4, 8, 16};
    int backends = 0;
    for (int kind = 0; kind < GLINT_BACKEND_COUNT; kind++) {
        for (int gate = 0; gate < GLINT_GATE_COUNT; gate++) {
            for (int pipeline = 0; pipeline < GLINT_PIPELINE_COUNT; pipeline++) {
                for (size_t i = 0; i < sizeof lanes / sizeof lanes[0]; i++) {
                    const glint_backend_config config = {.kind = (glint_backend_kind)kind,
                                                         .gate = (glint_gate)gate,
                                                         .pipeline = (glint_pipeline)pipeline,
                                                         .lanes = lanes[i]};
                    if (!is_affordable(&config))
                        continue;
                    check_backend(&config);
                    backends++;
                }
            }
        }
    }
    assert_int_equal(backends, 2 * 3 * 2 * 6 + (every_setting() ? 3 * 2 * 6 : 15 + 1));
}

/* By 0.52 of a step at most, so by one step of the rounded output. */
static void c_and_real_differ_by_a_step_at_most(void **state)
{
    (void)state;
    static run c;
    static run real;
    int steps = 0;
    for (int again = 0; again < 300; again++) {
        const glint_material material = draw_material();
        glint_error err;
        draw_cosines(material.n, &c);
        real = c;
        for (int kind = 0; kind < 2; kind++) {
            const glint_backend_config config = {.kind = kind == 0 ? GLINT_BACKEND_C
                                                                   : GLINT_BACKEND_REAL,
                                                 .gate = GLINT_GATE_COSINE,
                                                 .pipeline = GLINT_PIPELINE_PIPELINED,
                                                 .lanes = 0};
            run *to = kind == 0 ? &c : &real;
            glint_backend *backend;
            assert_int_equal(glint_backend_create(&config, &backend, &err), GLINT_OK);
            const glint_points points = points_of(to, LONGEST, true);
            assert_int_equal(glint_backend_shade(backend, &material, &points, &err), GLINT_OK);
            glint_backend_destroy(backend);
        }
        for (int i = 0; i < LONGEST; i++) {
            const int difference = c.r[i] - real.r[i];
            assert_true(difference >= -1 && difference <= 1);
            steps += difference != 0;
        }
    }
    /* They are not the same thing twice. */
    assert_true(steps > 0);
}

static void backends_that_do_not_exist_are_refused(void **state)
{
    (void)state;
    static const glint_backend_config bad[] = {
        {.kind = GLINT_BACKEND_COUNT,
         .gate = GLINT_GATE_COSINE,
         .pipeline = GLINT_PIPELINE_COMBINATIONAL,
         .lanes = 1},
        {.kind = (glint_backend_kind)-1,
         .gate = GLINT_GATE_COSINE,
         .pipeline = GLINT_PIPELINE_COMBINATIONAL,
         .lanes = 1},
        {.kind = GLINT_BACKEND_C,
         .gate = GLINT_GATE_COUNT,
         .pipeline = GLINT_PIPELINE_COMBINATIONAL,
         .lanes = 1},
        {.kind = GLINT_BACKEND_REAL,
         .gate = GLINT_GATE_COSINE,
         .pipeline = GLINT_PIPELINE_COUNT,
         .lanes = 1},
        {.kind = GLINT_BACKEND_RTL,
         .gate = GLINT_GATE_COSINE,
         .pipeline = GLINT_PIPELINE_COMBINATIONAL,
         .lanes = 33},
        {.kind = GLINT_BACKEND_RTL,
         .gate = GLINT_GATE_COSINE,
         .pipeline = GLINT_PIPELINE_COMBINATIONAL,
         .lanes = -1},
        {.kind = GLINT_BACKEND_RTL,
         .gate = GLINT_GATE_COSINE,
         .pipeline = GLINT_PIPELINE_COMBINATIONAL,
         .lanes = 1000},
    };
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        int nothing;
        glint_backend *backend = (glint_backend *)(void *)&nothing;
        glint_error err = {""};
        assert_int_equal(glint_backend_create(&bad[i], &backend, &err), GLINT_BAD_ARGUMENT);
        assert_null(backend);
        assert_true(err.text[0] != '\0');
    }
    glint_backend_destroy(NULL);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(batches_of_circuits_built_for_speed),
        cmocka_unit_test(batches_of_any_number_of_lanes),
        cmocka_unit_test(circuits_share_nothing),
        cmocka_unit_test(an_n_out_of_range_is_refused),
        cmocka_unit_test(every_backend_in_its_settings),
        cmocka_unit_test(c_and_real_differ_by_a_step_at_most),
        cmocka_unit_test(backends_that_do_not_exist_are_refused),
    };
    return cmocka_run_group_tests(tests, seed_draw, NULL);
}
