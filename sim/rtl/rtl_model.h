/* What one Verilated build offers, as a table of functions: the border between C and the C++ shim.
 *
 * sim/rtl/model_shim.cpp defines one such table for each build; rtl.c is the only caller. */
#ifndef GLINT_SIM_RTL_MODEL_H
#define GLINT_SIM_RTL_MODEL_H

#include <stdbool.h>

#include "glint_specular_device.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct glint_rtl_batch_io {
    const uint32_t *cos_code;
    size_t count;
    uint32_t *w_code; /* may be NULL */
    uint8_t *r, *g, *b;
} glint_rtl_batch_io;

typedef struct glint_rtl_model {
    glint_specular_config config;
    bool observed;         /* built with every named signal readable by find() */
    void *(*create)(void); /* NULL: no memory */
    void (*destroy)(void *instance);
    void (*clock)(void *instance, const glint_specular_inputs *inputs);
    /* The variable `name` of a lane (lane −1: of the device): where it lies and its size in bytes
     * (1, 2, 4 or 8); false when the circuit has none of that name. */
    bool (*find)(void *instance, int lane, const char *name, const void **data, int *size);
    uint64_t (*clocks)(const void *instance);
    /* Number of results that came back; count when all did. */
    size_t (*batch)(void *instance, const glint_material *material, const glint_rtl_batch_io *io);
    bool (*trace_open)(void *instance, const char *path);
    void (*trace_close)(void *instance);
} glint_rtl_model;

#ifdef __cplusplus
}
#endif

#endif
