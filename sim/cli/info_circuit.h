/* What `glint info` prints about a circuit, from its description. */
#ifndef GLINT_SIM_CLI_INFO_CIRCUIT_H
#define GLINT_SIM_CLI_INFO_CIRCUIT_H

#include "circuit/setting.h"

#include "file/json.h"

/* A few lines: its name, title, parameters. */
void glint_info_print_circuit(const glint_circuit *circuit);

/* All of it in one setting: pins, signals, latency, domain. */
void glint_info_print_setting(const glint_setting *setting);

/* The same as JSON; NULL: no memory. */
json_t *glint_info_json(const glint_setting *setting);

/* "gate": "cosine", "lanes": 4: the values of a setting, each under its parameter's name. */
void glint_info_add_values(json_t *json, const glint_setting *setting);

#endif
