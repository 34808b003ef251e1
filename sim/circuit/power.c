/* The power device, described. */
#include <stdio.h>
#include <string.h>

#include "circuit/circuits.h"
#include "circuit/highlight.h"
#include "circuit/stimulus.h"
#include "glint_describe.h"
#include "glint_power_device.h"

enum { ACCURACY, PIPELINE, LANES, PARAMETERS };

static const char *const accuracies[] = {"half", "quarter"};
_Static_assert(sizeof accuracies / sizeof accuracies[0] == GLINT_POWER_ACCURACY_COUNT,
               "a name for each accuracy");

static const glint_parameter parameters[PARAMETERS] = {
    [ACCURACY] = {.name = "accuracy",
                  .verilog = "ACCURACY",
                  .meaning = "largest error of W, of an 8-bit step",
                  .choices = accuracies,
                  .max = GLINT_POWER_ACCURACY_COUNT - 1,
                  .standard = GLINT_POWER_HALF},
    [PIPELINE] = GLINT_HIGHLIGHT_PIPELINE,
    [LANES] = GLINT_HIGHLIGHT_LANES,
};

static glint_power_config config_of(const int *values)
{
    return (glint_power_config){.accuracy = (glint_power_accuracy)values[ACCURACY],
                                .pipeline = (glint_pipeline)values[PIPELINE],
                                .lanes = values[LANES]};
}

static void describe(const int *values, char *text, size_t size)
{
    (void)snprintf(text, size, "accuracy %s, pipeline %s, lanes %d", accuracies[values[ACCURACY]],
                   glint_pipeline_name((glint_pipeline)values[PIPELINE]), values[LANES]);
}

GLINT_ALWAYS(const char *, top, "power_device")

static int pin_count(const int *values)
{
    return glint_highlight_pin_count(values[LANES]);
}

static glint_pin_info pin(const int *values, int index)
{
    return glint_highlight_pin(values[LANES], index);
}

/* ---- Signals --------------------------------------------------------------------------------- */

/* The outputs first, as the pins are to be seen together, then the blocks as the data flows. */
static const glint_heading headings[] = {
    {.title = "Outputs"},
    {.title = "Register 1: x"},
    {.title = "Register 2: n"},
    {.title = "Multiplier 7: n x"},
    {.title = "ROM 9: g(x)"},
    {.title = "Blocks 10, 11: v"},
    {.title = "ROM 33, keys 12: W"},
    {.title = "Registers 3, 4, 5"},
    {.title = "Multipliers 13-15"},
    {.title = "Valid bits"},
    {.title = "R, G, B, stages 2-4", .folded = 1},
};
enum { OUTPUTS, X, EXPONENT, P, LOG, V, POWER, COLORS, MULTIPLIERS, VALID_BITS, DELAYED_COLORS };

static int heading_of(const glint_signal_info *signal)
{
    static const int of_block[] = {
        [0] = VALID_BITS, [1] = X,      [2] = EXPONENT,     [3] = COLORS,       [4] = COLORS,
        [5] = COLORS,     [7] = P,      [9] = LOG,          [10] = V,           [11] = V,
        [12] = POWER,     [33] = POWER, [13] = MULTIPLIERS, [14] = MULTIPLIERS, [15] = MULTIPLIERS,
    };
    if (signal->kind == GLINT_SIGNAL_OUTPUT)
        return OUTPUTS;
    const int heading = of_block[signal->block];
    return heading == COLORS && signal->kind == GLINT_SIGNAL_STAGE ? DELAYED_COLORS : heading;
}

static int signal_count(const int *values)
{
    const glint_power_config config = config_of(values);
    return glint_power_signal_count(&config);
}

/* With the combinational pipeline a stage is a wire and says nothing new, but for the first, which
 * has a register, and for the two that take a part of what is before them. */
static int is_copy(const glint_power_config *config, const glint_signal_info *signal)
{
    return signal->kind == GLINT_SIGNAL_STAGE && config->pipeline == GLINT_PIPELINE_COMBINATIONAL &&
           strcmp(signal->name, "s1_valid") != 0 && strcmp(signal->name, "s2_mul7") != 0 &&
           strcmp(signal->name, "s3_mul10") != 0;
}

static glint_signal_info signal(const int *values, int index)
{
    const glint_power_config config = config_of(values);
    glint_signal_info info = glint_power_signal_info(&config, index);
    info.heading = headings[heading_of(&info)].title;
    info.is_copy = is_copy(&config, &info);
    return info;
}

static int latency(const int *values)
{
    return glint_power_latency((glint_pipeline)values[PIPELINE]);
}

/* ---- C model and stimulus -------------------------------------------------------------------- */

static glint_status create(const int *values, void **model)
{
    const glint_power_config config = config_of(values);
    glint_power_device *device;
    const glint_status status = glint_power_device_create(&config, &device);
    *model = device;
    return status;
}

static void destroy(void *model)
{
    glint_power_device_destroy(model);
}

static void clock_model(void *model, const void *pins)
{
    glint_power_device_clock(model, pins);
}

static const void *signals(const void *model)
{
    return glint_power_device_signals(model);
}

static void stimulus_begin(void *stimulus, const int *values, uint64_t seed)
{
    glint_stimulus_init(stimulus, seed, values[LANES]);
}

static void stimulus_next(void *stimulus, void *pins)
{
    glint_stimulus_next(stimulus, pins);
}

/* ---- Domain: a clock takes one n, in colours that n chooses, and a cosine code in every lane - */

static uint64_t clocks_of_n(const int *values)
{
    const uint64_t lanes = (uint64_t)values[LANES];
    return ((uint64_t)GLINT_COS_CODE_MAX + lanes) / lanes;
}

static uint64_t points(const int *values)
{
    return GLINT_N_COUNT * clocks_of_n(values);
}

static void put(const int *values, uint64_t point, void *pins)
{
    glint_specular_inputs *in = pins;
    const uint64_t clocks = clocks_of_n(values), lanes = (uint64_t)values[LANES];
    const uint64_t n = point / clocks, first = point % clocks * lanes;
    in->n_we = in->rgb_we = 1;
    in->n = (uint16_t)n;
    in->r = (uint8_t)(GLINT_COLOR_MAX - n);
    in->g = (uint8_t)(37 * n + first);
    in->b = GLINT_COLOR_MAX;
    in->in_valid = (uint32_t)((UINT64_C(1) << lanes) - 1);
    for (uint64_t i = 0; i < lanes; i++)
        in->cos[i] = (uint32_t)(first + i) & GLINT_COS_CODE_MAX;
}

static const glint_domain domain = {
    .what = "every n with every code of the cosine",
    .points = points,
    .put = put,
};

const glint_circuit glint_circuit_power = {
    .name = "power",
    .title = "Power device",
    .clock_port = "clk",
    .top = top,
    .parameters = parameters,
    .parameter_count = PARAMETERS,
    .describe = describe,
    .pin_count = pin_count,
    .pin = pin,
    .pins_size = sizeof(glint_specular_inputs),
    .signal_count = signal_count,
    .signal = signal,
    .lane_name = "lane",
    .lane_scope = "lane[%d].u",
    .headings = headings,
    .heading_count = sizeof headings / sizeof headings[0],
    .latency = latency,
    .create = create,
    .destroy = destroy,
    .clock = clock_model,
    .signals = signals,
    .stimulus_size = sizeof(glint_stimulus),
    .stimulus_begin = stimulus_begin,
    .stimulus_next = stimulus_next,
    .domain = &domain,
};
