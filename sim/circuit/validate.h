/* Whether a description is one: what somebody wrote outside is looked at before anything is built
 * of it, so that a slip has a line that names it. All that glint_circuit.h asks of a description
 * and that does not need the Verilog. */
#ifndef GLINT_SIM_CIRCUIT_VALIDATE_H
#define GLINT_SIM_CIRCUIT_VALIDATE_H

#include "circuit/setting.h"

/* Names, functions, headings and parameters, and then the tables in the standard setting and in
 * the first 512 of the listed ones. GLINT_BAD_INPUT, naming what is wrong, of several faults the
 * first; GLINT_NO_MEMORY. */
glint_status glint_circuit_check(const glint_circuit *circuit, glint_error *err);

/* Of a circuit that passed it: pins, signals, latency and C model in this setting, whose values are
 * in range. Fails as glint_circuit_check(). */
glint_status glint_circuit_check_tables(const glint_setting *setting, glint_error *err);

/* Of C, and so of Verilog; NULL is none. */
bool glint_is_identifier(const char *name);

#endif
