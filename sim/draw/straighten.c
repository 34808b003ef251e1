/* Removes small steps from wires. Places already connected by a level wire form a group, which
 * moves as one; a step between two groups is removed if either can move by that much without
 * hitting anything. */
#include "draw/layout.h"

#include <stdlib.h>

#define STEP_MAX 10 /* larger ones look intended */
#define LANE     6  /* clear space above and below a passing wire */

/* A node, or a net's pass through a column. */
typedef struct place {
    int node, column; /* of a pass: its net; column −1: the node itself */
    int group;
} place;

typedef struct places {
    glint_draw_graph *graph;
    int count;
    place place[GLINT_DRAW_NODES_MAX * 8];
} places;

enum { PLACES_MAX = GLINT_DRAW_NODES_MAX * 8 };

static int column_of(const places *p, int index)
{
    const place *at = &p->place[index];
    return at->column >= 0 ? at->column : p->graph->node[at->node].column;
}

static int *height_of(places *p, int index)
{
    const place *at = &p->place[index];
    return at->column >= 0 ? &p->graph->pass[at->node][at->column] : &p->graph->node[at->node].y;
}

static void extent_of(places *p, int index, int *top, int *bottom)
{
    const place *at = &p->place[index];
    const int y = *height_of(p, index), half = p->graph->node[at->node].height / 2;
    *top = at->column >= 0 ? y - LANE : y - half - GLINT_DRAW_ABOVE;
    *bottom = at->column >= 0 ? y + LANE : y + half + GLINT_DRAW_BELOW;
}

static void collect(places *p)
{
    const glint_draw_graph *graph = p->graph;
    for (int i = 0; i < graph->count; i++) {
        if (p->count < PLACES_MAX)
            p->place[p->count++] = (place){i, -1, 0};
        for (int c = 0; c < graph->columns; c++)
            if (p->count < PLACES_MAX && glint_draw_passes(graph, i, c))
                p->place[p->count++] = (place){i, c, 0};
    }
    for (int i = 0; i < p->count; i++)
        p->place[i].group = i;
}

/* The step of the wire that leads from one place to the given input of another; false: no such
 * wire. */
static bool step_of(places *p, int from, int to, int input, int *step)
{
    const place *a = &p->place[from], *b = &p->place[to];
    if (column_of(p, to) != column_of(p, from) + 1)
        return false;
    if (b->column >= 0) {
        *step = *height_of(p, to) - *height_of(p, from);
        return b->node == a->node && input == 0;
    }
    const glint_draw_node *node = &p->graph->node[b->node];
    if (input >= node->input_count || node->input[input] != a->node)
        return false;
    *step = glint_draw_input_height(node, input) - *height_of(p, from);
    return true;
}

static void join(places *p, int a, int b)
{
    const int from = p->place[a].group, into = p->place[b].group;
    for (int i = 0; i < p->count; i++)
        if (p->place[i].group == from)
            p->place[i].group = into;
}

static bool can_move(places *p, int group, int by)
{
    for (int i = 0; i < p->count; i++) {
        int top, bottom;
        if (p->place[i].group != group)
            continue;
        extent_of(p, i, &top, &bottom);
        for (int j = 0; j < p->count; j++) {
            int other_top, other_bottom;
            if (p->place[j].group == group || column_of(p, i) != column_of(p, j))
                continue;
            extent_of(p, j, &other_top, &other_bottom);
            if (top + by < other_bottom && bottom + by > other_top)
                return false;
        }
    }
    return true;
}

static bool move(places *p, int group, int by)
{
    if (!can_move(p, group, by))
        return false;
    for (int i = 0; i < p->count; i++)
        if (p->place[i].group == group)
            *height_of(p, i) += by;
    return true;
}

/* Levels a pair if possible, and merges the groups of a level pair. */
static void level(places *p, int from, int to, int input)
{
    int step;
    if (p->place[from].group == p->place[to].group || !step_of(p, from, to, input, &step))
        return;
    if (step == 0 || (abs(step) <= STEP_MAX &&
                      (move(p, p->place[to].group, -step) || move(p, p->place[from].group, step))))
        join(p, from, to);
}

static void level_all(places *p, int most)
{
    for (int i = 0; i < p->count; i++)
        for (int j = 0; j < p->count; j++)
            for (int k = 0; k < GLINT_DRAW_INPUTS_MAX; k++) {
                int step;
                if (step_of(p, i, j, k, &step) && abs(step) <= most)
                    level(p, i, j, k);
            }
}

void glint_draw_straighten(glint_draw_graph *graph)
{
    places *p = calloc(1, sizeof *p);
    if (p == NULL)
        return; /* the steps do no harm */
    p->graph = graph;
    collect(p);
    level_all(p, 0); /* what is level already stays so */
    level_all(p, STEP_MAX);
    free(p);
}
