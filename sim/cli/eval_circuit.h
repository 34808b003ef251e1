/* `glint eval` for any described circuit: a line of numbers for its data pins in, a row of outputs
 * out. */
#ifndef GLINT_SIM_CLI_EVAL_CIRCUIT_H
#define GLINT_SIM_CLI_EVAL_CIRCUIT_H

#include <stdbool.h>
#include <stddef.h>

#include "circuit/setting.h"

/* Reads standard input to its end; is_rtl: evaluates the Verilog, else the C model. Returns an exit
 * status. */
int glint_eval_circuit(const glint_setting *setting, bool is_rtl, bool json);

/* The input and output formats, for --help. */
void glint_eval_circuit_details(const glint_setting *setting, char *text, size_t size);

#endif
