/* Every number of the thesis's section 2.4 beside the one measured. */
#ifndef GLINT_SIM_REPORT_CLAIMS_H
#define GLINT_SIM_REPORT_CLAIMS_H

#include "report/divider_frames.h"

/* Clocks of an operation on the thesis's processor. The thesis gives none: these are inferred, as
 * the ones with which both of its totals come out. */
#define GLINT_CLOCKS_ADDITION           3
#define GLINT_CLOCKS_DIVISION           41
#define GLINT_CLOCKS_DIVISION_BY_SHIFTS 20

/* What Table 2.1 has. */
extern const glint_span_operations glint_table_21_stated;

glint_operations glint_operations_total(const glint_span_operations *operations);
uint64_t glint_operations_clocks(glint_operations operations, uint64_t clocks_of_a_division);

typedef struct glint_claim {
    const char *what;
    double stated;
    int decimals; /* that the thesis prints: the claim holds when the measured number rounds so */
    bool at_most; /* instead: the claim holds when the measured number is no larger */
    double measured;
    bool undecided;   /* what was measured rests on the stated number itself */
    bool holds;       /* false where it is undecided */
    const char *note; /* under what conditions, or why not */
} glint_claim;

#define GLINT_CLAIMS_MAX 32

typedef struct glint_claims {
    int count;
    glint_claim claim[GLINT_CLAIMS_MAX];
} glint_claims;

void glint_claims_check(const glint_table_21 *table,
                        const glint_divider_scene scenes[GLINT_DIVIDER_SCENES],
                        glint_claims *claims);

#endif
