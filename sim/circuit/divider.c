/* The shift-accumulate divider of figure 2.13 in its two forms, described. */
#include <stdio.h>
#include <string.h>

#include "circuit/circuits.h"
#include "circuit/divider_stimulus.h"
#include "glint_describe.h"

static const char *const forms[] = {"sequential", "pipelined"};
_Static_assert(sizeof forms / sizeof forms[0] == GLINT_DIVIDER_FORM_COUNT, "a name for each form");

static const glint_parameter parameters[] = {
    /* The Verilog has a module for each. */
    [GLINT_DIVIDER_FORM] = {.name = "form",
                            .meaning = "one bit per clock, or one division per clock",
                            .choices = forms,
                            .max = GLINT_DIVIDER_FORM_COUNT - 1,
                            .standard = GLINT_DIVIDER_PIPELINED},
    [GLINT_DIVIDER_SHIFTS] = {.name = "shifts",
                              .verilog = "SHIFTS",
                              .meaning = "number of shifts",
                              .min = GLINT_DIVIDER_SHIFTS_MIN,
                              .max = GLINT_DIVIDER_SHIFTS_MAX,
                              .standard = GLINT_DIVIDER_SHIFTS_DEFAULT},
};

glint_setting glint_setting_divider(glint_divider_form form, int shifts)
{
    return (glint_setting){
        .circuit = &glint_circuit_divider,
        .values = {[GLINT_DIVIDER_FORM] = (int)form, [GLINT_DIVIDER_SHIFTS] = shifts}};
}

static glint_divider_form form_of(const int *values)
{
    return (glint_divider_form)values[GLINT_DIVIDER_FORM];
}

static bool is_sequential(const int *values)
{
    return form_of(values) == GLINT_DIVIDER_SEQUENTIAL;
}

static void describe(const int *values, char *text, size_t size)
{
    (void)snprintf(text, size, "divider %s, %d shifts", glint_divider_form_name(form_of(values)),
                   values[GLINT_DIVIDER_SHIFTS]);
}

static const char *top(const int *values)
{
    return is_sequential(values) ? "shift_divider" : "pipelined_divider";
}

/* ---- Pins ------------------------------------------------------------------------------------ */

#define PIN(port, role, field, bits, is_signed, meaning)                                           \
    GLINT_PIN_OF(glint_divider_inputs, field, port, role, bits, 0, is_signed, -1, meaning)
#define CONTROLS(take)                                                                             \
    PIN("reset", RESET, reset, 1, 0, "clears every register"),                                     \
        PIN("en", ENABLE, en, 1, 0, "0 freezes the divider"),                                      \
        PIN(take, VALID, start, 1, 0, "starts a division"),                                        \
        PIN("k", DATA, k, GLINT_DIVIDER_K_BITS, 0, "length of the span")
#define DIFFERENCE(text, component, what)                                                          \
    PIN(text, DATA, difference[component], GLINT_DIVIDER_DIFFERENCE_BITS, 1, what)

static const glint_pin_info sequential_pins[] = {
    CONTROLS("start"),
    DIFFERENCE("difference", 0, "of two intensities"),
};
static const glint_pin_info pipelined_pins[] = {
    CONTROLS("in_valid"),
    DIFFERENCE("difference_r", 0, "of two intensities of R"),
    DIFFERENCE("difference_g", 1, "of two intensities of G"),
    DIFFERENCE("difference_b", 2, "of two intensities of B"),
};

static int pin_count(const int *values)
{
    return is_sequential(values) ? sizeof sequential_pins / sizeof sequential_pins[0]
                                 : sizeof pipelined_pins / sizeof pipelined_pins[0];
}

static glint_pin_info pin(const int *values, int index)
{
    return is_sequential(values) ? sequential_pins[index] : pipelined_pins[index];
}

/* ---- Signals --------------------------------------------------------------------------------- */

/* As the data flows; and how the sum of R grows from stage to stage: the one thing to look at
 * first. */
enum { UNDER_WAY, INPUTS, TABLE, BITS, SHIFT, ADDER, OUTPUTS, SUMS };
static const glint_heading headings[] = {
    [UNDER_WAY] = {.title = "In progress"},
    [INPUTS] = {.title = "Input registers"},
    [TABLE] = {.title = "Table: bits of 1/k"},
    [BITS] = {.title = "Bits still to come"},
    [SHIFT] = {.title = "Shift register"},
    [ADDER] = {.title = "Accumulating adder"},
    [OUTPUTS] = {.title = "Outputs"},
    [SUMS] = {.title = "Sum of R by stage", .every_lane = 1},
};

/* A heading begins with the signal of that name. */
static const struct {
    const char *signal;
    int heading;
} beginnings[] = {
    {"busy", UNDER_WAY}, {"s0_valid", INPUTS}, {"rom_bits", TABLE}, {"bits_rg", BITS},
    {"shift_rg", SHIFT}, {"term", ADDER},      {"done", OUTPUTS},   {"out_valid", OUTPUTS},
};

static const char *title_from(const char *signal)
{
    for (size_t i = 0; i < sizeof beginnings / sizeof beginnings[0]; i++)
        if (strcmp(beginnings[i].signal, signal) == 0)
            return headings[beginnings[i].heading].title;
    return NULL;
}

static glint_signal_info plain_signal(const int *values, int index)
{
    return glint_divider_signal_info(form_of(values), values[GLINT_DIVIDER_SHIFTS], index);
}

/* The first signal of each form begins one. */
static const char *title_of(const int *values, int index)
{
    const char *title;
    while ((title = title_from(plain_signal(values, index).name)) == NULL)
        index--;
    return title;
}

static int signal_count(const int *values)
{
    return glint_divider_signal_count(form_of(values), values[GLINT_DIVIDER_SHIFTS]);
}

static glint_signal_info signal(const int *values, int index)
{
    glint_signal_info info = plain_signal(values, index);
    if (info.lane < 0)
        info.heading = title_of(values, index);
    else if (strcmp(info.name, "acc_r") == 0)
        info.heading = headings[SUMS].title;
    return info;
}

static int latency(const int *values)
{
    return glint_divider_latency(values[GLINT_DIVIDER_SHIFTS]);
}

static int pace(const int *values)
{
    return is_sequential(values) ? values[GLINT_DIVIDER_SHIFTS] + 1 : 1;
}

/* ---- Drawing --------------------------------------------------------------------------------- */

#define OUT_OF_TABLE "\u2209 1\u202616"
_Static_assert(GLINT_DIVIDER_K_MAX == 16, "the drawing says so");
#define OTHERS "stages 2\u2026n"

/* Figure 2.13 with what feeds it: a start loads the registers, then each clock moves them on. */
static const glint_block_info sequential_blocks[] = {
    GLINT_BLOCK("k", PIN, NULL, NULL, NULL),
    GLINT_BLOCK("difference", PIN, NULL, NULL, NULL),
    GLINT_BLOCK("start", PIN, NULL, NULL, NULL),
    GLINT_BLOCK("rom_miss", COMPARATOR, OUT_OF_TABLE, "k", NULL),
    GLINT_BLOCK("rom_bits", ROM, "1/k", "k", NULL),
    GLINT_BLOCK("i0_d", KEYS, "i\u2080", "rom_bits difference", NULL),
    GLINT_BLOCK("bits_rg", REGISTER, "i\u2c7c", "rom_bits", "start, busy"),
    GLINT_BLOCK("shift_rg", REGISTER, "D", "shifted difference", "start, busy"),
    GLINT_BLOCK("shifted", LOGIC, "\u00f7 2", "shift_rg", NULL),
    GLINT_BLOCK("term", KEYS, "i\u2c7c", "bits_rg shifted", NULL),
    GLINT_BLOCK("sum", ADDER, NULL, "term acc_rg", NULL),
    GLINT_BLOCK("acc_rg", REGISTER, "\u03a3", "sum i0_d", "start, busy"),
    GLINT_BLOCK("left", REGISTER, "n\u20260", NULL, "start, busy"),
    GLINT_BLOCK("busy", REGISTER, NULL, "start left", NULL),
    GLINT_BLOCK("done", REGISTER, NULL, "left", "busy"),
    GLINT_BLOCK("out_of_table", REGISTER, NULL, "rom_miss", "start, busy"),
    GLINT_BLOCK("quotient", WIRE, NULL, "acc_rg", NULL),
};

/* The input registers and the table, stage 1, and the others as one. One of R, G and B. */
#define OF_EACH(called, how, says, feeds)                                                          \
    {                                                                                              \
        .name = called, .symbol = GLINT_SYMBOL_##how, .text = says, .inputs = feeds, .stacked = 1  \
    }
static const glint_block_info pipelined_blocks[] = {
    OF_EACH("difference_r", PIN, NULL, NULL),
    GLINT_BLOCK("k", PIN, NULL, NULL, NULL),
    GLINT_BLOCK("in_valid", PIN, NULL, NULL, NULL),
    {.name = "s0_d_r",
     .symbol = GLINT_SYMBOL_REGISTER,
     .text = "D",
     .inputs = "difference_r",
     .control = "in_valid",
     .stacked = 1},
    GLINT_BLOCK("s0_k", REGISTER, "k", "k", "in_valid"),
    GLINT_BLOCK("s0_valid", REGISTER, NULL, "in_valid", NULL),
    GLINT_BLOCK("rom_bits", ROM, "1/k", "s0_k", NULL),
    GLINT_BLOCK("rom_miss", COMPARATOR, OUT_OF_TABLE, "s0_k", NULL),
    OF_EACH("i0_d", KEYS, "i\u2080", "s0_d_r rom_bits"),
    OF_EACH("half", LOGIC, "\u00f7 2", "s0_d_r"),
    OF_EACH("i1_d", KEYS, "i\u2081", "half rom_bits"),
    OF_EACH("sum", ADDER, NULL, "i0_d i1_d"),
    OF_EACH("d_r[1]", REGISTER, NULL, "s0_d_r"),
    OF_EACH("acc_r[1]", REGISTER, NULL, "sum"),
    GLINT_BLOCK("bits[1]", REGISTER, NULL, "rom_bits", NULL),
    GLINT_BLOCK("miss[1]", REGISTER, NULL, "rom_miss", NULL),
    GLINT_BLOCK("valid[1]", REGISTER, NULL, "s0_valid", NULL),
    OF_EACH("more", MORE, OTHERS, "acc_r[1] d_r[1] bits[1]"),
    GLINT_BLOCK("more_miss", MORE, OTHERS, "miss[1]", NULL),
    GLINT_BLOCK("more_valid", MORE, OTHERS, "valid[1]", NULL),
    OF_EACH("quotient_r", WIRE, NULL, "more"),
    GLINT_BLOCK("out_of_table", WIRE, NULL, "more_miss", NULL),
    GLINT_BLOCK("out_valid", WIRE, NULL, "more_valid", NULL),
};

static int block_count(const int *values)
{
    return is_sequential(values) ? sizeof sequential_blocks / sizeof sequential_blocks[0]
                                 : sizeof pipelined_blocks / sizeof pipelined_blocks[0];
}

static glint_block_info block(const int *values, int index)
{
    return is_sequential(values) ? sequential_blocks[index] : pipelined_blocks[index];
}

/* ---- C model and stimulus -------------------------------------------------------------------- */

static glint_status create(const int *values, void **model)
{
    glint_divider_device *device;
    const glint_status status =
        glint_divider_device_create(form_of(values), values[GLINT_DIVIDER_SHIFTS], &device);
    *model = device;
    return status;
}

static void destroy(void *model)
{
    glint_divider_device_destroy(model);
}

static void clock_model(void *model, const void *pins)
{
    glint_divider_device_clock(model, pins);
}

static const void *signals(const void *model)
{
    const glint_divider_sequential_signals *sequential = glint_divider_device_sequential(model);
    return sequential != NULL ? (const void *)sequential : glint_divider_device_pipelined(model);
}

static void stimulus_begin(void *stimulus, const int *values, uint64_t seed)
{
    (void)values;
    glint_divider_stimulus_init(stimulus, seed);
}

static void stimulus_next(void *stimulus, void *pins)
{
    glint_divider_stimulus_next(stimulus, pins);
}

/* ---- Domain ---------------------------------------------------------------------------------- */

/* The nine bits hold one difference more than the divider is for, -256. */
enum {
    K_COUNT = 1 << GLINT_DIVIDER_K_BITS,
    DIFFERENCE_COUNT = 1 << GLINT_DIVIDER_DIFFERENCE_BITS,
    POINTS = K_COUNT * DIFFERENCE_COUNT,
    DIFFERENCE_MIN = -DIFFERENCE_COUNT / 2,
    /* From a component's difference to the next one's, so that none has that of another. */
    APART = DIFFERENCE_COUNT / GLINT_DIVIDER_COMPONENTS,
};

GLINT_ALWAYS(uint64_t, points, POINTS)

static void put(const int *values, uint64_t point, void *pins)
{
    glint_divider_inputs *in = pins;
    (void)values;
    in->k = (uint8_t)(point / DIFFERENCE_COUNT);
    for (int c = 0; c < GLINT_DIVIDER_COMPONENTS; c++)
        in->difference[c] =
            (int16_t)(DIFFERENCE_MIN + (int)((point + (unsigned)(c * APART)) % DIFFERENCE_COUNT));
}

static const glint_domain domain = {
    .what = "every k with every difference in each component",
    .points = points,
    .put = put,
};

const glint_circuit glint_circuit_divider = {
    .name = "divider",
    .title = "Shift-accumulate divider",
    .clock_port = "clk",
    .top = top,
    GLINT_PARAMETERS(parameters),
    .describe = describe,
    GLINT_PINS(glint_divider_inputs, pin),
    GLINT_SIGNALS(signal),
    .lane_name = "stage",
    .lane_scope = "stage[%d].u",
    GLINT_HEADINGS(headings),
    .latency = latency,
    .pace = pace,
    .create = create,
    .destroy = destroy,
    .clock = clock_model,
    .signals = signals,
    .stimulus_size = sizeof(glint_divider_stimulus),
    .stimulus_begin = stimulus_begin,
    .stimulus_next = stimulus_next,
    .domain = &domain,
    GLINT_BLOCKS(block),
};
