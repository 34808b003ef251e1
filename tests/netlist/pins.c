#include "pins.h"

#include <string.h>

#include "lockstep/divider_lockstep.h"
#include "lockstep/stimulus.h"
#include "rtl/places.h"

#define PINS_MAX (1 + 4 * GLINT_LANES_MAX)

/* An output pin: which signal of the model it is, and where its bits lie in the circuit. */
typedef struct pin {
    glint_signal_info info;
    int index;
    const uint8_t *data; /* of the port that it is a part of; Verilator's words are little-endian */
    int size;            /* of the port, bytes */
    int low;             /* its first bit in it */
} pin;

typedef struct pair {
    const pins_options *options;
    void *circuit;
    glint_specular_device *specular;
    glint_divider_device *divider;
    glint_stimulus stimulus;
    glint_divider_stimulus divider_stimulus;
    pin pins[PINS_MAX];
    int pin_count;
} pair;

/* ---- Either circuit ----------------------------------------------------------------------------
 */

static int signal_count(const pair *pair)
{
    const pins_options *o = pair->options;
    return o->specular != NULL ? glint_specular_signal_count(&o->specular->config)
                               : glint_divider_signal_count(o->divider->form, o->divider->shifts);
}

static glint_signal_info signal_info(const pair *pair, int index)
{
    const pins_options *o = pair->options;
    return o->specular != NULL
               ? glint_specular_signal_info(&o->specular->config, index)
               : glint_divider_signal_info(o->divider->form, o->divider->shifts, index);
}

static uint64_t signal_bits(const pair *pair, int index)
{
    if (pair->options->divider != NULL)
        return glint_divider_signal_bits(pair->divider, index);
    return glint_specular_signal_bits(&pair->options->specular->config,
                                      glint_specular_device_signals(pair->specular), index);
}

static bool find_port(const pair *pair, const char *name, const void **data, int *size)
{
    const pins_options *o = pair->options;
    return o->specular != NULL ? o->specular->find(pair->circuit, -1, name, data, size)
                               : o->divider->find(pair->circuit, -1, name, data, size);
}

static glint_status create_both(pair *pair)
{
    const pins_options *o = pair->options;
    pair->circuit = o->specular != NULL ? o->specular->create() : o->divider->create();
    if (pair->circuit == NULL)
        return GLINT_NO_MEMORY;
    if (o->divider != NULL) {
        glint_divider_stimulus_init(&pair->divider_stimulus, o->seed);
        return glint_divider_device_create(o->divider->form, o->divider->shifts, &pair->divider);
    }
    glint_stimulus_init(&pair->stimulus, o->seed, o->specular->config.lanes);
    return glint_specular_device_create(&o->specular->config, &pair->specular);
}

static void destroy_both(pair *pair)
{
    const pins_options *o = pair->options;
    glint_specular_device_destroy(pair->specular);
    glint_divider_device_destroy(pair->divider);
    if (pair->circuit != NULL && o->specular != NULL)
        o->specular->destroy(pair->circuit);
    if (pair->circuit != NULL && o->divider != NULL)
        o->divider->destroy(pair->circuit);
}

static void clock_both(pair *pair)
{
    const pins_options *o = pair->options;
    if (o->divider != NULL) {
        glint_divider_inputs inputs;
        glint_divider_stimulus_next(&pair->divider_stimulus, &inputs);
        glint_divider_device_clock(pair->divider, &inputs);
        o->divider->clock(pair->circuit, &inputs);
    } else {
        glint_specular_inputs inputs;
        glint_stimulus_next(&pair->stimulus, &inputs);
        glint_specular_device_clock(pair->specular, &inputs);
        o->specular->clock(pair->circuit, &inputs);
    }
}

/* ---- The pins ----------------------------------------------------------------------------------
 */

/* The outputs, and the one register that is a pin as well. */
static bool is_pin(const glint_signal_info *info)
{
    return info->kind == GLINT_SIGNAL_OUTPUT || strcmp(info->name, "busy") == 0;
}

static glint_status find_pins(pair *pair, glint_error *err)
{
    for (int i = 0; i < signal_count(pair); i++) {
        pin pin = {.info = signal_info(pair, i), .index = i};
        const void *data;
        if (!is_pin(&pin.info))
            continue;
        if (!find_port(pair, pin.info.name, &data, &pin.size))
            return glint_fail(err, GLINT_DEVICE_FAULT, "the circuit has no pin %s", pin.info.name);
        pin.data = data;
        pin.low = pin.info.lane < 0 ? 0 : pin.info.lane * (pin.info.int_bits + pin.info.frac_bits);
        pair->pins[pair->pin_count++] = pin;
    }
    return GLINT_OK;
}

static uint64_t pin_bits(const pin *pin)
{
    uint64_t bits = 0;
    const int first = pin->low / 8, shift = pin->low % 8;
    for (int i = 0; i < 8 && first + i < pin->size; i++)
        bits |= (uint64_t)pin->data[first + i] << (8 * i);
    return bits >> shift & glint_signal_mask(&pin->info);
}

static void compare(const pair *pair, pins_result *result)
{
    for (int i = 0; i < pair->pin_count; i++) {
        const pin *pin = &pair->pins[i];
        const uint64_t model = signal_bits(pair, pin->index), circuit = pin_bits(pin);
        if (model != circuit && result->mismatches++ == 0) {
            result->first_clock = result->clocks;
            result->first_pin = pin->info.name;
            result->first_lane = pin->info.lane;
            result->first_model = model;
            result->first_circuit = circuit;
        }
    }
    result->comparisons += (uint64_t)pair->pin_count;
}

glint_status pins_run(const pins_options *options, pins_result *result, glint_error *err)
{
    pair pair = {.options = options};
    memset(result, 0, sizeof *result);
    if (options->clocks == 0 || (options->specular == NULL) == (options->divider == NULL))
        return glint_fail(err, GLINT_BAD_ARGUMENT, "one circuit and at least one clock are needed");
    glint_status status = create_both(&pair);
    if (status != GLINT_OK)
        glint_fail(err, status, "cannot create the circuit or its C model");
    if (status == GLINT_OK)
        status = find_pins(&pair, err);

    while (status == GLINT_OK && result->clocks < options->clocks &&
           !(options->stop_at_first && result->mismatches != 0)) {
        clock_both(&pair);
        result->clocks++;
        compare(&pair, result);
    }
    destroy_both(&pair);
    return status;
}
