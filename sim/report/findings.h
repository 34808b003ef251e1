/* What the thesis claims, each with what was measured and whether it holds. */
#ifndef GLINT_SIM_REPORT_FINDINGS_H
#define GLINT_SIM_REPORT_FINDINGS_H

#include <stdbool.h>
#include <stdio.h>

#include <cjson/cJSON.h>

typedef enum glint_verdict {
    GLINT_HOLDS,
    GLINT_DOES_NOT_HOLD,
    GLINT_CANNOT_BE_DECIDED, /* as stated: what it says is not enough to measure it by, or what was
                                measured lies on both sides of it */
    GLINT_VERDICT_COUNT
} glint_verdict;

/* The rules of the verdicts, in words for the report's introduction. */
extern const char glint_verdict_rules[];

/* A plain number: whether the measured one rounds to it, with so many decimals. */
bool glint_rounds_to(double measured, double stated, int decimals);

/* A gain (times faster, times smaller, per cent less): whether the measured one, rounded to so many
 * decimals, is no smaller. */
bool glint_reaches(double measured, double stated, int decimals);

/* The same of a gain measured between lowest and highest. */
glint_verdict glint_verdict_of_gain(double lowest, double highest, double stated, int decimals);

/* One line of Markdown each, without "|". */
typedef struct glint_finding {
    glint_verdict verdict;
    char where[48];       /* "2.3", "(2.26)", "Table 3.2" */
    char claim[256];      /* as the thesis has it, in English */
    char measured[320];   /* the number */
    char conditions[384]; /* the range of n, the pixels, the scene… it was measured under */
} glint_finding;

typedef struct glint_findings glint_findings;

glint_findings *glint_findings_create(void); /* NULL: no memory */
void glint_findings_destroy(glint_findings *findings);

/* Adds one; claim, measured and conditions are for the caller to print into. Never NULL: where
 * there is no memory one that counts for nothing comes back, and glint_findings_complete() is
 * false from then on. */
glint_finding *glint_findings_add(glint_findings *findings, glint_verdict verdict,
                                  const char *where);
bool glint_findings_complete(const glint_findings *findings);

int glint_findings_count(const glint_findings *findings, glint_verdict verdict);

/* A table: where, claim, verdict, number, conditions. */
void glint_findings_write(const glint_findings *findings, FILE *markdown);
/* One line each, as a terminal shows them. */
void glint_findings_print(const glint_findings *findings, FILE *out);
cJSON *glint_findings_json(const glint_findings *findings); /* NULL: no memory */

#endif
