/* The settings to compare: a product over the parameters of each highlight unit. */
#include "compare/units.h"

#include <stdio.h>
#include <string.h>

#include "circuit/circuits.h"
#include "circuit/highlight.h"
#include "compare/formula.h"
#include "glint_specular_device.h"

#define PIPELINE "pipeline"
#define LANES    "lanes"
#define GATE     "gate"

enum { CANDIDATES_MAX = 16 };

/* The values of one parameter that are compared. */
typedef struct candidates {
    int value[CANDIDATES_MAX];
    int count;
} candidates;

static bool is_named(const glint_parameter *parameter, const char *name)
{
    return strcmp(parameter->name, name) == 0;
}

/* All that there are: is_compared() takes W as it is, and at the common width. */
static candidates candidate_drops(const glint_parameter *parameter)
{
    candidates found = {.count = 0};
    for (int drop = parameter->min; drop <= parameter->max && found.count < CANDIDATES_MAX; drop++)
        found.value[found.count++] = drop;
    return found;
}

static candidates candidates_of(const glint_parameter *parameter)
{
    candidates found = {{parameter->standard}, 1};
    if (is_named(parameter, GLINT_HIGHLIGHT_W_DROP_NAME))
        return candidate_drops(parameter);
    if (is_named(parameter, PIPELINE))
        return (candidates){{GLINT_PIPELINE_PIPELINED}, 1};
    if (is_named(parameter, LANES))
        return (candidates){{1, 4}, 2};
    if (is_named(parameter, GATE) || parameter->choices == NULL)
        return found;
    for (found.count = 0; found.count <= parameter->max && found.count < CANDIDATES_MAX;)
        found.value[found.count] = found.count, found.count++;
    return found;
}

static const glint_signal_info *output_w(const glint_setting *setting, glint_signal_info *info)
{
    const glint_circuit *circuit = setting->circuit;
    for (int i = 0; i < circuit->signal_count(setting->values); i++) {
        *info = circuit->signal(setting->values, i);
        if (info->kind == GLINT_SIGNAL_OUTPUT && strcmp(info->name, "out_w") == 0)
            return info;
    }
    return NULL;
}

static bool is_highlight_unit(const glint_circuit *circuit)
{
    const glint_setting standard = glint_setting_standard(circuit);
    glint_signal_info info;
    return glint_setting_value(&standard, PIPELINE, -1) >= 0 &&
           glint_setting_value(&standard, LANES, -1) >= 0 && output_w(&standard, &info) != NULL;
}

/* As glint_setting_listed(), the last parameter varying fastest; *index becomes what is left of it
 * past this circuit's last setting. */
static bool setting_of(const glint_circuit *circuit, int *index, glint_setting *setting)
{
    int turn = *index, count = 1;
    *setting = (glint_setting){.circuit = circuit};
    for (int i = circuit->parameter_count - 1; i >= 0; i--) {
        const candidates of = candidates_of(&circuit->parameters[i]);
        setting->values[i] = of.value[turn % of.count];
        turn /= of.count;
        count *= of.count;
    }
    *index -= count;
    return turn == 0;
}

static bool is_compared(const glint_setting *setting)
{
    return glint_setting_value(setting, GLINT_HIGHLIGHT_W_DROP_NAME, 0) == 0 ||
           glint_compare_w_frac_bits(setting) == GLINT_HIGHLIGHT_COMMON_W_FRAC_BITS;
}

/* Any candidate. */
static bool candidate_number(int index, glint_setting *setting)
{
    const glint_circuit *circuit;
    for (int i = 0; (circuit = glint_circuit_number(i)) != NULL; i++)
        if (is_highlight_unit(circuit) && setting_of(circuit, &index, setting))
            return true;
    return false;
}

bool glint_compare_setting(int index, glint_setting *setting)
{
    for (int i = 0; candidate_number(i, setting); i++)
        if (is_compared(setting) && index-- == 0)
            return true;
    return false;
}

bool glint_compare_setting_named(const char *name, glint_setting *setting)
{
    char text[GLINT_SETTING_TEXT];
    for (int i = 0; glint_compare_setting(i, setting); i++) {
        glint_setting_name(setting, text);
        if (strcmp(text, name) == 0)
            return true;
    }
    return false;
}

void glint_compare_label(const glint_setting *setting, char text[GLINT_SETTING_TEXT])
{
    const glint_circuit *circuit = setting->circuit;
    size_t length = (size_t)snprintf(text, GLINT_SETTING_TEXT, "%s", circuit->name);
    for (int i = 0; i < circuit->parameter_count; i++) {
        const glint_parameter *parameter = &circuit->parameters[i];
        if (candidates_of(parameter).count < 2 || is_named(parameter, LANES) ||
            glint_setting_leaves_out(setting, i))
            continue;
        if (is_named(parameter, GLINT_HIGHLIGHT_W_DROP_NAME))
            length += (size_t)snprintf(text + length, GLINT_SETTING_TEXT - length, ", W U1.%d",
                                       glint_compare_w_frac_bits(setting));
        else if (parameter->choices != NULL)
            length += (size_t)snprintf(text + length, GLINT_SETTING_TEXT - length, ", %s %s",
                                       parameter->name, parameter->choices[setting->values[i]]);
        else
            length += (size_t)snprintf(text + length, GLINT_SETTING_TEXT - length, ", %s %d",
                                       parameter->name, setting->values[i]);
    }
}

uint32_t glint_compare_only_n(const glint_setting *setting)
{
    glint_compare_formula formula;
    glint_error err;
    return glint_compare_formula_of(setting, &formula, &err) == GLINT_OK
               ? glint_compare_formula_n(&formula)
               : 0;
}

int glint_compare_lanes(const glint_setting *setting)
{
    return glint_setting_value(setting, LANES, 1);
}

int glint_compare_w_frac_bits(const glint_setting *setting)
{
    glint_signal_info info;
    return output_w(setting, &info) != NULL ? info.frac_bits : 0;
}
