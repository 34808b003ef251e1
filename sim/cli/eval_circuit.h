/* `glint eval` of a circuit by its description: a line of numbers for its data pins, a row with
 * what its outputs are then. */
#ifndef GLINT_SIM_CLI_EVAL_CIRCUIT_H
#define GLINT_SIM_CLI_EVAL_CIRCUIT_H

#include <stdbool.h>
#include <stddef.h>

#include "circuit/setting.h"

/* Reads standard input to its end; is_rtl: asks the Verilog, else the C model. Returns an exit
 * status. */
int glint_eval_circuit(const glint_setting *setting, bool is_rtl, bool json);

/* What a line is, and what is printed, for --help. */
void glint_eval_circuit_details(const glint_setting *setting, char *text, size_t size);

#endif
