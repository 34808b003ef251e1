/* The description of a highlight unit (cmodel/glint_unit.h): all but its names, its parameters and
 * the headings of its waveform.
 *
 *     static const glint_parameter parameters[] = {
 *         {.name = "accuracy", …},   the unit's variants, where it has more than one
 *         GLINT_HIGHLIGHT_PIPELINE,
 *         GLINT_HIGHLIGHT_LANES,
 *     };
 *     static const glint_unit_heading headings[] = {{"n x", 7}, …};
 *     GLINT_UNIT_DESCRIPTION(power, "Power device", "power_device", glint_unit_power)
 *
 * defines glint_circuit_power. Pins and random pins are the specular device's; the domain is every
 * n with every code of the cosine, a clock for as many codes as there are lanes. */
#ifndef GLINT_SIM_CIRCUIT_UNIT_H
#define GLINT_SIM_CIRCUIT_UNIT_H

#include "circuit/circuits.h"
#include "circuit/highlight.h"
#include "circuit/stimulus.h"
#include "glint_unit.h"

/* The blocks of a lane that stand together in a waveform, as the data flows. */
typedef struct glint_unit_heading {
    const char *title;
    unsigned char block[5]; /* numbers; 0: no more */
} glint_unit_heading;

/* A unit with the tables of its description. */
typedef struct glint_unit_circuit {
    const glint_unit *unit;
    const char *const *variants; /* their names; NULL: there is one alone */
    const glint_unit_heading *headings;
    int heading_count;
} glint_unit_circuit;

/* The pipeline and the lanes stand behind the variant, where there is one. */
glint_unit_config glint_unit_config_of(const glint_unit *unit, const int *values);

/* What the functions of the description do. */
void glint_unit_describe(const glint_unit_circuit *of, const int *values, char *text, size_t size);
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

/* The headings of the circuit: {{.title = "…"}, …} of the unit's stand in the middle. */
#define GLINT_UNIT_HEADINGS(...)                                                                   \
    {.title = GLINT_UNIT_HEADING_OUTPUTS}, {.title = GLINT_UNIT_HEADING_N}, __VA_ARGS__,           \
        {.title = GLINT_UNIT_HEADING_W}, {.title = GLINT_UNIT_HEADING_COLORS},                     \
        {.title = GLINT_UNIT_HEADING_MUL}, {.title = GLINT_UNIT_HEADING_VALID},                    \
    {                                                                                              \
        .title = GLINT_UNIT_HEADING_DELAYED, .folded = 1                                           \
    }

/* Of `parameters`, `own` (glint_unit_circuit) and `headings` (glint_heading), which the file has.
 */
#define GLINT_UNIT_DESCRIPTION(name_, title_, top_)                                                \
    static int lanes_of(const int *values)                                                         \
    {                                                                                              \
        return glint_unit_config_of(own.unit, values).lanes;                                       \
    }                                                                                              \
    static void describe(const int *values, char *text, size_t size)                               \
    {                                                                                              \
        glint_unit_describe(&own, values, text, size);                                             \
    }                                                                                              \
    GLINT_ALWAYS(const char *, top, top_)                                                          \
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
        .clock_port = "clk",                                                                       \
        .top = top,                                                                                \
        .parameters = parameters,                                                                  \
        .parameter_count = sizeof parameters / sizeof parameters[0],                               \
        .describe = describe,                                                                      \
        .pin_count = pin_count,                                                                    \
        .pin = pin,                                                                                \
        .pins_size = sizeof(glint_specular_inputs),                                                \
        .signal_count = signal_count,                                                              \
        .signal = signal,                                                                          \
        .lane_name = "lane",                                                                       \
        .lane_scope = "lane[%d].u",                                                                \
        .headings = headings,                                                                      \
        .heading_count = sizeof headings / sizeof headings[0],                                     \
        .latency = latency,                                                                        \
        .create = create,                                                                          \
        .destroy = glint_unit_destroy,                                                             \
        .clock = glint_unit_clock,                                                                 \
        .signals = glint_unit_signals,                                                             \
        .stimulus_size = sizeof(glint_stimulus),                                                   \
        .stimulus_begin = stimulus_begin,                                                          \
        .stimulus_next = glint_unit_stimulus_next,                                                 \
        .domain = &domain,                                                                         \
    };

#endif
