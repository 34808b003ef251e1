/* A synthesised netlist with many single faults, Verilated: the border between C and the C++ shim.
 *
 * tests/mutation/netlist_shim.cpp defines the one table of a program, mutation_netlist. Only the
 * pins are visible: a netlist has lost its registers' names. */
#ifndef GLINT_TESTS_MUTATION_NETLIST_H
#define GLINT_TESTS_MUTATION_NETLIST_H

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define MUTATION_PINS_MAX 64 /* of each direction */

typedef struct mutation_netlist_table {
    const char *circuit; /* the setting's name, as in build/settings */
    /* The netlist with fault `mutant`, 0 for none, one clock of reset behind it; before that every
     * register held 1, or 0. NULL: no memory. */
    void *(*create)(uint32_t mutant, bool ones);
    void (*destroy)(void *instance);
    /* One rising edge with these input pins, a word each in the description's order, around the
     * falling one every one of them inverted; then the output pins, in the order of their signals.
     */
    void (*clock)(void *instance, const uint64_t *in, uint64_t *out);
} mutation_netlist_table;

extern const mutation_netlist_table mutation_netlist;

#ifdef __cplusplus
}
#endif

#endif
