/* Writes the graph for dot: every node in its column, and a point in every column that a wire
 * passes. dot decides the order in each column and the heights; see layout.h. */
#include "draw/layout.h"

/* A table with a cell for each input on the left and one for the output on the right, so that dot
 * aligns edges with them. */
static void write_node(const glint_draw_graph *graph, int index, FILE *out)
{
    const glint_draw_node *node = &graph->node[index];
    const int inputs = node->input_count > 0 ? node->input_count : 1;
    const int whole = node->height + GLINT_DRAW_ABOVE + GLINT_DRAW_BELOW;
    const int above = node->height / 2 - inputs * GLINT_DRAW_PITCH / 2 + GLINT_DRAW_ABOVE;
    const int below = whole - above - inputs * GLINT_DRAW_PITCH;
    fprintf(out,
            "  n%d [label=<<table border=\"0\" cellborder=\"0\" cellspacing=\"0\" "
            "cellpadding=\"0\">",
            index);
    fprintf(out,
            "<tr><td width=\"1\" height=\"%d\" fixedsize=\"true\"></td>"
            "<td width=\"1\" height=\"%d\" fixedsize=\"true\"></td></tr>",
            above, above);
    for (int i = 0; i < inputs; i++) {
        fprintf(out, "<tr><td port=\"i%d\" width=\"1\" height=\"%d\" fixedsize=\"true\"></td>", i,
                GLINT_DRAW_PITCH);
        if (i == 0)
            fprintf(out,
                    "<td port=\"o\" rowspan=\"%d\" width=\"1\" height=\"%d\" fixedsize=\"true\">"
                    "</td>",
                    inputs, inputs * GLINT_DRAW_PITCH);
        fprintf(out, "</tr>");
    }
    fprintf(out,
            "<tr><td width=\"1\" height=\"%d\" fixedsize=\"true\"></td>"
            "<td width=\"1\" height=\"%d\" fixedsize=\"true\"></td></tr></table>>]; // %s\n",
            below, below, node->name);
}

static void write_column(const glint_draw_graph *graph, int column, FILE *out)
{
    fprintf(out, "  { rank=same;");
    for (int i = 0; i < graph->count; i++) {
        if (graph->node[i].column == column)
            fprintf(out, " n%d;", i);
        if (glint_draw_passes(graph, i, column))
            fprintf(out, " p%d_%d;", i, column);
    }
    fprintf(out, " }\n");
}

/* Keeps the pins in the order of the description. */
static void write_order(const glint_draw_graph *graph, FILE *out)
{
    int last = -1;
    for (int i = 0; i < graph->count; i++) {
        if (graph->node[i].kind != GLINT_DRAW_PIN)
            continue;
        if (last >= 0)
            fprintf(out, "  n%d -> n%d [style=invis];\n", last, i);
        last = i;
    }
}

/* Where a net leaves a column: the output of its node, or the point where it passes. */
static void write_tail(const glint_draw_graph *graph, int net, int column, FILE *out)
{
    if (graph->node[net].column == column)
        fprintf(out, "  n%d:o:e", net);
    else
        fprintf(out, "  p%d_%d", net, column);
}

/* Keeps feedback close: an invisible point behind its node, and one before what it feeds, pull it
 * there. */
static void write_feedback(const glint_draw_graph *graph, int net, FILE *out)
{
    const int from = graph->node[net].column;
    bool is_any = false;
    for (int e = graph->first_edge[net]; e < graph->first_edge[net + 1]; e++) {
        const glint_draw_edge *edge = &graph->edge[e];
        const int to = graph->node[edge->to].column;
        if (!glint_draw_is_feedback(graph, edge))
            continue;
        is_any = true;
        if (to > 0)
            fprintf(out,
                    "  b%d [shape=point, width=0.01];\n"
                    "  b%d -> p%d_%d [style=invis, weight=2];\n"
                    "  b%d -> n%d:i%d:w [style=invis, weight=2];\n",
                    e, e, net, to, e, edge->to, edge->input);
    }
    if (is_any && from + 1 < graph->columns)
        fprintf(out,
                "  a%d [shape=point, width=0.01];\n"
                "  p%d_%d -> a%d [style=invis, weight=2];\n"
                "  n%d:o:e -> a%d [style=invis, weight=2];\n",
                net, net, from, net, net, net);
}

/* The last part, up to the inputs. Wires from one node to just one other matter most: they should
 * be level. */
static void write_ends(const glint_draw_graph *graph, int net, FILE *out)
{
    const int first = graph->first_edge[net], last = graph->first_edge[net + 1];
    for (int e = first; e < last; e++) {
        const glint_draw_edge *edge = &graph->edge[e];
        const glint_draw_node *to = &graph->node[edge->to];
        if (glint_draw_is_feedback(graph, edge))
            continue;
        write_tail(graph, net, to->column - 1, out);
        fprintf(out, " -> n%d:i%d:w [weight=%d];\n", edge->to, edge->input,
                last - first == 1 && to->input_count == 1 ? 20 : 4);
    }
}

static void write_net(const glint_draw_graph *graph, int net, FILE *out)
{
    const int from = graph->node[net].column;
    for (int column = 0; column + 1 < graph->columns; column++)
        if (glint_draw_passes(graph, net, column + 1) &&
            (column == from || glint_draw_passes(graph, net, column))) {
            write_tail(graph, net, column, out);
            fprintf(out, " -> p%d_%d [weight=%d];\n", net, column + 1, column == from ? 8 : 20);
        }
    write_ends(graph, net, out);
    write_feedback(graph, net, out);
}

void glint_draw_dot(glint_draw_graph *graph, FILE *out)
{
    for (int i = 0; i < graph->count; i++)
        glint_draw_size(&graph->node[i]);
    /* Quoted: a circuit may have the name of a keyword. */
    fprintf(out, "digraph \"%s\" {\n", graph->setting->circuit->name);
    fprintf(out, "  rankdir=LR; splines=false; nodesep=%g; ranksep=1;\n", 6 / GLINT_DRAW_INCH);
    fprintf(out, "  node [shape=plain, fontsize=1];\n");
    for (int i = 0; i < graph->count; i++)
        write_node(graph, i, out);
    for (int i = 0; i < graph->count; i++)
        for (int c = 0; c < graph->columns; c++)
            if (glint_draw_passes(graph, i, c))
                fprintf(out, "  p%d_%d [shape=box, label=\"\", width=0.01, height=%g];\n", i, c,
                        12 / GLINT_DRAW_INCH);
    for (int c = 0; c < graph->columns; c++)
        write_column(graph, c, out);
    write_order(graph, out);
    for (int i = 0; i < graph->count; i++)
        write_net(graph, i, out);
    fprintf(out, "}\n");
}
