/* Cells of a netlist as the resources that a data sheet counts. */
#ifndef GLINT_SIM_COMPARE_CELLS_H
#define GLINT_SIM_COMPARE_CELLS_H

#include <jansson.h>

#include "glint_status.h"

/* One setting's use of a family. A carry cell counts as the look-up tables that it takes up. */
typedef struct glint_compare_cells {
    double lut, ff, dsp, bram;
} glint_compare_cells;

/* flow: as in recipe.sh; by_type: Yosys's num_cells_by_type. GLINT_BAD_INPUT, naming it, for a cell
 * that is not known, so that none is ever left out of a count. */
glint_status glint_compare_count(const char *flow, const json_t *by_type,
                                 glint_compare_cells *cells, glint_error *err);

#endif
