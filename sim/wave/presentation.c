#include "wave/presentation.h"

#include <stdio.h>
#include <string.h>

/* So many bits, one by one, have room in a clock of the view; of more GTKWave cuts off the last. */
#define BITS_OF_A_CLOCK 8

/* What a section holds: outputs, valid bits and the delayed colours, or blocks of the figure. */
typedef enum content { OUTPUTS, BLOCKS, VALID_BITS, DELAYED_COLORS } content;

static const struct {
    const char *title;
    content content;
    int blocks[4]; /* ended by 0 */
} sections[] = {
    {"Outputs", OUTPUTS, {0}},
    {"Register 1: cos", BLOCKS, {1}},
    {"Register 2, ROM 33", BLOCKS, {2, 33}},
    {"Blocks 6, 7, 8: t", BLOCKS, {6, 7, 8}},
    {"ROM 9, comparator 11", BLOCKS, {9, 11}},
    {"Blocks 10, 12: W", BLOCKS, {10, 12}},
    {"Registers 3, 4, 5", BLOCKS, {3, 4, 5}},
    {"Multipliers 13-15", BLOCKS, {13, 14, 15}},
    {"Valid bits", VALID_BITS, {0}},
    {"R, G, B, stages 2, 3", DELAYED_COLORS, {0}},
};

int glint_show_specular_sections(void)
{
    return (int)(sizeof sections / sizeof sections[0]);
}

static content content_of(const glint_signal_info *signal)
{
    if (signal->kind == GLINT_SIGNAL_OUTPUT)
        return OUTPUTS;
    if (signal->kind != GLINT_SIGNAL_STAGE)
        return BLOCKS;
    if (signal->block == 0)
        return VALID_BITS;
    return signal->block >= 3 && signal->block <= 5 ? DELAYED_COLORS : BLOCKS;
}

static bool has_block(int section, int block)
{
    for (int i = 0; sections[section].blocks[i] != 0; i++)
        if (sections[section].blocks[i] == block)
            return true;
    return false;
}

int glint_show_specular_section(const glint_signal_info *signal)
{
    const content content = content_of(signal);
    int section = 0;
    while (sections[section].content != content ||
           (content == BLOCKS && !has_block(section, signal->block)))
        section++;
    return section;
}

const char *glint_show_specular_title(int section)
{
    return sections[section].title;
}

bool glint_show_specular_folded(int section)
{
    return sections[section].content == DELAYED_COLORS;
}

/* A divider's heading stands before the signal of that name. */
static const struct {
    const char *signal, *title;
} divider_titles[] = {
    {"busy", "Under way"},
    {"rom_bits", "Table: bits of 1/k"},
    {"bits_rg", "Bits still to come"},
    {"shift_rg", "Shift register"},
    {"term", "Accumulating adder"},
    {"done", "Outputs"},
    {"s0_valid", "Input registers"},
    {"out_valid", "Outputs"},
};

static const char *title_before(const char *signal)
{
    for (size_t i = 0; i < sizeof divider_titles / sizeof divider_titles[0]; i++)
        if (strcmp(divider_titles[i].signal, signal) == 0)
            return divider_titles[i].title;
    return NULL;
}

bool glint_show_divider_begins(glint_divider_form form, int shifts, int index)
{
    return title_before(glint_divider_signal_info(form, shifts, index).name) != NULL;
}

/* The first signal of each form begins one. */
const char *glint_show_divider_title(glint_divider_form form, int shifts, int index)
{
    while (!glint_show_divider_begins(form, shifts, index))
        index--;
    return title_before(glint_divider_signal_info(form, shifts, index).name);
}

void glint_show_label(const glint_signal_info *signal, const char *place, const char *ending,
                      char label[GLINT_SHOW_LABEL])
{
    if (place != NULL && signal->lane >= 0)
        (void)snprintf(label, GLINT_SHOW_LABEL, "%s%d %s%s", place, signal->lane, signal->name,
                       ending);
    else
        (void)snprintf(label, GLINT_SHOW_LABEL, "%s%s", signal->name, ending);
}

/* Single bits; valid bits, one a lane; the bits of the dividers' table, which their names tell. */
static bool is_bits(const glint_signal_info *signal)
{
    const bool is_valid = strstr(signal->name, "valid") != NULL;
    return signal->int_bits + signal->frac_bits == 1 || is_valid ||
           strstr(signal->name, "bits") != NULL;
}

unsigned glint_show_number(const glint_signal_info *signal)
{
    return signal->is_signed ? GLINT_GTKW_SHOW_SIGNED
           : is_bits(signal) ? GLINT_GTKW_SHOW_BINARY
                             : GLINT_GTKW_SHOW_DECIMAL;
}

unsigned glint_show_code(const glint_signal_info *signal)
{
    const bool is_long = is_bits(signal) && signal->int_bits > BITS_OF_A_CLOCK;
    return signal->frac_bits > 0 || is_long ? GLINT_GTKW_SHOW_HEX : glint_show_number(signal);
}

int glint_show_color(const glint_signal_info *signal)
{
    return signal->kind == GLINT_SIGNAL_STAGE    ? GLINT_GTKW_COLOR_ORANGE
           : signal->kind == GLINT_SIGNAL_OUTPUT ? GLINT_GTKW_COLOR_YELLOW
                                                 : GLINT_GTKW_COLOR_NORMAL;
}

bool glint_show_curve(const glint_signal_info *signal)
{
    return strcmp(signal->name, "out_r") == 0 && signal->int_bits == GLINT_COLOR_BITS;
}
