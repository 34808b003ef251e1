/* A circuit of which nothing but the pins is known: a netlist out of synthesis, or one with a fault
 * in it. Its description is the circuit's with the signals that are pins alone, and with no
 * parameters in the Verilog; so lockstep drives it as any circuit, and compares every output pin
 * after each clock, bit for bit, whether it is valid or not. */
#ifndef GLINT_TESTS_NETLIST_PINS_H
#define GLINT_TESTS_NETLIST_PINS_H

#include "circuit/setting.h"

/* The setting of that circuit, until the next call: one at a time, of one thread. */
glint_setting pins_setting(const glint_setting *setting);

#endif
