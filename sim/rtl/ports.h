/* The ports of a setting's Verilog according to its description: pins and outputs, lane beside
 * lane, without the clock. */
#ifndef GLINT_SIM_RTL_PORTS_H
#define GLINT_SIM_RTL_PORTS_H

#include <stdbool.h>

#include "circuit/setting.h"

typedef struct glint_port {
    const char *name;
    int width; /* of all lanes */
    bool is_output;
} glint_port;

typedef struct glint_ports {
    int pins, signals;
    int count;
    glint_port *port; /* the inputs, in the order of the pins, then the outputs */
    int *of_pin;      /* pin i is in port[of_pin[i]] … */
    int *pin_at;      /* … from this bit on */
    int *of_signal;   /* −1: signal i is no output */
    int *signal_at;
} glint_ports;

/* GLINT_BAD_ARGUMENT for a description whose pins or outputs are no ports. To be freed, whatever it
 * returns. */
glint_status glint_ports_make(const glint_setting *setting, glint_ports *ports, glint_error *err);
void glint_ports_free(glint_ports *ports);

#endif
