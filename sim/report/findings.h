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

/* What a claim says of a number. */
typedef enum glint_rule {
    GLINT_AT_MOST,
    GLINT_BELOW,
    GLINT_AT_LEAST,
    GLINT_ABOVE,
    GLINT_ROUNDS_TO, /* a plain number: the measured one rounds to it, with so many decimals */
    GLINT_REACHES,   /* a gain (times faster, times smaller): rounded so, it is no smaller */
    GLINT_RULE_COUNT
} glint_rule;

/* A claim's number and the measured one, in the same unit: all that a verdict comes from. */
typedef struct glint_judged {
    glint_rule rule;
    double stated;
    int decimals; /* that the thesis prints; for the last two rules */
    /* What was measured lies between these: alike for one number; apart for what was timed, or for
     * a claim that can be read in several ways; not a number: nothing was measured. */
    double lowest, highest;
    bool circular; /* it was computed from the stated number: it can contradict that, not prove it
                    */
} glint_judged;

/* One number. */
glint_judged glint_judged_number(glint_rule rule, double stated, int decimals, double measured);

glint_verdict glint_judge(const glint_judged *judged);

/* "holds" and so on. */
extern const char *const glint_verdict_names[GLINT_VERDICT_COUNT];

/* The rules of the verdicts, in words for the report's introduction. */
extern const char glint_verdict_rules[];

/* One line of Markdown each, without "|". */
typedef struct glint_finding {
    glint_judged judged;
    glint_verdict verdict; /* glint_judge() of it */
    char where[48];        /* "2.3", "(2.26)", "Table 3.2" */
    char claim[256];       /* as the thesis has it, in English */
    char measured[384];    /* the number */
    char conditions[512];  /* the range of n, the pixels, the scene… it was measured under */
} glint_finding;

typedef struct glint_findings glint_findings;

glint_findings *glint_findings_create(void); /* NULL: no memory */
void glint_findings_destroy(glint_findings *findings);

/* Adds one with the verdict that its numbers give; claim, measured and conditions are for the
 * caller to print into. Never NULL: where there is no memory one that counts for nothing comes
 * back, and glint_findings_complete() is false from then on. */
glint_finding *glint_findings_add(glint_findings *findings, const char *where,
                                  const glint_judged *judged);
bool glint_findings_complete(const glint_findings *findings);

int glint_findings_count(const glint_findings *findings, glint_verdict verdict);

/* Number `index` in the order they were added; NULL: there are no more. */
const glint_finding *glint_findings_get(const glint_findings *findings, int index);

/* A table: where, claim, verdict, number, conditions. */
void glint_findings_write(const glint_findings *findings, FILE *markdown);
/* One line each, as a terminal shows them. */
void glint_findings_print(const glint_findings *findings, FILE *out);
/* The same with the numbers that each verdict comes from; NULL: no memory. */
cJSON *glint_findings_json(const glint_findings *findings);

#endif
