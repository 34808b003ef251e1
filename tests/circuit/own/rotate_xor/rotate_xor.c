/* rotate_xor: ports of 100 bits, no parameter, no enable. */
#include "glint_describe.h"

enum { HIGH_BITS = 100 - 64, TURN = 13 };
#define HIGH_MASK ((UINT64_C(1) << HIGH_BITS) - 1)

typedef struct pins {
    uint8_t reset, in_valid;
    uint64_t word[2];
} pins;

GLINT_PIN_TABLE(pin, GLINT_PIN(pins, reset, RESET, 1, 0, 0, "clears the state"),
                GLINT_PIN(pins, in_valid, VALID, 1, 0, 0, "the word is taken"),
                GLINT_PIN(pins, word, DATA, 100, 0, 0, "what is mixed in"))

typedef struct signals_now {
    uint64_t turned[2], state[2];
    int64_t out_valid, parity;
} signals_now;

GLINT_SIGNAL_TABLE(signal,
                   GLINT_SIGNAL(signals_now, out_valid, OUTPUT, 1, 0, 0, "State", "it is new"),
                   GLINT_SIGNAL(signals_now, state, OUTPUT, 100, 0, 0, "State", "the word kept"),
                   GLINT_SIGNAL(signals_now, turned, BLOCK, 100, 0, 0, "State", "13 to the left"),
                   GLINT_SIGNAL(signals_now, parity, OUTPUT, 1, 0, 0, "State", "of its bits"))

static void settle(signals_now *s)
{
    const uint64_t out = s->state[1] >> (HIGH_BITS - TURN);
    s->turned[0] = s->state[0] << TURN | out;
    s->turned[1] = (s->state[1] << TURN | s->state[0] >> (64 - TURN)) & HIGH_MASK;
    s->parity = __builtin_parityll(s->state[0] ^ s->state[1]);
}

static void clock_edge(void *model, const void *pins_now)
{
    signals_now *s = model;
    const pins *in = pins_now;
    if (in->reset) {
        *s = (signals_now){0};
    } else {
        s->out_valid = in->in_valid;
        if (in->in_valid) {
            s->state[0] = s->turned[0] ^ in->word[0];
            s->state[1] = (s->turned[1] ^ in->word[1]) & HIGH_MASK;
        }
    }
    settle(s);
}

const glint_circuit glint_my_circuit = {
    .name = "rotate_xor",
    .title = "Turned and mixed",
    .clock_port = "clk",
    GLINT_PINS(pins, pin),
    GLINT_SIGNALS(signal),
    GLINT_MODEL(signals_now, NULL, clock_edge),
};
