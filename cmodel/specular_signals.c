/* The tables that the list of signals in glint_specular_device.h expands to. */
#include <stddef.h>

#include "glint_specular_device.h"

/* The offset is that in glint_specular_signals, or in glint_specular_lane. */
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
#define SHARED_ROW(...) ROW(glint_specular_signals, __VA_ARGS__)
#define LANE_ROW(...)   ROW(glint_specular_lane, __VA_ARGS__)

static const glint_signal_info shared_rows[] = {GLINT_SPECULAR_SHARED_SIGNALS(SHARED_ROW)};
static const glint_signal_info lane_rows[] = {GLINT_SPECULAR_LANE_SIGNALS(LANE_ROW)};

enum {
    SHARED_COUNT = sizeof shared_rows / sizeof shared_rows[0],
    LANE_COUNT = sizeof lane_rows / sizeof lane_rows[0],
};

int glint_specular_signal_count(const glint_specular_config *config)
{
    return SHARED_COUNT + config->lanes * LANE_COUNT;
}

static int int_bits_of(const glint_specular_config *config, int int_bits)
{
    if (int_bits == GLINT_LANES_WIDTH)
        return config->lanes;
    if (int_bits == GLINT_MUL10_WIDTH)
        return config->gate == GLINT_GATE_DRAWN ? GLINT_W_DRAWN_INT_BITS : 1;
    return int_bits;
}

glint_signal_info glint_specular_signal_info(const glint_specular_config *config, int index)
{
    const int of_lanes = index - SHARED_COUNT;
    glint_signal_info info = of_lanes < 0 ? shared_rows[index] : lane_rows[of_lanes % LANE_COUNT];
    info.int_bits = int_bits_of(config, info.int_bits);
    if (of_lanes >= 0) {
        info.lane = of_lanes / LANE_COUNT;
        info.offset += offsetof(glint_specular_signals, lane) +
                       (size_t)info.lane * sizeof(glint_specular_lane);
    }
    return info;
}

uint64_t glint_specular_signal_bits(const glint_specular_config *config,
                                    const glint_specular_signals *signals, int index)
{
    const glint_signal_info info = glint_specular_signal_info(config, index);
    const int64_t value = *(const int64_t *)(const void *)((const char *)signals + info.offset);
    return (uint64_t)value & ((UINT64_C(1) << (info.int_bits + info.frac_bits)) - 1u);
}

const char *glint_gate_name(glint_gate gate)
{
    static const char *const names[GLINT_GATE_COUNT] = {"cosine", "sign", "drawn"};
    return (unsigned)gate < GLINT_GATE_COUNT ? names[gate] : NULL;
}

const char *glint_pipeline_name(glint_pipeline pipeline)
{
    static const char *const names[GLINT_PIPELINE_COUNT] = {"combinational", "pipelined"};
    return (unsigned)pipeline < GLINT_PIPELINE_COUNT ? names[pipeline] : NULL;
}
