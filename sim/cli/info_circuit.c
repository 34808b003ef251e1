/* Prints a circuit's parameters, pins and signals, as text and as JSON. */
#include "cli/info_circuit.h"

#include <inttypes.h>
#include <stdio.h>

#include "circuit/words.h"
#include "lockstep/signals.h"

static const char *const roles[] = {
    [GLINT_PIN_RESET] = "reset",   [GLINT_PIN_RESET_LOW] = "reset_low",
    [GLINT_PIN_ENABLE] = "enable", [GLINT_PIN_ENABLE_LOW] = "enable_low",
    [GLINT_PIN_VALID] = "valid",   [GLINT_PIN_STROBE] = "strobe",
    [GLINT_PIN_DATA] = "data",
};
static const char *const kinds[] = {
    [GLINT_SIGNAL_REGISTER] = "register",
    [GLINT_SIGNAL_BLOCK] = "block",
    [GLINT_SIGNAL_STAGE] = "stage",
    [GLINT_SIGNAL_OUTPUT] = "output",
};

/* Settings that `verify` tries unasked; as many as the limit when there are more. */
static int listed_count(const glint_circuit *circuit)
{
    glint_setting setting;
    int count = 0;
    while (count < 1000000 && glint_setting_listed(circuit, count, &setting))
        count++;
    return count;
}

static void print_parameter(const glint_parameter *parameter)
{
    printf("             --%s ", parameter->name);
    for (int i = 0; parameter->choices != NULL && i <= parameter->max; i++)
        printf("%s%s", i > 0 ? "|" : "", parameter->choices[i]);
    if (parameter->choices != NULL)
        printf(" (default %s)", parameter->choices[parameter->standard]);
    else
        printf("%d to %d (default %d)", parameter->min, parameter->max, parameter->standard);
    printf(": %s\n", parameter->meaning != NULL ? parameter->meaning : "a parameter");
}

void glint_info_print_circuit(const glint_circuit *circuit)
{
    const int settings = listed_count(circuit);
    printf("circuit    %s: %s; verify tries %d setting%s\n", circuit->name, circuit->title,
           settings, settings == 1 ? "" : "s");
    for (int i = 0; i < circuit->parameter_count; i++)
        print_parameter(&circuit->parameters[i]);
}

/* "U10.0", "S1.18": a number's bits before and behind its point. */
static void print_row(const char *name, int lane, const char *what, int is_signed, int int_bits,
                      int frac_bits, const char *meaning)
{
    char text[96], format[32];
    (void)snprintf(format, sizeof format, "%c%d.%d", is_signed ? 'S' : 'U', int_bits, frac_bits);
    if (lane >= 0)
        (void)snprintf(text, sizeof text, "%s[%d]", name, lane);
    else
        (void)snprintf(text, sizeof text, "%s", name);
    printf("  %-20s %-9s %-8s %s\n", text, what, format, meaning != NULL ? meaning : "");
}

static void print_rows(const glint_setting *setting)
{
    printf("pins, with integer and fraction bits:\n");
    for (int i = 0; i < glint_setting_pin_count(setting); i++) {
        const glint_pin_info pin = glint_setting_pin(setting, i);
        print_row(pin.name, pin.lane, roles[pin.role], pin.is_signed, pin.int_bits, pin.frac_bits,
                  pin.meaning);
    }
    printf("signals:\n");
    for (int i = 0; i < glint_setting_signal_count(setting); i++) {
        const glint_signal_info signal = glint_setting_signal(setting, i);
        print_row(signal.name, signal.lane, kinds[signal.kind], signal.is_signed, signal.int_bits,
                  signal.frac_bits, signal.meaning);
    }
}

void glint_info_print_setting(const glint_setting *setting)
{
    const glint_circuit *circuit = setting->circuit;
    const glint_domain *domain = circuit->domain;
    char text[GLINT_SETTING_TEXT];
    glint_info_print_circuit(circuit);
    glint_setting_describe(setting, text);
    printf("setting    %s; top module %s, clock %s\n", text, glint_setting_top(setting),
           circuit->clock_port != NULL ? circuit->clock_port : "none");
    printf("latency    %d clocks; accepts input every %d\n", glint_setting_latency(setting),
           glint_setting_pace(setting));
    if (domain != NULL)
        printf("domain     %s: %" PRIu64 " points\n", domain->what,
               domain->points(setting->values));
    else
        printf("domain     none\n");
    print_rows(setting);
}

void glint_info_add_values(cJSON *json, const glint_setting *setting)
{
    const glint_circuit *circuit = setting->circuit;
    for (int i = 0; i < circuit->parameter_count; i++) {
        const glint_parameter *parameter = &circuit->parameters[i];
        if (parameter->choices != NULL)
            cJSON_AddStringToObject(json, parameter->name, parameter->choices[setting->values[i]]);
        else
            cJSON_AddNumberToObject(json, parameter->name, setting->values[i]);
    }
}

static cJSON *parameter_json(const glint_parameter *parameter)
{
    cJSON *json = cJSON_CreateObject();
    cJSON_AddStringToObject(json, "name", parameter->name);
    if (parameter->meaning != NULL)
        cJSON_AddStringToObject(json, "meaning", parameter->meaning);
    if (parameter->choices == NULL) {
        cJSON_AddNumberToObject(json, "min", parameter->min);
        cJSON_AddNumberToObject(json, "max", parameter->max);
        cJSON_AddNumberToObject(json, "default", parameter->standard);
        return json;
    }
    cJSON *choices = cJSON_AddArrayToObject(json, "choices");
    for (int i = 0; i <= parameter->max; i++)
        cJSON_AddItemToArray(choices, cJSON_CreateString(parameter->choices[i]));
    cJSON_AddStringToObject(json, "default", parameter->choices[parameter->standard]);
    return json;
}

static cJSON *row_json(const char *name, const char *key, const char *what, int is_signed,
                       int int_bits, int frac_bits, int lane, const char *meaning)
{
    cJSON *json = cJSON_CreateObject();
    cJSON_AddStringToObject(json, "name", name);
    cJSON_AddStringToObject(json, key, what);
    cJSON_AddNumberToObject(json, "int_bits", int_bits);
    cJSON_AddNumberToObject(json, "frac_bits", frac_bits);
    cJSON_AddBoolToObject(json, "signed", is_signed);
    if (lane >= 0)
        cJSON_AddNumberToObject(json, "lane", lane);
    if (meaning != NULL)
        cJSON_AddStringToObject(json, "meaning", meaning);
    return json;
}

static void add_rows(cJSON *json, const glint_setting *setting)
{
    cJSON *pins = cJSON_AddArrayToObject(json, "pins");
    for (int i = 0; i < glint_setting_pin_count(setting); i++) {
        const glint_pin_info pin = glint_setting_pin(setting, i);
        cJSON_AddItemToArray(pins, row_json(pin.name, "role", roles[pin.role], pin.is_signed,
                                            pin.int_bits, pin.frac_bits, pin.lane, pin.meaning));
    }
    cJSON *signals = cJSON_AddArrayToObject(json, "signals");
    for (int i = 0; i < glint_setting_signal_count(setting); i++) {
        const glint_signal_info signal = glint_setting_signal(setting, i);
        cJSON_AddItemToArray(signals, row_json(signal.name, "kind", kinds[signal.kind],
                                               signal.is_signed, signal.int_bits, signal.frac_bits,
                                               signal.lane, signal.meaning));
    }
}

cJSON *glint_info_json(const glint_setting *setting)
{
    const glint_circuit *circuit = setting->circuit;
    cJSON *json = cJSON_CreateObject();
    cJSON_AddStringToObject(json, "circuit", circuit->name);
    cJSON_AddStringToObject(json, "title", circuit->title);
    cJSON *parameters = cJSON_AddArrayToObject(json, "parameters");
    for (int i = 0; i < circuit->parameter_count; i++)
        cJSON_AddItemToArray(parameters, parameter_json(&circuit->parameters[i]));
    glint_info_add_values(cJSON_AddObjectToObject(json, "setting"), setting);
    cJSON_AddNumberToObject(json, "settings_listed", listed_count(circuit));
    cJSON_AddStringToObject(json, "top", glint_setting_top(setting));
    if (circuit->clock_port != NULL)
        cJSON_AddStringToObject(json, "clock", circuit->clock_port);
    cJSON_AddNumberToObject(json, "latency", glint_setting_latency(setting));
    cJSON_AddNumberToObject(json, "pace", glint_setting_pace(setting));
    if (circuit->domain != NULL) {
        cJSON *domain = cJSON_AddObjectToObject(json, "domain");
        cJSON_AddStringToObject(domain, "what", circuit->domain->what);
        cJSON_AddNumberToObject(domain, "points", (double)circuit->domain->points(setting->values));
    }
    add_rows(json, setting);
    return json;
}
