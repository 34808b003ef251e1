/* The highlight units side by side: how far each is from cosⁿ and from its own formula, measured
 * here, and how large it is, out of docs/compare.csv (make compare). */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "compare/errors.h"
#include "compare/units.h"
#include "report/chapter.h"
#include "report/texts.h"

/* Codes of the cosine between two that are measured; every n is. */
enum { STRIDE = 256, STRIDE_QUICK = 8192 };

/* What a reader asks for: so much of an 8-bit step at most. */
static const struct {
    const char *name;
    double steps;
} accuracies[] = {{"half", 0.5}, {"quarter", 0.25}};

#define ACCURACIES ((int)(sizeof accuracies / sizeof accuracies[0]))

/* The unit with the fewest gates so far. */
typedef struct smallest {
    char label[GLINT_SETTING_TEXT];
    double gates;
} smallest;

/* ---- Sizes ----------------------------------------------------------------------------------- */

/* A row: unit,lanes,w_frac_bits,latency,kind,flow,"tools",quantity,value. NAN: there is none. */
static double size_of(const char *unit, const char *flow, const char *quantity)
{
    const size_t length = strlen(unit);
    char middle[64], end[64];
    snprintf(middle, sizeof middle, ",size,%s,\"", flow);
    snprintf(end, sizeof end, "\",%s,", quantity);
    for (const char *const *line = glint_text_compare; *line != NULL; line++) {
        if (strncmp(*line, unit, length) != 0 || (*line)[length] != ',')
            continue;
        const char *tools = strstr(*line, middle);
        const char *value = tools != NULL ? strstr(tools, end) : NULL;
        if (value != NULL)
            return strtod(value + strlen(end), NULL);
    }
    return NAN;
}

static void put_sizes(glint_numbers *numbers, const char *name, const char *unit)
{
    static const char *const resources[] = {"lut", "ff", "dsp", "bram"};
    glint_number_put(numbers, size_of(unit, "cells", "gates"), "units.%s.gates", name);
    for (size_t i = 0; i < sizeof resources / sizeof resources[0]; i++)
        glint_number_put(numbers, size_of(unit, "xilinx", resources[i]), "units.%s.%s", name,
                         resources[i]);
}

/* ---- One unit -------------------------------------------------------------------------------- */

static void choose(smallest best[ACCURACIES], const char *label, double steps, double gates)
{
    for (int i = 0; i < ACCURACIES; i++)
        if (steps <= accuracies[i].steps && gates < best[i].gates) {
            snprintf(best[i].label, sizeof best[i].label, "%s", label);
            best[i].gates = gates;
        }
}

static glint_status put_unit(glint_report *report, const glint_setting *setting,
                             smallest best[ACCURACIES], glint_error *err)
{
    glint_numbers *numbers = &report->numbers;
    glint_compare_errors errors;
    char name[GLINT_SETTING_TEXT], unit[GLINT_SETTING_TEXT], label[GLINT_SETTING_TEXT];
    const glint_status status =
        glint_compare_measure(setting, report->quick ? STRIDE_QUICK : STRIDE, &errors, err);
    if (status != GLINT_OK)
        return status;
    glint_setting_name(setting, unit);
    glint_compare_label(setting, label);
    snprintf(name, sizeof name, "%.*s", (int)(strstr(unit, "_pipelined") - unit), unit);
    glint_number_add_word(numbers, "units.all", name);
    glint_number_put_text(numbers, label, "units.%s.label", name);
    glint_number_put(numbers, glint_compare_w_frac_bits(setting), "units.%s.w-frac-bits", name);
    glint_number_put(numbers, setting->circuit->latency(setting->values), "units.%s.latency", name);
    glint_number_put(numbers, errors.power.steps, "units.%s.steps", name);
    glint_number_put(numbers, errors.power.n, "units.%s.n", name);
    glint_number_put(numbers, errors.own.steps, "units.%s.own", name);
    glint_number_put(numbers, errors.nmse, "units.%s.nmse", name);
    put_sizes(numbers, name, unit);
    if (glint_compare_only_n(setting) == 0)
        choose(best, label, errors.power.steps, size_of(unit, "cells", "gates"));
    return GLINT_OK;
}

glint_status glint_chapter_units(glint_report *report, glint_error *err)
{
    smallest best[ACCURACIES];
    glint_setting setting;
    glint_status status = GLINT_OK;
    for (int i = 0; i < ACCURACIES; i++)
        best[i] = (smallest){"none", INFINITY};
    for (int i = 0; status == GLINT_OK && glint_compare_setting(i, &setting); i++) {
        status = glint_report_go_on(report, err);
        if (status == GLINT_OK && glint_compare_lanes(&setting) == 1)
            status = put_unit(report, &setting, best, err);
    }
    for (int i = 0; i < ACCURACIES; i++)
        glint_number_put_text(&report->numbers, best[i].label, "units.best.%s", accuracies[i].name);
    glint_number_put(&report->numbers, report->quick ? STRIDE_QUICK : STRIDE, "units.stride");
    return status;
}
