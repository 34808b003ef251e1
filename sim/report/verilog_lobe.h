/* The lobe of the Verilog as one more reflectance model: the model `device`, every W of which comes
 * out of the simulated circuit. */
#ifndef GLINT_SIM_REPORT_VERILOG_LOBE_H
#define GLINT_SIM_REPORT_VERILOG_LOBE_H

#include "reflectance/reflectance.h"

/* A circuit of its own and the W that it gave. For one thread at a time. */
typedef struct glint_verilog_lobe glint_verilog_lobe;

glint_status glint_verilog_lobe_create(glint_verilog_lobe **lobe, glint_error *err);
void glint_verilog_lobe_destroy(glint_verilog_lobe *lobe); /* NULL is allowed */

/* Sets the exponent, an integer 0…GLINT_N_MAX. The result is for whatever takes a value at one
 * cosine or geometry at a time (not for glint_reflectance_batch()), until the next call. */
glint_status glint_verilog_lobe_prepare(glint_verilog_lobe *lobe, double n,
                                        const glint_reflectance **reflectance, glint_error *err);

/* What the circuit failed with since it was created: values from then on are 0. */
glint_status glint_verilog_lobe_check(const glint_verilog_lobe *lobe, glint_error *err);

#endif
