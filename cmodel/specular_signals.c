/* The tables that the list of signals in glint_specular_device.h expands to. */
#include <stddef.h>

#include "glint_specular_device.h"

typedef struct signal_row {
    glint_signal_info info;
    size_t offset; /* of its int64_t in glint_specular_signals or glint_specular_lane */
} signal_row;

#define ROW(type, name, block, kind, int_bits, frac_bits, is_signed, meaning)                      \
    {{#name, block, GLINT_SIGNAL_##kind, int_bits, frac_bits, is_signed, -1, meaning},             \
     offsetof(type, name)},
#define SHARED_ROW(...) ROW(glint_specular_signals, __VA_ARGS__)
#define LANE_ROW(...)   ROW(glint_specular_lane, __VA_ARGS__)

static const signal_row shared_rows[] = {GLINT_SPECULAR_SHARED_SIGNALS(SHARED_ROW)};
static const signal_row lane_rows[] = {GLINT_SPECULAR_LANE_SIGNALS(LANE_ROW)};

enum {
    SHARED_COUNT = sizeof shared_rows / sizeof shared_rows[0],
    LANE_COUNT = sizeof lane_rows / sizeof lane_rows[0],
};

int glint_specular_signal_count(const glint_specular_config *config)
{
    return SHARED_COUNT + config->lanes * LANE_COUNT;
}

static const signal_row *row_of(int index, int *lane)
{
    if (index < SHARED_COUNT) {
        *lane = -1;
        return &shared_rows[index];
    }
    *lane = (index - SHARED_COUNT) / LANE_COUNT;
    return &lane_rows[(index - SHARED_COUNT) % LANE_COUNT];
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
    int lane;
    glint_signal_info info = row_of(index, &lane)->info;
    info.lane = lane;
    info.int_bits = int_bits_of(config, info.int_bits);
    return info;
}

uint64_t glint_specular_signal_bits(const glint_specular_config *config,
                                    const glint_specular_signals *signals, int index)
{
    int lane;
    const signal_row *row = row_of(index, &lane);
    const void *base = lane < 0 ? (const void *)signals : (const void *)&signals->lane[lane];
    int64_t value = *(const int64_t *)(const void *)((const char *)base + row->offset);
    int width = int_bits_of(config, row->info.int_bits) + row->info.frac_bits;
    return (uint64_t)value & ((UINT64_C(1) << width) - 1u);
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
