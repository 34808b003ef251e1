/* The report on the divider (divider_report.h) as a section of the whole. */
#include "report/sections.h"

#include <stdlib.h>

#include "report/divider_parts.h"

static void add_findings(glint_findings *findings, const glint_claims *claims)
{
    for (int i = 0; i < claims->count; i++) {
        const glint_claim *claim = &claims->claim[i];
        const glint_judged *judged = &claim->judged;
        glint_finding *finding = glint_findings_add(findings, "2.4", judged);
        snprintf(finding->claim, sizeof finding->claim, "%s: %.*f", claim->what, judged->decimals,
                 judged->stated);
        snprintf(finding->measured, sizeof finding->measured, "%.8g", judged->lowest);
        snprintf(finding->conditions, sizeof finding->conditions, "%s", claim->note);
    }
}

static glint_status write(glint_report *report, glint_divider_report *divider, glint_error *err)
{
    const glint_status status =
        glint_divider_report_make(report->directory, report->threads, report->stop, divider, err);
    if (status != GLINT_OK)
        return status;
    glint_divider_write_parts(report->markdown, divider, "###");
    add_findings(report->findings, &divider->claims);
    report->plotted = report->plotted && divider->plotted;
    cJSON *numbers = glint_divider_report_json(divider);
    if (numbers == NULL || !cJSON_AddItemToObject(report->numbers, "report", numbers)) {
        cJSON_Delete(numbers);
        return glint_fail(err, GLINT_NO_MEMORY, "no memory for the divider's numbers");
    }
    return GLINT_OK;
}

glint_status glint_section_divider(glint_report *report, glint_error *err)
{
    glint_divider_report *divider = calloc(1, sizeof *divider);
    if (divider == NULL)
        return glint_fail(err, GLINT_NO_MEMORY, "no memory for the report on the divider");
    const glint_status status = write(report, divider, err);
    free(divider);
    return status;
}
