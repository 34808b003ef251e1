#include "report/findings.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

struct glint_findings {
    glint_finding *finding;
    int count, room;
    bool incomplete;
    glint_finding lost; /* takes what there was no memory for */
};

const char *const glint_verdict_names[GLINT_VERDICT_COUNT] = {
    [GLINT_HOLDS] = "holds",
    [GLINT_DOES_NOT_HOLD] = "does not hold",
    [GLINT_CANNOT_BE_DECIDED] = "cannot be decided",
};

static const char *const rule_names[GLINT_RULE_COUNT] = {
    [GLINT_AT_MOST] = "at most", [GLINT_BELOW] = "below",         [GLINT_AT_LEAST] = "at least",
    [GLINT_ABOVE] = "above",     [GLINT_ROUNDS_TO] = "rounds to", [GLINT_REACHES] = "reaches",
};

const char glint_verdict_rules[] =
    "A claim of *at most* holds when the measured number is no larger, one of *below* when it is "
    "smaller; a gain (so many times\nfaster, smaller or more accurate, so many per cent more) when "
    "the measured one, rounded as the thesis prints it, is no smaller;\nany other number when the "
    "measured one rounds to it. Where the measurement is a range (what was timed, or a claim that "
    "can\nbe read in several ways), the claim holds when all of the range keeps the rule, does not "
    "when none of it does, else it cannot be\ndecided. A number that was computed from the stated "
    "one can contradict it, not prove it: when it does not contradict, the\nclaim cannot be "
    "decided either.";

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

/* A range may lie about a number with neither end near it. */
static bool spans(const glint_judged *judged)
{
    return judged->rule == GLINT_ROUNDS_TO && judged->lowest < judged->stated &&
           judged->highest > judged->stated;
}

glint_judged glint_judged_number(glint_rule rule, double stated, int decimals, double measured)
{
    return (glint_judged){.rule = rule,
                          .stated = stated,
                          .decimals = decimals,
                          .lowest = measured,
                          .highest = measured};
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

glint_findings *glint_findings_create(void)
{
    return calloc(1, sizeof(glint_findings));
}

void glint_findings_destroy(glint_findings *findings)
{
    if (findings == NULL)
        return;
    free(findings->finding);
    free(findings);
}

static bool make_room(glint_findings *findings)
{
    if (findings->count < findings->room)
        return true;
    const int room = findings->room + 64;
    glint_finding *larger = realloc(findings->finding, (size_t)room * sizeof *findings->finding);
    if (larger == NULL)
        return false;
    findings->finding = larger;
    findings->room = room;
    return true;
}

glint_finding *glint_findings_add(glint_findings *findings, const char *where,
                                  const glint_judged *judged)
{
    glint_finding *added = &findings->lost;
    if (make_room(findings))
        added = &findings->finding[findings->count++];
    else
        findings->incomplete = true;
    memset(added, 0, sizeof *added);
    added->judged = *judged;
    added->verdict = glint_judge(judged);
    snprintf(added->where, sizeof added->where, "%s", where);
    return added;
}

bool glint_findings_complete(const glint_findings *findings)
{
    return !findings->incomplete;
}

int glint_findings_count(const glint_findings *findings, glint_verdict verdict)
{
    int count = 0;
    for (int i = 0; i < findings->count; i++)
        count += findings->finding[i].verdict == verdict;
    return count;
}

const glint_finding *glint_findings_get(const glint_findings *findings, int index)
{
    return index >= 0 && index < findings->count ? &findings->finding[index] : NULL;
}

void glint_findings_write(const glint_findings *findings, FILE *markdown)
{
    fputs("| where | the thesis says | | measured | conditions |\n|---|---|---|---|---|\n",
          markdown);
    for (int i = 0; i < findings->count; i++) {
        const glint_finding *finding = &findings->finding[i];
        fprintf(markdown, "| %s | %s | **%s** | %s | %s |\n", finding->where, finding->claim,
                glint_verdict_names[finding->verdict], finding->measured, finding->conditions);
    }
}

void glint_findings_print(const glint_findings *findings, FILE *out)
{
    for (int i = 0; i < findings->count; i++) {
        const glint_finding *finding = &findings->finding[i];
        fprintf(out, "%-18s %s: %s; measured: %s\n", glint_verdict_names[finding->verdict],
                finding->where, finding->claim, finding->measured);
    }
}

/* An infinite number or none is null. */
static bool add_number(cJSON *object, const char *name, double number)
{
    return isfinite(number) ? cJSON_AddNumberToObject(object, name, number) != NULL
                            : cJSON_AddNullToObject(object, name) != NULL;
}

static bool add_judged(cJSON *object, const glint_judged *judged)
{
    return cJSON_AddStringToObject(object, "rule", rule_names[judged->rule]) != NULL &&
           add_number(object, "stated", judged->stated) &&
           add_number(object, "decimals", judged->decimals) &&
           add_number(object, "lowest", judged->lowest) &&
           add_number(object, "highest", judged->highest) &&
           cJSON_AddBoolToObject(object, "circular", judged->circular) != NULL;
}

static cJSON *json_of(const glint_finding *finding)
{
    cJSON *object = cJSON_CreateObject();
    const bool whole =
        object != NULL && cJSON_AddStringToObject(object, "where", finding->where) != NULL &&
        cJSON_AddStringToObject(object, "claim", finding->claim) != NULL &&
        cJSON_AddStringToObject(object, "verdict", glint_verdict_names[finding->verdict]) != NULL &&
        cJSON_AddStringToObject(object, "measured", finding->measured) != NULL &&
        cJSON_AddStringToObject(object, "conditions", finding->conditions) != NULL &&
        add_judged(object, &finding->judged);
    if (whole)
        return object;
    cJSON_Delete(object);
    return NULL;
}

cJSON *glint_findings_json(const glint_findings *findings)
{
    cJSON *list = cJSON_CreateArray();
    for (int i = 0; list != NULL && i < findings->count; i++) {
        cJSON *object = json_of(&findings->finding[i]);
        if (object == NULL || !cJSON_AddItemToArray(list, object)) {
            cJSON_Delete(object);
            cJSON_Delete(list);
            return NULL;
        }
    }
    return list;
}
