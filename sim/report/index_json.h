/* index.json: every claim with the numbers behind its verdict, and every number by name. The only
 * part of the report that uses the JSON library. */
#ifndef GLINT_SIM_REPORT_INDEX_JSON_H
#define GLINT_SIM_REPORT_INDEX_JSON_H

#include "report/claims.h"

/* To be freed with free(); NULL: no memory. */
char *glint_index_json(const glint_claims *claims, const glint_numbers *numbers);

#endif
