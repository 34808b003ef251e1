/* The device clock by clock: its outputs against the pure function through a queue (inputs are
 * pushed, valid outputs popped), the clock enable, the reset, and the table of its signals. */
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "../golden.h"
#include "../seed.h"
#include "circuit/random.h"
#include "glint_specular_device.h"

static const int lane_counts[] = {1, 2, 3, 8, 16, 31, 32};

enum {
    LANE_COUNTS = sizeof lane_counts / sizeof lane_counts[0],
    SETTINGS = GLINT_GATE_COUNT * GLINT_PIPELINE_COUNT * LANE_COUNTS,
    LATENCY_MAX = 8,
    CLOCKS = 6000
};

static glint_random draw;

static int seed_draw(void **state)
{
    (void)state;
    draw.state = seed_of_this_run();
    return 0;
}

static glint_specular_config setting(int index)
{
    const int gate_and_pipeline = index / LANE_COUNTS;
    return (glint_specular_config){(glint_gate)(gate_and_pipeline / GLINT_PIPELINE_COUNT),
                                   (glint_pipeline)(gate_and_pipeline % GLINT_PIPELINE_COUNT),
                                   lane_counts[index % LANE_COUNTS]};
}

static glint_specular_device *create(const glint_specular_config *config)
{
    glint_specular_device *device;
    assert_int_equal(glint_specular_device_create(config, &device), GLINT_OK);
    assert_non_null(device);
    return device;
}

/* ---- The queue --------------------------------------------------------------------------------
 */

/* The points of one clock that are under way, and what has to become of them. */
typedef struct expectation {
    uint64_t due; /* the enabled clock after which they are out */
    uint32_t valid;
    glint_specular_values values[GLINT_LANES_MAX];
} expectation;

typedef struct scoreboard {
    glint_specular_config config;
    glint_specular_device *device;
    glint_material material;
    uint64_t enabled; /* clocks since the last reset */
    expectation queue[LATENCY_MAX];
    int queued;
    uint64_t points, stalls, resets, lost_in_reset, materials_with, materials_without;
} scoreboard;

static void push(scoreboard *s, const glint_specular_inputs *in)
{
    expectation *e = &s->queue[s->queued];
    assert_true(s->queued < LATENCY_MAX);
    e->due = s->enabled + (uint64_t)glint_specular_latency(s->config.pipeline) - 1;
    e->valid = in->in_valid & (UINT32_MAX >> (32 - s->config.lanes));
    for (int i = 0; i < s->config.lanes; i++) {
        if ((e->valid >> i & 1) != 0) {
            assert_int_equal(glint_specular_eval(s->config.gate, &s->material,
                                                 in->cos[i] & GLINT_COS_CODE_MAX, &e->values[i]),
                             GLINT_OK);
        }
    }
    s->queued += e->valid != 0;
}

static void pop_late(scoreboard *s)
{
    if (s->queued > 0 && s->queue[0].due < s->enabled) {
        s->queued--;
        memmove(&s->queue[0], &s->queue[1], (size_t)s->queued * sizeof s->queue[0]);
    }
}

/* What the queue expects of the edge that `in` is at. */
static void expect_clock(scoreboard *s, const glint_specular_inputs *in)
{
    if (in->reset) {
        s->resets++;
        s->lost_in_reset += s->queued > 0;
        s->queued = 0;
        s->material = (glint_material){0};
        return;
    }
    if (!in->en) {
        s->stalls++;
        return;
    }
    s->enabled++;
    if (in->n_we)
        s->material.n = in->n & GLINT_N_MAX;
    if (in->rgb_we) {
        s->material.r = in->r;
        s->material.g = in->g;
        s->material.b = in->b;
    }
    s->materials_with += (in->n_we || in->rgb_we) && in->in_valid != 0;
    s->materials_without += (in->n_we || in->rgb_we) && in->in_valid == 0;
    push(s, in);
    pop_late(s);
}

static void assert_outputs(scoreboard *s)
{
    const glint_specular_signals *found = glint_specular_device_signals(s->device);
    const bool due = s->queued > 0 && s->queue[0].due == s->enabled;
    const expectation *e = &s->queue[0];
    assert_true(found->out_valid == (due ? e->valid : 0));
    for (int i = 0; due && i < s->config.lanes; i++) {
        if ((e->valid >> i & 1) == 0)
            continue;
        assert_true(found->lane[i].out_w == e->values[i].keys12);
        assert_true(found->lane[i].out_r == e->values[i].mul13);
        assert_true(found->lane[i].out_g == e->values[i].mul14);
        assert_true(found->lane[i].out_b == e->values[i].mul15);
        s->points++;
    }
}

/* ---- Stimulus of its own: nothing here knows of sim/lockstep's ----------------------------------
 */

static uint32_t draw_cosine(uint32_t n)
{
    const uint32_t limit = glint_rom9(GLINT_GATE_COSINE, n);
    switch (glint_random_below(&draw, 4)) {
    case 0:
        return (uint32_t)glint_random_bits(&draw); /* wider than the pins */
    case 1:
        return (limit + glint_random_below(&draw, 5) - 2u) & GLINT_COS_CODE_MAX;
    case 2:
        return GLINT_COS_ONE - 1 + glint_random_below(&draw, 3);
    default:
        return limit + glint_random_below(&draw, GLINT_COS_ONE - limit + 1);
    }
}

/* The mix changes every so many clocks: dense, sparse, stalling, changing material. */
static void draw_inputs(int clock, uint32_t n, glint_specular_inputs *in)
{
    static const uint32_t chances[] = {0, 0, 20, 128, 230};
    static uint32_t gap, stall, change;
    if (clock % 100 == 0) {
        gap = chances[glint_random_below(&draw, 5)];
        stall = chances[glint_random_below(&draw, 5)];
        change = chances[glint_random_below(&draw, 5)];
    }
    memset(in, 0, sizeof *in);
    in->reset = glint_random_chance(&draw, 2);
    in->en = !glint_random_chance(&draw, stall);
    in->n_we = glint_random_chance(&draw, change);
    in->rgb_we = glint_random_chance(&draw, change);
    in->n = (uint16_t)glint_random_bits(&draw); /* wider than the pins */
    in->r = (uint8_t)glint_random_bits(&draw);
    in->g = (uint8_t)glint_random_bits(&draw);
    in->b = (uint8_t)glint_random_bits(&draw);
    if (!glint_random_chance(&draw, gap))
        in->in_valid = (uint32_t)glint_random_bits(&draw); /* bits above the lanes, too */
    for (int i = 0; i < GLINT_LANES_MAX; i++)
        in->cos[i] = draw_cosine(n);
}

static void run_scoreboard(scoreboard *s)
{
    glint_specular_inputs in;
    s->device = create(&s->config);
    for (int clock = 0; clock < CLOCKS; clock++) {
        draw_inputs(clock, s->material.n, &in);
        expect_clock(s, &in);
        glint_specular_device_clock(s->device, &in);
        assert_outputs(s);
    }
    glint_specular_device_destroy(s->device);
}

/* In order, exactly `latency` enabled clocks later, equal to the pure function. */
static void outputs_are_the_pure_function(void **state)
{
    (void)state;
    uint64_t points = 0;
    for (int i = 0; i < SETTINGS; i++) {
        scoreboard s = {.config = setting(i)};
        run_scoreboard(&s);
        assert_true(s.points > 0 && s.stalls > 0 && s.resets > 0 && s.materials_with > 0 &&
                    s.materials_without > 0);
        assert_true(s.lost_in_reset > 0 || s.config.pipeline == GLINT_PIPELINE_COMBINATIONAL);
        points += s.points;
    }
    print_message("%" PRIu64 " points in %d settings\n", points, SETTINGS);
}

/* ---- Directed ---------------------------------------------------------------------------------
 */

static void latency_is_as_stated(void **state)
{
    (void)state;
    assert_int_equal(glint_specular_latency(GLINT_PIPELINE_COMBINATIONAL), 1);
    assert_int_equal(glint_specular_latency(GLINT_PIPELINE_PIPELINED), GLINT_LATENCY_PIPELINED);
    assert_in_range(GLINT_LATENCY_PIPELINED, 4, 6);
}

static glint_specular_inputs point(uint32_t cosine)
{
    return (glint_specular_inputs){.en = 1, .in_valid = 1, .cos = {cosine}};
}

static void write_material(glint_specular_inputs *in, uint16_t n, uint8_t color)
{
    in->n_we = in->rgb_we = 1;
    in->n = n;
    in->r = in->g = in->b = color;
}

/* Three points back to back, at the centre, so each result is its material's colour; then a colour
 * written between points, and n written without R, G, B. */
static void points_under_way_keep_their_material(void **state)
{
    (void)state;
    golden();
    for (int p = 0; p < GLINT_PIPELINE_COUNT; p++) {
        const glint_specular_config config = {GLINT_GATE_COSINE, (glint_pipeline)p, 1};
        glint_specular_device *device = create(&config);
        const glint_specular_signals *s = glint_specular_device_signals(device);
        glint_specular_inputs in[24] = {{.en = 0}};
        int results[24];
        int count = 0;
        for (int i = 0; i < 24; i++)
            in[i].en = 1;
        in[0] = point(GLINT_COS_ONE);
        write_material(&in[0], 60, 10);
        in[1] = point(GLINT_COS_ONE);
        write_material(&in[1], 60, 20);
        in[2] = point(GLINT_COS_ONE); /* still 20 */
        write_material(&in[3], 60, 30);
        in[4] = point(GLINT_COS_ONE);
        in[5] = point(131072); /* n = 60: outside */
        in[6] = point(131072);
        in[6].n_we = 1;
        in[6].n = 2; /* W = 1/4 of 30: 7.5 */
        in[7] = point(GLINT_COS_ONE);
        in[7].rgb_we = 1;
        in[7].r = 99;
        for (int i = 0; i < 24; i++) {
            glint_specular_device_clock(device, &in[i]);
            if (s->out_valid != 0)
                results[count++] = (int)s->lane[0].out_r;
        }
        static const int expected[] = {10, 20, 20, 30, 0, 8, 99};
        assert_int_equal(count, 7);
        assert_memory_equal(results, expected, sizeof expected);
        glint_specular_device_destroy(device);
    }
}

static void one_result_a_clock(void **state)
{
    (void)state;
    const glint_specular_config config = {GLINT_GATE_COSINE, GLINT_PIPELINE_PIPELINED, 4};
    glint_specular_device *device = create(&config);
    glint_specular_inputs in = {.en = 1, .in_valid = 15};
    for (int clock = 1; clock <= 100; clock++) {
        glint_specular_device_clock(device, &in);
        assert_int_equal(glint_specular_device_signals(device)->out_valid,
                         clock >= GLINT_LATENCY_PIPELINED ? 15 : 0);
    }
    glint_specular_device_destroy(device);
}

/* A register that is not strobed, or whose lane is not valid, holds. */
static void registers_hold_without_their_strobe(void **state)
{
    (void)state;
    const glint_specular_config config = {GLINT_GATE_COSINE, GLINT_PIPELINE_PIPELINED, 2};
    glint_specular_device *device = create(&config);
    const glint_specular_signals *s = glint_specular_device_signals(device);
    glint_specular_inputs in = {.en = 1,
                                .n_we = 1,
                                .n = 7,
                                .rgb_we = 1,
                                .r = 1,
                                .g = 2,
                                .b = 3,
                                .in_valid = 3,
                                .cos = {11, 12}};
    glint_specular_device_clock(device, &in);
    in = (glint_specular_inputs){
        .en = 1, .n = 8, .r = 9, .g = 9, .b = 9, .in_valid = 2, .cos = {21, 22}};
    glint_specular_device_clock(device, &in);
    assert_true(s->reg2 == 7 && s->reg3 == 1 && s->reg4 == 2 && s->reg5 == 3);
    assert_true(s->lane[0].reg1 == 11 && s->lane[1].reg1 == 22 && s->s1_valid == 2);
    glint_specular_device_destroy(device);
}

static void a_stall_freezes_every_signal(void **state)
{
    (void)state;
    for (int i = 0; i < SETTINGS; i++) {
        const glint_specular_config config = setting(i);
        glint_specular_device *device = create(&config);
        const glint_specular_signals *s = glint_specular_device_signals(device);
        unsigned stalls = 0;
        for (int clock = 0; clock < 500; clock++) {
            const glint_specular_signals before = *s;
            glint_specular_inputs in;
            draw_inputs(clock, (uint32_t)s->reg2, &in);
            in.reset = 0;
            in.en = glint_random_chance(&draw, 128);
            glint_specular_device_clock(device, &in);
            if (!in.en) {
                assert_memory_equal(s, &before, sizeof before);
                stalls++;
            }
        }
        assert_true(stalls > 0);
        glint_specular_device_destroy(device);
    }
}

/* Every register 0, and what follows from that; with the clock enable and without. */
static void a_reset_clears_whatever_en_says(void **state)
{
    (void)state;
    for (int i = 0; i < SETTINGS; i++) {
        const glint_specular_config config = setting(i);
        glint_specular_device *fresh = create(&config);
        glint_specular_device *device = create(&config);
        const glint_specular_signals *s = glint_specular_device_signals(device);
        for (int en = 0; en <= 1; en++) {
            glint_specular_inputs in;
            for (int clock = 0; clock < 20; clock++) {
                draw_inputs(clock, (uint32_t)s->reg2, &in);
                in.reset = 0;
                in.en = in.n_we = in.rgb_we = 1;
                in.n |= 1; /* so that register 2 is not 0 beforehand */
                in.in_valid = 0xffff;
                glint_specular_device_clock(device, &in);
            }
            assert_true(s->reg2 != 0 && s->s1_valid != 0 && s->out_valid != 0);
            in.reset = 1;
            in.en = (uint8_t)en;
            glint_specular_device_clock(device, &in);
            assert_memory_equal(s, glint_specular_device_signals(fresh), sizeof *s);
            assert_true(s->reg2 == 0 && s->out_valid == 0 && s->rom33 == 2731);
        }
        glint_specular_device_destroy(device);
        glint_specular_device_destroy(fresh);
    }
}

static void settings_out_of_range_are_refused(void **state)
{
    (void)state;
    static const glint_specular_config bad[] = {
        {GLINT_GATE_COUNT, GLINT_PIPELINE_COMBINATIONAL, 1},
        {(glint_gate)-1, GLINT_PIPELINE_COMBINATIONAL, 1},
        {GLINT_GATE_SIGN, GLINT_PIPELINE_COUNT, 1},
        {GLINT_GATE_SIGN, (glint_pipeline)-1, 1},
        {GLINT_GATE_SIGN, GLINT_PIPELINE_COMBINATIONAL, 0},
        {GLINT_GATE_SIGN, GLINT_PIPELINE_COMBINATIONAL, -1},
        {GLINT_GATE_SIGN, GLINT_PIPELINE_COMBINATIONAL, GLINT_LANES_MAX + 1},
    };
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        int nothing;
        glint_specular_device *device = (glint_specular_device *)(void *)&nothing;
        assert_int_equal(glint_specular_device_create(&bad[i], &device), GLINT_BAD_ARGUMENT);
        assert_null(device);
    }
    glint_specular_device_destroy(NULL);
}

static void names_of_settings(void **state)
{
    (void)state;
    assert_string_equal(glint_gate_name(GLINT_GATE_COSINE), "cosine");
    assert_string_equal(glint_gate_name(GLINT_GATE_SIGN), "sign");
    assert_string_equal(glint_gate_name(GLINT_GATE_DRAWN), "drawn");
    assert_null(glint_gate_name(GLINT_GATE_COUNT));
    assert_null(glint_gate_name((glint_gate)-1));
    assert_string_equal(glint_pipeline_name(GLINT_PIPELINE_COMBINATIONAL), "combinational");
    assert_string_equal(glint_pipeline_name(GLINT_PIPELINE_PIPELINED), "pipelined");
    assert_null(glint_pipeline_name(GLINT_PIPELINE_COUNT));
    assert_null(glint_pipeline_name((glint_pipeline)-1));
}

/* ---- The table of signals ----------------------------------------------------------------------
 */

static bool is_in_figure(int block)
{
    return (block >= 1 && block <= 15) || block == 33;
}

static void every_signal_is_described_once(void **state)
{
    (void)state;
    for (int i = 0; i < SETTINGS; i++) {
        const glint_specular_config config = setting(i);
        const glint_specular_config single = {config.gate, config.pipeline, 1};
        const int count = glint_specular_signal_count(&config);
        bool blocks[34] = {false};
        int last_lane = -1;
        assert_true(count > 0);
        for (int a = 0; a < count; a++) {
            const glint_signal_info info = glint_specular_signal_info(&config, a);
            const int width = info.int_bits + info.frac_bits;
            assert_true(width >= 1 && width <= 63 && info.int_bits >= 1 && info.frac_bits >= 0);
            assert_true(info.block == 0 || is_in_figure(info.block));
            assert_true(info.name[0] != '\0' && info.meaning[0] != '\0');
            assert_true(info.lane == last_lane || info.lane == last_lane + 1);
            assert_true(info.lane < config.lanes);
            last_lane = info.lane;
            blocks[info.block] = true;
            for (int b = 0; b < a; b++) {
                const glint_signal_info other = glint_specular_signal_info(&config, b);
                assert_true(info.lane != other.lane || strcmp(info.name, other.name) != 0);
            }
        }
        assert_int_equal(last_lane, config.lanes - 1);
        for (int block = 1; block < 34; block++)
            assert_int_equal(blocks[block], is_in_figure(block));
        /* Each lane has the same signals. */
        const glint_specular_config two = {config.gate, config.pipeline, 2};
        const int of_a_lane =
            glint_specular_signal_count(&two) - glint_specular_signal_count(&single);
        assert_int_equal(count,
                         glint_specular_signal_count(&single) + (config.lanes - 1) * of_a_lane);
    }
}

/* What the figure and the header of rtl/specular_lane.v say of a signal: its block, its digits
 * before and after the point, whether one of them is a sign. Width 0: a bit a lane. */
typedef struct said {
    const char *name; /* without the prefix of its stage */
    int block, int_bits, frac_bits, is_signed;
} said;

static const said all_said[] = {
    {"valid", 0, 0, 0, 0},    {"out_valid", 0, 0, 0, 0}, {"reg1", 1, 1, 18, 0},
    {"reg2", 2, 10, 0, 0},    {"reg3", 3, 8, 0, 0},      {"reg4", 4, 8, 0, 0},
    {"reg5", 5, 8, 0, 0},     {"rom33", 33, 9, 13, 0},   {"rom9", 9, 1, 18, 0},
    {"adder6", 6, 1, 18, 1},  {"mul7", 7, 10, 18, 1},    {"adder8", 8, 10, 18, 1},
    {"cmp11", 11, 1, 0, 0},   {"mul10", 10, 1, 18, 0},   {"sat10", 10, 1, 18, 0},
    {"keys12", 12, 1, 18, 0}, {"mul13", 13, 8, 0, 0},    {"mul14", 14, 8, 0, 0},
    {"mul15", 15, 8, 0, 0},   {"out_w", 12, 1, 18, 0},   {"out_r", 13, 8, 0, 0},
    {"out_g", 14, 8, 0, 0},   {"out_b", 15, 8, 0, 0},
};

static const said *find_said(const char *name)
{
    const bool has_stage = name[0] == 's' && name[1] >= '1' && name[1] <= '3' && name[2] == '_';
    for (size_t i = 0; i < sizeof all_said / sizeof all_said[0]; i++)
        if (strcmp(all_said[i].name, has_stage ? name + 3 : name) == 0)
            return &all_said[i];
    fail_msg("nothing is said of %s", name);
    return NULL;
}

static glint_signal_kind kind_due(const char *name)
{
    return strncmp(name, "out_", 4) == 0  ? GLINT_SIGNAL_OUTPUT
           : strchr(name, '_') != NULL    ? GLINT_SIGNAL_STAGE
           : strncmp(name, "reg", 3) == 0 ? GLINT_SIGNAL_REGISTER
                                          : GLINT_SIGNAL_BLOCK;
}

/* A report names the block, and shows as a number what the bits stand for. */
static void every_signal_is_what_the_figure_says(void **state)
{
    (void)state;
    golden();
    for (int i = 0; i < SETTINGS; i++) {
        const glint_specular_config config = setting(i);
        for (int a = 0; a < glint_specular_signal_count(&config); a++) {
            const glint_signal_info info = glint_specular_signal_info(&config, a);
            const said *due = find_said(info.name);
            /* With gate drawn the square of any t, down to -340 1/3: below 2^17. */
            const bool is_wide = config.gate == GLINT_GATE_DRAWN && strcmp(info.name, "mul10") == 0;
            const int digits = is_wide ? 17 : due->int_bits == 0 ? config.lanes : due->int_bits;
            if (info.block != due->block || info.int_bits != digits ||
                info.frac_bits != due->frac_bits || info.is_signed != due->is_signed ||
                info.kind != kind_due(info.name)) {
                fail_msg("%s: block %d, kind %d, %c%d.%d", info.name, info.block, (int)info.kind,
                         info.is_signed ? 'S' : 'U', info.int_bits, info.frac_bits);
            }
        }
    }
}

static int find_signal(const glint_specular_config *config, const char *name, int lane)
{
    for (int i = 0; i < glint_specular_signal_count(config); i++) {
        const glint_signal_info info = glint_specular_signal_info(config, i);
        if (info.lane == lane && strcmp(info.name, name) == 0)
            return i;
    }
    fail_msg("no signal %s", name);
    return -1;
}

/* Only its own field gives a signal its bits, and only as many as its width. */
static void assert_reads(const glint_specular_config *config, const char *name, int lane,
                         int64_t *field, const glint_specular_signals *signals)
{
    const int index = find_signal(config, name, lane);
    const glint_signal_info info = glint_specular_signal_info(config, index);
    const uint64_t all = (UINT64_C(1) << (info.int_bits + info.frac_bits)) - 1;
    assert_true(glint_specular_signal_bits(config, signals, index) == 0);
    *field = -1;
    assert_true(glint_specular_signal_bits(config, signals, index) == all);
    *field = (int64_t)(all + 6);
    assert_true(glint_specular_signal_bits(config, signals, index) == (5 & all));
    *field = 0;
}

static void assert_shared_reads(const glint_specular_config *config,
                                glint_specular_signals *signals)
{
#define ASSERT_READS(name, ...) assert_reads(config, #name, -1, &signals->name, signals);
    GLINT_SPECULAR_SHARED_SIGNALS(ASSERT_READS)
#undef ASSERT_READS
}

static void assert_lane_reads(const glint_specular_config *config, glint_specular_signals *signals,
                              int lane)
{
#define ASSERT_READS(name, ...)                                                                    \
    assert_reads(config, #name, lane, &signals->lane[lane].name, signals);
    GLINT_SPECULAR_LANE_SIGNALS(ASSERT_READS)
#undef ASSERT_READS
}

static void bits_are_those_of_the_signal(void **state)
{
    (void)state;
    static glint_specular_signals signals;
    for (int i = 0; i < SETTINGS; i++) {
        const glint_specular_config config = setting(i);
        assert_shared_reads(&config, &signals);
        for (int lane = 0; lane < config.lanes; lane++)
            assert_lane_reads(&config, &signals, lane);
    }
}

static void widths_that_depend_on_the_setting(void **state)
{
    (void)state;
    golden();
    for (int i = 0; i < SETTINGS; i++) {
        const glint_specular_config config = setting(i);
        const glint_signal_info valid =
            glint_specular_signal_info(&config, find_signal(&config, "out_valid", -1));
        const glint_signal_info square =
            glint_specular_signal_info(&config, find_signal(&config, "mul10", 0));
        assert_int_equal(valid.int_bits, config.lanes);
        assert_int_equal(valid.frac_bits, 0);
        assert_int_equal(square.int_bits, config.gate == GLINT_GATE_DRAWN ? 17 : 1);
        assert_int_equal(square.frac_bits, 18);
        assert_int_equal(square.block, 10);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(outputs_are_the_pure_function),
        cmocka_unit_test(latency_is_as_stated),
        cmocka_unit_test(points_under_way_keep_their_material),
        cmocka_unit_test(one_result_a_clock),
        cmocka_unit_test(registers_hold_without_their_strobe),
        cmocka_unit_test(a_stall_freezes_every_signal),
        cmocka_unit_test(a_reset_clears_whatever_en_says),
        cmocka_unit_test(settings_out_of_range_are_refused),
        cmocka_unit_test(names_of_settings),
        cmocka_unit_test(every_signal_is_described_once),
        cmocka_unit_test(every_signal_is_what_the_figure_says),
        cmocka_unit_test(bits_are_those_of_the_signal),
        cmocka_unit_test(widths_that_depend_on_the_setting),
    };
    return cmocka_run_group_tests(tests, seed_draw, NULL);
}
