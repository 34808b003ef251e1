/* Writes the wires as SVG: for each net a path, dots where it forks, and arrowheads. */
#include "draw/svg.h"

#include <limits.h>
#include <stdlib.h>

/* ---- Ends ------------------------------------------------------------------------------------ */

/* How far inside its box a symbol's outline is at this height: nonzero for circles. */
static int inset(const glint_draw_node *node, int y)
{
    const int radius = node->height / 2, off = abs(y - node->y);
    int in = 0;
    if (node->symbol != GLINT_SYMBOL_MULTIPLIER && node->symbol != GLINT_SYMBOL_ADDER)
        return 0;
    while (in < radius && (radius - in) * (radius - in) > radius * radius - off * off)
        in++;
    return in;
}

/* Where a branch leaving the column at that height begins: at the net's node, or in the middle of
 * the column if it passes. */
static int left_end(const glint_draw_graph *graph, const glint_draw_layout *layout, int net,
                    int column, int y)
{
    const glint_draw_node *node = &graph->node[net];
    return node->column == column && node->y == y ? node->x + node->width : layout->middle[column];
}

/* Where a branch arriving at the column at that height ends: at an input, or in the middle. */
static int right_end(const glint_draw_graph *graph, const glint_draw_layout *layout, int net,
                     int column, int y)
{
    for (int e = graph->first_edge[net]; e < graph->first_edge[net + 1]; e++) {
        const glint_draw_node *to = &graph->node[graph->edge[e].to];
        if (to->column == column && glint_draw_input_height(to, graph->edge[e].input) == y)
            return to->x + inset(to, y);
    }
    return layout->middle[column];
}

/* ---- Paths ----------------------------------------------------------------------------------- */

static int height_of(const glint_draw_wire *wire, int end)
{
    return end < wire->left_count ? wire->left[end] : wire->right[end - wire->left_count];
}

/* A straight wire from end to end; else each branch from its end to the trunk, and the trunk. */
static void write_path(const glint_draw_graph *graph, const glint_draw_layout *layout, int column,
                       const glint_draw_wire *wire, FILE *out)
{
    int top = INT_MAX, bottom = INT_MIN;
    for (int i = 0; i < wire->left_count + wire->right_count; i++) {
        const int y = height_of(wire, i);
        const bool is_left = i < wire->left_count;
        const int x = is_left ? left_end(graph, layout, wire->net, column, y)
                              : right_end(graph, layout, wire->net, column + 1, y);
        if (wire->trunk >= 0)
            fprintf(out, "M%d %dH%d", x, y, wire->trunk);
        else if (is_left)
            fprintf(out, "M%d %dH%d", x, y, right_end(graph, layout, wire->net, column + 1, y));
        top = y < top ? y : top;
        bottom = y > bottom ? y : bottom;
    }
    if (wire->trunk >= 0)
        fprintf(out, "M%d %dV%d", wire->trunk, top, bottom);
}

/* A dot wherever more than two parts of a wire meet on the trunk. */
static void write_forks(const glint_draw_wire *wire, FILE *out)
{
    const int ends = wire->left_count + wire->right_count;
    for (int i = 0; i < ends && wire->trunk >= 0; i++) {
        const int y = height_of(wire, i);
        int above = 0, below = 0, here = 0;
        bool is_first = true;
        for (int j = 0; j < ends; j++) {
            above |= height_of(wire, j) < y;
            below |= height_of(wire, j) > y;
            here += height_of(wire, j) == y;
            is_first &= j >= i || height_of(wire, j) != y;
        }
        if (is_first && above + below + here > 2)
            fprintf(out, "M%d %dh0", wire->trunk, y);
    }
}

/* ---- A net ----------------------------------------------------------------------------------- */

static void write_through(const glint_draw_graph *graph, const glint_draw_layout *layout, int net,
                          bool is_forks, FILE *out)
{
    for (int c = 0; c + 1 < graph->columns; c++)
        for (int i = 0; i < layout->channel[c].count; i++) {
            const glint_draw_wire *wire = &layout->channel[c].wire[i];
            if (wire->net == net && is_forks)
                write_forks(wire, out);
            else if (wire->net == net)
                write_path(graph, layout, c, wire, out);
        }
}

static void write_arrows(const glint_draw_graph *graph, int net, FILE *out)
{
    for (int e = graph->first_edge[net]; e < graph->first_edge[net + 1]; e++) {
        const glint_draw_node *to = &graph->node[graph->edge[e].to];
        const int y = glint_draw_input_height(to, graph->edge[e].input);
        fprintf(out, "M%d %dl-8 -3.5v7z", to->x + inset(to, y), y);
    }
}

void glint_draw_write_net(const glint_draw_graph *graph, const glint_draw_layout *layout, int net,
                          FILE *out)
{
    const glint_draw_node *node = &graph->node[net];
    const int first = graph->first_edge[net], last = graph->first_edge[net + 1];
    if (first == last)
        return;
    fprintf(out, "<g data-net=\"%s\" data-to=\"", node->name);
    for (int e = first; e < last; e++)
        fprintf(out, "%s%s", e > first ? " " : "", graph->node[graph->edge[e].to].name);
    fprintf(out, "\">\n<path class=\"%s\" d=\"",
            node->int_bits + node->frac_bits == 1 ? "bit" : "bus");
    write_through(graph, layout, net, false, out);
    fprintf(out, "\"/>\n<path class=\"joint\" d=\"");
    write_through(graph, layout, net, true, out);
    fprintf(out, "\"/>\n<path class=\"arrow\" d=\"");
    write_arrows(graph, net, out);
    fprintf(out, "\"/>\n</g>\n");
}
