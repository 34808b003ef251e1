/* A circuit's drawing from its description: graph, layout, SVG; see draw.h. */
#include "draw/draw.h"

#include <stdlib.h>

#include "draw/layout.h"
#include "draw/svg.h"

glint_status glint_draw_svg(const glint_setting *setting, FILE *out, glint_error *err)
{
    glint_draw_graph *graph = malloc(sizeof *graph);
    glint_draw_layout *layout = malloc(sizeof *layout);
    glint_status status = graph != NULL && layout != NULL
                              ? glint_draw_graph_make(setting, graph, err)
                              : glint_fail(err, GLINT_NO_MEMORY, "not enough memory for a drawing");
    if (status == GLINT_OK)
        status = glint_draw_lay_out(graph, layout, err);
    if (status == GLINT_OK)
        glint_draw_write_svg(graph, layout, out);
    free(graph);
    free(layout);
    return status;
}

glint_status glint_draw_plan(const glint_setting *setting, FILE *out, glint_error *err)
{
    glint_draw_graph *graph = malloc(sizeof *graph);
    if (graph == NULL)
        return glint_fail(err, GLINT_NO_MEMORY, "not enough memory for a drawing");
    const glint_status status = glint_draw_graph_make(setting, graph, err);
    if (status == GLINT_OK)
        glint_draw_dot(graph, out);
    free(graph);
    return status;
}
