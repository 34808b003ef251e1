/* Validates a description before anything is built from it, so that a user's slip gets a message
 * that names it. Checks everything that glint_circuit.h requires and that does not need the
 * Verilog. */
#ifndef GLINT_SIM_CIRCUIT_VALIDATE_H
#define GLINT_SIM_CIRCUIT_VALIDATE_H

#include "circuit/setting.h"

/* Checks names, functions, headings and parameters, then the tables in the standard setting and in
 * the first 512 listed ones. GLINT_BAD_INPUT, naming the first fault; GLINT_NO_MEMORY. */
glint_status glint_circuit_check(const glint_circuit *circuit, glint_error *err);

/* Of a circuit that passed it: pins, signals, latency and C model in this setting, whose values are
 * in range. Fails as glint_circuit_check(). */
glint_status glint_circuit_check_tables(const glint_setting *setting, glint_error *err);

/* Of C, and so of Verilog; NULL is none. */
bool glint_is_identifier(const char *name);

#endif
