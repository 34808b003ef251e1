/* Sizes of symbols, and the heights of everything by Graphviz's dot; see layout.h. */
#define _GNU_SOURCE /* memfd_create */

#include "draw/layout.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

#include "rtl/command.h"

#define INCH   72.0 /* pixels: dot has sizes in inches, and points of this size in tables */
#define PITCH  20   /* from input to input of a symbol */
#define MARGIN 20   /* about the drawing */
#define TITLE  58   /* above it */

/* ---- Sizes ----------------------------------------------------------------------------------- */

int glint_draw_length(const char *text)
{
    int length = 0;
    for (; *text != '\0'; text++)
        length += ((unsigned char)*text & 0xc0u) != 0x80u; /* not one that goes on */
    return length;
}

void glint_draw_format(const glint_draw_node *node, char text[GLINT_DRAW_FORMAT])
{
    text[0] = '\0';
    if (node->int_bits + node->frac_bits > 1)
        (void)snprintf(text, GLINT_DRAW_FORMAT, "%c%d.%d", node->is_signed ? 'S' : 'U',
                       node->int_bits, node->frac_bits);
}

const char *glint_draw_text(const glint_draw_node *node)
{
    static const char *const usual[GLINT_SYMBOL_COUNT] = {
        [GLINT_SYMBOL_REGISTER] = "",         [GLINT_SYMBOL_ROM] = "",
        [GLINT_SYMBOL_MULTIPLIER] = "\u00d7", [GLINT_SYMBOL_ADDER] = "+",
        [GLINT_SYMBOL_COMPARATOR] = "\u2265", [GLINT_SYMBOL_MORE] = "\u22ef",
    };
    if (node->kind != GLINT_DRAW_BLOCK)
        return node->name;
    if (node->text != NULL)
        return node->text;
    return usual[node->symbol] != NULL ? usual[node->symbol] : "";
}

static void size_of(glint_draw_node *node)
{
    static const struct {
        int width, height;
    } sizes[GLINT_SYMBOL_COUNT] = {
        [GLINT_SYMBOL_REGISTER] = {44, 44},   [GLINT_SYMBOL_ROM] = {56, 48},
        [GLINT_SYMBOL_MULTIPLIER] = {40, 40}, [GLINT_SYMBOL_ADDER] = {40, 40},
        [GLINT_SYMBOL_COMPARATOR] = {44, 44}, [GLINT_SYMBOL_KEYS] = {48, 44},
        [GLINT_SYMBOL_LOGIC] = {44, 40},      [GLINT_SYMBOL_MORE] = {44, 44},
    };
    const int length = glint_draw_length(glint_draw_text(node));
    if (node->kind != GLINT_DRAW_BLOCK) {
        node->width = length * GLINT_DRAW_SANS + 24;
        node->height = 22;
        return;
    }
    node->width = sizes[node->symbol].width;
    node->height = sizes[node->symbol].height;
    if (node->symbol == GLINT_SYMBOL_REGISTER && length == 0) {
        node->width = 26;
        node->height = 34;
    }
    if (node->width < length * GLINT_DRAW_SANS + 12)
        node->width = length * GLINT_DRAW_SANS + 12;
    if (node->height < node->input_count * PITCH)
        node->height = node->input_count * PITCH;
}

int glint_draw_input_height(const glint_draw_node *node, int i)
{
    return node->y + (2 * i + 1 - node->input_count) * PITCH / 2;
}

/* ---- For dot --------------------------------------------------------------------------------- */

/* A table: on the left a cell for each input with room above and below them, on the right one for
 * the output. Their heights are what the edges are levelled to. */
static void write_node(const glint_draw_graph *graph, int index, FILE *out)
{
    const glint_draw_node *node = &graph->node[index];
    const int inputs = node->input_count > 0 ? node->input_count : 1;
    const int whole = node->height + GLINT_DRAW_ABOVE + GLINT_DRAW_BELOW;
    const int above = node->height / 2 - inputs * PITCH / 2 + GLINT_DRAW_ABOVE;
    const int below = whole - above - inputs * PITCH;
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
                PITCH);
        if (i == 0)
            fprintf(out,
                    "<td port=\"o\" rowspan=\"%d\" width=\"1\" height=\"%d\" fixedsize=\"true\">"
                    "</td>",
                    inputs, inputs * PITCH);
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

/* Pins from top to bottom as the description has them. */
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

/* Where a net leaves a column: its node's output, or where it passes. */
static void write_tail(const glint_draw_graph *graph, int net, int column, FILE *out)
{
    if (graph->node[net].column == column)
        fprintf(out, "  n%d:o:e", net);
    else
        fprintf(out, "  p%d_%d", net, column);
}

/* How many inputs a net feeds. */
static int fan_out(const glint_draw_graph *graph, int net)
{
    int count = 0;
    for (int i = 0; i < graph->count; i++)
        for (int j = 0; j < graph->node[i].input_count; j++)
            count += graph->node[i].input[j] == net;
    return count;
}

/* Feedback is to stay near: a point behind its node, and one before what it feeds, hold it there.
 */
static void write_feedback(const glint_draw_graph *graph, int net, FILE *out)
{
    const int from = graph->node[net].column;
    bool is_any = false;
    for (int i = 0; i < graph->count; i++)
        for (int j = 0; j < graph->node[i].input_count; j++) {
            const int to = graph->node[i].column;
            if (graph->node[i].input[j] != net || to > from)
                continue;
            is_any = true;
            if (to > 0)
                fprintf(out,
                        "  h%d_%d_%d [shape=point, width=0.01];\n"
                        "  h%d_%d_%d -> p%d_%d [style=invis, weight=2];\n"
                        "  h%d_%d_%d -> n%d:i%d:w [style=invis, weight=2];\n",
                        net, i, j, net, i, j, net, to, net, i, j, i, j);
        }
    if (is_any && from + 1 < graph->columns)
        fprintf(out,
                "  h%d [shape=point, width=0.01];\n"
                "  p%d_%d -> h%d [style=invis, weight=2];\n"
                "  n%d:o:e -> h%d [style=invis, weight=2];\n",
                net, net, from, net, net, net);
}

/* To the inputs themselves. What goes from one to one is to be level before all else. */
static void write_ends(const glint_draw_graph *graph, int net, FILE *out)
{
    const int from = graph->node[net].column;
    const bool is_one = fan_out(graph, net) == 1;
    for (int i = 0; i < graph->count; i++)
        for (int j = 0; j < graph->node[i].input_count; j++) {
            const glint_draw_node *to = &graph->node[i];
            if (to->input[j] != net || to->column <= from)
                continue;
            write_tail(graph, net, to->column - 1, out);
            fprintf(out, " -> n%d:i%d:w [weight=%d];\n", i, j,
                    is_one && to->input_count == 1 ? 20 : 4);
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
        size_of(&graph->node[i]);
    fprintf(out, "digraph %s {\n", graph->setting->circuit->name);
    fprintf(out, "  rankdir=LR; splines=false; nodesep=%g; ranksep=1;\n", 6 / INCH);
    fprintf(out, "  node [shape=plain, fontsize=1];\n");
    for (int i = 0; i < graph->count; i++)
        write_node(graph, i, out);
    for (int i = 0; i < graph->count; i++)
        for (int c = 0; c < graph->columns; c++)
            if (glint_draw_passes(graph, i, c))
                fprintf(out, "  p%d_%d [shape=box, label=\"\", width=0.01, height=%g];\n", i, c,
                        12 / INCH);
    for (int c = 0; c < graph->columns; c++)
        write_column(graph, c, out);
    write_order(graph, out);
    for (int i = 0; i < graph->count; i++)
        write_net(graph, i, out);
    fprintf(out, "}\n");
}

/* ---- By dot ---------------------------------------------------------------------------------- */

/* Writes the graph into a file without a name, which dot opens by its descriptor. */
static int dot_file(glint_draw_graph *graph)
{
    const int fd = memfd_create("glint", 0);
    FILE *out = fd >= 0 ? fdopen(dup(fd), "w") : NULL;
    if (out == NULL) {
        if (fd >= 0)
            close(fd);
        return -1;
    }
    glint_draw_dot(graph, out);
    const int failed = ferror(out);
    if (fclose(out) != 0 || failed != 0 || lseek(fd, 0, SEEK_SET) < 0) {
        close(fd);
        return -1;
    }
    return fd;
}

static glint_status run_dot(glint_draw_graph *graph, char **plain, glint_error *err)
{
    char path[64];
    const int fd = dot_file(graph);
    if (fd < 0)
        return glint_fail(err, GLINT_IO_ERROR, "no file for dot: %s", strerror(errno));
    (void)snprintf(path, sizeof path, "/proc/self/fd/%d", fd);
    const char *const arguments[] = {"dot", "-Tplain", path, NULL};
    bool success;
    glint_status status = glint_command_run(arguments, NULL, &success, plain, err);
    close(fd);
    if (status != GLINT_OK || success)
        return status;
    status = glint_fail(err, GLINT_IO_ERROR,
                        "dot draws nothing; it is in the package graphviz (it says: %.*s)",
                        (int)strcspn(*plain, "\n"), *plain);
    free(*plain);
    *plain = NULL;
    return status;
}

/* "node NAME X Y …": dot counts heights upwards, in inches. */
static void take_line(glint_draw_graph *graph, const char *line)
{
    int index, column;
    double x, y;
    if (sscanf(line, "node n%d %lf %lf", &index, &x, &y) == 3 && index >= 0 && index < graph->count)
        graph->node[index].y = (int)lround(-y * INCH) + (GLINT_DRAW_ABOVE - GLINT_DRAW_BELOW) / 2;
    else if (sscanf(line, "node p%d_%d %lf %lf", &index, &column, &x, &y) == 4 && index >= 0 &&
             index < graph->count && column >= 0 && column < graph->columns)
        graph->pass[index][column] = (int)lround(-y * INCH);
}

/* So that the highest thing is below the title, and the drawing as high as it must be. */
static void shift(glint_draw_graph *graph, glint_draw_layout *layout)
{
    int top = 0, bottom = -1000000;
    for (int i = 0; i < graph->count; i++) {
        const glint_draw_node *node = &graph->node[i];
        const int above = node->y - node->height / 2 - GLINT_DRAW_ABOVE;
        const int below = node->y + node->height / 2 + GLINT_DRAW_BELOW;
        top = i == 0 || above < top ? above : top;
        bottom = below > bottom ? below : bottom;
        for (int c = 0; c < graph->columns; c++)
            if (glint_draw_passes(graph, i, c) && graph->pass[i][c] < top)
                top = graph->pass[i][c];
    }
    for (int i = 0; i < graph->count; i++) {
        graph->node[i].y += TITLE - top;
        for (int c = 0; c < graph->columns; c++)
            if (glint_draw_passes(graph, i, c))
                graph->pass[i][c] += TITLE - top;
    }
    layout->height = bottom - top + TITLE + MARGIN;
}

glint_status glint_draw_lay_out(glint_draw_graph *graph, glint_draw_layout *layout,
                                glint_error *err)
{
    char *plain;
    const glint_status status = run_dot(graph, &plain, err);
    if (status != GLINT_OK)
        return status;
    for (const char *line = plain; line != NULL; line = strchr(line, '\n')) {
        line += *line == '\n';
        take_line(graph, line);
    }
    free(plain);
    glint_draw_straighten(graph);
    shift(graph, layout);
    glint_draw_route(graph, layout);
    return GLINT_OK;
}
