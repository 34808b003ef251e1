/* Whether a description is one: what somebody wrote outside is looked at before anything is built
 * of it, so that a slip has a line that names it. */
#ifndef GLINT_SIM_CIRCUIT_CHECK_H
#define GLINT_SIM_CIRCUIT_CHECK_H

#include "circuit/setting.h"

/* The circuit's functions and parameters. GLINT_BAD_INPUT, naming circuit and member. */
glint_status glint_circuit_check(const glint_circuit *circuit, glint_error *err);

/* Of a circuit that passed it: the tables of pins and signals in this setting, whose values are in
 * range. GLINT_BAD_INPUT, naming circuit, setting and the pin or signal. */
glint_status glint_circuit_check_tables(const glint_setting *setting, glint_error *err);

#endif
