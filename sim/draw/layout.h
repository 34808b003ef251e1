/* The layout of a drawing, in pixels. Graphviz's dot decides the vertical order and the heights;
 * columns, and the wires in the channels between them, are laid out here. */
#ifndef GLINT_SIM_DRAW_LAYOUT_H
#define GLINT_SIM_DRAW_LAYOUT_H

#include <stdio.h>

#include "draw/graph.h"

/* Space around a symbol: above it for its controls, below it for its name. */
#define GLINT_DRAW_ABOVE 18
#define GLINT_DRAW_BELOW 16

#define GLINT_DRAW_PITCH 20   /* from input to input */
#define GLINT_DRAW_INCH  72.0 /* dot has inches, and points in tables */

/* Widths of the fonts: sans of blocks, and the smaller one of names and formats. */
#define GLINT_DRAW_FORMAT 32 /* of a format as text */
#define GLINT_DRAW_SANS   8
#define GLINT_DRAW_MONO   6

typedef struct glint_draw_wire { /* of a net, between two columns */
    int net;
    int trunk;                                    /* its vertical part; −1: none */
    int left_count, left[GLINT_DRAW_NODES_MAX];   /* heights at which it leaves a column */
    int right_count, right[GLINT_DRAW_NODES_MAX]; /* and arrives at the next one */
} glint_draw_wire;

typedef struct glint_draw_channel {
    int left, right; /* where it begins and ends */
    int count;
    glint_draw_wire wire[GLINT_DRAW_NODES_MAX];
} glint_draw_channel;

typedef struct glint_draw_layout {
    int width, height;
    int middle[GLINT_DRAW_COLUMNS_MAX];                 /* of each column */
    glint_draw_channel channel[GLINT_DRAW_COLUMNS_MAX]; /* behind each column but the last */
} glint_draw_layout;

/* Writes the input for dot: nodes by column, and a point for every column that a wire passes. The
 * same description always gives the same text. */
void glint_draw_dot(glint_draw_graph *graph, FILE *out);

/* Fills in the graph's coordinates and the layout. GLINT_IO_ERROR if dot is missing or fails. */
glint_status glint_draw_lay_out(glint_draw_graph *graph, glint_draw_layout *layout,
                                glint_error *err);

/* Sets the size of a node (this and the next four: symbols.c). */
void glint_draw_size(glint_draw_node *node);

/* The height of input i of a node. */
int glint_draw_input_height(const glint_draw_node *node, int i);

/* "U1.18"; empty if the number has a single bit or no known format. */
void glint_draw_format(const glint_draw_node *node, char text[GLINT_DRAW_FORMAT]);

/* What is written inside a node. */
const char *glint_draw_text(const glint_draw_node *node);

/* Characters of UTF-8 text. */
int glint_draw_length(const char *text);

/* Straightens wires that are nearly level (straighten.c). */
void glint_draw_straighten(glint_draw_graph *graph);

/* Lays out columns and channels once the heights are known (route.c). */
void glint_draw_route(glint_draw_graph *graph, glint_draw_layout *layout);

#endif
