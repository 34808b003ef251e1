/* Every circuit of the list is described completely; a description with one fault is refused, each
 * with its own words. */
#define _XOPEN_SOURCE 700

#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "circuit/circuits.h"
#include "circuit/validate.h"
#include "circuit/words.h"
#include "glint_describe.h"

/* ---- A circuit in order, to be broken: two lanes, one pin as wide as the parameter ------------
 */

enum { PINS = 6, SIGNALS = 5 };

typedef struct toy_pins {
    uint8_t reset, take;
    int16_t cos[2];
    uint64_t wide[2];
    uint8_t more;
} toy_pins;

typedef struct toy_signals {
    int64_t sum[2], out[2];
    uint64_t wide[2];
} toy_signals;

static const char *const kinds[] = {"slow", "fast"};
static const int depths[] = {2, 4};
static const char *kind_names[] = {"slow", "fast"};
static toy_signals kept;

static glint_parameter parameters[2];
static glint_heading headings[2];
static glint_pin_info pins[PINS];
static glint_signal_info signals[SIGNALS];
static glint_domain domain;
static glint_circuit toy;
static int latency_of_toy, pace_of_toy, pin_count_of_toy, signal_count_of_toy;
static const char *top_of_toy;
static glint_status status_of_toy;

static int pin_count(const int *values)
{
    (void)values;
    return pin_count_of_toy;
}

static int signal_count(const int *values)
{
    (void)values;
    return signal_count_of_toy;
}

/* The wide pin has 64 bits more than depth. */
static glint_pin_info pin(const int *values, int index)
{
    glint_pin_info info = pins[index];
    if (strcmp(info.name, "wide") == 0 && info.int_bits == 0)
        info.int_bits = 64 + values[1];
    return info;
}

static glint_signal_info signal(const int *values, int index)
{
    (void)values;
    return signals[index];
}

static const char *top(const int *values)
{
    (void)values;
    return top_of_toy;
}

static int latency(const int *values)
{
    (void)values;
    return latency_of_toy;
}

static int pace(const int *values)
{
    (void)values;
    return pace_of_toy;
}

static glint_status create(const int *values, void **model)
{
    (void)values;
    *model = status_of_toy == GLINT_OK ? malloc(1) : NULL;
    return status_of_toy;
}

static void edge(void *model, const void *now)
{
    (void)model;
    (void)now;
}

static const void *signals_of(const void *model)
{
    (void)model;
    return &kept;
}

static const void *no_signals(const void *model)
{
    (void)model;
    return NULL;
}

static uint64_t points(const int *values)
{
    (void)values;
    return 4;
}

static void put(const int *values, uint64_t point, void *now)
{
    (void)values;
    ((toy_pins *)now)->more = (uint8_t)point;
}

static void begin(void *stimulus, const int *values, uint64_t seed)
{
    (void)stimulus;
    (void)values;
    (void)seed;
}

static void next(void *stimulus, void *now)
{
    (void)stimulus;
    (void)now;
}

static void make_pins(void)
{
    const glint_pin_info good[PINS] = {
        GLINT_PIN(toy_pins, reset, RESET_LOW, 1, 0, 0, "clears"),
        GLINT_PIN(toy_pins, take, VALID, 2, 0, 0, "takes"),
        GLINT_PIN_OF(toy_pins, cos[0], "cos", DATA, 1, 8, 1, 0, "a cosine"),
        GLINT_PIN_OF(toy_pins, cos[1], "cos", DATA, 1, 8, 1, 1, "a cosine"),
        GLINT_PIN(toy_pins, wide, DATA, 0, 0, 0, "64 bits and depth"),
        GLINT_PIN(toy_pins, more, STROBE, 1, 0, 0, "one more"),
    };
    memcpy(pins, good, sizeof pins);
    pin_count_of_toy = PINS;
}

static void make_signals(void)
{
    const glint_signal_info good[SIGNALS] = {
        GLINT_SIGNAL_OF(toy_signals, sum[0], "sum", NULL, BLOCK, 9, 0, 1, 0, "In", "a sum"),
        GLINT_SIGNAL_OF(toy_signals, sum[1], "sum", NULL, BLOCK, 9, 0, 1, 1, NULL, "a sum"),
        GLINT_SIGNAL_OF(toy_signals, wide, "wide", "u.mem[3]", REGISTER, 100, 0, 0, -1, "In", "x"),
        GLINT_SIGNAL_OF(toy_signals, out[0], "out", NULL, OUTPUT, 9, 0, 1, 0, "Out", "a result"),
        GLINT_SIGNAL_OF(toy_signals, out[1], "out", NULL, OUTPUT, 9, 0, 1, 1, "Out", "a result"),
    };
    memcpy(signals, good, sizeof signals);
    signal_count_of_toy = SIGNALS;
}

#define TEN         "abcdefghij"
#define A_LONG_NAME TEN TEN TEN TEN TEN TEN "abcd"

static void make_toy(void)
{
    parameters[0] = (glint_parameter){
        .name = "kind", .meaning = "how", .choices = kinds, .max = 1, .standard = 1};
    parameters[1] = (glint_parameter){.name = "depth",
                                      .verilog = "DEPTH",
                                      .meaning = "how much",
                                      .min = 1,
                                      .max = 8,
                                      .standard = 2,
                                      .listed = depths,
                                      .listed_count = 2};
    headings[0] = (glint_heading){.title = "In"};
    headings[1] = (glint_heading){.title = "Out"};
    domain = (glint_domain){.what = "every more", .points = points, .put = put};
    make_pins();
    make_signals();
    latency_of_toy = 1;
    pace_of_toy = 1;
    top_of_toy = "toy";
    status_of_toy = GLINT_OK;
    toy = (glint_circuit){.name = "toy",
                          .title = "Toy",
                          .clock_port = "clk",
                          .top = top,
                          .parameters = parameters,
                          .parameter_count = 2,
                          .pin_count = pin_count,
                          .pin = pin,
                          .pins_size = sizeof(toy_pins),
                          .signal_count = signal_count,
                          .signal = signal,
                          .lane_name = "lane",
                          .lane_scope = "lane[%d].u",
                          .headings = headings,
                          .heading_count = 2,
                          .latency = latency,
                          .pace = pace,
                          .create = create,
                          .destroy = free,
                          .clock = edge,
                          .signals = signals_of,
                          .domain = &domain};
}

/* ---- What may be wrong ------------------------------------------------------------------------
 */

/* X(name, what breaks it, the message after "circuit toy"). IN: in the standard setting. */
#define IN " (toy, kind fast, depth 2): "
#define FAULTS(X)                                                                                  \
    X(title, toy.title = "", " has no title")                                                      \
    X(clock, toy.clock_port = "1clk", ": clock_port \"1clk\" is not a C identifier")               \
    X(lane_name, toy.lane_name = "a b", ": lane_name \"a b\" is not a C identifier")               \
    X(scope_without, toy.lane_scope = "lane",                                                      \
      ": lane_scope \"lane\" must contain one %d, for the lane")                                   \
    X(scope_twice, toy.lane_scope = "l[%d].m[%d]",                                                 \
      ": lane_scope \"l[%d].m[%d]\" must contain one %d, for the lane")                            \
    X(scope_text, toy.lane_scope = "l[%s]",                                                        \
      ": lane_scope \"l[%s]\" must contain one %d, for the lane")                                  \
    X(no_pin_count, toy.pin_count = NULL, " has no function pin_count")                            \
    X(no_pin, toy.pin = NULL, " has no function pin")                                              \
    X(no_signal_count, toy.signal_count = NULL, " has no function signal_count")                   \
    X(no_signal, toy.signal = NULL, " has no function signal")                                     \
    X(no_create, toy.create = NULL, ": its C model has neither a model_size nor create()")         \
    X(both_models, toy.model_size = 8,                                                             \
      ": its C model has create(), and model_size or begin() as well")                             \
    X(no_destroy, toy.destroy = NULL, ": of create() and destroy() it has but one")                \
    X(no_clock, toy.clock = NULL, " has no function clock")                                        \
    X(no_signals, toy.signals = NULL, ": its C model has create(), and no signals()")              \
    X(half_a_stimulus, toy.stimulus_begin = begin,                                                 \
      ": stimulus_begin and stimulus_next must both be set, or neither")                           \
    X(other_half, toy.stimulus_next = next,                                                        \
      ": stimulus_begin and stimulus_next must both be set, or neither")                           \
    X(large_stimulus, toy.stimulus_size = GLINT_STIMULUS_SIZE_MAX + 1,                             \
      ": stimulus_size is 4097 bytes; at most 4096 are allowed")                                   \
    X(domain_what, domain.what = NULL, ": its domain needs all of what, points and put")           \
    X(domain_points, domain.points = NULL, ": its domain needs all of what, points and put")       \
    X(domain_put, domain.put = NULL, ": its domain needs all of what, points and put")             \
    X(headings, toy.headings = NULL, ": heading_count is 2, but headings is NULL")                 \
    X(heading_title, headings[1].title = "", ": heading 1 has no title")                           \
    X(two_headings, headings[1].title = "In", ": heading \"In\" appears twice")                    \
    X(many_parameters, toy.parameter_count = 9, ": parameter_count is 9, not from 0 to 8")         \
    X(parameters, toy.parameters = NULL, ": parameter_count is 2, but parameters is NULL")         \
    X(parameter_name, parameters[1].name = "a b",                                                  \
      ": the name of parameter 1 may only contain letters, digits, _ and -")                       \
    X(parameter_length, parameters[1].name = A_LONG_NAME,                                          \
      ": parameter abcdefghijabcdefghij…: its name is longer than 63")                             \
    X(parameter_verilog_length, parameters[1].verilog = A_LONG_NAME,                               \
      ": parameter depth…: its name is longer than 63")                                            \
    X(parameter_verilog, parameters[1].verilog = "",                                               \
      ": parameter depth: \"\" is not a Verilog parameter name")                                   \
    X(parameter_meaning, parameters[0].meaning = NULL, ": parameter kind has no meaning")          \
    X(two_parameters, parameters[1].name = "kind", ": parameter kind appears twice")               \
    X(one_verilog, parameters[0].verilog = "DEPTH",                                                \
      ": parameters kind and depth both set the Verilog's DEPTH")                                  \
    X(range, parameters[1].max = 0, ": parameter depth: the range 1 to 0 is empty")                \
    X(standard, parameters[1].standard = 9,                                                        \
      ": parameter depth: its standard, 9, is not from 1 to 8")                                    \
    X(choices, parameters[1].choices = kinds,                                                      \
      ": parameter depth has choices, so its min must be 0, not 1")                                \
    X(choice, kind_names[1] = "";                                                                  \
      parameters[0].choices = kind_names, ": parameter kind: choice 1 has no name")                \
    X(unlisted, parameters[1].listed = NULL;                                                       \
      parameters[1].max = 70000, ": parameter depth has 70000 values: list the ones to try")       \
    X(nothing_listed, parameters[1].listed_count = 0, ": parameter depth lists 0 values")          \
    X(listed, parameters[1].max = 3, ": parameter depth lists 4, which is not from 1 to 3")        \
    X(large_pins, toy.pins_size = 1025, IN "pins_size is 1025; at most 1024 is allowed")           \
    X(negative_pins, pin_count_of_toy = -1, IN "it has -1 pins, not from 0 to 1024")               \
    X(nothing_signalled, signal_count_of_toy = 0, IN "it has 0 signals, not from 1 to 2048")       \
    X(pin_name, pins[1].name = "a[0]", IN "the name of pin 1, \"a[0]\", is not a C identifier")    \
    X(pin_meaning, pins[1].meaning = NULL, IN "pin take has no meaning")                           \
    X(no_bits, pins[1].int_bits = 0, IN "pin take: its width, 0 + 0 bits, is not from 1 to 4096")  \
    X(many_bits, pins[1].int_bits = 4097,                                                          \
      IN "pin take: its width, 4097 + 0 bits, is not from 1 to 4096")                              \
    X(negative_bits, pins[1].frac_bits = -1,                                                       \
      IN "pin take: its width, 2 + -1 bits, is not from 1 to 4096")                                \
    X(no_sign, pins[3].int_bits = 0;                                                               \
      pins[3].frac_bits = 9, IN "pin cos is signed but has no integer bit for the sign")           \
    X(pin_lane, pins[1].lane = -2, IN "pin take: lane -2 does not exist")                          \
    X(wide_reset, pins[0].int_bits = 2,                                                            \
      IN "pin reset: a reset, enable or strobe has one bit, not 2")                                \
    X(wide_strobe, pins[5].int_bits = 3,                                                           \
      IN "pin more: a reset, enable or strobe has one bit, not 3")                                 \
    X(role, pins[1].role = (glint_pin_role)17, IN "pin take: unknown role number 17")              \
    X(pin_size, pins[1].size = 3,                                                                  \
      IN "pin take: its size, 3 bytes, is neither 1, 2, 4 nor a multiple of 8")                    \
    X(no_size, pins[1].size = 0,                                                                   \
      IN "pin take: its size, 0 bytes, is neither 1, 2, 4 nor a multiple of 8")                    \
    X(small_size, pins[2].size = 1, IN "pin cos: its 9 bits do not fit in 1 bytes")                \
    X(small_words, pins[4].size = 8, IN "pin wide: its 66 bits do not fit in 8 bytes")             \
    X(outside, pins[5].offset = sizeof(toy_pins),                                                  \
      IN "pin more: 1 bytes at offset 32 are outside a struct of 32")                              \
    X(unaligned, pins[2].offset = 3, IN "pin cos: offset 3 is not a multiple of its 2 bytes")      \
    X(unaligned_words, pins[4].offset = 12,                                                        \
      IN "pin wide: offset 12 is not a multiple of its 8 bytes")                                   \
    X(lane_missing, pins[2].lane = -1, IN "pin cos: lane 1 does not follow lane 0")                \
    X(lane_apart, pins[3] = pins[5]; pins[5] = pins[2];                                            \
      pins[5].lane = 1, IN "pin cos: lane 1 does not follow lane 0")                               \
    X(lane_width, pins[3].frac_bits = 7, IN "pin cos: lanes 0 and 1 differ in width or sign")      \
    X(lane_sign, pins[3].is_signed = 0, IN "pin cos: lanes 0 and 1 differ in width or sign")       \
    X(two_pins, pins[5].name = "take", IN "pin take appears twice")                                \
    X(pin_is_clock, pins[5].name = "clk",                                                          \
      IN "pin clk is the clock, which must not be among the pins")                                 \
    X(overlap, pins[5].offset = 1, IN "pins take and more share bytes")                            \
    X(signal_name, signals[2].name = "u.wide",                                                     \
      IN "the name of signal 2, \"u.wide\", is not a C identifier: it may be its path")            \
    X(signal_size, signals[2].size = 8,                                                            \
      IN "signal wide: its 100 bits want an array of uint64_t, not 8 bytes")                       \
    X(signal_not_in_model, toy.create = NULL; toy.destroy = NULL; toy.signals = NULL;              \
      toy.model_size = 8, IN "signal sum: offset 8 is not in a model of 8 bytes")                  \
    X(signal_meaning, signals[2].meaning = NULL, IN "signal wide has no meaning")                  \
    X(signal_bits, signals[2].int_bits = 5000,                                                     \
      IN "signal wide: its width, 5000 + 0 bits, is not from 1 to 4096")                           \
    X(kind, signals[2].kind = (glint_signal_kind)9, IN "signal wide: unknown kind number 9")       \
    X(signal_offset, signals[2].offset = 4,                                                        \
      IN "signal wide: offset 4 is not aligned for an int64_t inside its struct")                  \
    X(two_signals, signals[1].lane = 0, IN "signal sum of lane 0 appears twice")                   \
    X(heading, signals[2].heading = "Where",                                                       \
      IN "signal wide: the circuit has no heading \"Where\"")                                      \
    X(lanes_without_name, toy.lane_name = NULL,                                                    \
      IN "signal sum belongs to lane 0, but the circuit has no lane_name")                         \
    X(lanes_without_scope, toy.lane_scope = NULL,                                                  \
      IN "signal sum belongs to lane 0, but the circuit has no lane_scope")                        \
    X(path, signals[2].path = "u;v", IN "signal wide: \"u;v\" is not a Verilog path")              \
    X(output_is_pin, signals[3].name = "take", IN "output take has the same name as a pin")        \
    X(output_lane, signals[3].lane = -1, IN "output out: lane 1 does not follow lane 0")           \
    X(output_width, signals[4].int_bits = 8, IN "output out: lanes 0 and 1 differ in width")       \
    X(top_name, top_of_toy = NULL, IN "the name of its top module is not a C identifier")          \
    X(latency_below, latency_of_toy = -1, IN "its latency is negative: -1 clocks")                 \
    X(latency_of_wires, toy.clock_port = NULL, IN "it has no clock but a latency of 1")            \
    X(pace_below, pace_of_toy = 0, IN "its pace is below 1: 0 clocks")                             \
    X(refused, status_of_toy = GLINT_BAD_ARGUMENT,                                                 \
      IN "create() of the C model returns the error 1")                                            \
    X(model_signals, toy.signals = no_signals, IN "signals() of the C model returns NULL")

#define DEFINE(name, edit, said)                                                                   \
    static void break_##name(void)                                                                 \
    {                                                                                              \
        edit;                                                                                      \
    }
FAULTS(DEFINE)

#define ROW(name, edit, said) {break_##name, "circuit toy" said},
static const struct {
    void (*break_it)(void);
    const char *said;
} faults[] = {FAULTS(ROW)};

static void the_circuits_of_the_list_are_in_order(void **state)
{
    (void)state;
    const glint_circuit *circuit;
    glint_error err;
    for (int i = 0; (circuit = glint_circuit_number(i)) != NULL; i++) {
        if (glint_circuit_check(circuit, &err) != GLINT_OK)
            fail_msg("%s", err.text);
        assert_ptr_equal(glint_circuit_named(circuit->name), circuit);
    }
    assert_null(glint_circuit_named("nothing"));
    assert_null(glint_circuit_number(-1));
}

static void a_description_in_order_passes(void **state)
{
    (void)state;
    glint_error err;
    make_toy();
    if (glint_circuit_check(&toy, &err) != GLINT_OK)
        fail_msg("%s", err.text);
    toy.domain = NULL;
    toy.pace = NULL;
    toy.stimulus_begin = begin;
    toy.stimulus_next = next;
    toy.parameters = NULL;
    toy.parameter_count = 0;
    assert_int_equal(glint_circuit_check(&toy, &err), GLINT_OK);
    toy.clock_port = NULL;
    latency_of_toy = 0;
    assert_int_equal(glint_circuit_check(&toy, NULL), GLINT_OK);
}

static void each_fault_is_refused_in_its_own_words(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof faults / sizeof faults[0]; i++) {
        glint_error err = {""};
        make_toy();
        faults[i].break_it();
        assert_int_equal(glint_circuit_check(&toy, &err), GLINT_BAD_INPUT);
        assert_string_equal(err.text, faults[i].said);
    }
}

static void a_circuit_without_a_usable_name_is_refused(void **state)
{
    (void)state;
    glint_error err;
    make_toy();
    toy.name = NULL;
    assert_int_equal(glint_circuit_check(&toy, &err), GLINT_BAD_INPUT);
    assert_string_equal(err.text, "the circuit has no name");
    toy.name = "my-mac";
    assert_int_equal(glint_circuit_check(&toy, &err), GLINT_BAD_INPUT);
    assert_string_equal(err.text, "circuit \"my-mac\": its name is not a C identifier");
    toy.name = A_LONG_NAME;
    assert_int_equal(glint_circuit_check(&toy, &err), GLINT_BAD_INPUT);
    assert_string_equal(err.text, "circuit abcdefghijabcdefghij…: its name is longer than 63");
}

/* A fault may be there in one of the settings alone: with a depth of 70 the pin has three words. */
static void all_listed_settings_are_looked_at(void **state)
{
    (void)state;
    static const int deep[] = {2, 4, 70};
    glint_error err;
    make_toy();
    parameters[1].max = 70;
    parameters[1].listed = deep;
    parameters[1].listed_count = 3;
    assert_int_equal(glint_circuit_check(&toy, &err), GLINT_BAD_INPUT);
    assert_string_equal(
        err.text,
        "circuit toy (toy, kind slow, depth 70): pin wide: its 134 bits do not fit in 16 bytes");
}

static void no_memory_for_the_model_is_no_fault_of_the_description(void **state)
{
    (void)state;
    glint_error err;
    make_toy();
    status_of_toy = GLINT_NO_MEMORY;
    assert_int_equal(glint_circuit_check(&toy, &err), GLINT_NO_MEMORY);
}

/* ---- Settings ---------------------------------------------------------------------------------
 */

static void settings_have_names_texts_and_options(void **state)
{
    (void)state;
    char text[GLINT_SETTING_OPTIONS];
    const glint_specular_config config = {GLINT_GATE_DRAWN, GLINT_PIPELINE_COMBINATIONAL, 16};
    const glint_setting specular = glint_setting_specular(&config);
    const glint_setting divider = glint_setting_divider(GLINT_DIVIDER_SEQUENTIAL, 12);
    glint_setting_describe(&specular, text);
    assert_string_equal(text, "gate drawn, pipeline combinational, lanes 16");
    glint_setting_name(&specular, text);
    assert_string_equal(text, "specular_drawn_combinational_16");
    glint_setting_options(&specular, text);
    assert_string_equal(text,
                        "--circuit specular --gate drawn --pipeline combinational --lanes 16");
    glint_setting_describe(&divider, text);
    assert_string_equal(text, "divider sequential, 12 shifts");
    glint_setting_name(&divider, text);
    assert_string_equal(text, "divider_sequential_12");
    glint_setting_options(&divider, text);
    assert_string_equal(text, "--circuit divider --form sequential --shifts 12");

    make_toy();
    const glint_setting mine = glint_setting_standard(&toy);
    glint_setting_describe(&mine, text);
    assert_string_equal(text, "toy, kind fast, depth 2");
    glint_setting_name(&mine, text);
    assert_string_equal(text, "toy_fast_2");
    assert_int_equal(glint_setting_value(&mine, "depth", 7), 2);
    assert_int_equal(glint_setting_value(&mine, "width", 7), 7);
}

static void typed_settings_are_the_same_both_ways(void **state)
{
    (void)state;
    const glint_specular_config config = {GLINT_GATE_SIGN, GLINT_PIPELINE_PIPELINED, 5};
    const glint_setting setting = glint_setting_specular(&config);
    const glint_specular_config back = glint_specular_config_of(setting.values);
    assert_true(back.gate == config.gate && back.pipeline == config.pipeline &&
                back.lanes == config.lanes);
}

static void settings_out_of_range_are_refused(void **state)
{
    (void)state;
    glint_error err;
    glint_setting setting = glint_setting_standard(&glint_circuit_specular);
    assert_int_equal(glint_setting_check(&setting, &err), GLINT_OK);
    setting.values[GLINT_SPECULAR_LANES] = GLINT_LANES_MAX;
    assert_int_equal(glint_setting_check(&setting, &err), GLINT_OK);
    setting.values[GLINT_SPECULAR_LANES]++;
    assert_int_equal(glint_setting_check(&setting, &err), GLINT_BAD_ARGUMENT);
    assert_string_equal(err.text, "lanes: 33 is not from 1 to 32");
    setting.values[GLINT_SPECULAR_GATE] = 3;
    assert_int_equal(glint_setting_check(&setting, &err), GLINT_BAD_ARGUMENT);
    assert_string_equal(err.text, "gate: 3 is not the number of a choice: cosine, sign, drawn");
    setting = glint_setting_divider(GLINT_DIVIDER_PIPELINED, 5);
    assert_int_equal(glint_setting_check(&setting, &err), GLINT_BAD_ARGUMENT);
    assert_string_equal(err.text, "shifts: 5 is not from 6 to 16");
}

static int count_of_settings(const glint_circuit *circuit)
{
    int count = 0;
    glint_setting setting;
    while (glint_setting_listed(circuit, count, &setting)) {
        assert_int_equal(glint_setting_check(&setting, NULL), GLINT_OK);
        count++;
    }
    return count;
}

static void the_listed_settings_turn_the_last_parameter_fastest(void **state)
{
    (void)state;
    glint_setting setting;
    assert_int_equal(count_of_settings(&glint_circuit_specular), 30);
    assert_int_equal(count_of_settings(&glint_circuit_divider), 22);
    assert_true(glint_setting_listed(&glint_circuit_specular, 13, &setting));
    const glint_specular_config config = {GLINT_GATE_SIGN, GLINT_PIPELINE_COMBINATIONAL, 8};
    const glint_setting expected = glint_setting_specular(&config);
    assert_true(glint_setting_equal(&setting, &expected));
    make_toy();
    toy.parameter_count = 0;
    assert_int_equal(count_of_settings(&toy), 1);
}

static void settings_are_equal_by_circuit_values_and_verilog(void **state)
{
    (void)state;
    glint_setting a = glint_setting_standard(&glint_circuit_divider), b = a;
    char one[] = "rtl", other[] = "rtl";
    assert_true(glint_setting_equal(&a, &b));
    b.values[GLINT_DIVIDER_SHIFTS]++;
    assert_false(glint_setting_equal(&a, &b));
    b = a;
    a.verilog = one;
    assert_false(glint_setting_equal(&a, &b));
    b.verilog = other;
    assert_true(glint_setting_equal(&a, &b));
    b.verilog = "elsewhere";
    assert_false(glint_setting_equal(&a, &b));
}

/* ---- The divider's domain ---------------------------------------------------------------------
 */

/* Every pair of a k and a difference, once in each component. */
static void the_domain_of_the_divider_is_every_pair(void **state)
{
    (void)state;
    enum { KS = 256, DIFFERENCES = 512 };
    static bool seen[GLINT_DIVIDER_COMPONENTS][KS][DIFFERENCES];
    const glint_setting setting = glint_setting_standard(&glint_circuit_divider);
    const glint_domain *of_divider = glint_circuit_divider.domain;
    const uint64_t count = of_divider->points(setting.values);
    assert_int_equal(count, KS * DIFFERENCES);
    for (uint64_t point = 0; point < count; point++) {
        glint_divider_inputs in = {0};
        of_divider->put(setting.values, point, &in);
        for (int c = 0; c < GLINT_DIVIDER_COMPONENTS; c++) {
            bool *pair = &seen[c][in.k][in.difference[c] + DIFFERENCES / 2];
            assert_false(*pair);
            *pair = true;
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_circuits_of_the_list_are_in_order),
        cmocka_unit_test(a_description_in_order_passes),
        cmocka_unit_test(each_fault_is_refused_in_its_own_words),
        cmocka_unit_test(a_circuit_without_a_usable_name_is_refused),
        cmocka_unit_test(all_listed_settings_are_looked_at),
        cmocka_unit_test(no_memory_for_the_model_is_no_fault_of_the_description),
        cmocka_unit_test(settings_have_names_texts_and_options),
        cmocka_unit_test(typed_settings_are_the_same_both_ways),
        cmocka_unit_test(settings_out_of_range_are_refused),
        cmocka_unit_test(the_listed_settings_turn_the_last_parameter_fastest),
        cmocka_unit_test(settings_are_equal_by_circuit_values_and_verilog),
        cmocka_unit_test(the_domain_of_the_divider_is_every_pair),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
