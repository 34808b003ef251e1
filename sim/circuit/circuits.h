/* The circuits that Glint knows, one line each in circuits.c. */
#ifndef GLINT_SIM_CIRCUIT_CIRCUITS_H
#define GLINT_SIM_CIRCUIT_CIRCUITS_H

#include "glint_circuit.h"

extern const glint_circuit glint_circuit_specular; /* figure 3.1: gate, pipeline, lanes */
extern const glint_circuit glint_circuit_divider;  /* figure 2.13: form, shifts */

extern const glint_circuit glint_circuit_span; /* appendix A: fraction */

/* Number 0…; NULL past the last. */
const glint_circuit *glint_circuit_number(int index);

/* By name; NULL if there is none. */
const glint_circuit *glint_circuit_named(const char *name);

/* Adds a user's circuit (own.h), which must stay valid; it takes precedence over any other of the
 * same name. Only one, and before any thread looks up a name. */
void glint_circuit_add(const glint_circuit *circuit);

/* Positions of the thesis circuits' parameters in `values`. */
enum { GLINT_SPECULAR_GATE, GLINT_SPECULAR_PIPELINE, GLINT_SPECULAR_LANES };
enum { GLINT_DIVIDER_FORM, GLINT_DIVIDER_SHIFTS };

/* The settings of the typed interfaces as values, and back. */
#include "circuit/setting.h"
#include "glint_divider_device.h"
#include "glint_specular_device.h"
glint_setting glint_setting_specular(const glint_specular_config *config);
glint_setting glint_setting_divider(glint_divider_form form, int shifts);
glint_setting glint_setting_span(int fraction);
glint_specular_config glint_specular_config_of(const int *values);

#endif
