/* Random pins: of the thesis's circuits the same as ever, for each seed; of any other circuit what
 * its pins are for, and everything that is worth trying. */
#define _XOPEN_SOURCE 700

#include <inttypes.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "../seed.h"
#include "circuit/circuits.h"
#include "circuit/random_pins.h"
#include "circuit/words.h"
#include "glint_describe.h"

static uint64_t seed;

static int choose_seed(void **state)
{
    (void)state;
    seed = seed_of_this_run();
    return 0;
}

/* ---- The thesis's circuits --------------------------------------------------------------------
 */

/* FNV-1a over the values of all pins. */
static uint64_t digest_of(const glint_setting *setting, uint64_t of_seed)
{
    const glint_circuit *circuit = setting->circuit;
    glint_random_pins source;
    uint64_t digest = UINT64_C(0xcbf29ce484222325);
    glint_random_pins_begin(&source, setting, of_seed);
    for (int clock = 0; clock < 2000; clock++) {
        glint_pins pins;
        glint_random_pins_next(&source, &pins);
        for (int i = 0; i < circuit->pin_count(setting->values); i++) {
            const glint_pin_info pin = circuit->pin(setting->values, i);
            uint64_t value;
            glint_pin_get(&pin, &pins, &value);
            digest = (digest ^ value) * UINT64_C(0x100000001b3);
        }
    }
    return digest;
}

/* What a seed gave is in packets, reports and people's notes. */
static void a_seed_gives_the_pins_that_it_always_gave(void **state)
{
    (void)state;
    const glint_specular_config lanes_1 = {GLINT_GATE_COSINE, GLINT_PIPELINE_PIPELINED, 1};
    const glint_specular_config lanes_16 = {GLINT_GATE_DRAWN, GLINT_PIPELINE_COMBINATIONAL, 16};
    const struct {
        glint_setting setting;
        uint64_t seed, digest;
    } known[] = {
        {glint_setting_specular(&lanes_1), 1, UINT64_C(0xa98f2200b65a6ee0)},
        {glint_setting_specular(&lanes_16), 1, UINT64_C(0xec292162838ba72a)},
        {glint_setting_divider(GLINT_DIVIDER_SEQUENTIAL, 12), 1, UINT64_C(0xe950059da62e1c03)},
        {glint_setting_divider(GLINT_DIVIDER_PIPELINED, 16), 1, UINT64_C(0x6c1c16c97cd54b22)},
        {glint_setting_specular(&lanes_1), 2, UINT64_C(0x5f004e5387026424)},
        {glint_setting_specular(&lanes_16), 2, UINT64_C(0x829ad1c1431ccbe2)},
        {glint_setting_divider(GLINT_DIVIDER_SEQUENTIAL, 12), 2, UINT64_C(0xa7d8fc1a395ed74e)},
        {glint_setting_divider(GLINT_DIVIDER_PIPELINED, 16), 2, UINT64_C(0x9b867204933c2e42)},
    };
    for (size_t i = 0; i < sizeof known / sizeof known[0]; i++) {
        char text[GLINT_SETTING_TEXT];
        const uint64_t digest = digest_of(&known[i].setting, known[i].seed);
        glint_setting_describe(&known[i].setting, text);
        if (digest != known[i].digest)
            fail_msg("%s, seed %" PRIu64 ": 0x%016" PRIx64, text, known[i].seed, digest);
    }
}

/* ---- A circuit without a stimulus -------------------------------------------------------------
 */

enum { NARROW = 9, WIDE = 100, BITS = 5, CLOCKS = 200000 };

typedef struct pins_of_all {
    uint8_t reset, reset_n, en, in_valid, lanes_valid, we, flag;
    int16_t narrow;
    uint64_t wide[2];
    uint32_t plain;
} pins_of_all;

GLINT_PIN_TABLE(pin, GLINT_PIN(pins_of_all, reset, RESET, 1, 0, 0, ""),
                GLINT_PIN(pins_of_all, reset_n, RESET_LOW, 1, 0, 0, ""),
                GLINT_PIN(pins_of_all, en, ENABLE, 1, 0, 0, ""),
                GLINT_PIN(pins_of_all, in_valid, VALID, 1, 0, 0, ""),
                GLINT_PIN(pins_of_all, lanes_valid, VALID, BITS, 0, 0, ""),
                GLINT_PIN(pins_of_all, we, STROBE, 1, 0, 0, ""),
                GLINT_PIN(pins_of_all, flag, DATA, 1, 0, 0, ""),
                GLINT_PIN(pins_of_all, narrow, DATA, 1, NARROW - 1, 1, ""),
                GLINT_PIN(pins_of_all, wide, DATA, WIDE, 0, 1, ""),
                GLINT_PIN(pins_of_all, plain, DATA, 20, 0, 0, ""))

static const glint_circuit circuit = {.name = "all", GLINT_PINS(pins_of_all, pin)};
static const glint_setting setting = {.circuit = &circuit};

static void each_seed_has_its_pins(void **state)
{
    (void)state;
    glint_random_pins a, b, other;
    bool differs = false;
    glint_random_pins_begin(&a, &setting, seed);
    glint_random_pins_begin(&b, &setting, seed);
    glint_random_pins_begin(&other, &setting, seed + 1);
    for (int clock = 0; clock < 5000; clock++) {
        glint_pins of_a, of_b, of_other;
        memset(&of_a, 0x11, sizeof of_a); /* what was there before does not matter */
        memset(&of_b, 0x22, sizeof of_b);
        glint_random_pins_next(&a, &of_a);
        glint_random_pins_next(&b, &of_b);
        glint_random_pins_next(&other, &of_other);
        assert_memory_equal(&of_a, &of_b, sizeof(pins_of_all));
        differs |= memcmp(&of_a, &of_other, sizeof(pins_of_all)) != 0;
    }
    assert_true(differs);
}

/* A stimulus that relies on zeros: in a state that it does not set, and in pins that it leaves. */
static void begin_with_zeros(void *stimulus, const int *values, uint64_t of_seed)
{
    (void)stimulus;
    (void)values;
    (void)of_seed;
}

static void next_of_some(void *stimulus, void *pins)
{
    uint8_t *clocks = stimulus;
    pins_of_all *in = pins;
    if (++*clocks % 2 == 0)
        in->plain = *clocks;
}

static void a_stimulus_begins_with_zeros_and_so_do_its_pins(void **state)
{
    (void)state;
    const glint_circuit own = {.name = "own",
                               GLINT_PINS(pins_of_all, pin),
                               .stimulus_size = 1,
                               .stimulus_begin = begin_with_zeros,
                               .stimulus_next = next_of_some};
    const glint_setting of_own = {.circuit = &own};
    glint_random_pins source;
    glint_pins pins;
    pins_of_all expected;
    memset(&source, 0x33, sizeof source);
    memset(&pins, 0x44, sizeof pins);
    memset(&expected, 0, sizeof expected);
    glint_random_pins_begin(&source, &of_own, seed);
    for (uint8_t clock = 1; clock < 10; clock++) {
        expected.plain = clock % 2 == 0 ? clock : 0;
        glint_random_pins_next(&source, &pins);
        assert_memory_equal(pins.bytes, &expected, sizeof expected);
    }
}

/* The longest run of clocks in which it held. */
typedef struct run {
    int now, longest;
} run;

static void count(run *run, bool holds)
{
    run->now = holds ? run->now + 1 : 0;
    run->longest = run->now > run->longest ? run->now : run->longest;
}

static void controls_do_what_they_are_for(void **state)
{
    (void)state;
    glint_random_pins source;
    run stall = {0, 0}, no_reset = {0, 0}, taken = {0, 0}, idle = {0, 0}, written = {0, 0};
    run unwritten = {0, 0};
    int resets = 0, gaps = 0;
    bool pattern[1 << BITS] = {false};
    glint_random_pins_begin(&source, &setting, seed);
    for (int clock = 0; clock < CLOCKS; clock++) {
        glint_pins pins;
        pins_of_all in;
        glint_random_pins_next(&source, &pins);
        memcpy(&in, pins.bytes, sizeof in);
        assert_true(in.reset <= 1 && in.reset_n == !in.reset && in.en <= 1 && in.in_valid <= 1);
        assert_true(in.we <= 1 && in.lanes_valid < 1 << BITS);
        resets += in.reset;
        gaps += !in.in_valid;
        pattern[in.lanes_valid] = true;
        count(&stall, !in.en);
        count(&no_reset, !in.reset);
        count(&taken, in.in_valid);
        count(&idle, !in.in_valid);
        count(&written, in.we);
        count(&unwritten, !in.we);
    }
    assert_true(resets > 50 && gaps > CLOCKS / 50 && gaps < CLOCKS * 49 / 50);
    assert_true(stall.longest >= 64 && no_reset.longest >= 1 << 16);
    assert_true(taken.longest >= 100 && idle.longest >= 50);
    assert_true(written.longest >= 50 && unwritten.longest >= 100);
    for (int i = 0; i < 1 << BITS; i++)
        assert_true(pattern[i]);
}

/* ---- Data -------------------------------------------------------------------------------------
 */

static void every_value_of_a_narrow_pin_comes_up(void **state)
{
    (void)state;
    glint_random_pins source;
    bool seen[1 << NARROW] = {false}, flag[2] = {false, false};
    int ends = 0;
    glint_random_pins_begin(&source, &setting, seed);
    for (int clock = 0; clock < CLOCKS; clock++) {
        glint_pins pins;
        pins_of_all in;
        glint_random_pins_next(&source, &pins);
        memcpy(&in, pins.bytes, sizeof in);
        assert_in_range(in.narrow + 256, 0, 511); /* its sign fills the integer */
        assert_true(in.flag <= 1 && in.plain < 1u << 20);
        seen[in.narrow + 256] = true;
        flag[in.flag] = true;
        ends += in.narrow == -256 || in.narrow == 255;
    }
    for (int i = 0; i < 1 << NARROW; i++)
        assert_true(seen[i]);
    assert_true(flag[0] && flag[1]);
    assert_true(ends > CLOCKS / 50); /* of evenly random ones there were 1 in 256 */
}

/* -1 for a value that has not just one bit that is `value`. */
static int lonely_bit(const uint64_t *words, bool value)
{
    int found = -1;
    for (int i = 0; i < WIDE; i++)
        if (((words[i / 64] >> i % 64 & 1u) != 0) == value) {
            if (found >= 0)
                return -1;
            found = i;
        }
    return found;
}

static void the_corners_of_a_wide_pin_come_up(void **state)
{
    (void)state;
    static const uint64_t top = UINT64_C(1) << (WIDE - 65);
    const uint64_t corners[][2] = {
        {0, 0},                    /* 0 */
        {1, 0},                    /* 1 */
        {UINT64_MAX, 2 * top - 1}, /* -1 */
        {UINT64_MAX, top - 1},     /* the highest */
        {UINT64_MAX - 1, top - 1}, /* one less */
        {0, top},                  /* the lowest */
        {1, top},                  /* one more */
    };
    enum { CORNERS = sizeof corners / sizeof corners[0] };
    bool corner[CORNERS] = {false}, alone[WIDE] = {false}, missing[WIDE] = {false};
    glint_random_pins source;
    glint_random_pins_begin(&source, &setting, seed);
    for (int clock = 0; clock < CLOCKS; clock++) {
        glint_pins pins;
        pins_of_all in;
        glint_random_pins_next(&source, &pins);
        memcpy(&in, pins.bytes, sizeof in);
        assert_true(in.wide[1] < 2 * top);
        for (int i = 0; i < CORNERS; i++)
            corner[i] |= memcmp(in.wide, corners[i], sizeof in.wide) == 0;
        const int one = lonely_bit(in.wide, true), zero = lonely_bit(in.wide, false);
        if (one >= 0)
            alone[one] = true;
        if (zero >= 0)
            missing[zero] = true;
    }
    for (int i = 0; i < CORNERS; i++)
        assert_true(corner[i]);
    for (int i = 0; i < WIDE; i++)
        assert_true(alone[i] && missing[i]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_seed_gives_the_pins_that_it_always_gave),
        cmocka_unit_test(each_seed_has_its_pins),
        cmocka_unit_test(a_stimulus_begins_with_zeros_and_so_do_its_pins),
        cmocka_unit_test(controls_do_what_they_are_for),
        cmocka_unit_test(every_value_of_a_narrow_pin_comes_up),
        cmocka_unit_test(the_corners_of_a_wide_pin_come_up),
    };
    return cmocka_run_group_tests(tests, choose_seed, NULL);
}
