/* Assigns nodes to stages and columns, and lists the edges net by net; see graph.h. */
#include "draw/graph.h"

/* The stage of each node, and how many columns behind that stage's registers it is. */
typedef struct stages {
    int stage[GLINT_DRAW_NODES_MAX], depth[GLINT_DRAW_NODES_MAX];
} stages;

/* Nodes are in the order of the description, so the inputs of a node are placed before it, apart
 * from feedback. */
static void place_in_stage(const glint_draw_graph *graph, int index, stages *s)
{
    const glint_draw_node *node = &graph->node[index];
    const bool is_register = node->symbol == GLINT_SYMBOL_REGISTER;
    int stage = 0, depth = 0;
    if (node->input_count == 0 && !is_register && graph->setting->circuit->clock_port != NULL)
        stage = 1; /* constants stand behind the first registers */
    for (int i = 0; i < node->input_count; i++) {
        const int from = node->input[i];
        if (graph->node[from].kind == GLINT_DRAW_BLOCK && from >= index)
            continue; /* feedback */
        if (s->stage[from] > stage) {
            stage = s->stage[from];
            depth = s->depth[from];
        } else if (s->stage[from] == stage && s->depth[from] > depth) {
            depth = s->depth[from];
        }
    }
    s->stage[index] = stage + is_register;
    s->depth[index] = is_register ? 0 : depth + 1;
}

static glint_status place_in_columns(glint_draw_graph *graph, stages *s, glint_error *err)
{
    int deepest[GLINT_DRAW_COLUMNS_MAX] = {0}, first[GLINT_DRAW_COLUMNS_MAX + 1] = {0};
    for (int i = 0; i < graph->count; i++) {
        if (graph->node[i].kind == GLINT_DRAW_BLOCK)
            place_in_stage(graph, i, s);
        if (s->stage[i] >= GLINT_DRAW_COLUMNS_MAX - 1)
            return glint_fail(err, GLINT_BAD_INPUT, "the drawing has more than %d stages",
                              GLINT_DRAW_COLUMNS_MAX - 2);
        if (s->stage[i] > graph->stages)
            graph->stages = s->stage[i];
        if (s->depth[i] > deepest[s->stage[i]])
            deepest[s->stage[i]] = s->depth[i];
    }
    for (int i = 0; i <= graph->stages; i++) {
        graph->stage_column[i] = first[i];
        first[i + 1] = first[i] + deepest[i] + 1;
    }
    graph->columns = first[graph->stages + 1] + 1;
    if (graph->columns > GLINT_DRAW_COLUMNS_MAX)
        return glint_fail(err, GLINT_BAD_INPUT, "the drawing has more than %d columns",
                          GLINT_DRAW_COLUMNS_MAX);
    for (int i = 0; i < graph->count; i++)
        graph->node[i].column = graph->node[i].kind == GLINT_DRAW_PORT
                                    ? graph->columns - 1
                                    : first[s->stage[i]] + s->depth[i];
    return GLINT_OK;
}

static void list_edges(glint_draw_graph *graph)
{
    int count = 0;
    for (int net = 0; net < graph->count; net++) {
        graph->first_edge[net] = count;
        for (int i = 0; i < graph->count; i++)
            for (int j = 0; j < graph->node[i].input_count; j++)
                if (graph->node[i].input[j] == net)
                    graph->edge[count++] = (glint_draw_edge){net, i, j};
    }
    graph->first_edge[graph->count] = count;
}

bool glint_draw_passes(const glint_draw_graph *graph, int net, int column)
{
    const int from = graph->node[net].column;
    for (int e = graph->first_edge[net]; e < graph->first_edge[net + 1]; e++) {
        const int to = graph->node[graph->edge[e].to].column;
        if (to > from ? column > from && column < to : column >= to && column <= from)
            return true;
    }
    return false;
}

glint_status glint_draw_place(glint_draw_graph *graph, glint_error *err)
{
    stages s = {{0}, {0}};
    list_edges(graph);
    return place_in_columns(graph, &s, err);
}
