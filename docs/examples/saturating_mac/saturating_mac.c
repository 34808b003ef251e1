/* saturating_mac: the C model of saturating_mac.v, and the description by which Glint knows both.
 * docs/your-circuit.md goes through it. */
#include "glint_describe.h"

/* ---- What the circuit has: parameters, pins, signals ---- */

enum { WIDTH }; /* where the parameter stands in `values` */

static const glint_parameter parameters[] = {
    {.name = "width",
     .verilog = "WIDTH",
     .meaning = "bits of a factor",
     .min = 2,
     .max = 16,
     .standard = 8,
     GLINT_LISTED(2, 8, 16)}, /* what `verify` tries unasked */
};

typedef struct mac_pins {
    uint8_t reset, en, in_valid, first;
    int16_t a, b;
} mac_pins;

GLINT_PIN_TABLE(pin, GLINT_PIN(mac_pins, reset, RESET, 1, 0, 0, "clears everything"),
                GLINT_PIN(mac_pins, en, ENABLE, 1, 0, 0, "0 freezes everything"),
                GLINT_PIN(mac_pins, in_valid, VALID, 1, 0, 0, "a and b are taken"),
                GLINT_PIN(mac_pins, first, STROBE, 1, 0, 0,
                          "the sum begins anew with this product"),
                GLINT_PIN(mac_pins, a, DATA, values[WIDTH], 0, 1, "a factor"),
                GLINT_PIN(mac_pins, b, DATA, values[WIDTH], 0, 1, "the other factor"))

/* In the order that data flows: the first to differ is then the cause, or is fed by it. */
typedef struct mac_signals {
    int64_t s1_valid, s1_first, product;
    int64_t added, beyond, clamped;
    int64_t out_valid, out_saturated, out_sum;
} mac_signals;

#define PRODUCT "Stage 1: the product"
#define SUM     "Stage 2: the sum"
#define OUTPUTS "Outputs"

GLINT_SIGNAL_TABLE(
    signal, GLINT_SIGNAL(mac_signals, s1_valid, STAGE, 1, 0, 0, PRODUCT, "there is a product"),
    GLINT_SIGNAL(mac_signals, s1_first, STAGE, 1, 0, 0, PRODUCT, "the sum begins with it"),
    GLINT_SIGNAL(mac_signals, product, REGISTER, 2 * values[WIDTH], 0, 1, PRODUCT, "a*b"),
    GLINT_SIGNAL(mac_signals, added, BLOCK, 2 * values[WIDTH] + 1, 0, 1, SUM, "with a bit more"),
    GLINT_SIGNAL(mac_signals, beyond, BLOCK, 1, 0, 0, SUM, "it does not fit"),
    GLINT_SIGNAL(mac_signals, clamped, BLOCK, 2 * values[WIDTH], 0, 1, SUM, "brought back"),
    GLINT_SIGNAL(mac_signals, out_valid, OUTPUT, 1, 0, 0, OUTPUTS, "the sum is new"),
    GLINT_SIGNAL(mac_signals, out_saturated, OUTPUT, 1, 0, 0, OUTPUTS, "it stopped at an end"),
    GLINT_SIGNAL(mac_signals, out_sum, OUTPUT, 2 * values[WIDTH], 0, 1, OUTPUTS, "the sum"))

/* For the drawing (`glint draw`): what each value is made of. */
GLINT_BLOCK_TABLE(block, GLINT_BLOCK("factors", MULTIPLIER, NULL, "a b", NULL),
                  GLINT_BLOCK("product", REGISTER, "a\u00b7b", "factors", "in_valid"),
                  GLINT_BLOCK("s1_first", REGISTER, NULL, "first", "in_valid"),
                  GLINT_BLOCK("s1_valid", REGISTER, NULL, "in_valid", NULL),
                  GLINT_BLOCK("sum_or_0", KEYS, NULL, "s1_first out_sum", NULL),
                  GLINT_BLOCK("added", ADDER, NULL, "product sum_or_0", NULL),
                  GLINT_BLOCK("beyond", COMPARATOR, "fits?", "added", NULL),
                  GLINT_BLOCK("clamped", LOGIC, "clamp", "added beyond", NULL),
                  GLINT_BLOCK("out_sum", REGISTER, "sum", "clamped", "s1_valid"),
                  GLINT_BLOCK("out_saturated", REGISTER, NULL, "beyond", "s1_valid"),
                  GLINT_BLOCK("out_valid", REGISTER, NULL, "s1_valid", NULL))

GLINT_ALWAYS(int, latency, 2)

/* ---- What it does: the C model ---- */

typedef struct mac {
    mac_signals s;
    int64_t most; /* that the sum may be */
} mac;

/* What stands behind the registers, which the edge has just written. */
static void settle(mac *m)
{
    mac_signals *s = &m->s;
    s->added = s->product + (s->s1_first ? 0 : s->out_sum);
    s->beyond = s->added > m->most || s->added < -m->most - 1;
    s->clamped = !s->beyond ? s->added : s->added < 0 ? -m->most - 1 : m->most;
}

static void edge(mac_signals *s, const mac_pins *pins)
{
    s->out_valid = s->s1_valid;
    if (s->s1_valid) {
        s->out_saturated = s->beyond;
        s->out_sum = s->clamped;
    }
    s->s1_valid = pins->in_valid;
    if (pins->in_valid) {
        s->s1_first = pins->first;
        s->product = (int64_t)pins->a * pins->b;
    }
}

static void clock_edge(void *model, const void *pins_now)
{
    mac *m = model;
    const mac_pins *pins = pins_now;
    if (pins->reset)
        m->s = (mac_signals){0};
    else if (pins->en)
        edge(&m->s, pins);
    settle(m);
}

static void begin(const int *values, void *model)
{
    mac *m = model;
    m->most = (INT64_C(1) << (2 * values[WIDTH] - 1)) - 1;
}

/* ---- Every input: each pair of factors, four times in a row so that the sum meets its ends ----
 */

enum { ROUNDS = 4, WIDEST = 10 };

static uint64_t points(const int *values)
{
    return values[WIDTH] <= WIDEST ? (uint64_t)ROUNDS << (2 * values[WIDTH]) : 0;
}

static void put(const int *values, uint64_t point, void *pins_now)
{
    mac_pins *pins = pins_now;
    const int half = 1 << (values[WIDTH] - 1);
    const int pair = (int)(point / ROUNDS);
    pins->first = point % ROUNDS == 0;
    pins->a = (int16_t)(pair / (2 * half) - half);
    pins->b = (int16_t)(pair % (2 * half) - half);
}

static const glint_domain domain = {
    .what = "every a with every b, four times to a sum", .points = points, .put = put};

/* ---- All of it ---- */

const glint_circuit glint_my_circuit = {
    .name = "saturating_mac",
    .title = "Saturating multiply-accumulate",
    .clock_port = "clk",
    GLINT_PARAMETERS(parameters),
    GLINT_PINS(mac_pins, pin),
    GLINT_SIGNALS(signal),
    .latency = latency,
    GLINT_MODEL(mac, begin, clock_edge),
    .domain = &domain,
    GLINT_BLOCKS(block),
};
