/* The rules of the verdicts; text/head.md has them in words. */
#include "report/verdict.h"

#include <math.h>

const char *const glint_verdict_names[GLINT_VERDICT_COUNT] = {
    [GLINT_HOLDS] = "holds",
    [GLINT_DOES_NOT_HOLD] = "does not hold",
    [GLINT_CANNOT_BE_DECIDED] = "cannot be decided",
};

const char *const glint_rule_names[GLINT_RULE_COUNT] = {
    [GLINT_AT_MOST] = "at most", [GLINT_BELOW] = "below",         [GLINT_AT_LEAST] = "at least",
    [GLINT_ABOVE] = "above",     [GLINT_ROUNDS_TO] = "rounds to", [GLINT_REACHES] = "reaches",
};

/* Half of the last decimal, and what doubles make of it. */
static double tolerance_of(int decimals)
{
    return 0.5 * pow(10.0, -decimals) * (1.0 + 1e-9);
}

static bool keeps(const glint_judged *judged, double measured)
{
    const double stated = judged->stated;
    switch (judged->rule) {
    case GLINT_AT_MOST:
        return measured <= stated;
    case GLINT_BELOW:
        return measured < stated;
    case GLINT_AT_LEAST:
        return measured >= stated;
    case GLINT_ABOVE:
        return measured > stated;
    case GLINT_ROUNDS_TO:
        return fabs(measured - stated) <= tolerance_of(judged->decimals);
    case GLINT_REACHES:
        return measured >= stated - tolerance_of(judged->decimals);
    default:
        return false;
    }
}

/* A range may enclose a number with neither end near it. */
static bool spans(const glint_judged *judged)
{
    return judged->rule == GLINT_ROUNDS_TO && judged->lowest < judged->stated &&
           judged->highest > judged->stated;
}

glint_verdict glint_judge(const glint_judged *judged)
{
    const bool lowest = keeps(judged, judged->lowest), highest = keeps(judged, judged->highest);
    if (isnan(judged->lowest) || isnan(judged->highest))
        return GLINT_CANNOT_BE_DECIDED;
    if (lowest && highest)
        return judged->circular ? GLINT_CANNOT_BE_DECIDED : GLINT_HOLDS;
    return lowest || highest || spans(judged) ? GLINT_CANNOT_BE_DECIDED : GLINT_DOES_NOT_HOLD;
}
