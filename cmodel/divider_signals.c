/* The tables that the lists of signals in glint_divider_device.h expand to. */
#include <stddef.h>

#include "glint_divider_device.h"

typedef struct signal_row {
    glint_signal_info info;
    size_t offset; /* of its int64_t in the struct of its list */
} signal_row;

#define ROW(type, name, kind, int_bits, frac_bits, is_signed, meaning)                             \
    {{#name, 0, GLINT_SIGNAL_##kind, int_bits, frac_bits, is_signed, -1, meaning},                 \
     offsetof(type, name)},
#define SEQUENTIAL_ROW(...) ROW(glint_divider_sequential_signals, __VA_ARGS__)
#define PIPELINED_ROW(...)  ROW(glint_divider_pipelined_signals, __VA_ARGS__)
#define STAGE_ROW(...)      ROW(glint_divider_stage_signals, __VA_ARGS__)

static const signal_row sequential_rows[] = {GLINT_DIVIDER_SEQUENTIAL_SIGNALS(SEQUENTIAL_ROW)};
static const signal_row pipelined_rows[] = {GLINT_DIVIDER_PIPELINED_SIGNALS(PIPELINED_ROW)};
static const signal_row stage_rows[] = {GLINT_DIVIDER_STAGE_SIGNALS(STAGE_ROW)};

enum {
    SEQUENTIAL_COUNT = sizeof sequential_rows / sizeof sequential_rows[0],
    PIPELINED_COUNT = sizeof pipelined_rows / sizeof pipelined_rows[0],
    STAGE_COUNT = sizeof stage_rows / sizeof stage_rows[0],
};

int glint_divider_signal_count(glint_divider_form form, int shifts)
{
    return form == GLINT_DIVIDER_SEQUENTIAL ? SEQUENTIAL_COUNT
                                            : PIPELINED_COUNT + shifts * STAGE_COUNT;
}

/* *stage: −1 for a signal of the whole circuit. */
static const signal_row *row_of(glint_divider_form form, int index, int *stage)
{
    *stage = -1;
    if (form == GLINT_DIVIDER_SEQUENTIAL)
        return &sequential_rows[index];
    if (index < PIPELINED_COUNT)
        return &pipelined_rows[index];
    *stage = 1 + (index - PIPELINED_COUNT) / STAGE_COUNT;
    return &stage_rows[(index - PIPELINED_COUNT) % STAGE_COUNT];
}

glint_signal_info glint_divider_signal_info(glint_divider_form form, int shifts, int index)
{
    int stage;
    glint_signal_info info = row_of(form, index, &stage)->info;
    info.lane = stage;
    if (info.int_bits == GLINT_DIVIDER_WIDTH_N)
        info.int_bits = shifts;
    else if (info.int_bits == GLINT_DIVIDER_WIDTH_N1)
        info.int_bits = shifts + 1;
    if (info.frac_bits == GLINT_DIVIDER_FRAC_N)
        info.frac_bits = shifts;
    return info;
}

uint64_t glint_divider_signal_bits(const glint_divider_device *device, int index)
{
    const glint_divider_sequential_signals *sequential = glint_divider_device_sequential(device);
    const glint_divider_pipelined_signals *pipelined = glint_divider_device_pipelined(device);
    const glint_divider_form form =
        sequential != NULL ? GLINT_DIVIDER_SEQUENTIAL : GLINT_DIVIDER_PIPELINED;
    int stage;
    const signal_row *row = row_of(form, index, &stage);
    const void *base = sequential != NULL ? (const void *)sequential
                       : stage < 0        ? (const void *)pipelined
                                          : (const void *)&pipelined->stage[stage];
    const int64_t value = *(const int64_t *)(const void *)((const char *)base + row->offset);
    const glint_signal_info info =
        glint_divider_signal_info(form, glint_divider_device_shifts(device), index);
    return (uint64_t)value & ((UINT64_C(1) << (info.int_bits + info.frac_bits)) - 1u);
}

const char *glint_divider_form_name(glint_divider_form form)
{
    static const char *const names[GLINT_DIVIDER_FORM_COUNT] = {"sequential", "pipelined"};
    return (unsigned)form < GLINT_DIVIDER_FORM_COUNT ? names[form] : NULL;
}
