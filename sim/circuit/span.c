/* The span unit of quadratic interpolation, described. */
#include "circuit/circuits.h"
#include "glint_describe.h"
#include "glint_quadratic_span.h"

enum { FRACTION }; /* where the parameter stands in `values` */

static const glint_parameter parameters[] = {
    {.name = "fraction",
     .verilog = "FRACTION",
     .meaning = "fraction bits of the span unit's numbers",
     .min = GLINT_QUADRATIC_SPAN_FRACTION_MIN,
     .max = GLINT_QUADRATIC_SPAN_FRACTION_MAX,
     .standard = GLINT_QUADRATIC_SPAN_FRACTION_DEFAULT,
     GLINT_LISTED(GLINT_QUADRATIC_SPAN_FRACTION_MIN, GLINT_QUADRATIC_SPAN_FRACTION_DEFAULT,
                  GLINT_QUADRATIC_SPAN_FRACTION_MAX)},
};

glint_setting glint_setting_span(int fraction)
{
    return (glint_setting){.circuit = &glint_circuit_span, .values = {[FRACTION] = fraction}};
}

/* ---- Pins ------------------------------------------------------------------------------------ */

#define I GLINT_QUADRATIC_SPAN_INT_BITS
#define CONTROL(member, role, meaning)                                                             \
    GLINT_PIN(glint_quadratic_span_pins, member, role, 1, 0, 0, meaning)
#define NUMBER(port, field, c, meaning)                                                            \
    GLINT_PIN_OF(glint_quadratic_span_pins, walk.field[c], port, DATA, I, values[FRACTION], 1, -1, \
                 meaning)

GLINT_PIN_TABLE(pin, CONTROL(reset, RESET, "clears every register"),
                CONTROL(en, ENABLE, "0 freezes the unit"),
                CONTROL(load, VALID, "takes the numbers of a span; its first pixel"),
                CONTROL(step, STROBE, "without load: the next pixel"),
                NUMBER("start_r", start, 0, "intensity of R at the first pixel"),
                NUMBER("start_g", start, 1, "of G"), NUMBER("start_b", start, 2, "of B"),
                NUMBER("first_r", first, 0, "what R grows by to the second pixel"),
                NUMBER("first_g", first, 1, "of G"), NUMBER("first_b", first, 2, "of B"),
                NUMBER("second_r", second, 0, "what that growth of R grows by a pixel"),
                NUMBER("second_g", second, 1, "of G"), NUMBER("second_b", second, 2, "of B"))

/* ---- Signals --------------------------------------------------------------------------------- */

#define UNDER_WAY "In progress"
#define RED       "Walk of R"
#define GREEN     "Walk of G"
#define BLUE      "Walk of B"
#define OUTPUTS   "Outputs"

#define S(member, called, path, kind, ints, fracs, sign, heading, meaning)                         \
    GLINT_SIGNAL_OF(glint_quadratic_span_signals, member, called, path, kind, ints, fracs, sign,   \
                    -1, heading, meaning)
#define INNER(name, letter, c, kind, ints, fracs, sign, heading, meaning)                          \
    S(component[c].name, #name "_" letter, "u_" letter "." #name, kind, ints, fracs, sign,         \
      heading, meaning)
#define COMPONENT(letter, c, heading)                                                              \
    INNER(value, letter, c, REGISTER, I, values[FRACTION], 1, heading, "intensity of the pixel"),  \
        INNER(slope, letter, c, REGISTER, I, values[FRACTION], 1, heading,                         \
              "what it grows by to the next pixel"),                                               \
        INNER(curve, letter, c, REGISTER, I, values[FRACTION], 1, heading,                         \
              "what that growth grows by"),                                                        \
        INNER(next_value, letter, c, BLOCK, I, values[FRACTION], 1, heading, "value + slope"),     \
        INNER(next_slope, letter, c, BLOCK, I, values[FRACTION], 1, heading, "slope + curve"),     \
        INNER(level, letter, c, BLOCK, I + 1, 0, 1, heading, "the value rounded half up"),         \
        S(component[c].clamped, "clamped_" letter, NULL, BLOCK, GLINT_COLOR_BITS, 0, 0, heading,   \
          "held in 0 ... 255")

GLINT_SIGNAL_TABLE(signal,
                   S(s1_valid, "s1_valid", NULL, STAGE, 1, 0, 0, UNDER_WAY, "value is a pixel's"),
                   COMPONENT("r", 0, RED), COMPONENT("g", 1, GREEN), COMPONENT("b", 2, BLUE),
                   S(out_valid, "out_valid", NULL, OUTPUT, 1, 0, 0, OUTPUTS, "the pixel is new"),
                   S(component[0].out, "r", NULL, OUTPUT, GLINT_COLOR_BITS, 0, 0, OUTPUTS, "red"),
                   S(component[1].out, "g", NULL, OUTPUT, GLINT_COLOR_BITS, 0, 0, OUTPUTS, "green"),
                   S(component[2].out, "b", NULL, OUTPUT, GLINT_COLOR_BITS, 0, 0, OUTPUTS, "blue"))

GLINT_ALWAYS(const char *, top, "quadratic_span")
GLINT_ALWAYS(int, latency, GLINT_QUADRATIC_SPAN_LATENCY)

/* ---- Drawing --------------------------------------------------------------------------------- */

/* One of R, G and B. */
#define OF_EACH(called, how, says, feeds, obeys)                                                   \
    {                                                                                              \
        .name = called, .symbol = GLINT_SYMBOL_##how, .text = says, .inputs = feeds,               \
        .control = obeys, .stacked = 1                                                             \
    }

GLINT_BLOCK_TABLE(block, OF_EACH("curve_r", REGISTER, "\u0394\u00b2", "second_r", "load"),
                  OF_EACH("next_slope_r", ADDER, NULL, "slope_r curve_r", NULL),
                  OF_EACH("slope_r", REGISTER, "\u0394", "first_r next_slope_r", "load, step"),
                  OF_EACH("next_value_r", ADDER, NULL, "value_r slope_r", NULL),
                  OF_EACH("value_r", REGISTER, "I", "start_r next_value_r", "load, step"),
                  OF_EACH("level_r", LOGIC, "round", "value_r", NULL),
                  OF_EACH("clamped_r", LOGIC, "0\u2026255", "level_r", NULL),
                  GLINT_BLOCK("s1_valid", REGISTER, NULL, "load step", NULL),
                  OF_EACH("r", REGISTER, NULL, "clamped_r", "s1_valid"),
                  GLINT_BLOCK("out_valid", REGISTER, NULL, "s1_valid", NULL))

/* ---- C model --------------------------------------------------------------------------------- */

typedef struct model {
    glint_quadratic_span_signals s;
    int fraction;
} model;

static void begin(const int *values, void *created)
{
    ((model *)created)->fraction = values[FRACTION];
}

static void clock_edge(void *clocked, const void *pins)
{
    model *m = clocked;
    glint_quadratic_span_clock(m->fraction, &m->s, pins);
}

/* ---- Domain ---------------------------------------------------------------------------------- */

/* Every level with what stands next behind the point and, further behind, all bits alike: loaded,
 * then three steps on by numbers of the same kind. The components are at different places. */
enum {
    UPPER_FRACTION = 5,
    TOP_BITS = I + UPPER_FRACTION,
    CLOCKS = 4,
    STARTS = 2 << TOP_BITS,
    APART = STARTS / GLINT_QUADRATIC_SPAN_COMPONENTS,
    OTHER = 1001, /* to the numbers at the pins while it steps, which it must not take */
};

GLINT_ALWAYS(uint64_t, points, (uint64_t)STARTS *CLOCKS)

static int64_t number(uint64_t place, int fraction)
{
    const int lower = fraction - UPPER_FRACTION;
    const int64_t below = (place & 1u) != 0 ? (INT64_C(1) << lower) - 1 : 0;
    const int64_t top = (int64_t)(place / 2 % (1u << TOP_BITS)) - (1 << (TOP_BITS - 1));
    return top * (INT64_C(1) << lower) + below;
}

static void put(const int *values, uint64_t point, void *pins_now)
{
    glint_quadratic_span_pins *pins = pins_now;
    pins->load = point % CLOCKS == 0;
    pins->step = 1;
    for (unsigned c = 0; c < GLINT_QUADRATIC_SPAN_COMPONENTS; c++) {
        const uint64_t place = point / CLOCKS + c * APART + point % CLOCKS * OTHER;
        pins->walk.start[c] = number(place % STARTS, values[FRACTION]);
        pins->walk.first[c] = number(37 * place % STARTS, values[FRACTION]);
        pins->walk.second[c] = number(101 * place % STARTS, values[FRACTION]);
    }
}

static const glint_domain domain = {
    .what = "every level and its upper five fraction bits, loaded and three steps on",
    .points = points,
    .put = put,
};

const glint_circuit glint_circuit_span = {
    .name = "span",
    .title = "Span unit of quadratic interpolation",
    .clock_port = "clk",
    .on_request = 1,
    .top = top,
    GLINT_PARAMETERS(parameters),
    GLINT_PINS(glint_quadratic_span_pins, pin),
    GLINT_SIGNALS(signal),
    .latency = latency,
    GLINT_MODEL(model, begin, clock_edge),
    .domain = &domain,
    GLINT_BLOCKS(block),
};
