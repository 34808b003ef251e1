/* signed_order: a circuit without a clock, with signed fixed-point ports and a domain. */
#include <stdlib.h>

#include "glint_describe.h"

enum { WIDTH };
enum { INT_BITS = 4 };
#define FRAC_BITS (values[WIDTH] - INT_BITS)

static const int listed[] = {5, 8};
static const glint_parameter parameters[] = {
    {.name = "width",
     .verilog = "WIDTH",
     .meaning = "bits of a number, four of them before the point",
     .min = 5,
     .max = 12,
     .standard = 8,
     .listed = listed,
     .listed_count = 2},
};

typedef struct pins {
    int16_t a, b;
} pins;

GLINT_PIN_TABLE(pin_count, pin, GLINT_PIN(pins, a, DATA, INT_BITS, FRAC_BITS, 1, "one"),
                GLINT_PIN(pins, b, DATA, INT_BITS, FRAC_BITS, 1, "the other"))

typedef struct signals_now {
    int64_t swap, lesser, greater, distance;
} signals_now;

static const glint_heading headings[] = {{.title = "In order"}};
#define ORDER "In order"

GLINT_SIGNAL_TABLE(
    signal_count, signal, GLINT_SIGNAL(signals_now, swap, BLOCK, 1, 0, 0, ORDER, "b is the lesser"),
    GLINT_SIGNAL(signals_now, lesser, OUTPUT, INT_BITS, FRAC_BITS, 1, ORDER, "the lesser"),
    GLINT_SIGNAL(signals_now, greater, OUTPUT, INT_BITS, FRAC_BITS, 1, ORDER, "the greater"),
    GLINT_SIGNAL(signals_now, distance, OUTPUT, INT_BITS, FRAC_BITS, 0, ORDER, "between them"))

GLINT_ALWAYS(const char *, top, "signed_order")
GLINT_ALWAYS(int, latency, 0)

static void evaluate(void *model, const void *pins_now)
{
    signals_now *s = model;
    const pins *in = pins_now;
    s->swap = in->b < in->a;
    s->lesser = s->swap ? in->b : in->a;
    s->greater = s->swap ? in->a : in->b;
    s->distance = s->greater - s->lesser;
}

static glint_status create(const int *values, void **model)
{
    (void)values;
    *model = calloc(1, sizeof(signals_now));
    return *model != NULL ? GLINT_OK : GLINT_NO_MEMORY;
}

static const void *signals(const void *model)
{
    return model;
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
    .top = top,
    .parameters = parameters,
    .parameter_count = 1,
    .pin_count = pin_count,
    .pin = pin,
    .pins_size = sizeof(pins),
    .signal_count = signal_count,
    .signal = signal,
    .headings = headings,
    .heading_count = 1,
    .latency = latency,
    .create = create,
    .destroy = free,
    .clock = evaluate,
    .signals = signals,
    .domain = &domain,
};
