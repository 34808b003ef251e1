/* What one Verilated build of a divider offers, as a table of functions: the border between C and
 * the C++ shim. sim/rtl/divider_shim.cpp defines one for each build; divider_rtl.c calls it. */
#ifndef GLINT_SIM_DIVIDER_MODEL_H
#define GLINT_SIM_DIVIDER_MODEL_H

#include "glint_divider_device.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct glint_divider_model {
    glint_divider_form form;
    int shifts;
    void *(*create)(void); /* NULL: no memory */
    void (*destroy)(void *instance);
    void (*clock)(void *instance, const glint_divider_inputs *inputs);
    /* The variable `name` of a stage (−1: of the whole circuit): where it lies and its size in
     * bytes (1, 2, 4 or 8); false when the circuit has none of that name. */
    bool (*find)(void *instance, int stage, const char *name, const void **data, int *size);
    uint64_t (*clocks)(const void *instance);
    /* Number of divisions whose quotients came back; count when all did. */
    size_t (*batch)(void *instance, const glint_division *divisions, size_t count,
                    glint_quotients *quotients);
    bool (*trace_open)(void *instance, const char *path);
    void (*trace_close)(void *instance);
} glint_divider_model;

#ifdef __cplusplus
}
#endif

#endif
