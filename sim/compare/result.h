/* What one result file of make compare says (job.sh writes them). */
#ifndef GLINT_SIM_COMPARE_RESULT_H
#define GLINT_SIM_COMPARE_RESULT_H

#include <stdbool.h>

#include <jansson.h>

#include "compare/cells.h"

typedef struct glint_compare_result {
    char unit[160], kind[16], flow[16], tools[160];
    int seed;
    /* errors: 1/255, and the largest NMSE with its n */
    double power_steps, own_steps, nmse, nmse_n, points;
    /* size, debian; of flow cells instead: NAND2 equivalents, mm², MHz */
    glint_compare_cells cells;
    double gates, mm2;
    /* clock, and flow cells; 0 with unplaced */
    double mhz;
    bool unplaced; /* does not fit the chip */
} glint_compare_result;

/* GLINT_BAD_INPUT for another shape; the message does not name the file. */
glint_status glint_compare_result_read(const json_t *json, glint_compare_result *result,
                                       glint_error *err);

#endif
