/* The tables that the list of signals in glint_power_device.h expands to. */
#include <stddef.h>

#include "glint_power_device.h"

/* The offset is that in glint_power_signals, or in glint_power_lane. */
#define ROW(type, name_, block_, kind_, int_bits_, frac_bits_, is_signed_, meaning_)               \
    {.name = #name_,                                                                               \
     .block = (block_),                                                                            \
     .kind = GLINT_SIGNAL_##kind_,                                                                 \
     .int_bits = (int_bits_),                                                                      \
     .frac_bits = (frac_bits_),                                                                    \
     .is_signed = (is_signed_),                                                                    \
     .lane = -1,                                                                                   \
     .meaning = (meaning_),                                                                        \
     .offset = offsetof(type, name_)},
#define SHARED_ROW(...) ROW(glint_power_signals, __VA_ARGS__)
#define LANE_ROW(...)   ROW(glint_power_lane, __VA_ARGS__)

static const glint_signal_info shared_rows[] = {GLINT_POWER_SHARED_SIGNALS(SHARED_ROW)};
static const glint_signal_info lane_rows[] = {GLINT_POWER_LANE_SIGNALS(LANE_ROW)};

enum {
    SHARED_COUNT = sizeof shared_rows / sizeof shared_rows[0],
    LANE_COUNT = sizeof lane_rows / sizeof lane_rows[0],
};

int glint_power_signal_count(const glint_power_config *config)
{
    return SHARED_COUNT + config->lanes * LANE_COUNT;
}

static int frac_bits_of(const glint_power_config *config, int frac_bits)
{
    if (frac_bits == GLINT_POWER_TABLE_FRAC)
        return GLINT_POWER_TABLE_BITS(config->accuracy);
    if (frac_bits == GLINT_POWER_W_FRAC)
        return GLINT_POWER_W_FRAC_BITS(config->accuracy);
    return frac_bits;
}

glint_signal_info glint_power_signal_info(const glint_power_config *config, int index)
{
    const int of_lanes = index - SHARED_COUNT;
    glint_signal_info info = of_lanes < 0 ? shared_rows[index] : lane_rows[of_lanes % LANE_COUNT];
    if (info.int_bits == GLINT_LANES_WIDTH && info.frac_bits == 0)
        info.int_bits = config->lanes;
    info.frac_bits = frac_bits_of(config, info.frac_bits);
    if (of_lanes >= 0) {
        info.lane = of_lanes / LANE_COUNT;
        info.offset +=
            offsetof(glint_power_signals, lane) + (size_t)info.lane * sizeof(glint_power_lane);
    }
    return info;
}
