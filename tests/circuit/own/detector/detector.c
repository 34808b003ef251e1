/* detector: a Mealy machine, its output combinational of state and pin; no number at its pins. The
 * top module depends on a parameter that the Verilog does not have. */
#include "glint_describe.h"

enum { FORM };
enum { FORM_BINARY, FORM_ONEHOT };

static const char *const form_names[] = {"binary", "onehot"};
static const glint_parameter parameters[] = {
    {.name = "form", .meaning = "how the state is kept", .choices = form_names, .max = FORM_ONEHOT},
};

typedef struct pins {
    uint8_t reset, bit_in;
} pins;

GLINT_PIN_TABLE(pin, GLINT_PIN(pins, reset, RESET, 1, 0, 0, "nothing fits"),
                GLINT_PIN(pins, bit_in, STROBE, 1, 0, 0, "the next bit"))

typedef struct signals_now {
    int64_t state, found, count;
} signals_now;

GLINT_SIGNAL_TABLE(signal,
                   GLINT_SIGNAL(signals_now, state, REGISTER, values[FORM] == FORM_ONEHOT ? 4 : 2,
                                0, 0, "Detector", "how many bits fit"),
                   GLINT_SIGNAL(signals_now, found, MEALY, 1, 0, 0, "Detector", "they end here"),
                   GLINT_SIGNAL(signals_now, count, OUTPUT, 8, 0, 0, "Detector", "found so far"))

static const char *top(const int *values)
{
    return values[FORM] == FORM_ONEHOT ? "detector_onehot" : "detector_binary";
}

GLINT_ALWAYS(int, latency, 0)

typedef struct detector {
    signals_now s;
    int form;
    int fit; /* bits that fit so far; −1: after reset */
} detector;

static int fit_of(const detector *m)
{
    return m->fit < 0 ? 0 : m->fit;
}

static void clock_edge(void *model, const void *pins_now)
{
    static const int next[4][2] = {{0, 1}, {2, 1}, {0, 3}, {2, 1}};
    detector *m = model;
    const pins *in = pins_now;
    m->s.found = fit_of(m) == 3 && in->bit_in; /* before the edge */
    m->s.count = in->reset ? 0 : (m->s.count + m->s.found) & 0xff;
    m->fit = in->reset ? -1 : next[fit_of(m)][in->bit_in];
    m->s.state = m->form == FORM_BINARY ? fit_of(m) : m->fit < 0 ? 0 : 1 << m->fit;
}

static void begin(const int *values, void *model)
{
    detector *m = model;
    m->form = values[FORM];
    m->fit = -1;
}

const glint_circuit glint_my_circuit = {
    .name = "detector",
    .title = "Finds 1 0 1 1",
    .clock_port = "clk",
    .top = top,
    GLINT_PARAMETERS(parameters),
    GLINT_PINS(pins, pin),
    GLINT_SIGNALS(signal),
    .latency = latency,
    GLINT_MODEL(detector, begin, clock_edge),
};
