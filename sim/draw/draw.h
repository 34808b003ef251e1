/* The drawing of a circuit, made from its description: blocks with the figure's numbers, number
 * formats on the wires, the edges of the clock at which registers load.
 *
 * Graphviz's dot finds the layout; without it there is GLINT_IO_ERROR. */
#ifndef GLINT_SIM_DRAW_DRAW_H
#define GLINT_SIM_DRAW_DRAW_H

#include <stdio.h>

#include "circuit/setting.h"

/* An SVG. But for coordinates it is the same text for the same description. */
glint_status glint_draw_svg(const glint_setting *setting, FILE *out, glint_error *err);

/* What dot is given, without the drawing. */
glint_status glint_draw_plan(const glint_setting *setting, FILE *out, glint_error *err);

#endif
