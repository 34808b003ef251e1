/* A circuit as Yosys elaborates it: which named signals feed a signal. */
#ifndef GLINT_TESTS_DRAW_NETLIST_H
#define GLINT_TESTS_DRAW_NETLIST_H

#include <stdbool.h>

#include "circuit/setting.h"

enum { NETLIST_NAMES_MAX = 128, NETLIST_NAME = 96 };

typedef struct netlist netlist;

/* Has Yosys elaborate and flatten the setting's Verilog in `directory`, without optimising it;
 * `work` is for its files. NULL, with a message on standard error, if it fails. */
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
