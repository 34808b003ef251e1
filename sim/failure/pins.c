#include "failure/pins.h"

#include <stddef.h>

/* Where a pin lies in the inputs of its circuit. */
typedef struct pin {
    const char *name;
    size_t offset;
    int size; /* bytes */
    int width, frac_bits;
    bool is_signed;
} pin;

#define SPECULAR(name, width)                                                                      \
    {                                                                                              \
#name, offsetof(glint_specular_inputs, name), sizeof(((glint_specular_inputs *)0)->name),  \
            width, 0, false                                                                        \
    }
#define DIVIDER(text, field, width, is_signed)                                                     \
    {                                                                                              \
        text, offsetof(glint_divider_inputs, field), sizeof(((glint_divider_inputs *)0)->field),   \
            width, 0, is_signed                                                                    \
    }
#define DIFFERENCE(text, component)                                                                \
    DIVIDER(text, difference[component], GLINT_DIVIDER_DIFFERENCE_BITS, true)

/* The cosines come behind them, one a lane; in_valid has a bit for each. */
static const pin specular_pins[] = {
    SPECULAR(reset, 1),
    SPECULAR(en, 1),
    SPECULAR(n_we, 1),
    SPECULAR(n, GLINT_N_BITS),
    SPECULAR(rgb_we, 1),
    SPECULAR(r, GLINT_COLOR_BITS),
    SPECULAR(g, GLINT_COLOR_BITS),
    SPECULAR(b, GLINT_COLOR_BITS),
    SPECULAR(in_valid, 0),
};
#define SPECULAR_PINS ((int)(sizeof specular_pins / sizeof specular_pins[0]))

static const pin sequential_pins[] = {
    DIVIDER("reset", reset, 1, false), DIVIDER("en", en, 1, false),
    DIVIDER("start", start, 1, false), DIVIDER("k", k, GLINT_DIVIDER_K_BITS, false),
    DIFFERENCE("difference", 0),
};
#define SEQUENTIAL_PINS ((int)(sizeof sequential_pins / sizeof sequential_pins[0]))

static const pin pipelined_pins[] = {
    DIVIDER("reset", reset, 1, false),    DIVIDER("en", en, 1, false),
    DIVIDER("in_valid", start, 1, false), DIVIDER("k", k, GLINT_DIVIDER_K_BITS, false),
    DIFFERENCE("difference_r", 0),        DIFFERENCE("difference_g", 1),
    DIFFERENCE("difference_b", 2),
};
#define PIPELINED_PINS ((int)(sizeof pipelined_pins / sizeof pipelined_pins[0]))

static pin pin_of(const glint_setting *setting, int index)
{
    if (setting->is_divider)
        return setting->form == GLINT_DIVIDER_SEQUENTIAL ? sequential_pins[index]
                                                         : pipelined_pins[index];
    if (index < SPECULAR_PINS) {
        pin found = specular_pins[index];
        if (found.width == 0)
            found.width = setting->specular.lanes;
        return found;
    }
    const size_t lane = (size_t)(index - SPECULAR_PINS);
    return (pin){"cos",
                 offsetof(glint_specular_inputs, cos) + lane * sizeof(uint32_t),
                 sizeof(uint32_t),
                 GLINT_COS_BITS,
                 GLINT_COS_FRAC_BITS,
                 false};
}

int glint_pin_count(const glint_setting *setting)
{
    if (!setting->is_divider)
        return SPECULAR_PINS + setting->specular.lanes;
    return setting->form == GLINT_DIVIDER_SEQUENTIAL ? SEQUENTIAL_PINS : PIPELINED_PINS;
}

glint_pin_info glint_pin(const glint_setting *setting, int index)
{
    const pin pin = pin_of(setting, index);
    const int64_t values = INT64_C(1) << pin.width;
    return (glint_pin_info){
        .name = pin.name,
        .lane = !setting->is_divider && index >= SPECULAR_PINS ? index - SPECULAR_PINS : -1,
        .width = pin.width,
        .frac_bits = pin.frac_bits,
        .is_signed = pin.is_signed,
        .min = pin.is_signed ? -values / 2 : 0,
        .max = pin.is_signed ? values / 2 - 1 : values - 1};
}

static const void *place_of(const glint_setting *setting, const glint_pins *pins, const pin *pin)
{
    return setting->is_divider ? (const char *)&pins->divider + pin->offset
                               : (const char *)&pins->specular + pin->offset;
}

int64_t glint_pin_get(const glint_setting *setting, const glint_pins *pins, int index)
{
    const pin pin = pin_of(setting, index);
    const void *place = place_of(setting, pins, &pin);
    switch (pin.size) {
    case 1:
        return *(const uint8_t *)place;
    case 2:
        return pin.is_signed ? *(const int16_t *)place : *(const uint16_t *)place;
    default:
        return *(const uint32_t *)place;
    }
}

void glint_pin_set(const glint_setting *setting, glint_pins *pins, int index, int64_t value)
{
    const pin pin = pin_of(setting, index);
    char *base = setting->is_divider ? (char *)&pins->divider : (char *)&pins->specular;
    void *place = base + pin.offset;
    switch (pin.size) {
    case 1:
        *(uint8_t *)place = (uint8_t)value;
        break;
    case 2:
        *(uint16_t *)place = (uint16_t)value;
        break;
    default:
        *(uint32_t *)place = (uint32_t)value;
    }
}
