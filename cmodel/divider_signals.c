/* The tables that the lists of signals in glint_divider_device.h expand to. */
#include <stddef.h>

#include "glint_divider_device.h"

/* The offset is that in the struct of the list. */
#define ROW(type, name_, kind_, int_bits_, frac_bits_, is_signed_, meaning_)                       \
    {.name = #name_,                                                                               \
     .kind = GLINT_SIGNAL_##kind_,                                                                 \
     .int_bits = (int_bits_),                                                                      \
     .frac_bits = (frac_bits_),                                                                    \
     .is_signed = (is_signed_),                                                                    \
     .lane = -1,                                                                                   \
     .meaning = (meaning_),                                                                        \
     .offset = offsetof(type, name_)},
#define SEQUENTIAL_ROW(...) ROW(glint_divider_sequential_signals, __VA_ARGS__)
#define PIPELINED_ROW(...)  ROW(glint_divider_pipelined_signals, __VA_ARGS__)
#define STAGE_ROW(...)      ROW(glint_divider_stage_signals, __VA_ARGS__)

static const glint_signal_info sequential_rows[] = {
    GLINT_DIVIDER_SEQUENTIAL_SIGNALS(SEQUENTIAL_ROW)};
static const glint_signal_info pipelined_rows[] = {GLINT_DIVIDER_PIPELINED_SIGNALS(PIPELINED_ROW)};
static const glint_signal_info stage_rows[] = {GLINT_DIVIDER_STAGE_SIGNALS(STAGE_ROW)};

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

/* As the lists have it, with its stage and its offset. */
static glint_signal_info row_of(glint_divider_form form, int index)
{
    if (form == GLINT_DIVIDER_SEQUENTIAL)
        return sequential_rows[index];
    if (index < PIPELINED_COUNT)
        return pipelined_rows[index];
    const int of_stages = index - PIPELINED_COUNT;
    glint_signal_info info = stage_rows[of_stages % STAGE_COUNT];
    info.lane = 1 + of_stages / STAGE_COUNT;
    info.offset += offsetof(glint_divider_pipelined_signals, stage) +
                   (size_t)info.lane * sizeof(glint_divider_stage_signals);
    return info;
}

glint_signal_info glint_divider_signal_info(glint_divider_form form, int shifts, int index)
{
    glint_signal_info info = row_of(form, index);
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
    const glint_divider_form form =
        sequential != NULL ? GLINT_DIVIDER_SEQUENTIAL : GLINT_DIVIDER_PIPELINED;
    const void *signals = sequential != NULL ? (const void *)sequential
                                             : (const void *)glint_divider_device_pipelined(device);
    const glint_signal_info info =
        glint_divider_signal_info(form, glint_divider_device_shifts(device), index);
    const int64_t value = *(const int64_t *)(const void *)((const char *)signals + info.offset);
    return (uint64_t)value & ((UINT64_C(1) << (info.int_bits + info.frac_bits)) - 1u);
}

const char *glint_divider_form_name(glint_divider_form form)
{
    static const char *const names[GLINT_DIVIDER_FORM_COUNT] = {"sequential", "pipelined"};
    return (unsigned)form < GLINT_DIVIDER_FORM_COUNT ? names[form] : NULL;
}
