/* A circuit of one's own: a directory with its description and C model (*.c) and its Verilog. */
#ifndef GLINT_SIM_CIRCUIT_OWN_H
#define GLINT_SIM_CIRCUIT_OWN_H

#include "glint_circuit.h"

/* Compiles the directory's *.c, where the cache has not what they become, loads it and checks the
 * glint_my_circuit in it; it stays until the process ends. GLINT_IO_ERROR when the directory cannot
 * be read; GLINT_BAD_INPUT, with the compiler's own words or what is wrong in the description, when
 * it is no circuit. */
glint_status glint_circuit_load(const char *directory, const glint_circuit **circuit,
                                glint_error *err);

#endif
