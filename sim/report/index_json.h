/* index.json: every claim with the numbers that its verdict follows from, and every number by name.
 * All of the report that knows the JSON library. */
#ifndef GLINT_SIM_REPORT_INDEX_JSON_H
#define GLINT_SIM_REPORT_INDEX_JSON_H

#include "report/claims.h"

/* To be freed with free(); NULL: no memory. */
char *glint_index_json(const glint_claims *claims, const glint_numbers *numbers);

#endif
