/* The units' formulas by the name of their circuit. */
#include "compare/formula.h"

#include <string.h>

#include "circuit/circuits.h"
#include "circuit/unit.h"
#include "glint_power.h"
#include "glint_rivals.h"
#include "glint_specular.h"

static const struct {
    const char *circuit;
    const glint_unit *unit;
} units[] = {
    {"power", &glint_unit_power},         {"log2", &glint_unit_log2},
    {"schlick", &glint_unit_schlick},     {"newton", &glint_unit_newton},
    {"lyon", &glint_unit_lyon},           {"quadratic", &glint_unit_quadratic},
    {"bipartite", &glint_unit_bipartite},
};

/* The thesis's device or another form of it, whose parameters begin with the device's. */
static bool is_specular(const glint_circuit *circuit)
{
    return circuit == &glint_circuit_specular || strcmp(circuit->name, "lean") == 0 ||
           strcmp(circuit->name, "narrow") == 0;
}

glint_status glint_compare_formula_of(const glint_setting *setting, glint_compare_formula *formula,
                                      glint_error *err)
{
    *formula = (glint_compare_formula){.unit = NULL};
    if (is_specular(setting->circuit)) {
        formula->gate = glint_specular_config_of(setting->values).gate;
        return GLINT_OK;
    }
    for (size_t i = 0; i < sizeof units / sizeof units[0]; i++)
        if (strcmp(units[i].circuit, setting->circuit->name) == 0) {
            formula->unit = units[i].unit;
            formula->variant = glint_unit_config_of(formula->unit, setting->values).variant;
            return GLINT_OK;
        }
    return glint_fail(err, GLINT_BAD_ARGUMENT, "%s: its formula is unknown",
                      setting->circuit->name);
}

uint32_t glint_compare_formula_n(const glint_compare_formula *formula)
{
    const glint_unit *unit = formula->unit;
    return unit != NULL && unit->fixed_n != NULL ? unit->fixed_n(formula->variant) : 0;
}

double glint_compare_formula_w(const glint_compare_formula *formula, uint32_t n, uint32_t cos_code)
{
    if (formula->unit == NULL)
        return glint_specular_real(formula->gate, n, cos_code);
    return formula->unit->real(formula->variant, n, cos_code);
}
