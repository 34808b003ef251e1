/* The description of a highlight unit (cmodel/glint_unit.h): all but its names, its parameters and
 * the headings of its waveform.
 *
 *     static const glint_parameter parameters[] = {
 *         {.name = "accuracy", …},   the unit's variants, where it has more than one
 *         GLINT_HIGHLIGHT_W_DROP(…),
 *         GLINT_HIGHLIGHT_PIPELINE,
 *         GLINT_HIGHLIGHT_LANES,
 *     };
 *     #define HEADINGS(X)              a title, and the lane's blocks below it
 *         X("Multiplier 7: n x", 7)
 *         X("Blocks 10, 11: v", 10, 11)
 *     GLINT_UNIT_DESCRIPTION(power, "Power device", HEADINGS)
 *
 * defines glint_circuit_power, of glint_unit_power and the top power_device. Pins and random pins
 * are the specular device's; the domain is every n with every code of the cosine, a clock for as
 * many codes as there are lanes. */
#ifndef GLINT_SIM_CIRCUIT_UNIT_H
#define GLINT_SIM_CIRCUIT_UNIT_H

#include "circuit/circuits.h"
#include "circuit/highlight.h"
#include "circuit/stimulus.h"
#include "glint_describe.h"
#include "glint_unit.h"

/* The blocks of a lane that stand together in a waveform, as the data flows. */
typedef struct glint_unit_heading {
    const char *title;
    unsigned char block[5]; /* numbers; 0: no more */
} glint_unit_heading;

/* A unit with the tables of its description. */
typedef struct glint_unit_circuit {
    const glint_unit *unit;
    const glint_unit_heading *headings;
    int heading_count;
} glint_unit_circuit;

/* From values and back: the others stand behind the variant, where there is one. */
glint_unit_config glint_unit_config_of(const glint_unit *unit, const int *values);

void glint_unit_config_values(const glint_unit_config *config, int *values);

/* What the functions of the description do. */
glint_signal_info glint_unit_signal(const glint_unit_circuit *of, const int *values, int index);
glint_status glint_unit_create(const glint_unit *unit, const int *values, void **model);
void glint_unit_destroy(void *model);
void glint_unit_clock(void *model, const void *pins);
const void *glint_unit_signals(const void *model);
void glint_unit_stimulus_next(void *stimulus, void *pins);
uint64_t glint_unit_points(int lanes);
void glint_unit_put(int lanes, uint64_t point, void *pins);

/* In the order of waveforms: these around the unit's own. */
#define GLINT_UNIT_HEADING_OUTPUTS "Outputs"
#define GLINT_UNIT_HEADING_N       "Register 2: n"
#define GLINT_UNIT_HEADING_COLORS  "Registers 3, 4, 5"
#define GLINT_UNIT_HEADING_W       "W"
#define GLINT_UNIT_HEADING_MUL     "Multipliers 13-15"
#define GLINT_UNIT_HEADING_VALID   "Valid bits"
#define GLINT_UNIT_HEADING_DELAYED "n, R, G, B delayed"

#define GLINT_UNIT_LANE_HEADING(title_, ...) {title_, {__VA_ARGS__}},
#define GLINT_UNIT_HEADING(title_, ...)      {.title = title_},

/* Of `parameters`, which the file has, and its list of headings. */
#define GLINT_UNIT_DESCRIPTION(name_, title_, HEADINGS)                                            \
    GLINT_UNIT_DESCRIPTION_WITH(name_, title_, HEADINGS, .domain = &domain)

/* The same with a drawing: GLINT_BLOCKS(block_), of a table in which GLINT_UNIT_ROW_OF is a
 * register between two stages, or the wire in its place. */
#define GLINT_UNIT_DESCRIPTION_DRAWN(name_, title_, HEADINGS, block_)                              \
    GLINT_UNIT_DESCRIPTION_WITH(name_, title_, HEADINGS, .domain = &domain, GLINT_BLOCKS(block_))

#define GLINT_UNIT_ROW_OF(unit_, called, from)                                                     \
    {                                                                                              \
        .name = called, .inputs = from,                                                            \
        .symbol = glint_unit_config_of(unit_, values).pipeline == GLINT_PIPELINE_PIPELINED         \
                      ? GLINT_SYMBOL_REGISTER                                                      \
                      : GLINT_SYMBOL_WIRE                                                          \
    }

#define GLINT_UNIT_DESCRIPTION_WITH(name_, title_, HEADINGS, ...)                                  \
    static const glint_unit_heading lane_headings[] = {HEADINGS(GLINT_UNIT_LANE_HEADING)};         \
    static const glint_unit_circuit own = {                                                        \
        .unit = &glint_unit_##name_,                                                               \
        .headings = lane_headings,                                                                 \
        .heading_count = sizeof lane_headings / sizeof lane_headings[0],                           \
    };                                                                                             \
    static const glint_heading headings[] = {                                                      \
        {.title = GLINT_UNIT_HEADING_OUTPUTS},                                                     \
        {.title = GLINT_UNIT_HEADING_N},                                                           \
        HEADINGS(GLINT_UNIT_HEADING){.title = GLINT_UNIT_HEADING_W},                               \
        {.title = GLINT_UNIT_HEADING_COLORS},                                                      \
        {.title = GLINT_UNIT_HEADING_MUL},                                                         \
        {.title = GLINT_UNIT_HEADING_VALID},                                                       \
        {.title = GLINT_UNIT_HEADING_DELAYED, .folded = 1},                                        \
    };                                                                                             \
    static int lanes_of(const int *values)                                                         \
    {                                                                                              \
        return glint_unit_config_of(own.unit, values).lanes;                                       \
    }                                                                                              \
    GLINT_ALWAYS(const char *, top, #name_ "_device")                                              \
    static int pin_count(const int *values)                                                        \
    {                                                                                              \
        return glint_highlight_pin_count(lanes_of(values));                                        \
    }                                                                                              \
    static glint_pin_info pin(const int *values, int index)                                        \
    {                                                                                              \
        return glint_highlight_pin(lanes_of(values), index);                                       \
    }                                                                                              \
    static int signal_count(const int *values)                                                     \
    {                                                                                              \
        const glint_unit_config config = glint_unit_config_of(own.unit, values);                   \
        return glint_unit_signal_count(&config);                                                   \
    }                                                                                              \
    static glint_signal_info signal(const int *values, int index)                                  \
    {                                                                                              \
        return glint_unit_signal(&own, values, index);                                             \
    }                                                                                              \
    static int latency(const int *values)                                                          \
    {                                                                                              \
        const glint_unit_config config = glint_unit_config_of(own.unit, values);                   \
        return glint_unit_latency(&config);                                                        \
    }                                                                                              \
    static glint_status create(const int *values, void **model)                                    \
    {                                                                                              \
        return glint_unit_create(own.unit, values, model);                                         \
    }                                                                                              \
    static void stimulus_begin(void *stimulus, const int *values, uint64_t seed)                   \
    {                                                                                              \
        glint_stimulus_init(stimulus, seed, lanes_of(values));                                     \
    }                                                                                              \
    static uint64_t points(const int *values)                                                      \
    {                                                                                              \
        return glint_unit_points(lanes_of(values));                                                \
    }                                                                                              \
    static void put(const int *values, uint64_t point, void *pins)                                 \
    {                                                                                              \
        glint_unit_put(lanes_of(values), point, pins);                                             \
    }                                                                                              \
    static const glint_domain domain = {                                                           \
        .what = "every n with every code of the cosine", .points = points, .put = put};            \
    const glint_circuit glint_circuit_##name_ = {                                                  \
        .name = #name_,                                                                            \
        .title = title_,                                                                           \
        .on_request = 1,                                                                           \
        .clock_port = "clk",                                                                       \
        .top = top,                                                                                \
        GLINT_PARAMETERS(parameters),                                                              \
        GLINT_PINS(glint_specular_inputs, pin),                                                    \
        GLINT_SIGNALS(signal),                                                                     \
        .lane_name = "lane",                                                                       \
        .lane_scope = "lane[%d].u",                                                                \
        GLINT_HEADINGS(headings),                                                                  \
        .latency = latency,                                                                        \
        .create = create,                                                                          \
        .destroy = glint_unit_destroy,                                                             \
        .clock = glint_unit_clock,                                                                 \
        .signals = glint_unit_signals,                                                             \
        .stimulus_size = sizeof(glint_stimulus),                                                   \
        .stimulus_begin = stimulus_begin,                                                          \
        .stimulus_next = glint_unit_stimulus_next,                                                 \
        __VA_ARGS__,                                                                               \
    };

#endif
