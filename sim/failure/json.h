/* A failure as JSON: all that glint_failure_play() needs, and what it found. */
#ifndef GLINT_SIM_FAILURE_JSON_H
#define GLINT_SIM_FAILURE_JSON_H

#include "failure/failure.h"

/* The text, to be freed with free(). NULL: no memory. */
char *glint_failure_to_json(const glint_failure *failure);

/* Reads it back. extra: a circuit to accept besides Glint's own; NULL: none. GLINT_BAD_INPUT says
 * what is wrong, without the file's name. */
glint_status glint_failure_from_json(const char *text, const glint_circuit *extra,
                                     glint_failure **failure, glint_error *err);

#endif
