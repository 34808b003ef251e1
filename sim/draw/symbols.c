/* Sizes and texts of a drawing's symbols; see layout.h. */
#include "draw/layout.h"

int glint_draw_length(const char *text)
{
    int length = 0;
    for (; *text != '\0'; text++)
        length += ((unsigned char)*text & 0xc0u) != 0x80u; /* counts no continuation byte */
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

void glint_draw_size(glint_draw_node *node)
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
        node->width = length * GLINT_DRAW_SANS + 18;
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
    if (node->height < node->input_count * GLINT_DRAW_PITCH)
        node->height = node->input_count * GLINT_DRAW_PITCH;
}

int glint_draw_input_height(const glint_draw_node *node, int i)
{
    return node->y + (2 * i + 1 - node->input_count) * GLINT_DRAW_PITCH / 2;
}
