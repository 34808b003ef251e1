/* clip_lanes: lanes in a generate loop with ports side by side: 1 to 32 lanes of 12 bits, up to 384
 * bits per port. */
#include <string.h>

#include "glint_describe.h"

enum { LANES };
enum { LANES_MAX = 32 };

static const glint_parameter parameters[] = {
    {.name = "lanes",
     .verilog = "LANES",
     .meaning = "numbers a clock",
     .min = 1,
     .max = LANES_MAX,
     .standard = 1,
     GLINT_LISTED(1, 3, 8)},
};

typedef struct pins {
    uint8_t reset, en;
    uint32_t in_valid;
    int16_t x[LANES_MAX];
} pins;

enum { SHARED_PINS = 3 };

static int pin_count(const int *values)
{
    return SHARED_PINS + values[LANES];
}

static glint_pin_info pin(const int *values, int index)
{
    const glint_pin_info shared[SHARED_PINS] = {
        GLINT_PIN(pins, reset, RESET, 1, 0, 0, "clears everything"),
        GLINT_PIN(pins, en, ENABLE, 1, 0, 0, "0 freezes everything"),
        GLINT_PIN(pins, in_valid, VALID, values[LANES], 0, 0, "which lanes take a number"),
    };
    if (index < SHARED_PINS)
        return shared[index];
    const int lane = index - SHARED_PINS;
    return (glint_pin_info)GLINT_PIN_OF(pins, x[lane], "x", DATA, 12, 0, 1, lane, "a number");
}

typedef struct lane_signals {
    int64_t held, clipped, y;
} lane_signals;

typedef struct signals_now {
    int64_t s1_valid, out_valid;
    lane_signals lane[LANES_MAX];
} signals_now;

#define VALID   "Valid bits"
#define NUMBERS "Numbers"

static const glint_heading headings[] = {{.title = NUMBERS}, {.title = VALID}};

enum { SHARED_SIGNALS = 2, LANE_SIGNALS = 3 };

static int signal_count(const int *values)
{
    return SHARED_SIGNALS + values[LANES] * LANE_SIGNALS;
}

static glint_signal_info lane_signal(int lane, int row)
{
    const glint_signal_info rows[LANE_SIGNALS] = {
        GLINT_SIGNAL_OF(signals_now, lane[lane].held, "held", NULL, REGISTER, 12, 0, 1, lane,
                        NUMBERS, "the number taken"),
        GLINT_SIGNAL_OF(signals_now, lane[lane].clipped, "clipped", NULL, BLOCK, 8, 0, 1, lane,
                        NUMBERS, "brought into range"),
        GLINT_SIGNAL_OF(signals_now, lane[lane].y, "y", NULL, OUTPUT, 8, 0, 1, lane, NUMBERS,
                        "the result"),
    };
    return rows[row];
}

static glint_signal_info signal(const int *values, int index)
{
    const glint_signal_info shared[SHARED_SIGNALS] = {
        GLINT_SIGNAL(signals_now, s1_valid, STAGE, values[LANES], 0, 0, VALID, "lanes with one"),
        GLINT_SIGNAL(signals_now, out_valid, OUTPUT, values[LANES], 0, 0, VALID, "results out"),
    };
    if (index < SHARED_SIGNALS)
        return shared[index];
    return lane_signal((index - SHARED_SIGNALS) / LANE_SIGNALS,
                       (index - SHARED_SIGNALS) % LANE_SIGNALS);
}

GLINT_ALWAYS(int, latency, 2)

typedef struct clip {
    signals_now s;
    int lanes;
} clip;

static int64_t clamp(int64_t x)
{
    return x > 127 ? 127 : x < -128 ? -128 : x;
}

static void edge(clip *m, const pins *in)
{
    m->s.out_valid = m->s.s1_valid;
    m->s.s1_valid = in->in_valid;
    for (int i = 0; i < m->lanes; i++) {
        lane_signals *lane = &m->s.lane[i];
        lane->y = lane->clipped;
        if (in->in_valid >> i & 1)
            lane->held = in->x[i];
        lane->clipped = clamp(lane->held);
    }
}

static void clock_edge(void *model, const void *pins_now)
{
    clip *m = model;
    const pins *in = pins_now;
    if (in->reset)
        memset(&m->s, 0, sizeof m->s);
    else if (in->en)
        edge(m, in);
}

static void begin(const int *values, void *model)
{
    clip *m = model;
    m->lanes = values[LANES];
}

const glint_circuit glint_my_circuit = {
    .name = "clip_lanes",
    .title = "Numbers brought into range",
    .clock_port = "clk",
    GLINT_PARAMETERS(parameters),
    GLINT_PINS(pins, pin),
    GLINT_SIGNALS(signal),
    .lane_name = "lane",
    .lane_scope = "lane[%d].u",
    GLINT_HEADINGS(headings),
    .latency = latency,
    GLINT_MODEL(clip, begin, clock_edge),
};
