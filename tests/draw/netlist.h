/* A circuit as Yosys reads it: which named values a value is made of. */
#ifndef GLINT_TESTS_DRAW_NETLIST_H
#define GLINT_TESTS_DRAW_NETLIST_H

#include <stdbool.h>

#include "circuit/setting.h"

enum { NETLIST_NAMES_MAX = 128, NETLIST_NAME = 96 };

typedef struct netlist netlist;

/* Has Yosys elaborate the setting's Verilog, from `directory`, flattened and without optimisation;
 * `work` is a directory for its files. NULL, with words on standard error, when it cannot. */
netlist *netlist_make(const glint_setting *setting, const char *directory, const char *work);
void netlist_destroy(netlist *circuit);

/* Whether there is a wire of that name ("lane[0].u.reg1"), and whether all of it is constant. */
bool netlist_has(const netlist *circuit, const char *name);
bool netlist_is_constant(const netlist *circuit, const char *name);

/* Goes back from every bit of the wire, through cells and wires without a name in `names`, to the
 * bits of those that have one; reached[i]: whether names[i] was met. Where a bit has several names,
 * as that of a wire renamed has, those `expected` count before the others. The wire of a register
 * begins with what its flip-flops take, even if another wire has the same bits. */
void netlist_sources(const netlist *circuit, const char *wire, bool is_register,
                     char (*names)[NETLIST_NAME], int count, const bool *expected, bool *reached);

#endif
