/* The thesis's claims as one table (claim_table.c), and the verdicts on them from the measured
 * numbers. */
#ifndef GLINT_SIM_REPORT_CLAIMS_H
#define GLINT_SIM_REPORT_CLAIMS_H

#include <stdio.h>

#include "report/template.h"
#include "report/verdict.h"

/* The stated number's kind, relative to the measured one. */
typedef enum glint_claim_kind {
    GLINT_PLAIN,
    GLINT_PER_CENT, /* the measured number is a share: times 100 */
    GLINT_CIRCULAR, /* the measured number was computed from it: as in glint_judged */
    GLINT_NO_NUMBER /* not measured and cannot be decided; `measured` says why */
} glint_claim_kind;

typedef struct glint_claim {
    const char *chapter; /* where in the report it is measured: a chapter's name (chapter.h) */
    const char *where;   /* in the thesis: "2.3", "(2.26)", "Table 3.2" */
    const char *words;   /* what it says, in English */
    glint_rule rule;
    double stated;
    int decimals; /* that the thesis prints */
    glint_claim_kind kind;
    const char *number;   /* the measured number's name */
    const char *measured; /* a line of template.h: the number, and what it is of if that is not
                             what the chapter says of all its numbers */
} glint_claim;

extern const glint_claim glint_claim_table[];
extern const int glint_claim_count;

typedef struct glint_judgement {
    glint_judged judged;
    glint_verdict verdict;
    char measured[512];
} glint_judgement;

/* GLINT_BAD_ARGUMENT if the number it names was not measured. */
glint_status glint_claim_judge(const glint_claim *claim, const glint_numbers *numbers,
                               glint_judgement *judgement, glint_error *err);

/* The claims of the chapters that were measured, each with its verdict. */
typedef struct glint_claims {
    int count;
    struct {
        const glint_claim *claim;
        glint_judgement judgement;
    } * entry;
} glint_claims;

/* chapter: of that one alone; NULL: all. */
glint_status glint_claims_make(const glint_numbers *numbers, const char *chapter,
                               glint_claims *claims, glint_error *err);
void glint_claims_free(glint_claims *claims);

int glint_claims_count(const glint_claims *claims, glint_verdict verdict);

/* The numbers of a chapter's claims by verdict, each a link to its row in the table; one line. */
void glint_claims_write_links(const glint_claims *claims, const char *chapter, FILE *markdown);

/* The table: number, where, claim, verdict, what was measured. A chapter's claims stand together,
 * after a row with a link back to it. title_of: of a chapter by its name. */
void glint_claims_write_table(const glint_claims *claims, const char *(*title_of)(const char *name),
                              FILE *markdown);

/* One line each, for a terminal. */
void glint_claims_print(const glint_claims *claims, FILE *out);

#endif
