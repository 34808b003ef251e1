/* The Verilated dividers behind a plain C interface; as rtl.h is for the specular device. */
#ifndef GLINT_SIM_DIVIDER_RTL_H
#define GLINT_SIM_DIVIDER_RTL_H

#include "glint_divider_device.h"

typedef struct glint_divider_rtl glint_divider_rtl;
typedef struct glint_divider_model glint_divider_model; /* a Verilated build: divider_model.h */

/* Creates a circuit, reset for one clock. Both forms are built for every number of shifts;
 * GLINT_BAD_ARGUMENT for others. */
glint_status glint_divider_rtl_create(glint_divider_form form, int shifts, glint_divider_rtl **rtl,
                                      glint_error *err);

/* The same with a Verilated build of the caller's, for tests of the bench with a wrong circuit. */
glint_status glint_divider_rtl_create_from(const glint_divider_model *model,
                                           glint_divider_rtl **rtl, glint_error *err);

void glint_divider_rtl_destroy(glint_divider_rtl *rtl); /* closes an open trace; NULL is allowed */

/* One rising edge of the clock with these pins. */
void glint_divider_rtl_clock(glint_divider_rtl *rtl, const glint_divider_inputs *inputs);

/* The bits of signal `index` of glint_divider_signal_info(), read from the circuit by its Verilog
 * name, as the last edge left it. */
uint64_t glint_divider_rtl_signal_bits(const glint_divider_rtl *rtl, int index);

/* Rising edges so far, the reset of creation included. */
uint64_t glint_divider_rtl_clocks(const glint_divider_rtl *rtl);

/* Divides count times: the pipelined form takes one division a clock, the sequential one component
 * after component. GLINT_DEVICE_FAULT when the circuit does not give every quotient back in time.
 */
glint_status glint_divider_rtl_batch(glint_divider_rtl *rtl, const glint_division *divisions,
                                     size_t count, glint_quotients *quotients, glint_error *err);

/* A waveform, as glint_rtl_trace_open() and glint_rtl_trace_close(). */
glint_status glint_divider_rtl_trace_open(glint_divider_rtl *rtl, const char *path,
                                          glint_error *err);
void glint_divider_rtl_trace_close(glint_divider_rtl *rtl);

#endif
