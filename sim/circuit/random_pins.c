/* The default stimulus, driven by pin roles alone; see random_pins.h. */
#include "circuit/random_pins.h"

#include <string.h>

#include "circuit/random.h"
#include "circuit/schedule.h"
#include "circuit/words.h"

/* The state behind the pins of a circuit without its own stimulus. */
typedef struct by_roles {
    glint_random random;
    glint_schedule schedule;
    uint32_t gap_chance, bit_gap_chance, strobe_chance; /* of 256, in the present phase */
} by_roles;
_Static_assert(sizeof(by_roles) <= GLINT_STIMULUS_SIZE_MAX, "shares the stimulus's storage");

static uint32_t pick(glint_random *random, const uint32_t *choices, uint32_t count)
{
    return choices[glint_random_below(random, count)];
}

static void begin_phase(by_roles *r)
{
    static const uint32_t gaps[] = {0, 0, 16, 64, 128, 240};
    static const uint32_t strobes[] = {0, 8, 64, 128, 200, 255};
    r->gap_chance = pick(&r->random, gaps, 6);
    r->bit_gap_chance = pick(&r->random, gaps, 6);
    r->strobe_chance = pick(&r->random, strobes, 6);
}

static void put_bit(uint64_t *words, int bit, bool value)
{
    const uint64_t mask = UINT64_C(1) << bit % 64;
    words[bit / 64] = value ? words[bit / 64] | mask : words[bit / 64] & ~mask;
}

/* ---- Data ------------------------------------------------------------------------------------ */

static void fill(uint64_t *words, int width, bool value)
{
    memset(words, value ? 0xff : 0, (size_t)glint_words_of(width) * sizeof *words);
}

static void anywhere(glint_random *random, uint64_t *words, int width)
{
    for (int i = 0; i < glint_words_of(width); i++)
        words[i] = glint_random_bits(random);
}

/* The highest or the lowest number, or its neighbour. */
static void end_of_range(glint_random *random, const glint_pin_info *pin, uint64_t *words)
{
    const int width = glint_pin_width(pin);
    const bool top = glint_random_chance(random, 128);
    fill(words, width, top);
    if (pin->is_signed)
        put_bit(words, width - 1, !top);
    if (glint_random_chance(random, 64))
        put_bit(words, 0, !top);
}

/* 0, 1 or -1. */
static void around_zero(glint_random *random, uint64_t *words, int width)
{
    const uint32_t which = glint_random_below(random, 3);
    fill(words, width, which == 2);
    if (which == 1)
        put_bit(words, 0, true);
}

/* One bit alone, or all but one. */
static void one_bit(glint_random *random, uint64_t *words, int width)
{
    const bool alone = glint_random_chance(random, 128);
    fill(words, width, !alone);
    put_bit(words, (int)glint_random_below(random, (uint32_t)width), alone);
}

/* A number of some low bits, of either sign. */
static void short_number(glint_random *random, uint64_t *words, int width)
{
    const int bits = (int)glint_random_below(random, (uint32_t)width);
    const bool above = glint_random_chance(random, 64);
    anywhere(random, words, width);
    for (int i = bits; i < width; i++)
        put_bit(words, i, above);
}

static void random_data(glint_random *random, const glint_pin_info *pin, uint64_t *words)
{
    const int width = glint_pin_width(pin);
    switch (glint_random_below(random, 8)) {
    case 0:
        end_of_range(random, pin, words);
        break;
    case 1:
        around_zero(random, words, width);
        break;
    case 2:
        one_bit(random, words, width);
        break;
    case 3:
        short_number(random, words, width);
        break;
    default:
        anywhere(random, words, width);
    }
}

/* ---- All pins -------------------------------------------------------------------------------- */

/* With several bits, each is drawn separately if any is to be set. */
static void random_valid(by_roles *r, const glint_pin_info *pin, uint64_t *words)
{
    const int width = glint_pin_width(pin);
    fill(words, width, false);
    if (glint_random_chance(&r->random, r->gap_chance))
        return;
    for (int i = 0; i < width; i++)
        put_bit(words, i, width == 1 || !glint_random_chance(&r->random, r->bit_gap_chance));
}

static void random_pin(by_roles *r, const glint_pin_info *pin, bool reset, bool en,
                       uint64_t words[GLINT_VALUE_WORDS])
{
    memset(words, 0, GLINT_VALUE_WORDS * sizeof *words);
    switch (pin->role) {
    case GLINT_PIN_RESET:
        words[0] = reset;
        break;
    case GLINT_PIN_RESET_LOW:
        words[0] = !reset;
        break;
    case GLINT_PIN_ENABLE:
        words[0] = en;
        break;
    case GLINT_PIN_ENABLE_LOW:
        words[0] = !en;
        break;
    case GLINT_PIN_VALID:
        random_valid(r, pin, words);
        break;
    case GLINT_PIN_STROBE:
        words[0] = glint_random_chance(&r->random, r->strobe_chance);
        break;
    case GLINT_PIN_DATA:
        random_data(&r->random, pin, words);
        break;
    }
}

static void next_by_roles(by_roles *r, const glint_setting *setting, glint_pins *pins)
{
    const glint_circuit *circuit = setting->circuit;
    const int count = circuit->pin_count(setting->values);
    uint64_t words[GLINT_VALUE_WORDS];
    bool reset, en;
    if (glint_schedule_next(&r->schedule, &r->random, &reset, &en))
        begin_phase(r);
    for (int i = 0; i < count; i++) {
        const glint_pin_info pin = circuit->pin(setting->values, i);
        random_pin(r, &pin, reset, en, words);
        glint_pin_set(&pin, pins, words);
    }
}

void glint_random_pins_begin(glint_random_pins *source, const glint_setting *setting, uint64_t seed)
{
    const glint_circuit *circuit = setting->circuit;
    source->setting = *setting;
    memset(source->state.bytes, 0, circuit->stimulus_size);
    if (circuit->stimulus_begin != NULL)
        circuit->stimulus_begin(source->state.bytes, setting->values, seed);
    else
        *(by_roles *)(void *)source->state.bytes = (by_roles){.random = {seed}};
}

void glint_random_pins_next(glint_random_pins *source, glint_pins *pins)
{
    const glint_circuit *circuit = source->setting.circuit;
    memset(pins->bytes, 0,
           circuit->pins_size); /* a replay's are not in the same place as a run's */
    if (circuit->stimulus_begin != NULL)
        circuit->stimulus_next(source->state.bytes, pins);
    else
        next_by_roles((by_roles *)(void *)source->state.bytes, &source->setting, pins);
}
