#include "lockstep/reach.h"

#include <string.h>

void glint_reach_begin(glint_reach_count *count, const glint_setting *setting)
{
    memset(count, 0, sizeof *count);
    count->setting = setting;
}

static void keep_most(uint64_t *most, uint64_t value)
{
    if (*most < value)
        *most = value;
}

/* Whether anything taken has not come out yet. The result is out after the last of its clocks, so
 * of those taken `latency` enabled clocks ago none is left. */
static bool is_in_flight(const glint_reach_count *count)
{
    const int latency = glint_setting_latency(count->setting);
    return (count->in_flight & ((UINT64_C(1) << (latency - 1)) - 1)) != 0;
}

static void reset(glint_reach_count *count)
{
    count->reach.resets++;
    count->reach.resets_in_flight += is_in_flight(count);
    count->run = count->run_enabled = count->stall = 0;
    count->in_flight = 0;
}

static void count_lanes(glint_reach_count *count, uint32_t valid)
{
    const uint64_t bit = UINT64_C(1) << (valid % 64);
    uint64_t *seen = &count->patterns[valid / 64];
    if (valid == 0 || (*seen & bit) != 0)
        return;
    *seen |= bit;
    count->reach.patterns++;
    count->reach.lanes_alone += (valid & (valid - 1)) == 0;
}

/* True: points were taken. */
static bool take_points(glint_reach_count *count, const glint_specular_inputs *in)
{
    if (in->n_we || in->rgb_we) {
        count->reach.changes++;
        count->reach.changes_in_flight += is_in_flight(count);
    }
    count_lanes(count, in->in_valid);
    return in->in_valid != 0;
}

/* True: a division was taken. The sequential form takes none while it is busy with one. */
static bool take_division(glint_reach_count *count, const glint_divider_inputs *in)
{
    if (!in->start)
        return false;
    if (count->setting->form == GLINT_DIVIDER_SEQUENTIAL && is_in_flight(count)) {
        count->reach.ignored++;
        return false;
    }
    return true;
}

void glint_reach_clock(glint_reach_count *count, const glint_pins *pins)
{
    const bool is_divider = count->setting->is_divider;
    const bool resets = is_divider ? pins->divider.reset : pins->specular.reset;
    const bool en = is_divider ? pins->divider.en : pins->specular.en;
    if (resets) {
        reset(count);
        return;
    }
    keep_most(&count->reach.run, ++count->run);
    if (!en) {
        keep_most(&count->reach.stall, ++count->stall);
        return;
    }
    count->stall = 0;
    keep_most(&count->reach.run_enabled, ++count->run_enabled);
    const bool takes =
        is_divider ? take_division(count, &pins->divider) : take_points(count, &pins->specular);
    count->reach.taken += takes;
    count->in_flight = count->in_flight << 1 | takes;
}
