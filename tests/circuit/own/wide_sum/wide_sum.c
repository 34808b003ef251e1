/* wide_sum: signed ports of 33 to 511 bits, by a parameter: one word or eight. */
#include <string.h>

#include "glint_describe.h"

enum { WIDTH };
enum { WORDS = 8 };

static const glint_parameter parameters[] = {
    {.name = "width",
     .verilog = "WIDTH",
     .meaning = "bits of a summand",
     .min = 33,
     .max = 511,
     .standard = 256,
     GLINT_LISTED(65, 256)},
};

typedef struct pins {
    uint8_t reset, en, in_valid;
    uint64_t a[WORDS], b[WORDS];
} pins;

GLINT_PIN_TABLE(pin, GLINT_PIN(pins, reset, RESET, 1, 0, 0, "clears everything"),
                GLINT_PIN(pins, en, ENABLE, 1, 0, 0, "0 freezes everything"),
                GLINT_PIN(pins, in_valid, VALID, 1, 0, 0, "a and b are taken"),
                GLINT_PIN(pins, a, DATA, values[WIDTH], 0, 1, "a summand"),
                GLINT_PIN(pins, b, DATA, values[WIDTH], 0, 1, "the other"))

typedef struct signals_now {
    int64_t out_valid;
    uint64_t sum[WORDS];
} signals_now;

GLINT_SIGNAL_TABLE(signal,
                   GLINT_SIGNAL(signals_now, out_valid, OUTPUT, 1, 0, 0, "Outputs", "a sum is out"),
                   GLINT_SIGNAL(signals_now, sum, OUTPUT, values[WIDTH] + 1, 0, 1, "Outputs",
                                "a + b"))

typedef struct wide {
    signals_now s;
    int width;
} wide;

/* Word i of a number of the given width, sign-extended above it. */
static uint64_t word_of(const uint64_t *number, int width, int i)
{
    const int last = (width - 1) / 64;
    const uint64_t sign = number[last] >> ((width - 1) % 64) & 1 ? ~UINT64_C(0) : 0;
    if (i > last)
        return sign;
    const uint64_t within = width % 64 == 0 ? 0 : ~UINT64_C(0) << (width % 64);
    return i < last ? number[i] : (number[i] & ~within) | (sign & within);
}

static void add(wide *m, const pins *in)
{
    uint64_t carry = 0;
    for (int i = 0; i < WORDS; i++) {
        const uint64_t a = word_of(in->a, m->width, i);
        const uint64_t b = word_of(in->b, m->width, i);
        const uint64_t half = a + b;
        m->s.sum[i] = half + carry;
        carry = (half < a) | (m->s.sum[i] < half);
    }
}

static void clock_edge(void *model, const void *pins_now)
{
    wide *m = model;
    const pins *in = pins_now;
    if (in->reset) {
        memset(&m->s, 0, sizeof m->s);
    } else if (in->en) {
        m->s.out_valid = in->in_valid;
        if (in->in_valid)
            add(m, in);
    }
}

static void begin(const int *values, void *model)
{
    wide *m = model;
    m->width = values[WIDTH];
}

const glint_circuit glint_my_circuit = {
    .name = "wide_sum",
    .title = "Wide sum",
    .clock_port = "clk",
    GLINT_PARAMETERS(parameters),
    GLINT_PINS(pins, pin),
    GLINT_SIGNALS(signal),
    GLINT_MODEL(wide, begin, clock_edge),
};
