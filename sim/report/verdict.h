/* Whether a claim holds: a rule, the stated number and the measured one decide, nothing else. */
#ifndef GLINT_SIM_REPORT_VERDICT_H
#define GLINT_SIM_REPORT_VERDICT_H

#include <stdbool.h>

typedef enum glint_verdict {
    GLINT_HOLDS,
    GLINT_DOES_NOT_HOLD,
    GLINT_CANNOT_BE_DECIDED, /* as stated: what it says is not enough to measure it by, or what was
                                measured lies on both sides of it */
    GLINT_VERDICT_COUNT
} glint_verdict;

/* "holds" and so on. */
extern const char *const glint_verdict_names[GLINT_VERDICT_COUNT];

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

/* "at most" and so on. */
extern const char *const glint_rule_names[GLINT_RULE_COUNT];

/* A claim's number and the measured one, in the same unit. */
typedef struct glint_judged {
    glint_rule rule;
    double stated;
    int decimals;           /* that the thesis prints; for the last two rules */
    double lowest, highest; /* as in glint_number */
    bool circular; /* measured by the stated number: it can contradict that, not prove it */
} glint_judged;

glint_verdict glint_judge(const glint_judged *judged);

#endif
