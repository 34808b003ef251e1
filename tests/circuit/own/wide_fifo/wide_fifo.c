/* wide_fifo: a memory of 96-bit words, as many as a parameter says, and pins that mean something
 * together: ready and valid. */
#include <string.h>

#include "glint_describe.h"

enum { DEPTH_LOG };
enum { DEPTH_MAX = 8, WORD_BITS = 96 };

static const glint_parameter parameters[] = {
    {.name = "depth-log",
     .verilog = "DEPTH_LOG",
     .meaning = "logarithm of the depth",
     .min = 1,
     .max = 3,
     .standard = 2},
};

typedef uint64_t word[2];

typedef struct pins {
    uint8_t reset, s_valid, m_ready;
    word s_data;
} pins;

GLINT_PIN_TABLE(pin, GLINT_PIN(pins, reset, RESET, 1, 0, 0, "empties it"),
                GLINT_PIN(pins, s_valid, VALID, 1, 0, 0, "a word is offered"),
                GLINT_PIN(pins, m_ready, STROBE, 1, 0, 0, "the oldest word may leave"),
                GLINT_PIN(pins, s_data, DATA, WORD_BITS, 0, 0, "the word"))

typedef struct signals_now {
    int64_t written, taken, level, s_ready, m_valid;
    word m_data, mem[DEPTH_MAX];
} signals_now;

#define QUEUE "Queue"
#define WORDS "Words"

enum { OTHERS = 6 };

static int signal_count(const int *values)
{
    return OTHERS + (1 << values[DEPTH_LOG]);
}

#define CELL(i)                                                                                    \
    GLINT_SIGNAL_OF(signals_now, mem[i], "mem" #i, "mem[" #i "]", REGISTER, WORD_BITS, 0, 0, -1,   \
                    WORDS, "a word")

static glint_signal_info signal(const int *values, int index)
{
    const int bits = values[DEPTH_LOG] + 1;
    const glint_signal_info rows[OTHERS + DEPTH_MAX] = {
        CELL(0),
        CELL(1),
        CELL(2),
        CELL(3),
        CELL(4),
        CELL(5),
        CELL(6),
        CELL(7),
        GLINT_SIGNAL(signals_now, written, REGISTER, bits, 0, 0, QUEUE, "words so far"),
        GLINT_SIGNAL(signals_now, taken, REGISTER, bits, 0, 0, QUEUE, "of these gone"),
        GLINT_SIGNAL(signals_now, level, OUTPUT, bits, 0, 0, QUEUE, "how many are there"),
        GLINT_SIGNAL(signals_now, s_ready, OUTPUT, 1, 0, 0, QUEUE, "there is room"),
        GLINT_SIGNAL(signals_now, m_valid, OUTPUT, 1, 0, 0, QUEUE, "there is a word"),
        GLINT_SIGNAL(signals_now, m_data, OUTPUT, WORD_BITS, 0, 0, WORDS, "the oldest"),
    };
    const int depth = 1 << values[DEPTH_LOG];
    return rows[index < depth ? index : DEPTH_MAX + index - depth];
}

typedef struct fifo {
    signals_now s;
    int depth;
} fifo;

static void settle(fifo *m)
{
    signals_now *s = &m->s;
    s->level = (s->written - s->taken) & (2 * m->depth - 1);
    s->s_ready = s->level < m->depth;
    s->m_valid = s->level > 0;
    memcpy(s->m_data, s->mem[s->taken & (m->depth - 1)], sizeof s->m_data);
}

static void begin(const int *values, void *model)
{
    fifo *m = model;
    m->depth = 1 << values[DEPTH_LOG];
    settle(m);
}

static void clock_edge(void *model, const void *pins_now)
{
    fifo *m = model;
    const pins *in = pins_now;
    signals_now *s = &m->s;
    if (in->reset) {
        s->written = s->taken = 0;
    } else {
        if (in->s_valid && s->s_ready)
            memcpy(s->mem[s->written++ & (m->depth - 1)], in->s_data, sizeof in->s_data);
        if (s->m_valid && in->m_ready)
            s->taken++;
    }
    settle(m);
}

const glint_circuit glint_my_circuit = {
    .name = "wide_fifo",
    .title = "A queue of wide words",
    .clock_port = "clk",
    GLINT_PARAMETERS(parameters),
    GLINT_PINS(pins, pin),
    GLINT_SIGNALS(signal),
    GLINT_MODEL(fifo, begin, clock_edge),
};
