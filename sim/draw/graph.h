/* A circuit's drawing as a graph: the blocks of its description, the pins that feed them and the
 * output ports, each assigned to a column. */
#ifndef GLINT_SIM_DRAW_GRAPH_H
#define GLINT_SIM_DRAW_GRAPH_H

#include <stdbool.h>

#include "circuit/setting.h"

#define GLINT_DRAW_NODES_MAX   128
#define GLINT_DRAW_COLUMNS_MAX 64
#define GLINT_DRAW_INPUTS_MAX  16
#define GLINT_DRAW_NAME        64

typedef enum glint_draw_kind { GLINT_DRAW_PIN, GLINT_DRAW_BLOCK, GLINT_DRAW_PORT } glint_draw_kind;

typedef struct glint_draw_node {
    glint_draw_kind kind;
    glint_symbol symbol; /* of a block */
    char name[GLINT_DRAW_NAME];
    const char *text;                              /* inside; NULL: the symbol's own */
    const char *control;                           /* or NULL */
    int number;                                    /* in the figure; 0: none */
    bool has_name;                                 /* in the Verilog */
    bool is_stacked;                               /* stands for several alike */
    int int_bits, frac_bits, is_signed;            /* of its output; all 0: unknown */
    int input_count, input[GLINT_DRAW_INPUTS_MAX]; /* the nodes that feed it */
    int column;
    int x, y, width, height; /* of its symbol: left edge, middle, sizes; pixels (layout.h) */
} glint_draw_node;

/* Input `input` of node `to` is fed by node `from`. */
typedef struct glint_draw_edge {
    int from, to, input;
} glint_draw_edge;

#define GLINT_DRAW_EDGES_MAX (GLINT_DRAW_NODES_MAX * GLINT_DRAW_INPUTS_MAX)

/* Columns: first the pins; then, stage by stage, the registers and the logic behind them; last the
 * ports. A node and all that it feeds make a *net*, which has the node's index. */
typedef struct glint_draw_graph {
    const glint_setting *setting;
    int count;
    glint_draw_node node[GLINT_DRAW_NODES_MAX];
    glint_draw_edge edge[GLINT_DRAW_EDGES_MAX]; /* net by net */
    int first_edge[GLINT_DRAW_NODES_MAX + 1];   /* of each net; the next net's is past its last */
    int columns;
    int stages;                               /* that begin with registers */
    int stage_column[GLINT_DRAW_COLUMNS_MAX]; /* where the registers of stage 1… are */
    /* The height at which a net passes a column on its way to what it feeds (filled in by
     * layout.h). */
    int pass[GLINT_DRAW_NODES_MAX][GLINT_DRAW_COLUMNS_MAX];
} glint_draw_graph;

/* GLINT_BAD_INPUT, naming the block, if the description is wrong: an input that is neither a block
 * nor a pin, two blocks with the same name, too many of anything, or no blocks at all. The setting
 * must outlive the graph. */
glint_status glint_draw_graph_make(const glint_setting *setting, glint_draw_graph *graph,
                                   glint_error *err);

/* Whether the net passes the column, forwards or backwards, on its way to something it feeds. */
bool glint_draw_passes(const glint_draw_graph *graph, int net, int column);

/* Whether an edge goes against the direction of the drawing. */
static inline bool glint_draw_is_feedback(const glint_draw_graph *graph,
                                          const glint_draw_edge *edge)
{
    return graph->node[edge->from].column >= graph->node[edge->to].column;
}

/* A part of glint_draw_graph_make(): edges and columns of the nodes (columns.c). */
glint_status glint_draw_place(glint_draw_graph *graph, glint_error *err);

#endif
