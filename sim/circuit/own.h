/* A user's circuit: a directory with its description and C model (*.c) and its Verilog. */
#ifndef GLINT_SIM_CIRCUIT_OWN_H
#define GLINT_SIM_CIRCUIT_OWN_H

#include "glint_circuit.h"

/* Compiles the directory's *.c files unless the result is in the cache, loads it and checks its
 * glint_my_circuit, which stays valid until the process ends. GLINT_IO_ERROR if the directory
 * cannot be read; GLINT_BAD_INPUT, with the compiler's message or the fault in the description, if
 * it does not define a circuit. */
glint_status glint_circuit_load(const char *directory, const glint_circuit **circuit,
                                glint_error *err);

#endif
