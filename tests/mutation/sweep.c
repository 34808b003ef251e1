/* Directed stimulus, one clock at a time; see sweep.h. */
#include "sweep.h"

#include <string.h>

#include "circuit/circuits.h"
#include "circuit/unit.h"
#include "circuit/words.h"
#include "glint_power.h"

extern const glint_circuit glint_circuit_power; /* sim/circuit/power.c */

enum {
    AROUND = 8, /* codes below the limit */
    BELOW = 16, /* codes between 0 and the limit */
    BEYOND = 2,
    COLORS_STEP = 251, /* a prime: neighbours in W meet different colours */
    K_CODES = 1 << GLINT_DIVIDER_K_BITS,
    DIFFERENCES = 1 << GLINT_DIVIDER_DIFFERENCE_BITS,
};

/* ---- Highlight units: the specular device and the power device ------------------------------- */

static bool is_power(const glint_setting *setting)
{
    return setting->circuit == &glint_circuit_power;
}

/* The first cosine whose W is not 0; W never falls as the cosine grows. */
static uint32_t power_limit(const glint_setting *setting, uint32_t n)
{
    const int variant = glint_unit_config_of(&glint_unit_power, setting->values).variant;
    uint32_t dark = 0, bright = GLINT_COS_ONE; /* dark: all below it are */
    while (dark < bright) {
        const uint32_t middle = dark + (bright - dark) / 2;
        uint32_t w;
        glint_unit_power.ws(variant, n, &middle, 1, &w);
        if (w == 0)
            dark = middle + 1;
        else
            bright = middle;
    }
    return bright;
}

static uint32_t limit_of(const glint_setting *setting, uint32_t n)
{
    return is_power(setting) ? power_limit(setting, n) : glint_rom9(GLINT_GATE_COSINE, n);
}

/* Cosines of one n in white: some outside the highlight, all from just below its limit to 1.0, and
 * codes beyond. */
static uint32_t outside_count(uint32_t limit)
{
    return BELOW + (limit < AROUND ? limit : AROUND);
}

static uint32_t cosine_count(uint32_t limit)
{
    return outside_count(limit) + GLINT_COS_ONE + 1 - limit + BEYOND;
}

static uint32_t cosine_of(uint32_t limit, uint32_t place)
{
    static const uint32_t beyond[BEYOND] = {GLINT_COS_ONE + 1, GLINT_COS_CODE_MAX};
    if (place < BELOW)
        return (uint32_t)((uint64_t)limit * place / BELOW);
    const uint32_t cosine = limit + place - outside_count(limit);
    return cosine <= GLINT_COS_ONE ? cosine : beyond[cosine - GLINT_COS_ONE - 1];
}

static void highlight_next(mutation_sweep *at, const glint_setting *setting,
                           glint_specular_inputs *in)
{
    in->en = in->n_we = in->rgb_we = 1;
    in->in_valid = 1;
    if (at->n < GLINT_N_COUNT) {
        in->n = (uint16_t)(GLINT_N_MAX - at->n);
        in->r = in->g = in->b = GLINT_COLOR_MAX;
        if (at->place == 0)
            at->limit = limit_of(setting, in->n);
        in->cos[0] = cosine_of(at->limit, at->place++);
        if (at->place == cosine_count(at->limit)) {
            at->n++;
            at->place = 0;
        }
        return;
    }
    in->n = is_power(setting) ? 1 : 2;
    in->cos[0] = at->place++;
    in->r = (uint8_t)(in->cos[0] % COLORS_STEP);
    in->g = (uint8_t)(in->r + 85);
    in->b = (uint8_t)(in->r + 170);
}

static uint64_t highlight_clocks(const glint_setting *setting)
{
    uint64_t clocks = GLINT_COS_CODE_MAX + 1;
    for (uint32_t n = 0; n < GLINT_N_COUNT; n++)
        clocks += cosine_count(limit_of(setting, n));
    return clocks;
}

static bool has_highlights(const glint_setting *setting)
{
    return setting->circuit == &glint_circuit_specular || is_power(setting);
}

/* ---- Dividers -------------------------------------------------------------------------------- */

static int16_t difference_of(uint32_t place)
{
    return (int16_t)((int)(place % DIFFERENCES) - DIFFERENCES / 2);
}

static void sequential_next(int shifts, uint64_t clock, glint_divider_inputs *in)
{
    const uint32_t latency = (uint32_t)glint_divider_latency(shifts);
    const uint32_t place = (uint32_t)((clock - 1) / latency);
    in->en = 1;
    in->start = (clock - 1) % latency == 0;
    in->k = (uint8_t)(place / DIFFERENCES);
    in->difference[0] = difference_of(place);
}

static uint64_t sequential_clocks(int shifts)
{
    return (uint64_t)K_CODES * DIFFERENCES * (uint64_t)glint_divider_latency(shifts);
}

static void pipelined_next(uint64_t clock, glint_divider_inputs *in)
{
    const uint32_t place = (uint32_t)(clock - 1);
    in->en = in->start = 1;
    in->k = (uint8_t)(place / DIFFERENCES);
    in->difference[0] = difference_of(place);
    in->difference[1] = difference_of(place + DIFFERENCES / 3);
    in->difference[2] = difference_of(place + 2 * DIFFERENCES / 3);
}

static uint64_t pipelined_clocks(int shifts)
{
    return (uint64_t)K_CODES * DIFFERENCES + (uint64_t)glint_divider_latency(shifts);
}

/* ---- Whichever circuit ----------------------------------------------------------------------- */

static bool is_sequential(const glint_setting *setting)
{
    return setting->values[GLINT_DIVIDER_FORM] == GLINT_DIVIDER_SEQUENTIAL;
}

static uint64_t domain_clocks(const glint_setting *setting)
{
    const glint_circuit *circuit = setting->circuit;
    const int *values = setting->values;
    const uint64_t pace = circuit->pace != NULL ? (uint64_t)circuit->pace(values) : 1;
    return circuit->domain == NULL
               ? 0
               : circuit->domain->points(values) * pace + (uint64_t)glint_setting_latency(setting);
}

/* A point every `pace` clocks, and nothing after the last. */
static void domain_next(const glint_setting *setting, uint64_t clock, glint_pins *pins)
{
    const glint_circuit *circuit = setting->circuit;
    const uint64_t pace = circuit->pace != NULL ? (uint64_t)circuit->pace(setting->values) : 1;
    const uint64_t point = (clock - 1) / pace;
    const bool takes = (clock - 1) % pace == 0 && point < circuit->domain->points(setting->values);
    static const uint64_t one = 1;
    for (int i = 0; i < circuit->pin_count(setting->values); i++) {
        const glint_pin_info pin = circuit->pin(setting->values, i);
        if (pin.role == GLINT_PIN_ENABLE || pin.role == GLINT_PIN_RESET_LOW ||
            (pin.role == GLINT_PIN_VALID && takes))
            glint_pin_set(&pin, pins, &one);
    }
    if (takes)
        circuit->domain->put(setting->values, point, pins);
}

uint64_t mutation_sweep_clocks(const glint_setting *setting)
{
    const int shifts = setting->values[GLINT_DIVIDER_SHIFTS];
    if (has_highlights(setting))
        return highlight_clocks(setting);
    if (setting->circuit == &glint_circuit_divider)
        return is_sequential(setting) ? sequential_clocks(shifts) : pipelined_clocks(shifts);
    return domain_clocks(setting);
}

void mutation_sweep_next(mutation_sweep *at, const glint_setting *setting, uint64_t clock,
                         glint_pins *pins)
{
    memset(pins, 0, sizeof *pins);
    if (has_highlights(setting)) {
        glint_specular_inputs inputs = {0};
        highlight_next(at, setting, &inputs);
        memcpy(pins, &inputs, sizeof inputs);
    } else if (setting->circuit == &glint_circuit_divider) {
        glint_divider_inputs inputs = {0};
        if (is_sequential(setting))
            sequential_next(setting->values[GLINT_DIVIDER_SHIFTS], clock, &inputs);
        else
            pipelined_next(clock, &inputs);
        memcpy(pins, &inputs, sizeof inputs);
    } else {
        domain_next(setting, clock, pins);
    }
}
