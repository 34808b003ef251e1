/* Writes a drawing as SVG once it has a layout. */
#ifndef GLINT_SIM_DRAW_SVG_H
#define GLINT_SIM_DRAW_SVG_H

#include "draw/layout.h"

/* Apart from coordinates and the attribute d, the text depends on the description alone. */
void glint_draw_write_svg(const glint_draw_graph *graph, const glint_draw_layout *layout,
                          FILE *out);

/* The wires of a net, a part of it (svg_wires.c). */
void glint_draw_write_net(const glint_draw_graph *graph, const glint_draw_layout *layout, int net,
                          FILE *out);

#endif
