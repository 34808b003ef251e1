/* gray: an enable that is active low, no reset and registers that do not begin with 0, pins that
 * are called as the variables of a packet's waveform are, a number of 64 bits. */
#include "glint_describe.h"

enum { WIDTH };

static const glint_parameter parameters[] = {
    {.name = "width",
     .verilog = "WIDTH",
     .meaning = "bits of the code",
     .min = 2,
     .max = 64,
     .standard = 5,
     GLINT_LISTED(2, 5, 64)},
};

typedef struct pins {
    uint8_t ce_n, clk, mismatch;
} pins;

GLINT_PIN_TABLE(pin, GLINT_PIN(pins, ce_n, ENABLE_LOW, 1, 0, 0, "1 freezes everything"),
                GLINT_PIN(pins, clk, STROBE, 1, 0, 0, "up, not down"),
                GLINT_PIN(pins, mismatch, STROBE, 1, 0, 0, "the code turned over"))

typedef struct signals_now {
    uint64_t count, code;
    int64_t wrapped;
} signals_now;

GLINT_SIGNAL_TABLE(signal,
                   GLINT_SIGNAL(signals_now, count, REGISTER, values[WIDTH], 0, 0, NULL,
                                "as it is"),
                   GLINT_SIGNAL(signals_now, code, OUTPUT, values[WIDTH], 0, 0, NULL, "in Gray"),
                   GLINT_SIGNAL(signals_now, wrapped, OUTPUT, 1, 0, 0, NULL, "past an end"))

typedef struct gray {
    signals_now s;
    uint64_t mask;
} gray;

static void begin(const int *values, void *model)
{
    gray *m = model;
    m->mask = UINT64_MAX >> (64 - values[WIDTH]);
    m->s = (signals_now){.count = 3, .code = 2};
}

static void clock_edge(void *model, const void *pins_now)
{
    gray *m = model;
    const pins *in = pins_now;
    signals_now *s = &m->s;
    if (!in->ce_n) {
        s->wrapped = s->count == (in->clk ? m->mask : 0);
        s->count = (in->clk ? s->count + 1 : s->count - 1) & m->mask;
    }
    s->code = s->count ^ s->count >> 1 ^ (in->mismatch ? m->mask : 0);
}

const glint_circuit glint_my_circuit = {
    .name = "gray",
    .title = "Counts in Gray code",
    .clock_port = "clock",
    GLINT_PARAMETERS(parameters),
    GLINT_PINS(pins, pin),
    GLINT_SIGNALS(signal),
    GLINT_MODEL(gray, begin, clock_edge),
};
