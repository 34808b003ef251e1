/* serial_mul: a pace, random pins of its own, a domain, an asynchronous reset that is active high;
 * its C model in a file of its own. */
#include "serial_mul.h"

#include "glint_describe.h"

static const glint_parameter parameters[] = {
    {.name = "width",
     .verilog = "WIDTH",
     .meaning = "bits of a factor",
     .min = 2,
     .max = 16,
     .standard = 6,
     GLINT_LISTED(3, 6)},
};

GLINT_PIN_TABLE(pin, GLINT_PIN(serial_pins, arst, RESET, 1, 0, 0, "clears everything at once"),
                GLINT_PIN(serial_pins, en, ENABLE, 1, 0, 0, "0 freezes everything"),
                GLINT_PIN(serial_pins, start, VALID, 1, 0, 0, "a and b are taken"),
                GLINT_PIN(serial_pins, a, DATA, values[0], 0, 0, "a factor"),
                GLINT_PIN(serial_pins, b, DATA, values[0], 0, 0, "the other"))

#define BITS "Bit by bit"

GLINT_SIGNAL_TABLE(
    signal, GLINT_SIGNAL(serial_signals, busy, OUTPUT, 1, 0, 0, BITS, "it takes nothing"),
    GLINT_SIGNAL(serial_signals, left, REGISTER, 5, 0, 0, BITS, "bits still to come"),
    GLINT_SIGNAL(serial_signals, bits, REGISTER, values[0], 0, 0, BITS, "of b"),
    GLINT_SIGNAL(serial_signals, addend, REGISTER, 2 * values[0], 0, 0, BITS, "a, moved"),
    GLINT_SIGNAL(serial_signals, sum, BLOCK, 2 * values[0], 0, 0, BITS, "the next acc"),
    GLINT_SIGNAL(serial_signals, done, OUTPUT, 1, 0, 0, BITS, "the product is whole"),
    GLINT_SIGNAL(serial_signals, product, OUTPUT, 2 * values[0], 0, 0, BITS, "so far"))

static int busy_clocks(const int *values)
{
    return values[0] + 1;
}

/* Starts that arrive just as the last product is finishing. */
typedef struct stimulus {
    uint64_t state;
    int width, clock;
} stimulus;

static uint32_t next_random(stimulus *s)
{
    s->state = s->state * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
    return (uint32_t)(s->state >> 33);
}

static void stimulus_begin(void *state, const int *values, uint64_t seed)
{
    *(stimulus *)state = (stimulus){.state = seed, .width = values[0]};
}

static void stimulus_next(void *state, void *pins_now)
{
    stimulus *s = state;
    const uint32_t mask = (1u << s->width) - 1;
    s->clock++;
    *(serial_pins *)pins_now =
        (serial_pins){.arst = next_random(s) % 512 == 0,
                      .en = next_random(s) % 16 != 0,
                      .start = s->clock % (s->width + 2) < 2 || next_random(s) % 8 == 0,
                      .a = (uint16_t)(next_random(s) & mask),
                      .b = (uint16_t)(next_random(s) & mask)};
}

static uint64_t points(const int *values)
{
    return UINT64_C(1) << (2 * values[0]);
}

static void put(const int *values, uint64_t point, void *pins_now)
{
    serial_pins *pins = pins_now;
    pins->a = (uint16_t)(point >> values[0]);
    pins->b = (uint16_t)(point & ((1u << values[0]) - 1));
}

static const glint_domain domain = {.what = "every a with every b", .points = points, .put = put};

const glint_circuit glint_my_circuit = {
    .name = "serial_mul",
    .title = "A product bit by bit",
    .clock_port = "clk",
    GLINT_PARAMETERS(parameters),
    GLINT_PINS(serial_pins, pin),
    GLINT_SIGNALS(signal),
    .latency = busy_clocks,
    .pace = busy_clocks,
    .create = serial_create,
    .destroy = serial_destroy,
    .clock = serial_clock,
    .signals = serial_state,
    .stimulus_size = sizeof(stimulus),
    .stimulus_begin = stimulus_begin,
    .stimulus_next = stimulus_next,
    .domain = &domain,
};
