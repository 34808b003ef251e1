/* Writes the drawing as SVG: clock edges, then wires, then symbols on top. */
#include "draw/svg.h"

#include <string.h>

#include "lockstep/signals.h"

#define SHADOW 4 /* offset of the second outline */

static const char style[] =
    "  text { font-family: 'DejaVu Sans', Verdana, sans-serif; font-size: 13px; fill: #1f2933; "
    "text-anchor: middle }\n"
    "  .title { font-size: 16px; font-weight: bold; text-anchor: start }\n"
    "  .note { font-size: 12px; fill: #52606d; text-anchor: start }\n"
    "  .name { font-family: 'DejaVu Sans Mono', Menlo, monospace; font-size: 10.5px; "
    "fill: #52606d; "
    "paint-order: stroke; stroke: #ffffff; stroke-width: 3px }\n"
    "  .kind { font-size: 11px; fill: #334e68 }\n"
    "  .format { font-family: 'DejaVu Sans Mono', Menlo, monospace; font-size: 10.5px; "
    "fill: #0b5394; text-anchor: start }\n"
    "  .control { font-size: 10.5px; font-style: italic; fill: #9c3d10; text-anchor: start }\n"
    "  .number { font-size: 11px; font-weight: bold; fill: #ffffff }\n"
    "  .edge { font-size: 12px; fill: #8a6d00 }\n"
    "  .cut { stroke: #c9a400; stroke-width: 1.2; stroke-dasharray: 6 4; fill: none }\n"
    "  .shape { stroke: #1f2933; stroke-width: 1.4; fill: #ffffff }\n"
    "  .register { fill: #fff3c4 } .rom { fill: #d9eaf7 } .multiplier { fill: #dff2df }\n"
    "  .adder { fill: #dff2df } .comparator { fill: #fbe3d6 } .keys { fill: #fbe3d6 }\n"
    "  .pin { fill: #eceff3 } .port { fill: #eceff3 } .more { fill: #f5f5f5; "
    "stroke-dasharray: 4 3 }\n"
    "  .mark { stroke: #1f2933; stroke-width: 1.2; fill: none }\n"
    "  .badge { fill: #334e68 }\n"
    "  .bus { stroke: #334e68; stroke-width: 1.8; fill: none; stroke-linejoin: round }\n"
    "  .bit { stroke: #52606d; stroke-width: 1; fill: none; stroke-linejoin: round }\n"
    "  .joint { stroke: #334e68; stroke-width: 5.5; stroke-linecap: round; fill: none }\n"
    "  .arrow { fill: #334e68 }\n";

static const char *const symbol_names[GLINT_SYMBOL_COUNT] = {
    [GLINT_SYMBOL_PIN] = "pin",     [GLINT_SYMBOL_REGISTER] = "register",
    [GLINT_SYMBOL_ROM] = "rom",     [GLINT_SYMBOL_MULTIPLIER] = "multiplier",
    [GLINT_SYMBOL_ADDER] = "adder", [GLINT_SYMBOL_COMPARATOR] = "comparator",
    [GLINT_SYMBOL_KEYS] = "keys",   [GLINT_SYMBOL_LOGIC] = "logic",
    [GLINT_SYMBOL_MORE] = "more",   [GLINT_SYMBOL_WIRE] = "wire",
};

static void write_text(FILE *out, const char *text)
{
    for (; *text != '\0'; text++) {
        const char *entity = *text == '<'   ? "&lt;"
                             : *text == '>' ? "&gt;"
                             : *text == '&' ? "&amp;"
                             : *text == '"' ? "&quot;"
                                            : NULL;
        if (entity != NULL)
            fputs(entity, out);
        else
            fputc(*text, out);
    }
}

static void label(FILE *out, const char *class, int x, int y, const char *text)
{
    fprintf(out, "<text class=\"%s\" x=\"%d\" y=\"%d\">", class, x, y);
    write_text(out, text);
    fprintf(out, "</text>\n");
}

static void write_format(const glint_draw_node *node, FILE *out)
{
    char text[GLINT_DRAW_FORMAT];
    glint_draw_format(node, text);
    if (text[0] != '\0')
        label(out, "format", node->x + node->width + 4 + (node->is_stacked ? SHADOW : 0),
              node->y - 4, text);
}

/* ---- Symbols --------------------------------------------------------------------------------- */

static void write_outline(const glint_draw_node *node, int shift, const char *class, FILE *out)
{
    const int x = node->x + shift, y = node->y - node->height / 2 - shift;
    const int w = node->width, h = node->height;
    if (node->kind != GLINT_DRAW_BLOCK)
        fprintf(out, "<path class=\"shape %s\" d=\"M%d %dh%dl%d %dl-%d %dh-%dz\"/>\n", class, x, y,
                w - h / 2, h / 2, h / 2, h / 2, h / 2, w - h / 2);
    else if (node->symbol == GLINT_SYMBOL_MULTIPLIER || node->symbol == GLINT_SYMBOL_ADDER)
        fprintf(out, "<ellipse class=\"shape %s\" cx=\"%d\" cy=\"%d\" rx=\"%d\" ry=\"%d\"/>\n",
                class, x + w / 2, y + h / 2, w / 2, h / 2);
    else
        fprintf(out,
                "<rect class=\"shape %s\" x=\"%d\" y=\"%d\" width=\"%d\" height=\"%d\" "
                "rx=\"%d\"/>\n",
                class, x, y, w, h, node->symbol == GLINT_SYMBOL_LOGIC ? 8 : 2);
}

/* The part of a symbol inside its outline: a clock wedge, the heading of a ROM, a switch. */
static void write_mark(const glint_draw_node *node, FILE *out)
{
    const int x = node->x, bottom = node->y + node->height / 2;
    switch (node->symbol) {
    case GLINT_SYMBOL_REGISTER:
        fprintf(out, "<path class=\"mark\" d=\"M%d %dl6 -8l6 8\"/>\n", x + node->width / 2 - 6,
                bottom);
        break;
    case GLINT_SYMBOL_ROM:
        fprintf(out, "<path class=\"mark\" d=\"M%d %dh%d\"/>\n", x, bottom - node->height + 17,
                node->width);
        label(out, "kind", x + node->width / 2, bottom - node->height + 12, "ROM");
        break;
    case GLINT_SYMBOL_KEYS:
        fprintf(out,
                "<path class=\"mark\" d=\"M%d %dh12l13 -9m-1 9h12\"/>\n"
                "<path class=\"joint\" d=\"M%d %dh0m12 0h0\"/>\n",
                x + 6, node->y + 10, x + 18, node->y + 10);
        break;
    default:
        break;
    }
}

/* How far below the middle the text stands: some symbols contain more than text. */
static int text_below(const glint_draw_node *node)
{
    return node->symbol == GLINT_SYMBOL_ROM ? 13 : node->symbol == GLINT_SYMBOL_KEYS ? -7 : 4;
}

static void write_node(const glint_draw_node *node, FILE *out)
{
    const char *class = node->kind == GLINT_DRAW_PIN    ? "pin"
                        : node->kind == GLINT_DRAW_PORT ? "port"
                                                        : symbol_names[node->symbol];
    const int middle = node->x + node->width / 2;
    const int top = node->y - node->height / 2, bottom = node->y + node->height / 2;
    const bool is_block = node->kind == GLINT_DRAW_BLOCK;
    const int shadow = node->is_stacked ? SHADOW : 0;
    char number[16];
    fprintf(out, "<g data-%s=\"", is_block ? "block" : class);
    write_text(out, node->name);
    fprintf(out, "\">\n");
    if (node->is_stacked)
        write_outline(node, shadow, class, out);
    write_outline(node, 0, class, out);
    if (is_block)
        write_mark(node, out);
    label(out, "text", is_block ? middle : middle - 3, node->y + text_below(node),
          glint_draw_text(node));
    if (node->has_name)
        label(out, "name", middle, bottom + 12, node->name);
    (void)snprintf(number, sizeof number, "%d", node->number);
    if (node->number != 0) {
        fprintf(out,
                "<rect class=\"badge\" x=\"%d\" y=\"%d\" width=\"20\" height=\"14\" "
                "rx=\"7\"/>\n",
                node->x - 1, top - 9);
        label(out, "number", node->x + 9, top + 2, number);
    }
    if (!is_block && node->kind == GLINT_DRAW_PIN && node->text != NULL)
        label(out, "name", node->x + 10, top - 3 - shadow, node->text);
    if (node->control != NULL) {
        fprintf(out, "<path class=\"bit\" d=\"M%d %dv-9\"/>\n", middle + 6, top - shadow);
        label(out, "control", middle + 9, top - 4 - shadow, node->control);
    }
    fprintf(out, "</g>\n");
}

/* ---- The whole ------------------------------------------------------------------------------- */

/* Where the setting begins, after the title: long titles average less than 10 a letter, short ones
 * more. */
static int setting_left(const glint_draw_graph *graph)
{
    const int length = glint_draw_length(graph->setting->circuit->title);
    return 20 + (length > 20 ? length * 10 : length * 8 + 40);
}

/* Of the drawing, or of the line above it where that is wider. */
static int page_width(const glint_draw_graph *graph, const glint_draw_layout *layout)
{
    char text[GLINT_SETTING_TEXT];
    glint_setting_describe(graph->setting, text);
    const int line = setting_left(graph) + glint_draw_length(text) * 7 + 20;
    return line > layout->width ? line : layout->width;
}

/* The clock, resets and enables go everywhere, so they are named, not drawn. */
static void write_notes(const glint_draw_graph *graph, const glint_draw_layout *layout, FILE *out)
{
    const glint_setting *setting = graph->setting;
    char text[GLINT_SETTING_TEXT];
    bool any = setting->circuit->clock_port != NULL, stacked = false;
    label(out, "title", 20, 24, setting->circuit->title);
    glint_setting_describe(setting, text);
    label(out, "note", setting_left(graph), 24, text);
    fprintf(out, "<text class=\"note\" x=\"20\" y=\"%d\">", layout->height - 8);
    if (any)
        fprintf(out, "not drawn: %s", setting->circuit->clock_port);
    for (int i = 0; i < glint_setting_pin_count(setting); i++) {
        const glint_pin_info pin = glint_setting_pin(setting, i);
        if (pin.role != GLINT_PIN_RESET && pin.role != GLINT_PIN_RESET_LOW &&
            pin.role != GLINT_PIN_ENABLE && pin.role != GLINT_PIN_ENABLE_LOW)
            continue;
        fprintf(out, "%s%s", any ? ", " : "not drawn: ", pin.name);
        any = true;
    }
    for (int i = 0; i < graph->count; i++)
        stacked |= graph->node[i].is_stacked;
    if (stacked)
        fprintf(out, "%sdouble outline: several alike", any ? "; " : "");
    fprintf(out, "</text>\n");
}

/* The clock edges of a pipeline; a circuit that takes several clocks per input has no stages. */
static void write_cuts(const glint_draw_graph *graph, const glint_draw_layout *layout, FILE *out)
{
    if (glint_setting_pace(graph->setting) > 1)
        return;
    for (int s = 1; s <= graph->stages; s++) {
        const int x = layout->middle[graph->stage_column[s]];
        char text[32];
        (void)snprintf(text, sizeof text, "edge %d", s);
        fprintf(out, "<path class=\"cut\" d=\"M%d 50V%d\"/>\n", x, layout->height - 24);
        label(out, "edge", x, 46, text);
    }
}

void glint_draw_write_svg(const glint_draw_graph *graph, const glint_draw_layout *layout, FILE *out)
{
    const int width = page_width(graph, layout);
    fprintf(out,
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%d\" height=\"%d\" "
            "viewBox=\"0 0 %d %d\">\n<title>",
            width, layout->height, width, layout->height);
    write_text(out, graph->setting->circuit->title);
    fprintf(out, "</title>\n<style>\n%s</style>\n", style);
    fprintf(out, "<rect width=\"100%%\" height=\"100%%\" fill=\"#ffffff\"/>\n");
    write_notes(graph, layout, out);
    write_cuts(graph, layout, out);
    for (int i = 0; i < graph->count; i++)
        glint_draw_write_net(graph, layout, i, out);
    for (int i = 0; i < graph->count; i++)
        write_format(&graph->node[i], out);
    for (int i = 0; i < graph->count; i++)
        write_node(&graph->node[i], out);
    fprintf(out, "</svg>\n");
}
