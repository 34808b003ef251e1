/* The heights of everything, by Graphviz's dot; see layout.h. */
#define _GNU_SOURCE /* memfd_create */

#include "draw/layout.h"

#include <errno.h>
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

#include "rtl/command.h"

#define MARGIN 20 /* about the drawing */
#define TITLE  58 /* above it */

/* Writes the graph to an unnamed file, which dot opens through its descriptor. */
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
        return glint_fail(err, GLINT_IO_ERROR, "cannot write the input for dot: %s",
                          strerror(errno));
    (void)snprintf(path, sizeof path, "/proc/self/fd/%d", fd);
    const char *const arguments[] = {"dot", "-Tplain", path, NULL};
    bool success;
    glint_status status = glint_command_run(arguments, NULL, &success, plain, err);
    close(fd);
    if (status != GLINT_OK || success)
        return status;
    const int length = (int)strcspn(*plain, "\n");
    status = glint_fail(err, GLINT_IO_ERROR, "dot (package graphviz) failed%s%.*s",
                        length > 0 ? ": " : "", length, *plain);
    free(*plain);
    *plain = NULL;
    return status;
}

#define NOWHERE INT_MIN

/* "node NAME X Y …" in inches, Y upwards. */
static void take_line(glint_draw_graph *graph, const char *line)
{
    const int shifted = (GLINT_DRAW_ABOVE - GLINT_DRAW_BELOW) / 2; /* the symbol in its space */
    int index, column;
    double x, y;
    if (sscanf(line, "node n%d %lf %lf", &index, &x, &y) == 3 && index >= 0 && index < graph->count)
        graph->node[index].y = (int)lround(-y * GLINT_DRAW_INCH) + shifted;
    else if (sscanf(line, "node p%d_%d %lf %lf", &index, &column, &x, &y) == 4 && index >= 0 &&
             index < graph->count && column >= 0 && column < graph->columns)
        graph->pass[index][column] = (int)lround(-y * GLINT_DRAW_INCH);
}

/* The heights in dot's answer; all of them must be there. */
static glint_status take_heights(glint_draw_graph *graph, const char *plain, glint_error *err)
{
    for (int i = 0; i < graph->count; i++) {
        graph->node[i].y = NOWHERE;
        for (int c = 0; c < graph->columns; c++)
            graph->pass[i][c] = glint_draw_passes(graph, i, c) ? NOWHERE : 0;
    }
    for (const char *line = plain; line != NULL; line = strchr(line, '\n')) {
        line += *line == '\n';
        take_line(graph, line);
    }
    for (int i = 0; i < graph->count; i++) {
        bool is_missing = graph->node[i].y == NOWHERE;
        for (int c = 0; c < graph->columns; c++)
            is_missing |= graph->pass[i][c] == NOWHERE;
        if (is_missing)
            return glint_fail(err, GLINT_IO_ERROR, "dot returned no position for %s",
                              graph->node[i].name);
    }
    return GLINT_OK;
}

/* Moves everything below the title, and sets the height of the drawing. */
static void shift(glint_draw_graph *graph, glint_draw_layout *layout)
{
    int top = INT_MAX, bottom = INT_MIN;
    for (int i = 0; i < graph->count; i++) {
        const glint_draw_node *node = &graph->node[i];
        const int above = node->y - node->height / 2 - GLINT_DRAW_ABOVE;
        const int below = node->y + node->height / 2 + GLINT_DRAW_BELOW;
        top = above < top ? above : top;
        bottom = below > bottom ? below : bottom;
        for (int c = 0; c < graph->columns; c++) {
            const int pass = graph->pass[i][c];
            if (!glint_draw_passes(graph, i, c))
                continue;
            top = pass < top ? pass : top;
            bottom = pass > bottom ? pass : bottom;
        }
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
    glint_status status = run_dot(graph, &plain, err);
    if (status != GLINT_OK)
        return status;
    status = take_heights(graph, plain, err);
    free(plain);
    if (status != GLINT_OK)
        return status;
    glint_draw_straighten(graph);
    shift(graph, layout);
    glint_draw_route(graph, layout);
    return GLINT_OK;
}
