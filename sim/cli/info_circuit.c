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
    [GLINT_SIGNAL_REGISTER] = "register", [GLINT_SIGNAL_BLOCK] = "block",
    [GLINT_SIGNAL_STAGE] = "stage",       [GLINT_SIGNAL_OUTPUT] = "output",
    [GLINT_SIGNAL_MEALY] = "mealy",
};

/* Settings that `verify` tries, of a circuit; as many as the limit when there are more. */
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
    printf("circuit    %s: %s; verify tries %d setting%s%s\n", circuit->name, circuit->title,
           settings, settings == 1 ? "" : "s", circuit->on_request ? ", on request" : "");
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
    const int latency = glint_setting_latency(setting), pace = glint_setting_pace(setting);
    printf("latency    %d clock%s; takes an input every ", latency, latency == 1 ? "" : "s");
    if (pace == 1)
        printf("clock\n");
    else
        printf("%d clocks\n", pace);
    if (domain != NULL)
        printf("domain     %s: %" PRIu64 " points\n", domain->what,
               domain->points(setting->values));
    else
        printf("domain     none\n");
    print_rows(setting);
}

void glint_info_add_values(json_t *json, const glint_setting *setting)
{
    const glint_circuit *circuit = setting->circuit;
    for (int i = 0; i < circuit->parameter_count; i++) {
        const glint_parameter *parameter = &circuit->parameters[i];
        if (parameter->choices != NULL)
            glint_json_add_text(json, parameter->name, parameter->choices[setting->values[i]]);
        else
            glint_json_add_number(json, parameter->name, setting->values[i]);
    }
}

static json_t *parameter_json(const glint_parameter *parameter)
{
    json_t *json = json_object();
    glint_json_add_text(json, "name", parameter->name);
    if (parameter->meaning != NULL)
        glint_json_add_text(json, "meaning", parameter->meaning);
    if (parameter->choices == NULL) {
        glint_json_add_number(json, "min", parameter->min);
        glint_json_add_number(json, "max", parameter->max);
        glint_json_add_number(json, "default", parameter->standard);
        return json;
    }
    json_t *choices = glint_json_add(json, "choices", json_array());
    for (int i = 0; i <= parameter->max; i++)
        json_array_append_new(choices, glint_json_text_of(parameter->choices[i]));
    glint_json_add_text(json, "default", parameter->choices[parameter->standard]);
    return json;
}

static json_t *row_json(const char *name, const char *key, const char *what, int is_signed,
                        int int_bits, int frac_bits, int lane, const char *meaning)
{
    json_t *json = json_object();
    glint_json_add_text(json, "name", name);
    glint_json_add_text(json, key, what);
    glint_json_add_number(json, "int_bits", int_bits);
    glint_json_add_number(json, "frac_bits", frac_bits);
    json_object_set_new(json, "signed", json_boolean(is_signed));
    if (lane >= 0)
        glint_json_add_number(json, "lane", lane);
    if (meaning != NULL)
        glint_json_add_text(json, "meaning", meaning);
    return json;
}

static void add_rows(json_t *json, const glint_setting *setting)
{
    json_t *pins = glint_json_add(json, "pins", json_array());
    for (int i = 0; i < glint_setting_pin_count(setting); i++) {
        const glint_pin_info pin = glint_setting_pin(setting, i);
        json_array_append_new(pins, row_json(pin.name, "role", roles[pin.role], pin.is_signed,
                                             pin.int_bits, pin.frac_bits, pin.lane, pin.meaning));
    }
    json_t *signals = glint_json_add(json, "signals", json_array());
    for (int i = 0; i < glint_setting_signal_count(setting); i++) {
        const glint_signal_info signal = glint_setting_signal(setting, i);
        json_array_append_new(signals, row_json(signal.name, "kind", kinds[signal.kind],
                                                signal.is_signed, signal.int_bits, signal.frac_bits,
                                                signal.lane, signal.meaning));
    }
}

json_t *glint_info_json(const glint_setting *setting)
{
    const glint_circuit *circuit = setting->circuit;
    json_t *json = json_object();
    glint_json_add_text(json, "circuit", circuit->name);
    glint_json_add_text(json, "title", circuit->title);
    json_t *parameters = glint_json_add(json, "parameters", json_array());
    for (int i = 0; i < circuit->parameter_count; i++)
        json_array_append_new(parameters, parameter_json(&circuit->parameters[i]));
    glint_info_add_values(glint_json_add(json, "setting", json_object()), setting);
    glint_json_add_number(json, "settings_listed", listed_count(circuit));
    glint_json_add_text(json, "top", glint_setting_top(setting));
    if (circuit->clock_port != NULL)
        glint_json_add_text(json, "clock", circuit->clock_port);
    glint_json_add_number(json, "latency", glint_setting_latency(setting));
    glint_json_add_number(json, "pace", glint_setting_pace(setting));
    if (circuit->domain != NULL) {
        json_t *domain = glint_json_add(json, "domain", json_object());
        glint_json_add_text(domain, "what", circuit->domain->what);
        glint_json_add_number(domain, "points", (double)circuit->domain->points(setting->values));
    }
    add_rows(json, setting);
    return json;
}
