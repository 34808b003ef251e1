/* Reduces the output of Verilator and the compiler to one line. */
#ifndef GLINT_SIM_RTL_DIAGNOSIS_H
#define GLINT_SIM_RTL_DIAGNOSIS_H

#include "rtl/probe.h"

/* Of Verilator's words about the probe, whose Verilog came from `directory`: GLINT_DEVICE_FAULT
 * with the first that is wrong with the Verilog, in its own words, or where Verilog and description
 * differ. GLINT_OK: nothing is; warnings about the Verilog alone are nothing. */
glint_status glint_diagnose_verilator(const char *said, const glint_setting *setting,
                                      const glint_ports *ports, const glint_probe *probe,
                                      const char *directory, glint_error *err);

/* The next port of the Verilog, from `said` on, that the description has neither as a pin nor as a
 * signal: an input that nobody drives, or an output that nobody looks at. What is said behind it;
 * NULL: there is no more. */
#define GLINT_PORT_NAME 256
const char *glint_diagnose_port(const char *said, const glint_setting *setting,
                                const glint_ports *ports, char name[GLINT_PORT_NAME]);

/* GLINT_DEVICE_FAULT with the first error, or the last words, of the compiler. */
glint_status glint_diagnose_compiler(const char *said, glint_error *err);

#endif
