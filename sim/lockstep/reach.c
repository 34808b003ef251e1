/* Coverage counters, fed from the pins alone; see reach.h. */
#include "lockstep/reach.h"

#include <string.h>

static uint64_t mask_of(int width)
{
    return width >= 64 ? UINT64_MAX : (UINT64_C(1) << width) - 1;
}

static void add_pin(glint_reach_count *count, const glint_pin_info *pin)
{
    if (pin->role == GLINT_PIN_DATA || count->pins == GLINT_REACH_PINS_MAX)
        return;
    count->pin[count->pins++] =
        (glint_reach_pin){pin->role, pin->offset, pin->size, mask_of(glint_pin_width(pin))};
    count->has_valid |= pin->role == GLINT_PIN_VALID;
}

void glint_reach_begin(glint_reach_count *count, const glint_setting *setting)
{
    memset(count, 0, sizeof *count);
    for (int i = 0; i < glint_setting_pin_count(setting); i++) {
        const glint_pin_info pin = glint_setting_pin(setting, i);
        add_pin(count, &pin);
    }
    count->lanes = glint_reach_lanes(setting);
    count->latency = (uint64_t)glint_setting_latency(setting);
    count->pace = (uint64_t)glint_setting_pace(setting);
}

/* The combined meaning of one clock's pins. */
typedef struct controls {
    bool resets, enabled, strobes;
    uint64_t valid;
} controls;

static uint64_t value_of(const glint_reach_pin *pin, const glint_pins *pins)
{
    const unsigned char *from = pins->bytes + pin->offset;
    uint64_t word = 0, any = 0;
    uint16_t two;
    uint32_t four;
    switch (pin->size) {
    case 1:
        return *from & pin->mask;
    case 2:
        memcpy(&two, from, sizeof two);
        return two & pin->mask;
    case 4:
        memcpy(&four, from, sizeof four);
        return four & pin->mask;
    default: /* of more than a word: whether any of it is 1 */
        for (size_t at = 0; at < pin->size; at += sizeof word) {
            memcpy(&word, from + at, sizeof word);
            any |= word;
        }
        return any & pin->mask;
    }
}

static controls read_controls(const glint_reach_count *count, const glint_pins *pins)
{
    controls now = {.enabled = true, .valid = !count->has_valid};
    for (int i = 0; i < count->pins; i++) {
        const uint64_t value = value_of(&count->pin[i], pins);
        switch (count->pin[i].role) {
        case GLINT_PIN_RESET:
            now.resets |= value != 0;
            break;
        case GLINT_PIN_RESET_LOW:
            now.resets |= value == 0;
            break;
        case GLINT_PIN_ENABLE:
            now.enabled &= value != 0;
            break;
        case GLINT_PIN_ENABLE_LOW:
            now.enabled &= value == 0;
            break;
        case GLINT_PIN_VALID:
            now.valid |= value;
            break;
        default:
            now.strobes |= value != 0;
        }
    }
    return now;
}

bool glint_reach_is_live(const glint_reach_count *count, const glint_pins *pins)
{
    const controls now = read_controls(count, pins);
    return now.enabled && !now.resets;
}

bool glint_reach_is_reset(const glint_reach_count *count, const glint_pins *pins)
{
    return read_controls(count, pins).resets;
}

static void keep_most(uint64_t *most, uint64_t value)
{
    if (*most < value)
        *most = value;
}

/* Whether anything was taken fewer enabled clocks ago. */
static bool taken_within(const glint_reach_count *count, uint64_t clocks)
{
    return count->since != 0 && count->since < clocks;
}

/* Whether any input is still in flight. A result is out after its last clock, so inputs from
 * `latency` enabled clocks ago are gone. */
static bool is_in_flight(const glint_reach_count *count)
{
    return taken_within(count, count->latency);
}

static void reset(glint_reach_count *count)
{
    count->reach.resets++;
    count->reach.resets_in_flight += is_in_flight(count);
    count->run = count->run_enabled = count->stall = 0;
    count->since = 0;
}

static void count_alone(glint_reach_count *count, uint64_t valid)
{
    const bool is_one = (valid & (valid - 1)) == 0;
    count->reach.lanes_alone += is_one && (count->alone & valid) == 0;
    count->alone |= is_one ? valid : 0;
}

static void count_lanes(glint_reach_count *count, uint64_t valid)
{
    if (valid == 0 || count->lanes == 0)
        return;
    count_alone(count, valid);
    if (count->lanes > GLINT_REACH_PATTERN_LANES)
        return;
    const uint64_t bit = UINT64_C(1) << (valid % 64);
    uint64_t *seen = &count->patterns[valid / 64];
    count->reach.patterns += (*seen & bit) == 0;
    *seen |= bit;
}

/* True if an input was accepted. A circuit with a pace accepts nothing while it is busy. */
static bool take(glint_reach_count *count, const controls *now)
{
    if (now->strobes) {
        count->reach.changes++;
        count->reach.changes_in_flight += is_in_flight(count);
    }
    if (now->valid == 0)
        return false;
    if (taken_within(count, count->pace)) {
        count->reach.ignored++;
        return false;
    }
    count_lanes(count, now->valid);
    return true;
}

void glint_reach_clock(glint_reach_count *count, const glint_pins *pins)
{
    const controls now = read_controls(count, pins);
    if (now.resets) {
        reset(count);
        return;
    }
    keep_most(&count->reach.run, ++count->run);
    if (!now.enabled) {
        keep_most(&count->reach.stall, ++count->stall);
        return;
    }
    count->stall = 0;
    keep_most(&count->reach.run_enabled, ++count->run_enabled);
    const bool takes = take(count, &now);
    count->reach.taken += takes;
    if (takes)
        count->since = 1;
    else if (count->since != 0)
        count->since++;
}

bool glint_reach_has(const glint_setting *setting, glint_pin_role role)
{
    bool has = false;
    for (int i = 0; i < glint_setting_pin_count(setting); i++)
        has |= glint_setting_pin(setting, i).role == role;
    return has;
}

int glint_reach_lanes(const glint_setting *setting)
{
    bool has_lanes = false;
    int width = 0;
    for (int i = 0; i < glint_setting_pin_count(setting); i++) {
        const glint_pin_info pin = glint_setting_pin(setting, i);
        has_lanes |= pin.lane >= 0;
        if (pin.role == GLINT_PIN_VALID)
            width = glint_pin_width(&pin);
    }
    return (has_lanes || width > 1) && width <= 64 ? width : 0;
}
