/* A circuit with a value for each of its parameters, which is what all circuit-independent code in
 * sim/ works with. */
#ifndef GLINT_SIM_CIRCUIT_SETTING_H
#define GLINT_SIM_CIRCUIT_SETTING_H

#include <stdbool.h>

#include "glint_circuit.h"

typedef struct glint_setting {
    const glint_circuit *circuit;
    int values[GLINT_PARAMETERS_MAX]; /* those of the circuit's parameters; the rest 0 */
    const char *verilog; /* the directory with its Verilog, which must stay valid; NULL: Glint's own
                          * rtl/ */
} glint_setting;

/* Every parameter at its standard value. */
glint_setting glint_setting_standard(const glint_circuit *circuit);

/* GLINT_BAD_ARGUMENT, naming parameter and value, for a value out of its range. */
glint_status glint_setting_check(const glint_setting *setting, glint_error *err);

bool glint_setting_equal(const glint_setting *a, const glint_setting *b);

/* The value of the parameter of that name; `otherwise` when the circuit has none. */
int glint_setting_value(const glint_setting *setting, const char *name, int otherwise);

/* A parameter at the standard value that goes without saying. */
bool glint_setting_leaves_out(const glint_setting *setting, int parameter);

/* The Verilog's top module. */
const char *glint_setting_top(const glint_setting *setting);

/* Clocks until a result is out. */
int glint_setting_latency(const glint_setting *setting);

/* The index-th setting of the listed values, with the last parameter varying fastest; false past
 * the last. */
bool glint_setting_listed(const glint_circuit *circuit, int index, glint_setting *setting);

/* Signals and their values as an array of words; those of signal i start at
 * glint_signal_word(i). */
#define GLINT_SIGNAL_WORDS_MAX 2048 /* of all signals of a circuit */
#define GLINT_PINS_SIZE_MAX    1024 /* of a circuit's struct of pins */

/* The input pins of a circuit at one rising edge, in the circuit's own struct. */
typedef union glint_pins {
    unsigned char bytes[GLINT_PINS_SIZE_MAX];
    uint64_t words[GLINT_PINS_SIZE_MAX / 8];
} glint_pins;

/* "gate cosine, pipeline pipelined, lanes 1", "divider sequential, 12 shifts", "saturating_mac,
 * width 16": for people. */
#define GLINT_SETTING_TEXT 160
void glint_setting_describe(const glint_setting *setting, char text[GLINT_SETTING_TEXT]);

/* "specular_cosine_pipelined_1", "divider_sequential_12": for the names of files. */
void glint_setting_name(const glint_setting *setting, char text[GLINT_SETTING_TEXT]);

/* "--circuit specular --gate cosine --pipeline pipelined --lanes 1": for a command line. */
#define GLINT_SETTING_OPTIONS 320
void glint_setting_options(const glint_setting *setting, char text[GLINT_SETTING_OPTIONS]);

#endif
