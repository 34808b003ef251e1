/* The specular-colour device of figure 3.1, described; and on request the same with lean
 * multipliers, and with a narrower W. All have one C model. */
#include <stdio.h>
#include <string.h>

#include "circuit/circuits.h"
#include "circuit/highlight.h"
#include "circuit/stimulus.h"
#include "circuit/unit.h"

static const char *const gates[] = {"cosine", "sign", "drawn"};
_Static_assert(sizeof gates / sizeof gates[0] == GLINT_GATE_COUNT, "a name for each gate");

#define GATE_MEMBERS                                                                               \
    .name = "gate", .verilog = "GATE", .meaning = "what cuts off the highlight", .choices = gates, \
    .max = GLINT_GATE_COUNT - 1, .standard = GLINT_GATE_COSINE
#define GATE                                                                                       \
    {                                                                                              \
        GATE_MEMBERS                                                                               \
    }

static const glint_parameter parameters[] = {
    [GLINT_SPECULAR_GATE] = GATE,
    [GLINT_SPECULAR_PIPELINE] = GLINT_HIGHLIGHT_PIPELINE,
    [GLINT_SPECULAR_LANES] = GLINT_HIGHLIGHT_LANES,
};

glint_setting glint_setting_specular(const glint_specular_config *config)
{
    return (glint_setting){.circuit = &glint_circuit_specular,
                           .values = {[GLINT_SPECULAR_GATE] = (int)config->gate,
                                      [GLINT_SPECULAR_PIPELINE] = (int)config->pipeline,
                                      [GLINT_SPECULAR_LANES] = config->lanes}};
}

glint_specular_config glint_specular_config_of(const int *values)
{
    return (glint_specular_config){.gate = (glint_gate)values[GLINT_SPECULAR_GATE],
                                   .pipeline = (glint_pipeline)values[GLINT_SPECULAR_PIPELINE],
                                   .lanes = values[GLINT_SPECULAR_LANES]};
}

static void describe(const int *values, char *text, size_t size)
{
    const glint_specular_config config = glint_specular_config_of(values);
    (void)snprintf(text, size, "gate %s, pipeline %s, lanes %d", glint_gate_name(config.gate),
                   glint_pipeline_name(config.pipeline), config.lanes);
}

GLINT_ALWAYS(const char *, top, "specular_device")

static int pin_count(const int *values)
{
    return glint_highlight_pin_count(values[GLINT_SPECULAR_LANES]);
}

static glint_pin_info pin(const int *values, int index)
{
    return glint_highlight_pin(values[GLINT_SPECULAR_LANES], index);
}

/* ---- Signals --------------------------------------------------------------------------------- */

/* Outputs first, so that all pins are visible together in any window, then the figure's blocks in
 * data-flow order. Kept short: the widest sets the width of the name column. */
static const glint_heading headings[] = {
    {.title = "Outputs"},
    {.title = "Register 1: cos"},
    {.title = "Register 2, ROM 33"},
    {.title = "Blocks 6, 7, 8: t"},
    {.title = "ROM 9, comparator 11"},
    {.title = "Blocks 10, 12: W"},
    {.title = "Registers 3, 4, 5"},
    {.title = "Multipliers 13-15"},
    {.title = "Valid bits"},
    {.title = "R, G, B, stages 2, 3", .folded = 1},
};
enum {
    OUTPUTS,
    COSINE,
    EXPONENT,
    T,
    LIMIT,
    W,
    COLORS,
    MULTIPLIERS,
    VALID_BITS,
    DELAYED_COLORS,
};

static int heading_of(const glint_signal_info *signal)
{
    static const int of_block[] = {
        [0] = VALID_BITS,
        [1] = COSINE,
        [2] = EXPONENT,
        [3] = COLORS,
        [4] = COLORS,
        [5] = COLORS,
        [6] = T,
        [7] = T,
        [8] = T,
        [9] = LIMIT,
        [10] = W,
        [11] = LIMIT,
        [12] = W,
        [33] = EXPONENT,
        [13] = MULTIPLIERS,
        [14] = MULTIPLIERS,
        [15] = MULTIPLIERS,
    };
    if (signal->kind == GLINT_SIGNAL_OUTPUT)
        return OUTPUTS;
    const int heading = of_block[signal->block];
    return heading == COLORS && signal->kind == GLINT_SIGNAL_STAGE ? DELAYED_COLORS : heading;
}

/* In the combinational form a stage is a wire and adds nothing, except the first, which has a
 * register. Only with gate drawn does the saturated square differ from the square, and is the limit
 * needed in stage 2. */
static int is_copy(const glint_specular_config *config, const glint_signal_info *signal)
{
    if (signal->kind == GLINT_SIGNAL_STAGE && config->pipeline == GLINT_PIPELINE_COMBINATIONAL)
        return strcmp(signal->name, "s1_valid") != 0;
    if (strcmp(signal->name, "sat10") == 0 || strcmp(signal->name, "s2_rom9") == 0)
        return config->gate != GLINT_GATE_DRAWN;
    return 0;
}

static int signal_count(const int *values)
{
    const glint_specular_config config = glint_specular_config_of(values);
    return glint_specular_signal_count(&config);
}

static glint_signal_info signal(const int *values, int index)
{
    const glint_specular_config config = glint_specular_config_of(values);
    glint_signal_info info = glint_specular_signal_info(&config, index);
    info.heading = headings[heading_of(&info)].title;
    info.is_copy = is_copy(&config, &info);
    return info;
}

static int latency(const int *values)
{
    return glint_specular_latency((glint_pipeline)values[GLINT_SPECULAR_PIPELINE]);
}

/* ---- Drawing --------------------------------------------------------------------------------- */

/* A stage's register, or the wire in its place. */
static glint_symbol stage_symbol(const int *values)
{
    return values[GLINT_SPECULAR_PIPELINE] == GLINT_PIPELINE_PIPELINED ? GLINT_SYMBOL_REGISTER
                                                                       : GLINT_SYMBOL_WIRE;
}

#define STAGE(called, from)                                                                        \
    {                                                                                              \
        .name = called, .inputs = from, .symbol = stage_symbol(values)                             \
    }

/* Of a type, one value for each gate. */
#define BY_GATE(type, ...)                                                                         \
    (((type const[GLINT_GATE_COUNT]){__VA_ARGS__})[values[GLINT_SPECULAR_GATE]])
#define TEXT_BY_GATE(...) BY_GATE(const char *, __VA_ARGS__)
_Static_assert(GLINT_GATE_COSINE == 0 && GLINT_GATE_SIGN == 1 && GLINT_GATE_DRAWN == 2,
               "the order below");

/* Registers 2 to 5 and the ROMs first, as they are at the top of the figure. */
GLINT_BLOCK_TABLE(
    block, GLINT_BLOCK("n", PIN, "17", NULL, NULL), GLINT_BLOCK("cos", PIN, "32", NULL, NULL),
    GLINT_BLOCK("reg2", REGISTER, "n", "n", "n_we"),
    GLINT_BLOCK("reg1", REGISTER, "cos \u03b3", "cos", "in_valid"),
    GLINT_BLOCK("reg3", REGISTER, "R", "r", "rgb_we"),
    GLINT_BLOCK("reg4", REGISTER, "G", "g", "rgb_we"),
    GLINT_BLOCK("reg5", REGISTER, "B", "b", "rgb_we"),
    GLINT_BLOCK("s1_valid", REGISTER, NULL, "in_valid", NULL),
    GLINT_BLOCK("rom33", ROM, "\u03c3", "reg2", NULL),
    GLINT_BLOCK("rom9", ROM, "limit", TEXT_BY_GATE("reg2", NULL, NULL), NULL),
    GLINT_BLOCK("adder6", ADDER, "\u2212 1", "reg1", NULL),
    GLINT_BLOCK("mul7", MULTIPLIER, NULL, "rom33 adder6", NULL),
    GLINT_BLOCK("adder8", ADDER, "+ 1", "mul7", NULL), STAGE("s2_adder8", "adder8"),
    STAGE("s2_rom9", "rom9"), GLINT_BLOCK("mul10", MULTIPLIER, "x\u00b2", "s2_adder8", NULL),
    {.name = "sat10",
     .symbol = BY_GATE(glint_symbol, GLINT_SYMBOL_WIRE, GLINT_SYMBOL_WIRE, GLINT_SYMBOL_LOGIC),
     .text = "\u2264 1",
     .inputs = "mul10"},
    GLINT_BLOCK("cmp11", COMPARATOR, TEXT_BY_GATE(NULL, "\u2265 0", NULL),
                TEXT_BY_GATE("rom9 reg1", "adder8", "s2_rom9 mul10"), NULL),
    STAGE("s2_cmp11", "cmp11"),
    GLINT_BLOCK("keys12", KEYS, NULL,
                TEXT_BY_GATE("s2_cmp11 sat10", "s2_cmp11 sat10", "cmp11 sat10"), NULL),
    STAGE("s2_reg3", "reg3"), STAGE("s2_reg4", "reg4"), STAGE("s2_reg5", "reg5"),
    STAGE("s2_valid", "s1_valid"), STAGE("s3_keys12", "keys12"), STAGE("s3_reg3", "s2_reg3"),
    STAGE("s3_reg4", "s2_reg4"), STAGE("s3_reg5", "s2_reg5"), STAGE("s3_valid", "s2_valid"),
    GLINT_BLOCK("mul13", MULTIPLIER, NULL, "s3_keys12 s3_reg3", NULL),
    GLINT_BLOCK("mul14", MULTIPLIER, NULL, "s3_keys12 s3_reg4", NULL),
    GLINT_BLOCK("mul15", MULTIPLIER, NULL, "s3_keys12 s3_reg5", NULL), STAGE("out_w", "s3_keys12"),
    STAGE("out_r", "mul13"), STAGE("out_g", "mul14"), STAGE("out_b", "mul15"),
    STAGE("out_valid", "s3_valid"))

/* ---- C model and stimulus -------------------------------------------------------------------- */

static glint_status create(const int *values, void **model)
{
    const glint_specular_config config = glint_specular_config_of(values);
    glint_specular_device *device;
    const glint_status status = glint_specular_device_create(&config, &device);
    *model = device;
    return status;
}

static void destroy(void *model)
{
    glint_specular_device_destroy(model);
}

static void clock_model(void *model, const void *pins)
{
    glint_specular_device_clock(model, pins);
}

static const void *signals(const void *model)
{
    return glint_specular_device_signals(model);
}

static void stimulus_begin(void *stimulus, const int *values, uint64_t seed)
{
    glint_stimulus_init(stimulus, seed, values[GLINT_SPECULAR_LANES]);
}

static void stimulus_next(void *stimulus, void *pins)
{
    glint_stimulus_next(stimulus, pins);
}

const glint_circuit glint_circuit_specular = {
    .name = "specular",
    .title = "Specular-colour device",
    .clock_port = "clk",
    .top = top,
    GLINT_PARAMETERS(parameters),
    .describe = describe,
    GLINT_PINS(glint_specular_inputs, pin),
    GLINT_SIGNALS(signal),
    .lane_name = "lane",
    .lane_scope = "lane[%d].u",
    GLINT_HEADINGS(headings),
    .latency = latency,
    .create = create,
    .destroy = destroy,
    .clock = clock_model,
    .signals = signals,
    .stimulus_size = sizeof(glint_stimulus),
    .stimulus_begin = stimulus_begin,
    .stimulus_next = stimulus_next,
    GLINT_BLOCKS(block),
};

/* ---- With lean multipliers --------------------------------------------------------------------
 */

/* The last parameter is fixed. */
static const glint_parameter lean_parameters[] = {
    [GLINT_SPECULAR_GATE] = GATE,
    [GLINT_SPECULAR_PIPELINE] = GLINT_HIGHLIGHT_PIPELINE,
    [GLINT_SPECULAR_LANES] = GLINT_HIGHLIGHT_FEW_LANES,
    {.name = "lean",
     .verilog = "LEAN",
     .meaning = "multipliers 7 and 10 of 18-bit ports",
     .min = 1,
     .max = 1,
     .standard = 1},
};

/* All signals but the square before the key block, which is another where it is not passed. */
static int is_square(const glint_signal_info *info)
{
    return info->block == 10;
}

static int lean_signal_count(const int *values)
{
    int count = 0;
    for (int i = 0; i < signal_count(values); i++) {
        const glint_signal_info info = signal(values, i);
        count += !is_square(&info);
    }
    return count;
}

static glint_signal_info lean_signal(const int *values, int index)
{
    glint_signal_info info = signal(values, 0);
    for (int i = 1; index > 0; i++) {
        info = signal(values, i);
        index -= !is_square(&info);
    }
    return info;
}

static uint64_t points(const int *values)
{
    return glint_unit_points(values[GLINT_SPECULAR_LANES]);
}

static void put(const int *values, uint64_t point, void *pins)
{
    glint_unit_put(values[GLINT_SPECULAR_LANES], point, pins);
}

static const glint_domain domain = {
    .what = "every n with every code of the cosine", .points = points, .put = put};

const glint_circuit glint_circuit_lean = {
    .name = "lean",
    .title = "Specular-colour device with lean multipliers",
    .on_request = 1,
    .clock_port = "clk",
    .top = top,
    GLINT_PARAMETERS(lean_parameters),
    GLINT_PINS(glint_specular_inputs, pin),
    GLINT_SIGNALS(lean_signal),
    .lane_name = "lane",
    .lane_scope = "lane[%d].u",
    GLINT_HEADINGS(headings),
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

/* ---- With a narrower W -------------------------------------------------------------------------
 */

enum { W_DROP = GLINT_SPECULAR_LANES + 1 };

#define COMMON_DROP GLINT_HIGHLIGHT_COMMON_DROP(GLINT_W_FRAC_BITS)

/* Listed with the gate that the device has by default, and W at the common width. */
static const glint_parameter narrow_parameters[] = {
    [GLINT_SPECULAR_GATE] = {GATE_MEMBERS, GLINT_LISTED(GLINT_GATE_COSINE)},
    [GLINT_SPECULAR_PIPELINE] = GLINT_HIGHLIGHT_PIPELINE,
    [GLINT_SPECULAR_LANES] = GLINT_HIGHLIGHT_FEW_LANES,
    [W_DROP] = {GLINT_HIGHLIGHT_W_DROP_MEMBERS(1, 6, COMMON_DROP), .standard = COMMON_DROP},
};

/* Behind the rounding there is less of W. */
static glint_signal_info narrow_signal(const int *values, int index)
{
    glint_signal_info info = signal(values, index);
    if (strcmp(info.name, "s3_keys12") == 0 || strcmp(info.name, "out_w") == 0)
        info.frac_bits -= values[W_DROP];
    return info;
}

static glint_status create_narrow(const int *values, void **model)
{
    const glint_specular_config config = glint_specular_config_of(values);
    glint_specular_device *device;
    const glint_status status =
        glint_specular_device_create_narrow(&config, values[W_DROP], &device);
    *model = device;
    return status;
}

const glint_circuit glint_circuit_narrow = {
    .name = "narrow",
    .title = "Specular-colour device with a narrower W",
    .on_request = 1,
    .clock_port = "clk",
    .top = top,
    GLINT_PARAMETERS(narrow_parameters),
    GLINT_PINS(glint_specular_inputs, pin),
    .signal = narrow_signal,
    .signal_count = signal_count,
    .lane_name = "lane",
    .lane_scope = "lane[%d].u",
    GLINT_HEADINGS(headings),
    .latency = latency,
    .create = create_narrow,
    .destroy = destroy,
    .clock = clock_model,
    .signals = signals,
    .stimulus_size = sizeof(glint_stimulus),
    .stimulus_begin = stimulus_begin,
    .stimulus_next = stimulus_next,
    .domain = &domain,
};
