/* A drawing that has its layout, as SVG. */
#ifndef GLINT_SIM_DRAW_SVG_H
#define GLINT_SIM_DRAW_SVG_H

#include "draw/layout.h"

/* Of one text for one description, but for the values of coordinates and of the attribute d. */
void glint_draw_write_svg(const glint_draw_graph *graph, const glint_draw_layout *layout,
                          FILE *out);

/* A part of it: a net's wires (svg_wires.c). */
void glint_draw_write_net(const glint_draw_graph *graph, const glint_draw_layout *layout, int net,
                          FILE *out);

#endif
