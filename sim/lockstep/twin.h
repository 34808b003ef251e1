/* The C model and the Verilog of any circuit side by side: clocked with the same pins, read signal
 * by signal. */
#ifndef GLINT_SIM_LOCKSTEP_TWIN_H
#define GLINT_SIM_LOCKSTEP_TWIN_H

#include "lockstep/signals.h"

typedef struct glint_twin glint_twin;

/* Both in reset state. GLINT_BAD_ARGUMENT for a setting that does not exist; GLINT_DEVICE_FAULT
 * when its Verilog does not build. */
glint_status glint_twin_create(const glint_setting *setting, glint_twin **twin, glint_error *err);

/* The C model alone: glint_twin_read() must then not be asked for rtl. */
glint_status glint_twin_create_model(const glint_setting *setting, glint_twin **twin,
                                     glint_error *err);

void glint_twin_destroy(glint_twin *twin); /* NULL is allowed */

/* Those that both are read by; valid until the twin is destroyed. */
const glint_signals *glint_twin_signals(const glint_twin *twin);

/* One rising edge. */
void glint_twin_clock(glint_twin *twin, const glint_pins *pins);

/* What those pins make of the Verilog's signals before the edge, which has yet to come. */
void glint_twin_settle(glint_twin *twin, const glint_pins *pins, uint64_t *rtl);

/* The words of every signal after the last edge, at most GLINT_SIGNAL_WORDS_MAX; rtl may be
 * NULL. */
void glint_twin_read(const glint_twin *twin, uint64_t *model, uint64_t *rtl);

#endif
