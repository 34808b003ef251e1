/* signed_order: a circuit without a clock, with signed fixed-point ports and a domain. */
#include "glint_describe.h"

enum { WIDTH };
enum { INT_BITS = 4 };
#define FRAC_BITS (values[WIDTH] - INT_BITS)

static const glint_parameter parameters[] = {
    {.name = "width",
     .verilog = "WIDTH",
     .meaning = "bits of a number, four of them before the point",
     .min = 5,
     .max = 12,
     .standard = 8,
     GLINT_LISTED(5, 8)},
};

typedef struct pins {
    int16_t a, b;
} pins;

GLINT_PIN_TABLE(pin, GLINT_PIN(pins, a, DATA, INT_BITS, FRAC_BITS, 1, "one"),
                GLINT_PIN(pins, b, DATA, INT_BITS, FRAC_BITS, 1, "the other"))

typedef struct signals_now {
    int64_t swap, lesser, greater, distance;
} signals_now;

#define ORDER "In order"

GLINT_SIGNAL_TABLE(
    signal, GLINT_SIGNAL(signals_now, swap, BLOCK, 1, 0, 0, ORDER, "b is the lesser"),
    GLINT_SIGNAL(signals_now, lesser, OUTPUT, INT_BITS, FRAC_BITS, 1, ORDER, "the lesser"),
    GLINT_SIGNAL(signals_now, greater, OUTPUT, INT_BITS, FRAC_BITS, 1, ORDER, "the greater"),
    GLINT_SIGNAL(signals_now, distance, OUTPUT, INT_BITS, FRAC_BITS, 0, ORDER, "between them"))

static void evaluate(void *model, const void *pins_now)
{
    signals_now *s = model;
    const pins *in = pins_now;
    s->swap = in->b < in->a;
    s->lesser = s->swap ? in->b : in->a;
    s->greater = s->swap ? in->a : in->b;
    s->distance = s->greater - s->lesser;
}

static uint64_t points(const int *values)
{
    return UINT64_C(1) << (2 * values[WIDTH]);
}

static void put(const int *values, uint64_t point, void *pins_now)
{
    pins *in = pins_now;
    const int all = 1 << values[WIDTH];
    in->a = (int16_t)((int)(point / (unsigned)all) - all / 2);
    in->b = (int16_t)((int)(point % (unsigned)all) - all / 2);
}

static const glint_domain domain = {.what = "every a with every b", .points = points, .put = put};

const glint_circuit glint_my_circuit = {
    .name = "signed_order",
    .title = "Two numbers in order",
    GLINT_PARAMETERS(parameters),
    GLINT_PINS(pins, pin),
    GLINT_SIGNALS(signal),
    GLINT_MODEL(signals_now, NULL, evaluate),
    .domain = &domain,
};
