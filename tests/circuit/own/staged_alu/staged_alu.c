/* staged_alu: three parameters, of choices and of ranges; stages in a generate loop, as many as one
 * parameter says; a second Verilog file. */
#include "glint_describe.h"

enum { OP, WIDTH, STAGES };
enum { OP_ADD, OP_SUBTRACT, OP_XOR };
enum { STAGES_MAX = 6 };

static const char *const op_names[] = {"add", "subtract", "xor"};
static const glint_parameter parameters[] = {
    {.name = "op",
     .verilog = "OP",
     .meaning = "what a stage does",
     .choices = op_names,
     .max = OP_XOR},
    {.name = "width",
     .verilog = "WIDTH",
     .meaning = "bits of a number",
     .min = 2,
     .max = 32,
     .standard = 8,
     GLINT_LISTED(8)},
    {.name = "stages",
     .verilog = "STAGES",
     .meaning = "how often it is done",
     .min = 1,
     .max = STAGES_MAX,
     .standard = 2,
     GLINT_LISTED(1, 3)},
};

typedef struct pins {
    uint8_t reset, en, in_valid;
    uint32_t a, b;
} pins;

GLINT_PIN_TABLE(pin, GLINT_PIN(pins, reset, RESET, 1, 0, 0, "clears everything"),
                GLINT_PIN(pins, en, ENABLE, 1, 0, 0, "0 freezes everything"),
                GLINT_PIN(pins, in_valid, VALID, 1, 0, 0, "a and b are taken"),
                GLINT_PIN(pins, a, DATA, values[WIDTH], 0, 0, "the beginning"),
                GLINT_PIN(pins, b, DATA, values[WIDTH], 0, 0, "the operand of every stage"))

typedef struct stage_signals {
    int64_t valid, value, operand;
} stage_signals;

typedef struct signals_now {
    stage_signals stage[STAGES_MAX + 1]; /* 0: what stage 1 takes */
    int64_t out_valid, result;
} signals_now;

enum { OUTPUTS = 2, STAGE_ROWS = 3 };

static int signal_count(const int *values)
{
    return OUTPUTS + values[STAGES] * STAGE_ROWS;
}

static glint_signal_info stage_signal(const int *values, int stage, int row)
{
    const glint_signal_info rows[STAGE_ROWS] = {
        GLINT_SIGNAL_OF(signals_now, stage[stage].valid, "valid", NULL, STAGE, 1, 0, 0, stage, NULL,
                        "it holds something"),
        GLINT_SIGNAL_OF(signals_now, stage[stage].value, "value", NULL, STAGE, values[WIDTH], 0, 0,
                        stage, NULL, "the result so far"),
        GLINT_SIGNAL_OF(signals_now, stage[stage].operand, "operand", NULL, STAGE, values[WIDTH], 0,
                        0, stage, NULL, "b on its way"),
    };
    return rows[row];
}

static glint_signal_info signal(const int *values, int index)
{
    const glint_signal_info outputs[OUTPUTS] = {
        GLINT_SIGNAL(signals_now, out_valid, OUTPUT, 1, 0, 0, "Outputs", "a result is out"),
        GLINT_SIGNAL(signals_now, result, OUTPUT, values[WIDTH], 0, 0, "Outputs", "the result"),
    };
    const int behind = values[STAGES] * STAGE_ROWS;
    return index < behind ? stage_signal(values, 1 + index / STAGE_ROWS, index % STAGE_ROWS)
                          : outputs[index - behind];
}

static int latency(const int *values)
{
    return values[STAGES];
}

typedef struct alu {
    signals_now s;
    int op, stages;
    uint32_t mask;
} alu;

static stage_signals done_by(const alu *m, const stage_signals *before)
{
    stage_signals after = *before;
    if (m->op == OP_ADD)
        after.value += before->operand;
    else if (m->op == OP_SUBTRACT)
        after.value -= before->operand;
    else
        after.value ^= before->operand;
    after.value &= m->mask;
    return after;
}

static void clock_edge(void *model, const void *pins_now)
{
    alu *m = model;
    const pins *in = pins_now;
    signals_now *s = &m->s;
    if (in->reset) {
        *s = (signals_now){0};
    } else if (in->en) {
        s->stage[0] = (stage_signals){in->in_valid, in->a & m->mask, in->b & m->mask};
        for (int j = m->stages; j >= 1; j--)
            s->stage[j] = done_by(m, &s->stage[j - 1]);
    }
    s->out_valid = s->stage[m->stages].valid;
    s->result = s->stage[m->stages].value;
}

static void begin(const int *values, void *model)
{
    alu *m = model;
    m->op = values[OP];
    m->stages = values[STAGES];
    m->mask = UINT32_MAX >> (32 - values[WIDTH]);
}

const glint_circuit glint_my_circuit = {
    .name = "staged_alu",
    .title = "One operation, several times",
    .clock_port = "clk",
    GLINT_PARAMETERS(parameters),
    GLINT_PINS(pins, pin),
    GLINT_SIGNALS(signal),
    .lane_name = "stage",
    .lane_scope = "stage[%d].u",
    .latency = latency,
    GLINT_MODEL(alu, begin, clock_edge),
};
