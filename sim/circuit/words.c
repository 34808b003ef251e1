/* Multi-word arithmetic on pin and signal values: loads and stores, hexadecimal, decimal, double,
 * and parsing. */
#include "circuit/words.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define HALF_BITS 32
#define BILLION   1000000000u
#define NINE      9 /* digits below a billion */

static bool bit_of(const uint64_t *words, int bit)
{
    return (words[bit / 64] >> bit % 64 & 1u) != 0;
}

/* The bits above the width become 0. */
static void cut(uint64_t *words, int width)
{
    if (width % 64 != 0)
        words[width / 64] &= (UINT64_C(1) << width % 64) - 1u;
}

/* ---- Pins ------------------------------------------------------------------------------------ */

static uint64_t load(const unsigned char *place, size_t size)
{
    uint16_t two;
    uint32_t four;
    uint64_t eight;
    switch (size) {
    case sizeof(uint8_t):
        return *place;
    case sizeof two:
        memcpy(&two, place, sizeof two);
        return two;
    case sizeof four:
        memcpy(&four, place, sizeof four);
        return four;
    default:
        memcpy(&eight, place, sizeof eight);
        return eight;
    }
}

static void store(unsigned char *place, size_t size, uint64_t value)
{
    const uint16_t two = (uint16_t)value;
    const uint32_t four = (uint32_t)value;
    switch (size) {
    case sizeof(uint8_t):
        *place = (unsigned char)value;
        break;
    case sizeof two:
        memcpy(place, &two, sizeof two);
        break;
    case sizeof four:
        memcpy(place, &four, sizeof four);
        break;
    default:
        memcpy(place, &value, sizeof value);
    }
}

/* A pin of few bits may lie in an array of words, as its width may depend on the setting. */
static int words_in_memory(const glint_pin_info *pin)
{
    return pin->size > sizeof(uint64_t) ? (int)(pin->size / sizeof(uint64_t)) : 0;
}

void glint_pin_get(const glint_pin_info *pin, const glint_pins *pins, uint64_t *words)
{
    const unsigned char *place = pins->bytes + pin->offset;
    const int width = glint_pin_width(pin);
    if (words_in_memory(pin) != 0)
        memcpy(words, place, (size_t)glint_words_of(width) * sizeof *words);
    else
        words[0] = load(place, pin->size);
    cut(words, width);
}

void glint_pin_set(const glint_pin_info *pin, glint_pins *pins, const uint64_t *words)
{
    unsigned char *place = pins->bytes + pin->offset;
    const int width = glint_pin_width(pin);
    uint64_t value[GLINT_VALUE_WORDS] = {0};
    memcpy(value, words, (size_t)glint_words_of(width) * sizeof *value);
    cut(value, width);
    if (words_in_memory(pin) != 0) {
        memcpy(place, value, pin->size);
        return;
    }
    if (pin->is_signed && width < 64 && bit_of(value, width - 1))
        value[0] |= ~UINT64_C(0) << width;
    store(place, pin->size, value[0]);
}

/* ---- Text and number ------------------------------------------------------------------------- */

/* 0 minus the value. */
static void negate(uint64_t *words, int width)
{
    bool carry = true;
    for (int i = 0; i < glint_words_of(width); i++) {
        words[i] = ~words[i] + carry;
        carry = carry && words[i] == 0;
    }
    cut(words, width);
}

/* The magnitude, with the bits above the width 0; returns whether the value is negative. */
static bool magnitude_of(const uint64_t *words, int width, bool is_signed, uint64_t *magnitude)
{
    const bool negative = is_signed && bit_of(words, width - 1);
    memcpy(magnitude, words, (size_t)glint_words_of(width) * sizeof *magnitude);
    cut(magnitude, width);
    if (negative)
        negate(magnitude, width);
    return negative;
}

void glint_words_hex(const uint64_t *words, int width, char *text)
{
    const int digits = (width + 3) / 4;
    text += sprintf(text, "0x");
    for (int i = digits - 1; i >= 0; i--)
        *text++ = "0123456789abcdef"[words[i / 16] >> i % 16 * 4 & 15u];
    *text = '\0';
}

/* Divides by a billion; the rest. */
static uint32_t take_nine_digits(uint64_t *words, int count)
{
    uint64_t rest = 0;
    for (int i = count - 1; i >= 0; i--) {
        const uint64_t high = rest << HALF_BITS | words[i] >> HALF_BITS;
        const uint64_t low = high % BILLION << HALF_BITS | (words[i] & UINT32_MAX);
        words[i] = high / BILLION << HALF_BITS | low / BILLION;
        rest = low % BILLION;
    }
    return (uint32_t)rest;
}

void glint_words_decimal(const uint64_t *words, int width, bool is_signed, char *text)
{
    uint64_t magnitude[GLINT_VALUE_WORDS];
    uint32_t parts[GLINT_VALUE_TEXT / NINE + 1];
    int count = glint_words_of(width), part = 0;
    if (magnitude_of(words, width, is_signed, magnitude))
        *text++ = '-';
    do {
        parts[part++] = take_nine_digits(magnitude, count);
        while (count > 0 && magnitude[count - 1] == 0)
            count--;
    } while (count > 0);
    text += sprintf(text, "%u", parts[--part]);
    while (part > 0)
        text += sprintf(text, "%09u", parts[--part]);
}

/* The 64 bits from the highest 1 on, the lowest of them 1 where any below is: what a double, which
 * has fewer, is rounded from. */
static uint64_t leading_bits(const uint64_t *words, int top)
{
    uint64_t bits = 0;
    for (int i = 0; i < 64; i++)
        bits = bits << 1 | (top - i >= 0 && bit_of(words, top - i));
    for (int i = top - 64; i >= 0; i--)
        bits |= bit_of(words, i);
    return bits;
}

double glint_words_number(const uint64_t *words, int width, int frac_bits, bool is_signed)
{
    uint64_t magnitude[GLINT_VALUE_WORDS];
    const bool negative = magnitude_of(words, width, is_signed, magnitude);
    int top = width - 1;
    while (top > 0 && !bit_of(magnitude, top))
        top--;
    const double value = ldexp((double)leading_bits(magnitude, top), top - 63 - frac_bits);
    return negative ? -value : value;
}

/* ---- Parsing --------------------------------------------------------------------------------- */

/* A digit of base 10 or 16; −1 if it is not one. */
static int digit_of(char c, unsigned base)
{
    const char *digits = "0123456789abcdef";
    const char *found = c != '\0' ? strchr(digits, c >= 'A' && c <= 'F' ? c - 'A' + 'a' : c) : NULL;
    return found != NULL && found - digits < (int)base ? (int)(found - digits) : -1;
}

/* value · factor + more; what is carried out of it. */
static uint64_t multiply_add(uint64_t *words, int count, unsigned factor, unsigned more)
{
    uint64_t carry = more;
    for (int i = 0; i < count; i++) {
        const uint64_t low = (words[i] & UINT32_MAX) * factor + carry;
        const uint64_t high = (words[i] >> HALF_BITS) * factor + (low >> HALF_BITS);
        words[i] = high << HALF_BITS | (low & UINT32_MAX);
        carry = high >> HALF_BITS;
    }
    return carry;
}

static bool parse_digits(const char *text, unsigned base, int width, uint64_t *words)
{
    const int count = glint_words_of(width);
    memset(words, 0, (size_t)count * sizeof *words);
    if (*text == '\0')
        return false;
    for (; *text != '\0'; text++) {
        const int digit = digit_of(*text, base);
        if (digit < 0 || multiply_add(words, count, base, (unsigned)digit) != 0)
            return false;
    }
    return width % 64 == 0 || words[count - 1] >> width % 64 == 0;
}

/* Of the numbers with that sign bit set only the smallest, and only negative, is one. */
static bool fits_signed(const uint64_t *words, int width, bool negative)
{
    if (!bit_of(words, width - 1))
        return true;
    for (int i = 0; i < width - 1; i++)
        if (bit_of(words, i))
            return false;
    return negative;
}

bool glint_words_parse(const char *text, int width, bool is_signed, uint64_t *words)
{
    if (strncmp(text, "0x", 2) == 0)
        return parse_digits(text + 2, 16, width, words);
    const bool negative = is_signed && *text == '-';
    if (!parse_digits(text + negative, 10, width, words) ||
        (is_signed && !fits_signed(words, width, negative)))
        return false;
    if (negative)
        negate(words, width);
    return true;
}

/* ---- Rows of signals ------------------------------------------------------------------------- */

bool glint_signal_places(const glint_setting *setting, int *place)
{
    const glint_circuit *circuit = setting->circuit;
    const int count = circuit->signal_count(setting->values);
    int at = 0;
    for (int i = 0; i < count; i++) {
        const glint_signal_info signal = circuit->signal(setting->values, i);
        const int words = glint_words_of(glint_signal_width(&signal));
        if (words > GLINT_SIGNAL_WORDS_MAX - at)
            return false;
        place[i] = at;
        at += words;
    }
    place[count] = at;
    return true;
}
