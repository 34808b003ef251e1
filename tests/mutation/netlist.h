/* A synthesised netlist with many single faults, Verilated: the border between C and the C++ shim.
 *
 * tests/mutation/netlist_shim.cpp defines the one table of a program, mutation_netlist. Only the
 * pins can be seen: a netlist has lost its registers' names. */
#ifndef GLINT_TESTS_MUTATION_NETLIST_H
#define GLINT_TESTS_MUTATION_NETLIST_H

#include <stdbool.h>

#include "circuit/setting.h"

#ifdef __cplusplus
extern "C" {
#endif

#define MUTATION_PINS_MAX 5

typedef struct mutation_netlist_table {
    const char *circuit; /* specular-GATE-PIPELINE, divider-FORM-SHIFTS */
    glint_setting setting;
    /* The netlist with fault `mutant`, 0 for none, one clock of reset behind it; before that every
     * register held 1, or 0. NULL: no memory. */
    void *(*create)(uint32_t mutant, bool ones);
    void (*destroy)(void *instance);
    /* One rising edge, around the falling one every input pin inverted; then the output pins, as
     * many and in the order of mutation_pin_names(). */
    void (*clock)(void *instance, const glint_pins *inputs, uint32_t *pins);
} mutation_netlist_table;

extern const mutation_netlist_table mutation_netlist;

#ifdef __cplusplus
}
#endif

#endif
