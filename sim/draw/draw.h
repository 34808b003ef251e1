/* The block diagram of a circuit, made from its description: the figure's block numbers, number
 * formats on the wires, and the clock edges at which registers load.
 *
 * Graphviz's dot computes the layout. */
#ifndef GLINT_SIM_DRAW_DRAW_H
#define GLINT_SIM_DRAW_DRAW_H

#include <stdio.h>

#include "circuit/setting.h"

/* As SVG. Apart from coordinates, its text depends on the description alone. GLINT_IO_ERROR if dot
 * is missing or fails. */
glint_status glint_draw_svg(const glint_setting *setting, FILE *out, glint_error *err);

/* The input for dot; does not need dot. */
glint_status glint_draw_plan(const glint_setting *setting, FILE *out, glint_error *err);

#endif
