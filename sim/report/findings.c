#include "report/findings.h"

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
