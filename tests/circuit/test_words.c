/* Values of any width: pins in memory, texts, numbers, against arithmetic of the compiler's own. */
#define _XOPEN_SOURCE 700

#include <inttypes.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "../seed.h"
#include "circuit/circuits.h"
#include "circuit/random.h"
#include "circuit/words.h"

static glint_random draw;

static int seed_draw(void **state)
{
    (void)state;
    draw.state = seed_of_this_run();
    return 0;
}

static uint64_t low_bits(uint64_t value, int width)
{
    return width == 64 ? value : value & ((UINT64_C(1) << width) - 1u);
}

static int64_t extended(uint64_t value, int width)
{
    const uint64_t sign = UINT64_C(1) << (width - 1);
    return (int64_t)((low_bits(value, width) ^ sign) - sign);
}

/* ---- Pins -------------------------------------------------------------------------------------
 */

static void a_narrow_pin_is_an_integer_of_its_size(void **state)
{
    (void)state;
    static const size_t sizes[] = {1, 2, 4, 8};
    for (size_t s = 0; s < 4; s++)
        for (int width = 1; width <= 8 * (int)sizes[s]; width++)
            for (int is_signed = 0; is_signed <= 1; is_signed++) {
                const glint_pin_info pin = {.name = "a",
                                            .int_bits = width,
                                            .is_signed = is_signed,
                                            .offset = 16,
                                            .size = sizes[s]};
                glint_pins pins;
                const uint64_t value = glint_random_bits(&draw);
                uint64_t back;
                memset(&pins, 0xa5, sizeof pins);
                glint_pin_set(&pin, &pins, &value);
                glint_pin_get(&pin, &pins, &back);
                assert_true(back == low_bits(value, width));
                int64_t whole = 0;
                memcpy(&whole, pins.bytes + 16, sizes[s]); /* little-endian here */
                assert_true(is_signed ? extended((uint64_t)whole, 8 * (int)sizes[s]) ==
                                            extended(value, width)
                                      : (uint64_t)whole == low_bits(value, width));
                assert_int_equal(pins.bytes[15], 0xa5);
                assert_int_equal(pins.bytes[16 + sizes[s]], 0xa5);
            }
}

static void what_lies_above_a_pin_is_ignored(void **state)
{
    (void)state;
    const glint_pin_info pin = {.name = "a", .int_bits = 5, .offset = 3, .size = 1};
    glint_pins pins = {{0}};
    uint64_t value;
    pins.bytes[3] = 0xff;
    glint_pin_get(&pin, &pins, &value);
    assert_int_equal(value, 0x1f);
}

static void a_wide_pin_is_words(void **state)
{
    (void)state;
    const glint_pin_info pin = {.name = "a", .int_bits = 100, .offset = 8, .size = 16};
    const uint64_t value[2] = {UINT64_C(0x0123456789abcdef), ~UINT64_C(0)};
    uint64_t back[2];
    glint_pins pins = {{0}};
    glint_pin_set(&pin, &pins, value);
    assert_true(pins.words[1] == value[0] && pins.words[2] == UINT64_C(0xfffffffff));
    pins.words[2] = ~UINT64_C(0);
    glint_pin_get(&pin, &pins, back);
    assert_true(back[0] == value[0] && back[1] == UINT64_C(0xfffffffff));
    assert_true(pins.words[3] == 0);
}

/* As its width may depend on the setting. */
static void a_narrow_pin_may_lie_in_words(void **state)
{
    (void)state;
    const glint_pin_info pin = {.name = "a", .int_bits = 40, .offset = 0, .size = 24};
    const uint64_t value = ~UINT64_C(0);
    uint64_t back;
    glint_pins pins;
    memset(&pins, 0xa5, sizeof pins);
    glint_pin_set(&pin, &pins, &value);
    glint_pin_get(&pin, &pins, &back);
    assert_true(back == UINT64_C(0xffffffffff) && pins.words[0] == back);
    assert_true(pins.words[1] == 0 && pins.words[2] == 0 && pins.words[3] != 0);
}

/* ---- Text -------------------------------------------------------------------------------------
 */

static void hexadecimal_has_all_digits(void **state)
{
    (void)state;
    char text[GLINT_VALUE_TEXT];
    const uint64_t wide[3] = {UINT64_C(0x123), 0, UINT64_C(0x2a)};
    glint_words_hex((uint64_t[]){0xff}, 12, text);
    assert_string_equal(text, "0x0ff");
    glint_words_hex((uint64_t[]){1}, 1, text);
    assert_string_equal(text, "0x1");
    glint_words_hex((uint64_t[]){0}, 64, text);
    assert_string_equal(text, "0x0000000000000000");
    glint_words_hex(wide, 134, text);
    assert_string_equal(text, "0x2a00000000000000000000000000000123");
}

static void numbers_of_64_bits_are_the_compilers(void **state)
{
    (void)state;
    char text[GLINT_VALUE_TEXT], expected[32];
    for (int i = 0; i < 20000; i++) {
        const int width = 1 + (int)glint_random_below(&draw, 64);
        const bool is_signed = glint_random_chance(&draw, 128);
        const int frac_bits = (int)glint_random_below(&draw, 64);
        const uint64_t value =
            low_bits(glint_random_bits(&draw) >> glint_random_below(&draw, 64), width);
        uint64_t back;
        glint_words_decimal(&value, width, is_signed, text);
        if (is_signed)
            (void)snprintf(expected, sizeof expected, "%" PRId64, extended(value, width));
        else
            (void)snprintf(expected, sizeof expected, "%" PRIu64, value);
        assert_string_equal(text, expected);
        assert_true(glint_words_parse(text, width, is_signed, &back) && back == value);
        glint_words_hex(&value, width, text);
        assert_true(glint_words_parse(text, width, is_signed, &back) && back == value);
        const double number =
            is_signed ? (double)extended(value, width) : (double)value; /* rounds once */
        assert_true(glint_words_number(&value, width, frac_bits, is_signed) ==
                    ldexp(number, -frac_bits));
    }
}

static void wide_numbers_have_all_their_digits(void **state)
{
    (void)state;
    char text[GLINT_VALUE_TEXT];
    uint64_t back[2];
    const uint64_t all[2] = {~UINT64_C(0), ~UINT64_C(0)};
    const uint64_t least[2] = {0, UINT64_C(1) << 63};
    glint_words_decimal(all, 128, false, text);
    assert_string_equal(text, "340282366920938463463374607431768211455");
    assert_true(glint_words_parse(text, 128, false, back));
    assert_memory_equal(back, all, sizeof all);
    glint_words_decimal(all, 128, true, text);
    assert_string_equal(text, "-1");
    assert_true(glint_words_parse("-1", 128, true, back));
    assert_memory_equal(back, all, sizeof all);
    glint_words_decimal(least, 128, true, text);
    assert_string_equal(text, "-170141183460469231731687303715884105728");
    assert_true(glint_words_parse(text, 128, true, back));
    assert_memory_equal(back, least, sizeof least);
    glint_words_decimal((uint64_t[]){0, UINT64_C(1) << 35}, 100, false, text);
    assert_string_equal(text, "633825300114114700748351602688"); /* zeros inside are kept */
}

/* The widest there are, there and back; and with the room that the header promises. */
static void the_widest_value_comes_back(void **state)
{
    (void)state;
    uint64_t value[GLINT_VALUE_WORDS], back[GLINT_VALUE_WORDS];
    char text[GLINT_VALUE_TEXT];
    for (int width = 4000; width <= 64 * GLINT_VALUE_WORDS; width++) {
        for (int i = 0; i < GLINT_VALUE_WORDS; i++)
            value[i] = 64 * i >= width        ? 0
                       : width - 64 * i >= 64 ? glint_random_bits(&draw)
                                              : low_bits(glint_random_bits(&draw), width - 64 * i);
        const size_t size = (size_t)glint_words_of(width) * sizeof *value;
        for (int is_signed = 0; is_signed <= 1; is_signed++) {
            glint_words_decimal(value, width, is_signed, text);
            assert_true(strlen(text) < GLINT_VALUE_TEXT);
            assert_true(glint_words_parse(text, width, is_signed, back));
            assert_memory_equal(back, value, size);
        }
        glint_words_hex(value, width, text);
        assert_true(glint_words_parse(text, width, true, back));
        assert_memory_equal(back, value, size);
    }
}

static void what_is_no_value_is_refused(void **state)
{
    (void)state;
    static const struct {
        const char *text;
        int width;
        bool is_signed;
    } bad[] = {
        {"", 8, false},
        {"-", 8, true},
        {"0x", 8, false},
        {"256", 8, false},
        {"0x100", 8, true},
        {"-1", 8, false},
        {"128", 8, true},
        {"-129", 8, true},
        {"+1", 8, true},
        {" 1", 8, false},
        {"1 ", 8, false},
        {"1.5", 8, false},
        {"a", 8, false},
        {"0xg", 8, false},
        {"-0x1", 8, true},
        {"--1", 8, true},
        {"2", 1, false},
        {"1", 1, true},
        {"0X1f", 8, false},
        {"1e2", 8, false},
        {"18446744073709551616", 64, false},
        {"9223372036854775808", 64, true},
        {"0x10000000000000000", 64, false},
        {"340282366920938463463374607431768211456", 128, false},
        {"1000000000000000000000000000000000000000000000", 65, false},
    };
    uint64_t words[2];
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++)
        if (glint_words_parse(bad[i].text, bad[i].width, bad[i].is_signed, words))
            fail_msg("\"%s\" is taken for %d bits", bad[i].text, bad[i].width);
}

static void what_is_a_value_is_taken(void **state)
{
    (void)state;
    static const struct {
        const char *text;
        int width;
        bool is_signed;
        uint64_t value;
    } good[] = {
        {"0", 1, false, 0},
        {"1", 1, false, 1},
        {"-1", 1, true, 1},
        {"255", 8, false, 255},
        {"007", 8, false, 7},
        {"-128", 8, true, 0x80},
        {"127", 8, true, 0x7f},
        {"0xFf", 8, true, 0xff},
        {"0x00000000000000000001", 4, false, 1},
        {"-0", 8, true, 0},
        {"0x8", 4, true, 8},
        {"18446744073709551615", 64, false, UINT64_MAX},
        {"-9223372036854775808", 64, true, UINT64_C(1) << 63},
    };
    for (size_t i = 0; i < sizeof good / sizeof good[0]; i++) {
        uint64_t value = 99;
        if (!glint_words_parse(good[i].text, good[i].width, good[i].is_signed, &value))
            fail_msg("\"%s\" is refused for %d bits", good[i].text, good[i].width);
        assert_true(value == good[i].value);
    }
}

/* ---- Real numbers -----------------------------------------------------------------------------
 */

/* A double has 53 digits: what lies below them decides, however far below, and a tie is even. */
static void wide_numbers_are_rounded_once(void **state)
{
    (void)state;
    uint64_t value[4] = {0, 0, UINT64_C(1) << 63, 0};
    const double top = 0x1p191, step = 0x1p139;
    assert_true(glint_words_number(value, 256, 0, false) == top);
    value[2] |= 1u << 10; /* half a step: a tie */
    assert_true(glint_words_number(value, 256, 0, false) == top);
    value[0] = 1;
    assert_true(glint_words_number(value, 256, 0, false) == top + step);
    assert_true(glint_words_number(value, 256, 191, false) == (top + step) / top);
    assert_true(glint_words_number(value, 192, 0, true) < 0.0);
    assert_true(glint_words_number((uint64_t[4]){0}, 256, 9, true) == 0.0);
    assert_true(isinf(glint_words_number((uint64_t[GLINT_VALUE_WORDS]){[63] = 1}, 4096, 0, false)));
}

/* ---- Places -----------------------------------------------------------------------------------
 */

static glint_signal_info signals[GLINT_SIGNAL_WORDS_MAX + 1];
static int signals_count;

static int signal_count(const int *values)
{
    (void)values;
    return signals_count;
}

static glint_signal_info signal(const int *values, int index)
{
    (void)values;
    return signals[index];
}

static void each_signal_has_words_of_its_own(void **state)
{
    (void)state;
    const glint_circuit circuit = {.signal_count = signal_count, .signal = signal};
    const glint_setting setting = {.circuit = &circuit};
    int place[GLINT_SIGNAL_WORDS_MAX + 1];
    signals_count = 4;
    signals[0].int_bits = 1;
    signals[1].int_bits = 65;
    signals[2].frac_bits = 64;
    signals[3].int_bits = 200;
    assert_true(glint_signal_places(&setting, place));
    assert_true(place[0] == 0 && place[1] == 1 && place[2] == 3 && place[3] == 4 && place[4] == 8);
}

static void too_many_words_are_refused(void **state)
{
    (void)state;
    const glint_circuit circuit = {.signal_count = signal_count, .signal = signal};
    const glint_setting setting = {.circuit = &circuit};
    int place[GLINT_SIGNAL_WORDS_MAX + 1];
    memset(signals, 0, sizeof signals);
    for (int i = 0; i <= GLINT_SIGNAL_WORDS_MAX; i++)
        signals[i].int_bits = 1;
    signals_count = GLINT_SIGNAL_WORDS_MAX;
    assert_true(glint_signal_places(&setting, place));
    assert_int_equal(place[signals_count], GLINT_SIGNAL_WORDS_MAX);
    signals[0].int_bits = 65;
    assert_false(glint_signal_places(&setting, place));
    signals[0].int_bits = 1;
    signals_count++;
    assert_false(glint_signal_places(&setting, place));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_narrow_pin_is_an_integer_of_its_size),
        cmocka_unit_test(what_lies_above_a_pin_is_ignored),
        cmocka_unit_test(a_wide_pin_is_words),
        cmocka_unit_test(a_narrow_pin_may_lie_in_words),
        cmocka_unit_test(hexadecimal_has_all_digits),
        cmocka_unit_test(numbers_of_64_bits_are_the_compilers),
        cmocka_unit_test(wide_numbers_have_all_their_digits),
        cmocka_unit_test(the_widest_value_comes_back),
        cmocka_unit_test(what_is_no_value_is_refused),
        cmocka_unit_test(what_is_a_value_is_taken),
        cmocka_unit_test(wide_numbers_are_rounded_once),
        cmocka_unit_test(each_signal_has_words_of_its_own),
        cmocka_unit_test(too_many_words_are_refused),
    };
    return cmocka_run_group_tests(tests, seed_draw, NULL);
}
