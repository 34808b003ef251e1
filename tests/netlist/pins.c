#include "pins.h"

#include <string.h>

#include "circuit/random_pins.h"
#include "lockstep/twin.h"
#include "rtl/divider_model.h"
#include "rtl/places.h"
#include "rtl/rtl_model.h"

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
    const glint_setting *setting;
    void *circuit;
    glint_twin *model;
    glint_random_pins source;
    pin pins[PINS_MAX];
    int pin_count;
} pair;

/* ---- Either circuit -------------------------------------------------------------------------- */

static glint_status create_both(pair *pair, uint64_t seed, glint_error *err)
{
    const glint_setting *setting = pair->setting;
    pair->circuit =
        setting->is_divider ? setting->divider_model->create() : setting->specular_model->create();
    if (pair->circuit == NULL)
        return glint_fail(err, GLINT_NO_MEMORY, "no memory for the circuit");
    glint_random_pins_begin(&pair->source, setting, seed);
    return glint_twin_create_model(setting, &pair->model, err);
}

static void destroy_both(pair *pair)
{
    glint_twin_destroy(pair->model);
    if (pair->circuit == NULL)
        return;
    if (pair->setting->is_divider)
        pair->setting->divider_model->destroy(pair->circuit);
    else
        pair->setting->specular_model->destroy(pair->circuit);
}

static void clock_both(pair *pair)
{
    glint_pins pins;
    glint_random_pins_next(&pair->source, &pins);
    glint_twin_clock(pair->model, &pins);
    if (pair->setting->is_divider)
        pair->setting->divider_model->clock(pair->circuit, &pins.divider);
    else
        pair->setting->specular_model->clock(pair->circuit, &pins.specular);
}

static bool find_port(const pair *pair, const char *name, const void **data, int *size)
{
    const glint_setting *setting = pair->setting;
    return setting->is_divider ? setting->divider_model->find(pair->circuit, -1, name, data, size)
                               : setting->specular_model->find(pair->circuit, -1, name, data, size);
}

/* ---- The pins -------------------------------------------------------------------------------- */

/* The outputs, and the one register that is a pin as well. */
static bool is_pin(const glint_signal_info *info)
{
    return info->kind == GLINT_SIGNAL_OUTPUT || strcmp(info->name, "busy") == 0;
}

static glint_status find_pins(pair *pair, glint_error *err)
{
    for (int i = 0; i < glint_setting_signal_count(pair->setting); i++) {
        pin pin = {.info = glint_setting_signal(pair->setting, i), .index = i};
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
    uint64_t model[GLINT_SETTING_SIGNALS_MAX];
    glint_twin_read(pair->model, model, NULL);
    for (int i = 0; i < pair->pin_count; i++) {
        const pin *pin = &pair->pins[i];
        const uint64_t circuit = pin_bits(pin);
        if (model[pin->index] != circuit && result->mismatches++ == 0) {
            result->first_clock = result->clocks;
            result->first_pin = pin->info.name;
            result->first_lane = pin->info.lane;
            result->first_model = model[pin->index];
            result->first_circuit = circuit;
        }
    }
    result->comparisons += (uint64_t)pair->pin_count;
}

static bool has_build(const glint_setting *setting)
{
    return setting->is_divider ? setting->divider_model != NULL : setting->specular_model != NULL;
}

glint_status pins_run(const pins_options *options, pins_result *result, glint_error *err)
{
    pair pair = {.setting = &options->setting};
    memset(result, 0, sizeof *result);
    if (options->clocks == 0 || !has_build(&options->setting))
        return glint_fail(err, GLINT_BAD_ARGUMENT, "a build and at least one clock are needed");
    glint_status status = create_both(&pair, options->seed, err);
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
