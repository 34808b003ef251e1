/* The Verilog around a unit under comparison. */
#ifndef GLINT_SIM_COMPARE_MODULE_H
#define GLINT_SIM_COMPARE_MODULE_H

#include <stdio.h>

#include "circuit/setting.h"

/* The module's name in both forms. */
#define GLINT_COMPARE_MODULE "compare_unit"

/* The unit with its parameters and its own ports: what it costs. */
void glint_compare_write_bare(FILE *out, const glint_setting *setting);

/* The unit between registers, with three pins: `clk`, `in`, `out`. Each input comes from a bit of a
 * shift register that `in` fills; each output goes to a register, whose bits are folded into a
 * second shift register, one gate a bit, that ends at `out`. So every path of the unit lies between
 * two registers inside the chip, nothing of it can be optimised away, and what is added to reach
 * the pins is no slower than one gate. For the clock rate, not for the cost. */
void glint_compare_write_timed(FILE *out, const glint_setting *setting);

#endif
