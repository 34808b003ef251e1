/* The function table of a circuit's shared object: the border between C and the C++ shim. shim.cpp
 * defines the one symbol, GLINT_SHIM_SYMBOL; rtl.c calls it. */
#ifndef GLINT_SIM_RTL_SHIM_H
#define GLINT_SIM_RTL_SHIM_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A port as Verilator has it: an integer of 1, 2, 4 or 8 bytes, or 32-bit words, the lowest first.
 */
typedef struct glint_shim_port {
    const char *name; /* as the Verilog has it, or of the generated ones: "glint_s12" */
    void *data;
    size_t size; /* bytes */
} glint_shim_port;

/* To be raised with every change of what follows or of glint_shim_port, or of what a function does:
 * a program that was linked before the change does not take circuits built after it. */
#define GLINT_SHIM_VERSION 2

typedef struct glint_shim {
    uint64_t version, size; /* GLINT_SHIM_VERSION, sizeof(glint_shim) */
    void *(*create)(void);  /* NULL: no memory */
    void (*destroy)(void *instance);
    int (*port_count)(void);
    glint_shim_port (*port)(void *instance, int index);
    void (*settle)(void *instance); /* all that follows the ports, with the clock low: no edge */
    void (*edge)(void *instance);   /* one rising edge of the clock with what the ports hold */
    void (*begin)(void *instance);  /* no edge, but counted as one: what stands behind registers */
    uint64_t (*edges)(const void *instance);
    bool (*trace_open)(void *instance, const char *path); /* NULL, both: built without */
    void (*trace_close)(void *instance);
} glint_shim;

#define GLINT_SHIM_SYMBOL glint_circuit_table

#ifdef __cplusplus
}
#endif

#endif
