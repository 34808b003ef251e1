/* The names in failure.json shared by its writer and its reader. */
#ifndef GLINT_SIM_FAILURE_JSON_NAMES_H
#define GLINT_SIM_FAILURE_JSON_NAMES_H

#include <stdbool.h>

#include "circuit/circuits.h"

#define GLINT_JSON_FORMAT  "glint failure"
#define GLINT_JSON_VERSION 1

#define GLINT_JSON_CIRCUIT_DIR "circuit_dir"
#define GLINT_JSON_RTL         "rtl"

/* A user circuit's parameters are in an object of their own, since they may have any name. */
#define GLINT_JSON_PARAMETERS "parameters"
static inline bool glint_json_is_own(const glint_circuit *circuit)
{
    int i = 0;
    while (glint_circuit_number(i) != NULL && glint_circuit_number(i) != circuit)
        i++;
    return glint_circuit_number(i) != NULL;
}

/* Wider pins are strings, "0x1f": a JSON number would lose low bits. */
#define GLINT_JSON_NUMBER_BITS 53

#endif
