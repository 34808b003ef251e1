/* free_runner: no reset, no enable, nothing that says when something is taken. */
#include <stdlib.h>

#include "glint_describe.h"

typedef struct pins {
    int8_t step;
} pins;

GLINT_PIN_TABLE(pin_count, pin, GLINT_PIN(pins, step, DATA, 5, 0, 1, "how far, but for 1"))

typedef struct signals_now {
    int64_t count;
} signals_now;

GLINT_SIGNAL_TABLE(signal_count, signal,
                   GLINT_SIGNAL_OF(signals_now, count, "count__33", NULL, OUTPUT, 33, 0, 0, -1,
                                   NULL, "since power-up"))

GLINT_ALWAYS(const char *, top, "free_runner")
GLINT_ALWAYS(int, latency, 1)

static void clock_edge(void *model, const void *pins_now)
{
    signals_now *s = model;
    s->count += ((const pins *)pins_now)->step + 1;
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

const glint_circuit glint_my_circuit = {
    .name = "free_runner",
    .title = "Counts from power-up on",
    .clock_port = "clk_i",
    .top = top,
    .pin_count = pin_count,
    .pin = pin,
    .pins_size = sizeof(pins),
    .signal_count = signal_count,
    .signal = signal,
    .latency = latency,
    .create = create,
    .destroy = free,
    .clock = clock_edge,
    .signals = signals,
};
