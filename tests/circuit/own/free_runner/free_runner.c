/* free_runner: no reset, no enable, no valid pin. */
#include "glint_describe.h"

typedef struct pins {
    int8_t step;
} pins;

GLINT_PIN_TABLE(pin, GLINT_PIN(pins, step, DATA, 5, 0, 1, "how far, but for 1"))

typedef struct signals_now {
    int64_t count;
} signals_now;

GLINT_SIGNAL_TABLE(signal, GLINT_SIGNAL_OF(signals_now, count, "count__33", NULL, OUTPUT, 33, 0, 0,
                                           -1, NULL, "since power-up"))

static void clock_edge(void *model, const void *pins_now)
{
    signals_now *s = model;
    s->count += ((const pins *)pins_now)->step + 1;
}

const glint_circuit glint_my_circuit = {
    .name = "free_runner",
    .title = "Counts from power-up on",
    .clock_port = "clk_i",
    GLINT_PINS(pins, pin),
    GLINT_SIGNALS(signal),
    GLINT_MODEL(signals_now, NULL, clock_edge),
};
