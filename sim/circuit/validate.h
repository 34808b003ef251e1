/* Whether a description can be believed: everything that glint_circuit.h asks of one and that does
 * not need the Verilog. */
#ifndef GLINT_SIM_VALIDATE_H
#define GLINT_SIM_VALIDATE_H

#include "circuit/setting.h"

/* The settings looked at: the standard one and so many of the listed ones. */
#define GLINT_CHECKED_SETTINGS_MAX 512

/* Names, parameters, headings and functions; then, in every setting, pins, signals, latency, and
 * that the C model can be created. GLINT_BAD_INPUT, naming what is wrong in which setting; of
 * several faults the first. GLINT_NO_MEMORY. */
glint_status glint_circuit_check(const glint_circuit *circuit, glint_error *err);

#endif
