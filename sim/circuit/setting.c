/* Parameter values: checked, compared, enumerated, and printed as text, file names and options. */
#include "circuit/setting.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#define VALUE_TEXT 64

/* The choice's name, or the number. */
static const char *value_text(const glint_parameter *parameter, int value, char text[VALUE_TEXT])
{
    if (parameter->choices != NULL && value >= 0 && value <= parameter->max)
        return parameter->choices[value];
    (void)snprintf(text, VALUE_TEXT, "%d", value);
    return text;
}

static void append(char *text, size_t size, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

static void append(char *text, size_t size, const char *format, ...)
{
    const size_t length = strlen(text);
    va_list arguments;
    va_start(arguments, format);
    (void)vsnprintf(text + length, size - length, format, arguments);
    va_end(arguments);
}

glint_setting glint_setting_standard(const glint_circuit *circuit)
{
    glint_setting setting = {.circuit = circuit};
    for (int i = 0; i < circuit->parameter_count; i++)
        setting.values[i] = circuit->parameters[i].standard;
    return setting;
}

static glint_status refuse_value(const glint_parameter *parameter, int value, glint_error *err)
{
    char choices[256] = "";
    if (parameter->choices == NULL)
        return glint_fail(err, GLINT_BAD_ARGUMENT, "%s: %d is not from %d to %d", parameter->name,
                          value, parameter->min, parameter->max);
    for (int i = 0; i <= parameter->max; i++)
        append(choices, sizeof choices, "%s%s", i == 0 ? "" : ", ", parameter->choices[i]);
    return glint_fail(err, GLINT_BAD_ARGUMENT, "%s: %d is not the number of a choice: %s",
                      parameter->name, value, choices);
}

glint_status glint_setting_check(const glint_setting *setting, glint_error *err)
{
    for (int i = 0; i < setting->circuit->parameter_count; i++) {
        const glint_parameter *parameter = &setting->circuit->parameters[i];
        const int value = setting->values[i];
        if (value < parameter->min || value > parameter->max)
            return refuse_value(parameter, value, err);
    }
    return GLINT_OK;
}

static bool same_directory(const char *a, const char *b)
{
    return a == NULL || b == NULL ? a == b : strcmp(a, b) == 0;
}

bool glint_setting_equal(const glint_setting *a, const glint_setting *b)
{
    return a->circuit == b->circuit && memcmp(a->values, b->values, sizeof a->values) == 0 &&
           same_directory(a->verilog, b->verilog);
}

int glint_setting_value(const glint_setting *setting, const char *name, int otherwise)
{
    for (int i = 0; i < setting->circuit->parameter_count; i++)
        if (strcmp(setting->circuit->parameters[i].name, name) == 0)
            return setting->values[i];
    return otherwise;
}

bool glint_setting_leaves_out(const glint_setting *setting, int parameter)
{
    const glint_parameter *of = &setting->circuit->parameters[parameter];
    return of->goes_unsaid && setting->values[parameter] == of->standard;
}

const char *glint_setting_top(const glint_setting *setting)
{
    const glint_circuit *circuit = setting->circuit;
    return circuit->top != NULL ? circuit->top(setting->values) : circuit->name;
}

int glint_setting_latency(const glint_setting *setting)
{
    const glint_circuit *circuit = setting->circuit;
    return circuit->latency != NULL ? circuit->latency(setting->values)
                                    : circuit->clock_port != NULL;
}

static int listed_count(const glint_parameter *parameter)
{
    return parameter->listed != NULL ? parameter->listed_count
                                     : parameter->max - parameter->min + 1;
}

bool glint_setting_listed(const glint_circuit *circuit, int index, glint_setting *setting)
{
    *setting = (glint_setting){.circuit = circuit};
    for (int i = circuit->parameter_count - 1; i >= 0; i--) {
        const glint_parameter *parameter = &circuit->parameters[i];
        const int turn = index % listed_count(parameter);
        setting->values[i] =
            parameter->listed != NULL ? parameter->listed[turn] : parameter->min + turn;
        index /= listed_count(parameter);
    }
    return index == 0;
}

void glint_setting_describe(const glint_setting *setting, char text[GLINT_SETTING_TEXT])
{
    const glint_circuit *circuit = setting->circuit;
    char value[VALUE_TEXT];
    if (circuit->describe != NULL) {
        circuit->describe(setting->values, text, GLINT_SETTING_TEXT);
        return;
    }
    (void)snprintf(text, GLINT_SETTING_TEXT, "%s", circuit->name);
    for (int i = 0; i < circuit->parameter_count; i++)
        if (!glint_setting_leaves_out(setting, i))
            append(text, GLINT_SETTING_TEXT, ", %s %s", circuit->parameters[i].name,
                   value_text(&circuit->parameters[i], setting->values[i], value));
}

void glint_setting_name(const glint_setting *setting, char text[GLINT_SETTING_TEXT])
{
    const glint_circuit *circuit = setting->circuit;
    char value[VALUE_TEXT];
    (void)snprintf(text, GLINT_SETTING_TEXT, "%s", circuit->name);
    for (int i = 0; i < circuit->parameter_count; i++)
        if (!glint_setting_leaves_out(setting, i))
            append(text, GLINT_SETTING_TEXT, "_%s",
                   value_text(&circuit->parameters[i], setting->values[i], value));
}

void glint_setting_options(const glint_setting *setting, char text[GLINT_SETTING_OPTIONS])
{
    const glint_circuit *circuit = setting->circuit;
    char value[VALUE_TEXT];
    (void)snprintf(text, GLINT_SETTING_OPTIONS, "--circuit %s", circuit->name);
    for (int i = 0; i < circuit->parameter_count; i++)
        if (!glint_setting_leaves_out(setting, i))
            append(text, GLINT_SETTING_OPTIONS, " --%s %s", circuit->parameters[i].name,
                   value_text(&circuit->parameters[i], setting->values[i], value));
}
