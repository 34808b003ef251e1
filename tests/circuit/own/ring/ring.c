/* ring: an asynchronous reset that is active low, no enable, a clock of another name, combinational
 * outputs of the pins, a memory, and a register in a submodule that leads nowhere. */
#include <stdlib.h>
#include <string.h>

#include "glint_describe.h"

enum { PLACES = 4 };

typedef struct pins {
    uint8_t rst_n, push, pop;
    int8_t data;
} pins;

GLINT_PIN_TABLE(pin, GLINT_PIN(pins, rst_n, RESET_LOW, 1, 0, 0, "0 empties it at once"),
                GLINT_PIN(pins, push, VALID, 1, 0, 0, "data goes in"),
                GLINT_PIN(pins, pop, STROBE, 1, 0, 0, "the front goes away"),
                GLINT_PIN(pins, data, DATA, 8, 0, 1, "what goes in"))

typedef struct signals_now {
    int64_t mem[PLACES], head, level;
    int64_t gone, tail, taken, full, front, sum;
} signals_now;

#define QUEUE "The queue"
#define SUM   "The sum"

#define PLACE(i, name)                                                                             \
    GLINT_SIGNAL_OF(signals_now, mem[i], name, "mem[" #i "]", REGISTER, 8, 0, 1, -1, QUEUE,        \
                    "a place")

GLINT_SIGNAL_TABLE(signal, PLACE(0, "mem0"), PLACE(1, "mem1"), PLACE(2, "mem2"), PLACE(3, "mem3"),
                   GLINT_SIGNAL(signals_now, head, REGISTER, 2, 0, 0, QUEUE, "where the front is"),
                   GLINT_SIGNAL(signals_now, tail, BLOCK, 2, 0, 0, QUEUE, "the first free place"),
                   GLINT_SIGNAL(signals_now, gone, BLOCK, 1, 0, 0, QUEUE, "the front goes"),
                   GLINT_SIGNAL(signals_now, taken, MEALY, 1, 0, 0, QUEUE, "data is taken next"),
                   GLINT_SIGNAL(signals_now, full, OUTPUT, 1, 0, 0, QUEUE, "no place is free"),
                   GLINT_SIGNAL(signals_now, front, OUTPUT, 8, 0, 1, QUEUE, "the oldest"),
                   GLINT_SIGNAL(signals_now, level, OUTPUT, 3, 0, 0, QUEUE, "how many there are"),
                   GLINT_SIGNAL_OF(signals_now, sum, "sum", "u_sum.acc", REGISTER, 16, 0, 1, -1,
                                   SUM, "of all that were taken"))

/* What follows the state and the pins; `taken` is wanted as it is before the edge. */
static int64_t settle(signals_now *s, const pins *in)
{
    s->full = s->level == PLACES;
    s->gone = in->pop && s->level != 0;
    s->tail = (s->head + s->level) % PLACES;
    s->front = s->mem[s->head];
    return in->push && (!s->full || s->gone);
}

static void edge(signals_now *s, const pins *in)
{
    if (s->taken) {
        s->mem[s->tail] = in->data;
        s->sum = (int16_t)(s->sum + in->data);
    }
    if (s->gone)
        s->head = (s->head + 1) % PLACES;
    s->level += s->taken - s->gone;
}

static void clock_edge(void *model, const void *pins_now)
{
    signals_now *s = model;
    const pins *in = pins_now;
    if (!in->rst_n)
        memset(s, 0, sizeof *s); /* at once, so `taken` is that of an empty ring */
    s->taken = settle(s, in);
    if (in->rst_n)
        edge(s, in);
    (void)settle(s, in);
}

const glint_circuit glint_my_circuit = {
    .name = "ring",
    .title = "A queue of four",
    .clock_port = "clock",
    GLINT_PINS(pins, pin),
    GLINT_SIGNALS(signal),
    GLINT_MODEL(signals_now, NULL, clock_edge),
};
