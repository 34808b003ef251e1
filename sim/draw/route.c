/* Columns from left to right, and the wires in the channels between them. In a channel a net is a
 * vertical trunk with a horizontal branch to each place where it enters or leaves. */
#include "draw/layout.h"

#include <stdlib.h>

#define MARGIN 20
#define TRACK  9  /* from trunk to trunk */
#define ARROW  10 /* room for an arrowhead */
#define BEHIND 7  /* and before the first trunk */

/* ---- Channels -------------------------------------------------------------------------------- */

static void add_height(int *heights, int *count, int height)
{
    for (int i = 0; i < *count; i++)
        if (heights[i] == height)
            return;
    if (*count < GLINT_DRAW_NODES_MAX)
        heights[(*count)++] = height;
}

/* The heights at which the net enters and leaves the channel behind the column. */
static void collect(const glint_draw_graph *graph, int net, int column, glint_draw_wire *wire)
{
    const int from = graph->node[net].column;
    *wire = (glint_draw_wire){.net = net, .trunk = -1};
    if (glint_draw_passes(graph, net, column))
        add_height(wire->left, &wire->left_count, graph->pass[net][column]);
    if (glint_draw_passes(graph, net, column + 1))
        add_height(wire->right, &wire->right_count, graph->pass[net][column + 1]);
    for (int e = graph->first_edge[net]; e < graph->first_edge[net + 1]; e++) {
        const glint_draw_node *to = &graph->node[graph->edge[e].to];
        if (to->column == column + 1)
            add_height(wire->right, &wire->right_count,
                       glint_draw_input_height(to, graph->edge[e].input));
    }
    if (column == from && wire->left_count + wire->right_count > 0)
        add_height(wire->left, &wire->left_count, graph->node[net].y);
}

static void ends_of(const glint_draw_wire *wire, int *least, int *most)
{
    *least = 1000000;
    *most = -1000000;
    for (int i = 0; i < wire->left_count + wire->right_count; i++) {
        const int y = i < wire->left_count ? wire->left[i] : wire->right[i - wire->left_count];
        *least = y < *least ? y : *least;
        *most = y > *most ? y : *most;
    }
}

/* The cost of a branch at height y crossing a trunk: high near its ends, where it would look
 * connected. */
static int crossing(const glint_draw_wire *trunk, int y)
{
    int least, most;
    ends_of(trunk, &least, &most);
    if (y < least - 4 || y > most + 4)
        return 0;
    for (int i = 0; i < trunk->left_count + trunk->right_count; i++) {
        const int end =
            i < trunk->left_count ? trunk->left[i] : trunk->right[i - trunk->left_count];
        if (abs(end - y) <= 4)
            return 20;
    }
    return 1;
}

/* Of two wires, if the first has its trunk to the left of the second's. */
static int cost_of(const glint_draw_wire *first, const glint_draw_wire *second)
{
    int cost = 0;
    for (int i = 0; i < first->right_count; i++) {
        cost += crossing(second, first->right[i]);
        for (int j = 0; j < second->left_count; j++)
            if (abs(first->right[i] - second->left[j]) <= 4)
                cost += 200; /* one over the other */
    }
    for (int j = 0; j < second->left_count; j++)
        cost += crossing(first, second->left[j]);
    return cost;
}

static void swap(glint_draw_wire *a, glint_draw_wire *b)
{
    const glint_draw_wire kept = *a;
    *a = *b;
    *b = kept;
}

/* Swaps neighbouring trunks as long as that saves crossings. */
static void order(glint_draw_wire *wire, int count)
{
    for (int round = 0; round < count; round++)
        for (int i = 0; i + 1 < count; i++)
            if (cost_of(&wire[i + 1], &wire[i]) < cost_of(&wire[i], &wire[i + 1]))
                swap(&wire[i], &wire[i + 1]);
}

static bool is_straight(const glint_draw_wire *wire)
{
    int least, most;
    ends_of(wire, &least, &most);
    return least == most;
}

/* Gives every wire that is not straight a trunk; straight ones come last. */
static int find_trunks(glint_draw_channel *channel)
{
    int bent = 0;
    for (int i = 0; i < channel->count; i++)
        if (!is_straight(&channel->wire[i]))
            swap(&channel->wire[i], &channel->wire[bent++]);
    order(channel->wire, bent);
    for (int i = 0; i < bent; i++)
        channel->wire[i].trunk = i;
    return bent;
}

/* ---- Columns --------------------------------------------------------------------------------- */

static int column_width(const glint_draw_graph *graph, int column)
{
    int width = 12;
    for (int i = 0; i < graph->count; i++) {
        const glint_draw_node *node = &graph->node[i];
        const int name =
            node->has_name ? (int)(glint_draw_length(node->name) * GLINT_DRAW_MONO) : 0;
        if (node->column != column)
            continue;
        width = node->width > width ? node->width : width;
        width = name > width ? name : width;
    }
    return width;
}

/* Room for the formats, which are written where wires leave a column. */
static int format_width(const glint_draw_graph *graph, int column)
{
    int width = 0;
    for (int i = 0; i < graph->count; i++) {
        char text[GLINT_DRAW_FORMAT];
        if (graph->node[i].column != column)
            continue;
        glint_draw_format(&graph->node[i], text);
        const int needed = (int)(glint_draw_length(text) * GLINT_DRAW_MONO);
        width = needed > width ? needed : width;
    }
    return width;
}

void glint_draw_route(glint_draw_graph *graph, glint_draw_layout *layout)
{
    int x = MARGIN;
    for (int c = 0; c < graph->columns; c++) {
        glint_draw_channel *channel = &layout->channel[c];
        const int width = column_width(graph, c);
        layout->middle[c] = x + width / 2;
        for (int i = 0; i < graph->count; i++)
            if (graph->node[i].column == c)
                graph->node[i].x = layout->middle[c] - graph->node[i].width / 2;
        x += width;
        if (c + 1 == graph->columns)
            break;
        channel->left = x;
        channel->count = 0;
        for (int net = 0; net < graph->count; net++) {
            glint_draw_wire *wire = &channel->wire[channel->count];
            collect(graph, net, c, wire);
            channel->count += wire->left_count + wire->right_count > 0;
        }
        const int trunks = find_trunks(channel);
        x += format_width(graph, c) + BEHIND;
        for (int i = 0; i < trunks; i++)
            channel->wire[i].trunk = x + i * TRACK;
        x += (trunks > 0 ? (trunks - 1) * TRACK : 0) + ARROW;
        channel->right = x;
    }
    layout->width = x + MARGIN;
}
