/* From a circuit's description to the graph of its drawing; see graph.h. */
#include "draw/graph.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "lockstep/signals.h"

/* While the graph is made: the rows of the description, and which nodes they have become. */
typedef struct making {
    glint_draw_graph *graph;
    int row_count;
    glint_block_info row[GLINT_DRAW_NODES_MAX];
    int node_of[GLINT_DRAW_NODES_MAX];    /* −1: none: a wire, or feeds nothing */
    bool is_needed[GLINT_DRAW_NODES_MAX]; /* a row that an output depends on */
    glint_error *err;
} making;

#define SEPARATORS ", " /* of the names in a list */

#define WRONG(m, ...) glint_fail((m)->err, GLINT_BAD_INPUT, __VA_ARGS__)

/* ---- Names ----------------------------------------------------------------------------------- */

static int find_row(const making *m, const char *name, size_t length)
{
    for (int i = 0; i < m->row_count; i++)
        if (strlen(m->row[i].name) == length && strncmp(m->row[i].name, name, length) == 0)
            return i;
    return -1;
}

static bool is_of(const char *name, int lane, const char *text, size_t length)
{
    char whole[GLINT_DRAW_NAME];
    if (strlen(name) == length && strncmp(name, text, length) == 0)
        return true;
    (void)snprintf(whole, sizeof whole, "%s[%d]", name, lane);
    return strlen(whole) == length && strncmp(whole, text, length) == 0;
}

/* "acc[3]": of lane 3; "acc": of no lane, or else of the first. */
static bool find_signal(const glint_setting *setting, const char *name, glint_signal_info *signal)
{
    for (int i = 0; i < glint_setting_signal_count(setting); i++) {
        *signal = glint_setting_signal(setting, i);
        if (is_of(signal->name, signal->lane, name, strlen(name)))
            return true;
    }
    return false;
}

static bool find_pin(const glint_setting *setting, const char *name, size_t length,
                     glint_pin_info *pin)
{
    for (int i = 0; i < glint_setting_pin_count(setting); i++) {
        *pin = glint_setting_pin(setting, i);
        if (is_of(pin->name, pin->lane, name, length))
            return true;
    }
    return false;
}

/* The next name of a list, which has blanks or commas between; NULL past the last. */
static const char *next_name(const char **list, size_t *length)
{
    if (*list == NULL)
        return NULL;
    const char *name = *list + strspn(*list, SEPARATORS);
    *length = strcspn(name, SEPARATORS);
    *list = name + *length;
    return *length > 0 ? name : NULL;
}

/* ---- Nodes ----------------------------------------------------------------------------------- */

static glint_status add_node(making *m, glint_draw_kind kind, const char *name, size_t length,
                             int *index)
{
    glint_draw_graph *graph = m->graph;
    if (graph->count == GLINT_DRAW_NODES_MAX)
        return WRONG(m, "the drawing has more than %d blocks", GLINT_DRAW_NODES_MAX);
    if (length >= GLINT_DRAW_NAME)
        return WRONG(m, "block %.*s: its name is longer than %d", (int)length, name,
                     GLINT_DRAW_NAME - 1);
    glint_draw_node *node = &graph->node[ *index = graph->count++];
    *node = (glint_draw_node){.kind = kind};
    memcpy(node->name, name, length);
    return GLINT_OK;
}

static bool has_several_lanes(const glint_setting *setting, const char *name)
{
    bool several = false;
    for (int i = 0; i < glint_setting_signal_count(setting) && !several; i++) {
        const glint_signal_info signal = glint_setting_signal(setting, i);
        several = signal.lane > 0 && strcmp(signal.name, name) == 0;
    }
    for (int i = 0; i < glint_setting_pin_count(setting) && !several; i++) {
        const glint_pin_info pin = glint_setting_pin(setting, i);
        several = pin.lane > 0 && strcmp(pin.name, name) == 0;
    }
    return several;
}

/* Format and number come from the signal's row; each number of the figure is shown once. */
static void describe_block(making *m, glint_draw_node *node, const glint_block_info *row)
{
    glint_signal_info signal;
    node->symbol = row->symbol;
    node->text = row->text;
    node->control = row->control;
    node->is_stacked = row->stacked || has_several_lanes(m->graph->setting, node->name);
    if (!find_signal(m->graph->setting, row->name, &signal))
        return;
    node->has_name = true;
    node->int_bits = signal.int_bits;
    node->frac_bits = signal.frac_bits;
    node->is_signed = signal.is_signed;
    if (signal.kind == GLINT_SIGNAL_REGISTER || signal.kind == GLINT_SIGNAL_BLOCK)
        node->number = signal.block;
    for (const glint_draw_node *other = m->graph->node; other < node; other++)
        if (node->number != 0 && other->number == node->number)
            node->number = 0;
}

static glint_status add_pin(making *m, const char *name, size_t length, int *index)
{
    glint_draw_graph *graph = m->graph;
    glint_pin_info pin;
    for (*index = 0; *index < graph->count; ++*index)
        if (graph->node[*index].kind == GLINT_DRAW_PIN &&
            strncmp(graph->node[*index].name, name, length) == 0 &&
            graph->node[*index].name[length] == '\0')
            return GLINT_OK;
    if (!find_pin(graph->setting, name, length, &pin))
        return WRONG(m, "%.*s is neither a block of the drawing nor a pin", (int)length, name);
    const glint_status status = add_node(m, GLINT_DRAW_PIN, name, length, index);
    if (status != GLINT_OK)
        return status;
    glint_draw_node *node = &graph->node[*index];
    const int row = find_row(m, name, length);
    node->text = row >= 0 ? m->row[row].text : NULL;
    node->int_bits = pin.int_bits;
    node->frac_bits = pin.frac_bits;
    node->is_signed = pin.is_signed;
    node->is_stacked =
        has_several_lanes(graph->setting, node->name) || (row >= 0 && m->row[row].stacked);
    return GLINT_OK;
}

/* The node that drives the signal of that name; −1: a wire that nothing feeds. */
static glint_status find_source(making *m, const char *name, size_t length, int *node)
{
    int row = find_row(m, name, length);
    for (int steps = 0; row >= 0 && m->row[row].symbol == GLINT_SYMBOL_WIRE; steps++) {
        const char *list = m->row[row].inputs;
        *node = -1;
        if ((name = next_name(&list, &length)) == NULL || steps == m->row_count)
            return GLINT_OK;
        row = find_row(m, name, length);
    }
    if (row >= 0 && m->row[row].symbol != GLINT_SYMBOL_PIN) {
        *node = m->node_of[row];
        return GLINT_OK;
    }
    return add_pin(m, name, length, node);
}

static glint_status add_inputs(making *m, int to, const char *list)
{
    const char *name;
    size_t length;
    glint_status status = GLINT_OK;
    while (status == GLINT_OK && (name = next_name(&list, &length)) != NULL) {
        int from;
        status = find_source(m, name, length, &from);
        glint_draw_node *node = &m->graph->node[to];
        if (status == GLINT_OK && node->input_count == GLINT_DRAW_INPUTS_MAX)
            status =
                WRONG(m, "block %s has more than %d inputs", node->name, GLINT_DRAW_INPUTS_MAX);
        if (status == GLINT_OK && from >= 0)
            node->input[node->input_count++] = from;
    }
    return status;
}

/* ---- What is drawn --------------------------------------------------------------------------- */

static bool is_output(const glint_setting *setting, const char *name)
{
    glint_signal_info signal;
    return find_signal(setting, name, &signal) && glint_signal_is_port(signal.kind);
}

/* Marks the row, what feeds it and what controls it. */
static void need(making *m, int row)
{
    const char *const lists[] = {m->row[row].inputs, m->row[row].control};
    if (m->is_needed[row])
        return;
    m->is_needed[row] = true;
    for (size_t i = 0; i < sizeof lists / sizeof lists[0]; i++) {
        const char *name, *list = lists[i];
        size_t length;
        while ((name = next_name(&list, &length)) != NULL) {
            const int from = find_row(m, name, length);
            if (from >= 0)
                need(m, from);
        }
    }
}

/* Controls are not wired, but they must exist. */
static glint_status check_control(const making *m, const glint_block_info *row)
{
    const char *name, *list = row->control;
    size_t length;
    glint_pin_info pin;
    while ((name = next_name(&list, &length)) != NULL)
        if (find_row(m, name, length) < 0 && !find_pin(m->graph->setting, name, length, &pin))
            return WRONG(m, "block %s: %.*s is neither a block of the drawing nor a pin", row->name,
                         (int)length, name);
    return GLINT_OK;
}

static glint_status read_rows(making *m)
{
    const glint_setting *setting = m->graph->setting;
    const glint_circuit *circuit = setting->circuit;
    if (circuit->block_count == NULL || circuit->block == NULL)
        return WRONG(m, "circuit %s: its description has no blocks to draw (glint_circuit.h)",
                     circuit->name);
    const int count = circuit->block_count(setting->values);
    if (count < 1 || count > GLINT_DRAW_NODES_MAX)
        return WRONG(m, "circuit %s: it has %d blocks, not from 1 to %d", circuit->name, count,
                     GLINT_DRAW_NODES_MAX);
    for (int i = 0; i < count; i++) {
        const glint_block_info row = circuit->block(setting->values, i);
        if (row.name == NULL || (unsigned)row.symbol >= GLINT_SYMBOL_COUNT)
            return WRONG(m, "circuit %s: block %d has no name or no known symbol", circuit->name,
                         i);
        if (row.name[strcspn(row.name, SEPARATORS "\"<>&\n")] != '\0')
            return WRONG(m, "circuit %s: block %d: its name has a blank or one of , \" < > &",
                         circuit->name, i);
        if (find_row(m, row.name, strlen(row.name)) >= 0)
            return WRONG(m, "circuit %s: block %s appears twice", circuit->name, row.name);
        m->row[m->row_count++] = row;
    }
    for (int i = 0; i < count; i++)
        if (is_output(setting, m->row[i].name))
            need(m, i);
    return GLINT_OK;
}

/* Stages that are left out pass on the format of their first input. */
static void follow_format(glint_draw_graph *graph, int index)
{
    glint_draw_node *node = &graph->node[index];
    if (node->symbol != GLINT_SYMBOL_MORE || node->has_name || node->input_count == 0)
        return;
    const glint_draw_node *first = &graph->node[node->input[0]];
    node->int_bits = first->int_bits;
    node->frac_bits = first->frac_bits;
    node->is_signed = first->is_signed;
}

/* Pins with rows come first, in their order. */
static glint_status add_pins(making *m)
{
    glint_status status = GLINT_OK;
    int index;
    for (int i = 0; i < m->row_count && status == GLINT_OK; i++)
        if (m->is_needed[i] && m->row[i].symbol == GLINT_SYMBOL_PIN)
            status = add_pin(m, m->row[i].name, strlen(m->row[i].name), &index);
    return status;
}

static glint_status add_blocks(making *m)
{
    glint_status status = GLINT_OK;
    for (int i = 0; i < m->row_count && status == GLINT_OK; i++) {
        const glint_block_info *row = &m->row[i];
        m->node_of[i] = -1;
        if (!m->is_needed[i] || row->symbol == GLINT_SYMBOL_PIN || row->symbol == GLINT_SYMBOL_WIRE)
            continue;
        status = add_node(m, GLINT_DRAW_BLOCK, row->name, strlen(row->name), &m->node_of[i]);
        if (status == GLINT_OK)
            describe_block(m, &m->graph->node[m->node_of[i]], row);
    }
    for (int i = 0; i < m->row_count && status == GLINT_OK; i++) {
        status = check_control(m, &m->row[i]);
        if (status == GLINT_OK && m->node_of[i] >= 0)
            status = add_inputs(m, m->node_of[i], m->row[i].inputs);
        if (status == GLINT_OK && m->node_of[i] >= 0)
            follow_format(m->graph, m->node_of[i]);
    }
    return status;
}

static glint_status add_ports(making *m)
{
    glint_status status = GLINT_OK;
    for (int i = 0; i < m->row_count && status == GLINT_OK; i++) {
        const char *name = m->row[i].name;
        int port, source;
        if (!is_output(m->graph->setting, name))
            continue;
        status = find_source(m, name, strlen(name), &source);
        if (status == GLINT_OK)
            status = add_node(m, GLINT_DRAW_PORT, name, strlen(name), &port);
        if (status != GLINT_OK || source < 0)
            continue;
        glint_draw_node *node = &m->graph->node[port];
        node->is_stacked = m->graph->node[source].is_stacked;
        node->input[node->input_count++] = source;
    }
    return status;
}

glint_status glint_draw_graph_make(const glint_setting *setting, glint_draw_graph *graph,
                                   glint_error *err)
{
    making *m = calloc(1, sizeof *m);
    if (m == NULL)
        return glint_fail(err, GLINT_NO_MEMORY, "not enough memory for a drawing");
    memset(graph, 0, sizeof *graph);
    graph->setting = setting;
    m->graph = graph;
    m->err = err;
    glint_status status = read_rows(m);
    if (status == GLINT_OK)
        status = add_pins(m);
    if (status == GLINT_OK)
        status = add_blocks(m);
    if (status == GLINT_OK)
        status = add_ports(m);
    if (status == GLINT_OK)
        status = glint_draw_place(graph, err);
    free(m);
    return status;
}
