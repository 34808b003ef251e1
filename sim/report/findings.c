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

static const char *const texts[GLINT_VERDICT_COUNT] = {
    [GLINT_HOLDS] = "holds",
    [GLINT_DOES_NOT_HOLD] = "does not hold",
    [GLINT_CANNOT_BE_DECIDED] = "cannot be decided",
};

const char glint_verdict_rules[] =
    "A claim of *at most* holds when the measured number is no larger; a gain (so many times "
    "faster, smaller or more\naccurate, so many per cent less time) when the measured one, rounded "
    "as the thesis prints it, is no smaller;\nany other number when the measured one rounds to "
    "it. What was timed cannot be decided where the measurements\nlie on both sides.";

/* Half of the last decimal, and what doubles make of it. */
static double tolerance_of(int decimals)
{
    return 0.5 * pow(10.0, -decimals) * (1.0 + 1e-9);
}

bool glint_rounds_to(double measured, double stated, int decimals)
{
    return fabs(measured - stated) <= tolerance_of(decimals);
}

bool glint_reaches(double measured, double stated, int decimals)
{
    return measured >= stated - tolerance_of(decimals);
}

glint_verdict glint_verdict_of_gain(double lowest, double highest, double stated, int decimals)
{
    return glint_reaches(lowest, stated, decimals)    ? GLINT_HOLDS
           : glint_reaches(highest, stated, decimals) ? GLINT_CANNOT_BE_DECIDED
                                                      : GLINT_DOES_NOT_HOLD;
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

glint_finding *glint_findings_add(glint_findings *findings, glint_verdict verdict,
                                  const char *where)
{
    glint_finding *added = &findings->lost;
    if (make_room(findings))
        added = &findings->finding[findings->count++];
    else
        findings->incomplete = true;
    memset(added, 0, sizeof *added);
    added->verdict = verdict;
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

void glint_findings_write(const glint_findings *findings, FILE *markdown)
{
    fputs("| where | the thesis says | | measured | conditions |\n|---|---|---|---|---|\n",
          markdown);
    for (int i = 0; i < findings->count; i++) {
        const glint_finding *finding = &findings->finding[i];
        fprintf(markdown, "| %s | %s | **%s** | %s | %s |\n", finding->where, finding->claim,
                texts[finding->verdict], finding->measured, finding->conditions);
    }
}

void glint_findings_print(const glint_findings *findings, FILE *out)
{
    for (int i = 0; i < findings->count; i++) {
        const glint_finding *finding = &findings->finding[i];
        fprintf(out, "%-18s %s: %s; measured: %s\n", texts[finding->verdict], finding->where,
                finding->claim, finding->measured);
    }
}

static cJSON *json_of(const glint_finding *finding)
{
    cJSON *object = cJSON_CreateObject();
    const bool whole =
        object != NULL && cJSON_AddStringToObject(object, "where", finding->where) != NULL &&
        cJSON_AddStringToObject(object, "claim", finding->claim) != NULL &&
        cJSON_AddStringToObject(object, "verdict", texts[finding->verdict]) != NULL &&
        cJSON_AddStringToObject(object, "measured", finding->measured) != NULL &&
        cJSON_AddStringToObject(object, "conditions", finding->conditions) != NULL;
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
