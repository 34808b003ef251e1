/* A circuit of which only the pins are known: a synthesised netlist, possibly with a fault. Its
 * description is the circuit's, reduced to the signals that are pins and without Verilog
 * parameters, so that lockstep can drive it like any circuit and compare every output pin after
 * each clock, bit for bit, valid or not. */
#ifndef GLINT_TESTS_NETLIST_PINS_H
#define GLINT_TESTS_NETLIST_PINS_H

#include "circuit/setting.h"

/* The setting of that circuit, valid until the next call; single-threaded. */
glint_setting pins_setting(const glint_setting *setting);

#endif
