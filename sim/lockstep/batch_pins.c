#include "lockstep/batch_pins.h"

#include <string.h>

static bool is_sequential(const glint_setting *setting)
{
    return setting->is_divider && setting->form == GLINT_DIVIDER_SEQUENTIAL;
}

static void put_points(const glint_setting *setting, const glint_batch *batch, size_t clock,
                       glint_specular_inputs *in)
{
    const size_t lanes = (size_t)setting->specular.lanes;
    in->en = 1;
    if (clock == 0) {
        in->n_we = in->rgb_we = 1;
        in->n = batch->material->n;
        in->r = batch->material->r;
        in->g = batch->material->g;
        in->b = batch->material->b;
    }
    for (size_t lane = 0; lane < lanes && clock * lanes + lane < batch->count; lane++) {
        in->cos[lane] = batch->cos_code[clock * lanes + lane];
        in->in_valid |= 1u << lane;
    }
}

/* The sequential form takes one component after the other. */
static void put_division(const glint_setting *setting, const glint_batch *batch, size_t clock,
                         glint_divider_inputs *in)
{
    const size_t pace = is_sequential(setting) ? (size_t)setting->shifts + 1 : 1;
    const size_t each = is_sequential(setting) ? GLINT_DIVIDER_COMPONENTS : 1;
    const size_t turn = clock / pace;
    in->en = 1;
    if (clock % pace != 0 || turn >= batch->count * each)
        return;
    const glint_division *division = &batch->division[turn / each];
    in->start = 1;
    in->k = division->k;
    memcpy(in->difference, division->difference, sizeof in->difference);
    if (is_sequential(setting))
        in->difference[0] = division->difference[turn % each];
}

size_t glint_batch_feeding_clocks(const glint_setting *setting, size_t count)
{
    if (!setting->is_divider)
        return (count + (size_t)setting->specular.lanes - 1) / (size_t)setting->specular.lanes;
    return is_sequential(setting) ? count * GLINT_DIVIDER_COMPONENTS * (size_t)(setting->shifts + 1)
                                  : count;
}

size_t glint_batch_clocks(const glint_setting *setting, size_t count)
{
    const size_t feeding = glint_batch_feeding_clocks(setting, count);
    return is_sequential(setting) ? feeding : feeding + (size_t)glint_setting_latency(setting) - 1;
}

glint_pins glint_batch_pins(const glint_setting *setting, const glint_batch *batch, size_t clock)
{
    glint_pins pins;
    memset(&pins, 0, sizeof pins);
    if (setting->is_divider)
        put_division(setting, batch, clock, &pins.divider);
    else
        put_points(setting, batch, clock, &pins.specular);
    return pins;
}
