/* Both forms of the divider clock by clock: inputs come out on time and as the pure function says,
 * checked against a contract written here; clock enable, reset, and the table of signals. */
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "../seed.h"
#include "circuit/random.h"
#include "glint_divider_device.h"

enum { N_FIRST = 6, N_LAST = 16, K_TABLE = 16, D_MAX = 255, CLOCKS = 8000 };

static glint_random draw;

static int seed_draw(void **state)
{
    (void)state;
    draw.state = seed_of_this_run();
    return 0;
}

static glint_divider_device *create(glint_divider_form form, int n)
{
    glint_divider_device *device;
    assert_int_equal(glint_divider_device_create(form, n, &device), GLINT_OK);
    assert_non_null(device);
    assert_int_equal(glint_divider_device_shifts(device), n);
    return device;
}

static int32_t divide(int n, int difference, uint32_t k)
{
    int32_t code;
    bool out_of_table;
    assert_int_equal(glint_divide(n, difference, k, &code, &out_of_table), GLINT_OK);
    assert_int_equal(out_of_table, k == 0 || k > K_TABLE);
    return code;
}

static bool is_miss(uint32_t k)
{
    return k == 0 || k > K_TABLE;
}

/* The mix changes every so many clocks: dense, sparse, stalling, beyond the table. Independent of
 * sim/lockstep's stimulus. */
static void draw_inputs(int clock, glint_divider_inputs *in)
{
    static const uint32_t chances[] = {0, 20, 128, 230, 256};
    static uint32_t start, stall, miss;
    if (clock % 100 == 0) {
        start = chances[1 + glint_random_below(&draw, 4)];
        stall = chances[glint_random_below(&draw, 4)];
        miss = chances[glint_random_below(&draw, 4)];
    }
    memset(in, 0, sizeof *in);
    in->reset = glint_random_chance(&draw, 2);
    in->en = !glint_random_chance(&draw, stall);
    in->start = glint_random_chance(&draw, start);
    in->k = glint_random_chance(&draw, miss) ? (uint8_t)glint_random_bits(&draw)
                                             : (uint8_t)(1 + glint_random_below(&draw, K_TABLE));
    for (int c = 0; c < GLINT_DIVIDER_COMPONENTS; c++)
        in->difference[c] = (int16_t)((int)glint_random_below(&draw, 2 * D_MAX + 1) - D_MAX);
}

/* ---- The sequential form ------------------------------------------------------------------------
 */

/* What its header promises, and how often each case occurred. */
typedef struct contract {
    int n;
    int left; /* enabled clocks until done; 0: not busy */
    bool done, out_of_table;
    bool known; /* the quotient is stable: nothing was started since it came out */
    int32_t quotient, coming;
    unsigned divisions, ignored, with_done, held, stalled_busy, stalled_done, reset_busy, misses;
} contract;

static void expect_reset(contract *c)
{
    c->reset_busy += c->left > 0;
    c->left = 0;
    c->done = c->out_of_table = false;
    c->known = true;
    c->quotient = 0;
}

static void expect_start(contract *c, const glint_divider_inputs *in)
{
    c->with_done += c->done;
    c->coming = divide(c->n, in->difference[0], in->k);
    c->out_of_table = is_miss(in->k);
    c->misses += c->out_of_table;
    c->left = c->n;
    c->known = false;
}

static void expect_sequential(contract *c, const glint_divider_inputs *in)
{
    if (in->reset) {
        expect_reset(c);
    } else if (!in->en) {
        c->stalled_busy += c->left > 0;
        c->stalled_done += c->done;
    } else if (c->left > 0) {
        c->ignored += in->start;
        c->done = --c->left == 0;
        if (c->done) {
            c->known = true;
            c->quotient = c->coming;
            c->divisions++;
        }
    } else {
        c->held += c->known && !c->done && !in->start;
        if (in->start)
            expect_start(c, in);
        c->done = false;
    }
}

static void the_sequential_form_keeps_its_contract(void **state)
{
    (void)state;
    unsigned divisions = 0;
    for (int n = N_FIRST; n <= N_LAST; n++) {
        contract c = {.n = n, .known = true};
        glint_divider_device *device = create(GLINT_DIVIDER_SEQUENTIAL, n);
        const glint_divider_sequential_signals *s = glint_divider_device_sequential(device);
        assert_null(glint_divider_device_pipelined(device));
        for (int clock = 0; clock < CLOCKS; clock++) {
            glint_divider_inputs in;
            draw_inputs(clock, &in);
            expect_sequential(&c, &in);
            glint_divider_device_clock(device, &in);
            assert_int_equal(s->busy, c.left > 0);
            assert_int_equal(s->done, c.done);
            assert_int_equal(s->out_of_table, c.out_of_table);
            if (c.known)
                assert_int_equal(s->quotient, c.quotient);
        }
        glint_divider_device_destroy(device);
        assert_true(c.divisions > 100 && c.ignored > 0 && c.with_done > 0 && c.held > 0);
        assert_true(c.stalled_busy > 0 && c.stalled_done > 0 && c.reset_busy > 0 && c.misses > 0);
        divisions += c.divisions;
    }
    print_message("%u divisions\n", divisions);
}

/* One division by hand, 255/7 with n = 6: after the edge that takes the start, and after each of
 * the six that follow. 1/7 is 001001 in binary. */
static void a_division_step_by_step(void **state)
{
    (void)state;
    static const int shift_registers[] = {16320, 8160, 4080, 2040, 1020, 510, 255};
    static const int sums[] = {0, 0, 0, 2040, 2040, 2040, 2295};
    static const int bits[] = {9, 18, 36, 8, 16, 32, 0};
    glint_divider_device *device = create(GLINT_DIVIDER_SEQUENTIAL, 6);
    const glint_divider_sequential_signals *s = glint_divider_device_sequential(device);
    glint_divider_inputs in = {.en = 1, .start = 1, .k = 7, .difference = {255, 1, 2}};
    for (int edge = 0; edge <= 6; edge++) {
        glint_divider_device_clock(device, &in);
        in = (glint_divider_inputs){.en = 1, .k = 3, .difference = {-9}};
        assert_int_equal(s->shift_rg, shift_registers[edge]);
        assert_int_equal(s->acc_rg, sums[edge]);
        assert_int_equal(s->bits_rg, bits[edge]);
        assert_int_equal(s->left, 6 - edge);
        assert_int_equal(s->busy, edge < 6);
        assert_int_equal(s->done, edge == 6);
    }
    assert_int_equal(s->quotient, 255 * 9);
    glint_divider_device_destroy(device);
}

/* Start held at 1: a division every n + 1 clocks, each started in the clock of the last one's
 * done. */
static void divisions_follow_each_other_without_a_gap(void **state)
{
    (void)state;
    for (int n = N_FIRST; n <= N_LAST; n++) {
        glint_divider_device *device = create(GLINT_DIVIDER_SEQUENTIAL, n);
        const glint_divider_sequential_signals *s = glint_divider_device_sequential(device);
        for (int clock = 1; clock <= 20 * (n + 1); clock++) {
            const glint_divider_inputs in = {
                .en = 1, .start = 1, .k = (uint8_t)(1 + clock % 16), .difference = {-200}};
            glint_divider_device_clock(device, &in);
            assert_int_equal(s->done, clock % (n + 1) == 0);
            if (s->done)
                assert_int_equal(s->quotient, divide(n, -200, 1u + (uint32_t)(clock - n) % 16));
        }
        glint_divider_device_destroy(device);
    }
}

/* ---- The pipelined form -------------------------------------------------------------------------
 */

typedef struct expectation {
    bool valid, out_of_table;
    int32_t code[GLINT_DIVIDER_COMPONENTS];
} expectation;

typedef struct pipeline {
    int n;
    expectation stage[N_LAST + 1]; /* 0: the input registers */
    unsigned divisions, bubbles, stalled, lost_in_reset, misses;
} pipeline;

static void expect_pipelined(pipeline *p, const glint_divider_inputs *in)
{
    if (in->reset) {
        for (int j = 0; j <= p->n; j++)
            p->lost_in_reset += p->stage[j].valid;
        memset(p->stage, 0, sizeof p->stage);
        return;
    }
    if (!in->en) {
        p->stalled++;
        return;
    }
    memmove(&p->stage[1], &p->stage[0], (size_t)p->n * sizeof p->stage[0]);
    p->stage[0] = (expectation){.valid = in->start, .out_of_table = is_miss(in->k)};
    for (int c = 0; in->start && c < GLINT_DIVIDER_COMPONENTS; c++)
        p->stage[0].code[c] = divide(p->n, in->difference[c], in->k);
    p->divisions += in->start;
    p->bubbles += !in->start;
    p->misses += in->start && p->stage[0].out_of_table;
}

static void the_pipelined_form_keeps_its_contract(void **state)
{
    (void)state;
    unsigned divisions = 0;
    for (int n = N_FIRST; n <= N_LAST; n++) {
        pipeline p = {.n = n};
        glint_divider_device *device = create(GLINT_DIVIDER_PIPELINED, n);
        const glint_divider_pipelined_signals *s = glint_divider_device_pipelined(device);
        assert_null(glint_divider_device_sequential(device));
        for (int clock = 0; clock < CLOCKS; clock++) {
            glint_divider_inputs in;
            draw_inputs(clock, &in);
            expect_pipelined(&p, &in);
            glint_divider_device_clock(device, &in);
            const expectation *out = &p.stage[n];
            assert_int_equal(s->out_valid, out->valid);
            if (out->valid) {
                assert_int_equal(s->out_of_table, out->out_of_table);
                assert_int_equal(s->quotient_r, out->code[0]);
                assert_int_equal(s->quotient_g, out->code[1]);
                assert_int_equal(s->quotient_b, out->code[2]);
            }
        }
        glint_divider_device_destroy(device);
        assert_true(p.divisions > 0 && p.bubbles > 0 && p.stalled > 0 && p.lost_in_reset > 0 &&
                    p.misses > 0);
        divisions += p.divisions;
    }
    print_message("%u divisions of three components\n", divisions);
}

/* ---- Both forms ---------------------------------------------------------------------------------
 */

/* Clocks from the edge that takes a division, counted, until its quotient is out. */
static int clocks_until_out(glint_divider_form form, int n)
{
    glint_divider_device *device = create(form, n);
    glint_divider_inputs in = {.en = 1, .start = 1, .k = 5, .difference = {-77, 0, 77}};
    int clocks = 0;
    bool out = false;
    while (!out && clocks < 100) {
        glint_divider_device_clock(device, &in);
        in.start = 0;
        clocks++;
        out = form == GLINT_DIVIDER_SEQUENTIAL
                  ? glint_divider_device_sequential(device)->done != 0
                  : glint_divider_device_pipelined(device)->out_valid != 0;
    }
    glint_divider_device_destroy(device);
    return clocks;
}

static void latency_is_as_stated(void **state)
{
    (void)state;
    for (int n = N_FIRST; n <= N_LAST; n++) {
        assert_int_equal(glint_divider_latency(n), n + 1);
        assert_int_equal(clocks_until_out(GLINT_DIVIDER_SEQUENTIAL, n), n + 1);
        assert_int_equal(clocks_until_out(GLINT_DIVIDER_PIPELINED, n), n + 1);
    }
}

/* Every difference by every k of the table, 0 and one beyond, through both. The pipelined form's
 * three components differ from each other, and each is compared. */
static uint64_t compare_forms(int n, uint32_t k, glint_divider_device *sequential,
                              glint_divider_device *pipelined)
{
    const glint_divider_sequential_signals *one = glint_divider_device_sequential(sequential);
    const glint_divider_pipelined_signals *all = glint_divider_device_pipelined(pipelined);
    uint64_t compared = 0;
    for (int d = -D_MAX; d <= D_MAX; d++) {
        const int16_t other = (int16_t)(d == D_MAX ? -D_MAX : d + 1);
        glint_divider_inputs in = {.en = 1, .start = 1, .k = (uint8_t)k};
        in.difference[0] = (int16_t)d;
        in.difference[1] = (int16_t)-d;
        in.difference[2] = other;
        for (int clock = 0; clock < glint_divider_latency(n); clock++) {
            glint_divider_device_clock(sequential, &in);
            glint_divider_device_clock(pipelined, &in);
            in.start = 0;
        }
        assert_true(one->done && all->out_valid);
        assert_true(one->quotient == all->quotient_r && one->out_of_table == all->out_of_table);
        assert_true(-one->quotient == all->quotient_g);
        assert_true(all->quotient_b == divide(n, other, k));
        compared++;
    }
    return compared;
}

static void the_forms_are_equal(void **state)
{
    (void)state;
    uint64_t compared = 0;
    for (int n = N_FIRST; n <= N_LAST; n++) {
        glint_divider_device *sequential = create(GLINT_DIVIDER_SEQUENTIAL, n);
        glint_divider_device *pipelined = create(GLINT_DIVIDER_PIPELINED, n);
        for (uint32_t k = 0; k <= K_TABLE + 1; k++)
            compared += compare_forms(n, k, sequential, pipelined);
        glint_divider_device_destroy(sequential);
        glint_divider_device_destroy(pipelined);
    }
    print_message("%" PRIu64 " divisions in both forms\n", compared);
    assert_true(compared == 11 * 18 * 511);
}

/* All bits of all signals. */
enum { SIGNALS_MAX = 256 };

static void read_all(const glint_divider_device *device, glint_divider_form form,
                     uint64_t bits[SIGNALS_MAX])
{
    const int count = glint_divider_signal_count(form, glint_divider_device_shifts(device));
    assert_in_range(count, 1, SIGNALS_MAX);
    memset(bits, 0, SIGNALS_MAX * sizeof bits[0]);
    for (int i = 0; i < count; i++)
        bits[i] = glint_divider_signal_bits(device, i);
}

/* In the sequential form the table hangs on the pin k: it follows that, stalled or not. */
static bool follows_a_pin(glint_divider_form form, const char *name)
{
    return form == GLINT_DIVIDER_SEQUENTIAL && strncmp(name, "rom_", 4) == 0;
}

static void assert_frozen(glint_divider_form form, int n, const uint64_t *before,
                          const uint64_t *after)
{
    for (int i = 0; i < glint_divider_signal_count(form, n); i++) {
        const glint_signal_info info = glint_divider_signal_info(form, n, i);
        if (before[i] != after[i] && !follows_a_pin(form, info.name)) {
            fail_msg("%s, n = %d: a stall moves %s (stage %d)", glint_divider_form_name(form), n,
                     info.name, info.lane);
        }
    }
}

static void a_stall_freezes_every_signal(void **state)
{
    (void)state;
    for (int f = 0; f < GLINT_DIVIDER_FORM_COUNT; f++) {
        for (int n = N_FIRST; n <= N_LAST; n++) {
            const glint_divider_form form = (glint_divider_form)f;
            glint_divider_device *device = create(form, n);
            unsigned stalls = 0;
            for (int clock = 0; clock < 1000; clock++) {
                uint64_t before[SIGNALS_MAX];
                uint64_t after[SIGNALS_MAX];
                glint_divider_inputs in;
                draw_inputs(clock, &in);
                in.reset = 0;
                in.en = glint_random_chance(&draw, 128);
                read_all(device, form, before);
                glint_divider_device_clock(device, &in);
                read_all(device, form, after);
                if (!in.en) {
                    assert_frozen(form, n, before, after);
                    stalls++;
                }
                if (form == GLINT_DIVIDER_SEQUENTIAL) {
                    const glint_divider_sequential_signals *s =
                        glint_divider_device_sequential(device);
                    assert_int_equal(s->rom_bits, glint_divider_bits(n, in.k));
                    assert_int_equal(s->rom_miss, is_miss(in.k));
                }
            }
            assert_true(stalls > 300);
            glint_divider_device_destroy(device);
        }
    }
}

/* As new, with the clock enable and without, with a start at the pins and without. */
static void a_reset_clears_whatever_en_says(void **state)
{
    (void)state;
    for (int f = 0; f < GLINT_DIVIDER_FORM_COUNT; f++) {
        for (int n = N_FIRST; n <= N_LAST; n++) {
            const glint_divider_form form = (glint_divider_form)f;
            glint_divider_device *fresh = create(form, n);
            glint_divider_device *device = create(form, n);
            for (int round = 0; round < 8; round++) {
                uint64_t expected[SIGNALS_MAX];
                uint64_t found[SIGNALS_MAX];
                /* A division is out, the next one under way. */
                for (int clock = 0; clock < n + 3; clock++) {
                    const glint_divider_inputs in = {
                        .en = 1, .start = 1, .k = 3, .difference = {-255, 255, 100}};
                    glint_divider_device_clock(device, &in);
                }
                const glint_divider_inputs reset = {
                    .reset = 1, .en = round & 1, .start = round >> 1 & 1, .difference = {9, 9, 9}};
                read_all(fresh, form, expected);
                read_all(device, form, found);
                assert_memory_not_equal(found, expected, sizeof found);
                glint_divider_device_clock(device, &reset);
                read_all(device, form, found);
                assert_memory_equal(found, expected, sizeof found);
            }
            glint_divider_device_destroy(device);
            glint_divider_device_destroy(fresh);
        }
    }
}

static void settings_out_of_range_are_refused(void **state)
{
    (void)state;
    static const struct {
        int form, shifts;
    } bad[] = {{GLINT_DIVIDER_SEQUENTIAL, 5},  {GLINT_DIVIDER_PIPELINED, 5},
               {GLINT_DIVIDER_SEQUENTIAL, 17}, {GLINT_DIVIDER_PIPELINED, 17},
               {GLINT_DIVIDER_PIPELINED, 0},   {GLINT_DIVIDER_PIPELINED, -1},
               {GLINT_DIVIDER_FORM_COUNT, 12}, {-1, 12}};
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        int nothing;
        glint_divider_device *device = (glint_divider_device *)(void *)&nothing;
        assert_int_equal(
            glint_divider_device_create((glint_divider_form)bad[i].form, bad[i].shifts, &device),
            GLINT_BAD_ARGUMENT);
        assert_null(device);
    }
    glint_divider_device_destroy(NULL);
}

static void names_of_forms(void **state)
{
    (void)state;
    assert_string_equal(glint_divider_form_name(GLINT_DIVIDER_SEQUENTIAL), "sequential");
    assert_string_equal(glint_divider_form_name(GLINT_DIVIDER_PIPELINED), "pipelined");
    assert_null(glint_divider_form_name(GLINT_DIVIDER_FORM_COUNT));
    assert_null(glint_divider_form_name((glint_divider_form)-1));
}

/* ---- The table of signals -----------------------------------------------------------------------
 */

static int width_due(const char *name, int n)
{
    static const char *const single[] = {"busy",     "rom_miss",  "done",  "out_of_table",
                                         "s0_valid", "out_valid", "valid", "miss"};
    for (size_t i = 0; i < sizeof single / sizeof single[0]; i++)
        if (strcmp(name, single[i]) == 0)
            return 1;
    if (strcmp(name, "left") == 0)
        return 5;
    if (strcmp(name, "s0_k") == 0)
        return 8;
    if (strcmp(name, "bits_rg") == 0)
        return n;
    if (strcmp(name, "rom_bits") == 0 || strcmp(name, "bits") == 0)
        return n + 1;
    return strstr(name, "d_") != NULL ? 9 : 9 + n;
}

/* Differences and their sums are signed; shifted and summed values have n fraction digits. */
static bool is_difference(const char *name)
{
    return strstr(name, "d_r") != NULL || strstr(name, "d_g") != NULL ||
           strstr(name, "d_b") != NULL;
}

static bool is_sum(const char *name)
{
    static const char *const sums[] = {"shift_rg", "shifted", "term", "sum", "acc_", "quotient"};
    for (size_t i = 0; i < sizeof sums / sizeof sums[0]; i++)
        if (strncmp(name, sums[i], strlen(sums[i])) == 0)
            return true;
    return false;
}

static glint_signal_kind kind_due(const glint_signal_info *info)
{
    static const char *const outputs[] = {"done", "out_", "quotient"};
    static const char *const blocks[] = {"rom_", "shifted", "term", "sum"};
    for (size_t i = 0; i < sizeof outputs / sizeof outputs[0]; i++)
        if (strncmp(info->name, outputs[i], strlen(outputs[i])) == 0)
            return GLINT_SIGNAL_OUTPUT;
    for (size_t i = 0; i < sizeof blocks / sizeof blocks[0]; i++)
        if (strncmp(info->name, blocks[i], strlen(blocks[i])) == 0)
            return GLINT_SIGNAL_BLOCK;
    return info->lane > 0 ? GLINT_SIGNAL_STAGE : GLINT_SIGNAL_REGISTER;
}

static void every_signal_is_the_number_it_stands_for(void **state)
{
    (void)state;
    for (int f = 0; f < GLINT_DIVIDER_FORM_COUNT; f++) {
        for (int n = N_FIRST; n <= N_LAST; n++) {
            for (int a = 0; a < glint_divider_signal_count((glint_divider_form)f, n); a++) {
                const glint_signal_info info =
                    glint_divider_signal_info((glint_divider_form)f, n, a);
                if (info.frac_bits != (is_sum(info.name) ? n : 0) ||
                    info.is_signed != (is_sum(info.name) || is_difference(info.name)) ||
                    info.kind != kind_due(&info)) {
                    fail_msg("%s: kind %d, %c%d.%d", info.name, (int)info.kind,
                             info.is_signed ? 'S' : 'U', info.int_bits, info.frac_bits);
                }
            }
        }
    }
}

static void every_signal_is_described_once(void **state)
{
    (void)state;
    for (int f = 0; f < GLINT_DIVIDER_FORM_COUNT; f++) {
        for (int n = N_FIRST; n <= N_LAST; n++) {
            const glint_divider_form form = (glint_divider_form)f;
            const int count = glint_divider_signal_count(form, n);
            int last_stage = -1;
            assert_int_equal(count, form == GLINT_DIVIDER_SEQUENTIAL ? 13 : 12 + 9 * n);
            for (int a = 0; a < count; a++) {
                const glint_signal_info info = glint_divider_signal_info(form, n, a);
                assert_int_equal(info.int_bits + info.frac_bits, width_due(info.name, n));
                assert_true(info.int_bits >= 1 && (info.frac_bits == 0 || info.frac_bits == n));
                assert_true(info.meaning[0] != '\0' && info.block == 0);
                assert_true(info.lane == last_stage || info.lane == last_stage + 1 ||
                            (last_stage == -1 && info.lane == 1));
                last_stage = info.lane;
                for (int b = 0; b < a; b++) {
                    const glint_signal_info other = glint_divider_signal_info(form, n, b);
                    assert_true(info.lane != other.lane || strcmp(info.name, other.name) != 0);
                }
            }
            assert_int_equal(last_stage, form == GLINT_DIVIDER_SEQUENTIAL ? -1 : n);
        }
    }
}

/* The bits of a signal are those of the field of its name, as many as its width. */
static void assert_bits(const glint_divider_device *device, glint_divider_form form, int index,
                        const char *name, int64_t value)
{
    const glint_signal_info info =
        glint_divider_signal_info(form, glint_divider_device_shifts(device), index);
    const uint64_t mask = (UINT64_C(1) << (info.int_bits + info.frac_bits)) - 1;
    assert_string_equal(info.name, name);
    assert_true(glint_divider_signal_bits(device, index) == ((uint64_t)value & mask));
}

/* Each asserts the bits of some signals, of which the first is number `index`; the number after
 * them. */
static int assert_sequential_bits(const glint_divider_device *device)
{
    const glint_divider_sequential_signals *s = glint_divider_device_sequential(device);
    int index = 0;
#define ASSERT_SIGNAL(name, ...)                                                                   \
    assert_bits(device, GLINT_DIVIDER_SEQUENTIAL, index++, #name, s->name);
    GLINT_DIVIDER_SEQUENTIAL_SIGNALS(ASSERT_SIGNAL)
#undef ASSERT_SIGNAL
    return index;
}

static int assert_stage_bits(const glint_divider_device *device, int index, int stage)
{
    const glint_divider_pipelined_signals *p = glint_divider_device_pipelined(device);
#define ASSERT_SIGNAL(name, ...)                                                                   \
    assert_bits(device, GLINT_DIVIDER_PIPELINED, index++, #name, p->stage[stage].name);
    GLINT_DIVIDER_STAGE_SIGNALS(ASSERT_SIGNAL)
#undef ASSERT_SIGNAL
    return index;
}

static int assert_pipelined_bits(const glint_divider_device *device)
{
    const glint_divider_pipelined_signals *p = glint_divider_device_pipelined(device);
    int index = 0;
#define ASSERT_SIGNAL(name, ...)                                                                   \
    assert_bits(device, GLINT_DIVIDER_PIPELINED, index++, #name, p->name);
    GLINT_DIVIDER_PIPELINED_SIGNALS(ASSERT_SIGNAL)
#undef ASSERT_SIGNAL
    for (int stage = 1; stage <= glint_divider_device_shifts(device); stage++)
        index = assert_stage_bits(device, index, stage);
    return index;
}

static void assert_all_bits(const glint_divider_device *device, glint_divider_form form, int n)
{
    const int count = form == GLINT_DIVIDER_SEQUENTIAL ? assert_sequential_bits(device)
                                                       : assert_pipelined_bits(device);
    assert_int_equal(count, glint_divider_signal_count(form, n));
}

static void bits_are_those_of_the_signal(void **state)
{
    (void)state;
    for (int f = 0; f < GLINT_DIVIDER_FORM_COUNT; f++) {
        for (int n = N_FIRST; n <= N_LAST; n++) {
            const glint_divider_form form = (glint_divider_form)f;
            glint_divider_device *device = create(form, n);
            for (int clock = 0; clock < 300; clock++) {
                glint_divider_inputs in;
                draw_inputs(clock, &in);
                glint_divider_device_clock(device, &in);
                assert_all_bits(device, form, n);
            }
            glint_divider_device_destroy(device);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_sequential_form_keeps_its_contract),
        cmocka_unit_test(a_division_step_by_step),
        cmocka_unit_test(divisions_follow_each_other_without_a_gap),
        cmocka_unit_test(the_pipelined_form_keeps_its_contract),
        cmocka_unit_test(latency_is_as_stated),
        cmocka_unit_test(the_forms_are_equal),
        cmocka_unit_test(a_stall_freezes_every_signal),
        cmocka_unit_test(a_reset_clears_whatever_en_says),
        cmocka_unit_test(settings_out_of_range_are_refused),
        cmocka_unit_test(names_of_forms),
        cmocka_unit_test(every_signal_is_described_once),
        cmocka_unit_test(every_signal_is_the_number_it_stands_for),
        cmocka_unit_test(bits_are_those_of_the_signal),
    };
    return cmocka_run_group_tests(tests, seed_draw, NULL);
}
