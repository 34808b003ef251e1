/* A table of cells; the first row whose beginning fits is a cell's. */
#include "compare/cells.h"

#include <string.h>

typedef enum resource { NOTHING, LUT, FF, DSP, BRAM } resource;

/* flow: its beginning, "" for all; cell: the beginning of a name. each: what one counts as. */
static const struct row {
    const char *flow, *cell;
    resource resource;
    double each;
} rows[] = {
    {"", "$scopeinfo", NOTHING, 0},
    {"xilinx", "LUT", LUT, 1},
    {"xilinx", "SRL", LUT, 1},
    {"xilinx", "FD", FF, 1},
    {"xilinx", "DSP48E1", DSP, 1},
    {"xilinx", "RAMB18E1", BRAM, 0.5}, /* of a RAMB36 */
    {"xilinx", "RAMB36E1", BRAM, 1},
    {"xilinx", "CARRY4", NOTHING, 0}, /* beside the tables that feed it */
    {"xilinx", "MUXF", NOTHING, 0},
    {"xilinx", "INV", NOTHING, 0}, /* goes into a table */
    {"ecp5", "LUT4", LUT, 1},
    {"ecp5", "CCU2C", LUT, 2},
    {"ecp5", "PFUMX", NOTHING, 0},
    {"ecp5", "L6MUX21", NOTHING, 0},
    {"ecp5", "TRELLIS_FF", FF, 1},
    {"ecp5", "MULT18X18D", DSP, 1},
    {"ecp5", "DP16KD", BRAM, 1},
    {"ecp5", "PDPW16KD", BRAM, 1},
    {"ice40", "SB_LUT4", LUT, 1},
    {"ice40", "SB_CARRY", NOTHING, 0}, /* beside a table */
    {"ice40", "SB_DFF", FF, 1},
    {"ice40", "SB_MAC16", DSP, 1},
    {"ice40", "SB_RAM40_4K", BRAM, 1},
    {"gowin", "LUT", LUT, 1},
    {"gowin", "ALU", LUT, 1},
    {"gowin", "INV", LUT, 1},
    {"gowin", "MUX2_LUT", NOTHING, 0},
    {"gowin", "DFF", FF, 1},
    {"gowin", "MULT9X9", DSP, 0.5}, /* of an 18 by 18 */
    {"gowin", "MULT18X18", DSP, 1},
    {"gowin", "MULT36X36", DSP, 4},
    {"gowin", "SP", BRAM, 1},
    {"gowin", "pROM", BRAM, 1},
    {"gowin", "DP", BRAM, 1},
    {"gowin", "SDP", BRAM, 1},
    {"gowin", "GND", NOTHING, 0},
    {"gowin", "VCC", NOTHING, 0},
    {"cyclonev", "MISTRAL_ALUT", LUT, 1},
    {"cyclonev", "MISTRAL_NOT", NOTHING, 0},
    {"cyclonev", "MISTRAL_FF", FF, 1},
    {"cyclonev", "MISTRAL_MUL27X27", DSP, 1},
    {"cyclonev", "MISTRAL_MUL18X18", DSP, 0.5}, /* two to a block */
    {"cyclonev", "MISTRAL_MUL9X9", DSP, 1.0 / 3},
    {"cyclonev", "MISTRAL_M10K", BRAM, 1},
};

static int begins(const char *text, const char *with)
{
    return strncmp(text, with, strlen(with)) == 0;
}

static const struct row *row_of(const char *flow, const char *cell)
{
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++)
        if (begins(flow, rows[i].flow) && begins(cell, rows[i].cell))
            return &rows[i];
    return NULL;
}

static void add(glint_compare_cells *cells, resource resource, double count)
{
    if (resource == LUT)
        cells->lut += count;
    else if (resource == FF)
        cells->ff += count;
    else if (resource == DSP)
        cells->dsp += count;
    else if (resource == BRAM)
        cells->bram += count;
}

glint_status glint_compare_count(const char *flow, const json_t *by_type,
                                 glint_compare_cells *cells, glint_error *err)
{
    const char *cell;
    json_t *count;
    *cells = (glint_compare_cells){0};
    if (!json_is_object(by_type))
        return glint_fail(err, GLINT_BAD_INPUT, "%s: no table of cells", flow);
    json_object_foreach((json_t *)by_type, cell, count)
    {
        const struct row *row = row_of(flow, cell);
        if (row == NULL)
            return glint_fail(err, GLINT_BAD_INPUT, "%s: unknown cell %s", flow, cell);
        add(cells, row->resource, row->each * json_number_value(count));
    }
    return GLINT_OK;
}
