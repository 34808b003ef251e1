/* Numbers of the thesis's section 2.4 beside the measured ones. */
#ifndef GLINT_SIM_REPORT_CLAIMS_H
#define GLINT_SIM_REPORT_CLAIMS_H

#include "report/divider_error.h"
#include "report/divider_frames.h"
#include "report/findings.h"

/* Clocks of an operation on the thesis's processor. The thesis gives none: these are inferred, as
 * the least whole ones with which both of its totals come out. */
#define GLINT_CLOCKS_ADDITION           3
#define GLINT_CLOCKS_DIVISION           41
#define GLINT_CLOCKS_DIVISION_BY_SHIFTS 20

/* Those totals. */
#define GLINT_CLOCKS_STATED_DIVISION  2946
#define GLINT_CLOCKS_STATED_BY_SHIFTS 2064

/* What Table 2.1 has. */
extern const glint_span_operations glint_table_21_stated;

glint_operations glint_operations_total(const glint_span_operations *operations);
uint64_t glint_operations_clocks(glint_operations operations, uint64_t clocks_of_a_division);

typedef struct glint_claim {
    char what[160];
    glint_judged judged;
    glint_verdict verdict; /* glint_judge() of it */
    char note[160];        /* under what conditions, or why not */
} glint_claim;

#define GLINT_CLAIMS_MAX 32

typedef struct glint_claims {
    int count;
    glint_claim claim[GLINT_CLAIMS_MAX];
} glint_claims;

/* What the claims are measured by. */
typedef struct glint_claims_facts {
    glint_divider_example example;
    const glint_divider_error *error; /* bits rounded, from GLINT_DIVIDER_SHIFTS_MIN on */
    const glint_table_21 *table;
    const glint_divider_scene *scenes; /* GLINT_DIVIDER_SCENES */
} glint_claims_facts;

/* From the facts alone. */
void glint_claims_check(const glint_claims_facts *facts, glint_claims *claims);

#endif
