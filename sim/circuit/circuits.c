/* The list of built-in circuits, plus the one that --circuit-dir adds at run time. */
#include "circuit/circuits.h"

#include <string.h>

#include "circuit/units.h"

/* One line per circuit: its description is glint_circuit_NAME, in its own file. The thesis's first,
 * then those on request. */
#define CIRCUITS(X)                                                                                \
    X(specular)                                                                                    \
    X(divider)                                                                                     \
    X(lean)                                                                                        \
    X(narrow)                                                                                      \
    GLINT_UNITS(X)                                                                                 \
    X(span)                                                                                        \
    /* no more */

#define DECLARE(name) extern const glint_circuit glint_circuit_##name;
#define ADDRESS(name) &glint_circuit_##name,

CIRCUITS(DECLARE)
static const glint_circuit *const circuits[] = {CIRCUITS(ADDRESS)};

const glint_circuit *glint_circuit_number(int index)
{
    return index >= 0 && index < (int)(sizeof circuits / sizeof circuits[0]) ? circuits[index]
                                                                             : NULL;
}

/* Of the process, as what the dynamic linker has loaded is. */
static const glint_circuit *added;

void glint_circuit_add(const glint_circuit *circuit)
{
    added = circuit;
}

const glint_circuit *glint_circuit_named(const char *name)
{
    const glint_circuit *circuit;
    if (added != NULL && strcmp(added->name, name) == 0)
        return added;
    for (int i = 0; (circuit = glint_circuit_number(i)) != NULL; i++)
        if (strcmp(circuit->name, name) == 0)
            return circuit;
    return NULL;
}
