/* Checks of the circuit and its parameters; validate_tables.c checks the pins and signals. */
#include "circuit/validate.h"

#include <ctype.h>
#include <string.h>

#define SETTINGS_MAX 512   /* that are looked at */
#define UNLISTED_MAX 65536 /* of a parameter without a list `verify` tries all values */
#define NAME_LENGTH  63    /* of a circuit or parameter at most: names of files, lines of help */

bool glint_is_identifier(const char *name)
{
    if (name == NULL || (!isalpha((unsigned char)*name) && *name != '_'))
        return false;
    while (isalnum((unsigned char)*name) || *name == '_')
        name++;
    return *name == '\0';
}

static bool is_text(const char *text)
{
    return text != NULL && *text != '\0';
}

/* ---- The circuit ----------------------------------------------------------------------------- */

static glint_status check_names(const glint_circuit *circuit, glint_error *err)
{
    if (!is_text(circuit->name))
        return glint_fail(err, GLINT_BAD_INPUT, "the circuit has no name");
    if (!glint_is_identifier(circuit->name))
        return glint_fail(err, GLINT_BAD_INPUT, "circuit \"%s\": its name is not a C identifier",
                          circuit->name);
    if (strlen(circuit->name) > NAME_LENGTH)
        return glint_fail(err, GLINT_BAD_INPUT, "circuit %.20s…: its name is longer than %d",
                          circuit->name, NAME_LENGTH);
    if (!is_text(circuit->title))
        return glint_fail(err, GLINT_BAD_INPUT, "circuit %s has no title", circuit->name);
    if (circuit->clock_port != NULL && !glint_is_identifier(circuit->clock_port))
        return glint_fail(err, GLINT_BAD_INPUT,
                          "circuit %s: clock_port \"%s\" is not a C identifier", circuit->name,
                          circuit->clock_port);
    if (circuit->lane_name != NULL && !glint_is_identifier(circuit->lane_name))
        return glint_fail(err, GLINT_BAD_INPUT,
                          "circuit %s: lane_name \"%s\" is not a C identifier", circuit->name,
                          circuit->lane_name);
    return GLINT_OK;
}

/* One %d and no other conversion. */
static glint_status check_lane_scope(const glint_circuit *circuit, glint_error *err)
{
    const char *scope = circuit->lane_scope;
    if (scope == NULL)
        return GLINT_OK;
    const char *number = strchr(scope, '%');
    if (number == NULL || number[1] != 'd' || strchr(number + 1, '%') != NULL)
        return glint_fail(err, GLINT_BAD_INPUT,
                          "circuit %s: lane_scope \"%s\" must contain one %%d, for the lane",
                          circuit->name, scope);
    return GLINT_OK;
}

static glint_status check_functions(const glint_circuit *circuit, glint_error *err)
{
    const struct {
        const char *name;
        bool there;
    } functions[] = {
        {"pin_count", circuit->pin_count != NULL},
        {"pin", circuit->pin != NULL},
        {"signal_count", circuit->signal_count != NULL},
        {"signal", circuit->signal != NULL},
        {"clock", circuit->clock != NULL},
    };
    for (size_t i = 0; i < sizeof functions / sizeof functions[0]; i++)
        if (!functions[i].there)
            return glint_fail(err, GLINT_BAD_INPUT, "circuit %s has no function %s", circuit->name,
                              functions[i].name);
    return GLINT_OK;
}

/* A size, or functions of its own; what it allocates itself it says how to free. */
static glint_status check_model(const glint_circuit *circuit, glint_error *err)
{
    if (circuit->create == NULL && circuit->model_size == 0)
        return glint_fail(err, GLINT_BAD_INPUT,
                          "circuit %s: its C model has neither a model_size nor create()",
                          circuit->name);
    if (circuit->create != NULL && (circuit->model_size != 0 || circuit->begin != NULL))
        return glint_fail(err, GLINT_BAD_INPUT,
                          "circuit %s: its C model has create(), and model_size or begin() as well",
                          circuit->name);
    if ((circuit->create == NULL) != (circuit->destroy == NULL))
        return glint_fail(err, GLINT_BAD_INPUT,
                          "circuit %s: of create() and destroy() it has but one", circuit->name);
    if (circuit->create != NULL && circuit->signals == NULL)
        return glint_fail(err, GLINT_BAD_INPUT,
                          "circuit %s: its C model has create(), and no signals()", circuit->name);
    return GLINT_OK;
}

static glint_status check_stimulus(const glint_circuit *circuit, glint_error *err)
{
    if ((circuit->stimulus_begin == NULL) != (circuit->stimulus_next == NULL))
        return glint_fail(
            err, GLINT_BAD_INPUT,
            "circuit %s: stimulus_begin and stimulus_next must both be set, or neither",
            circuit->name);
    if (circuit->stimulus_size > GLINT_STIMULUS_SIZE_MAX)
        return glint_fail(err, GLINT_BAD_INPUT,
                          "circuit %s: stimulus_size is %zu bytes; at most %d are allowed",
                          circuit->name, circuit->stimulus_size, GLINT_STIMULUS_SIZE_MAX);
    return GLINT_OK;
}

static glint_status check_domain(const glint_circuit *circuit, glint_error *err)
{
    const glint_domain *domain = circuit->domain;
    if (domain != NULL && (!is_text(domain->what) || domain->points == NULL || domain->put == NULL))
        return glint_fail(err, GLINT_BAD_INPUT,
                          "circuit %s: its domain needs all of what, points and put",
                          circuit->name);
    return GLINT_OK;
}

static glint_status check_headings(const glint_circuit *circuit, glint_error *err)
{
    if (circuit->heading_count < 0 || (circuit->heading_count > 0 && circuit->headings == NULL))
        return glint_fail(err, GLINT_BAD_INPUT,
                          "circuit %s: heading_count is %d, but headings is NULL", circuit->name,
                          circuit->heading_count);
    for (int i = 0; i < circuit->heading_count; i++) {
        const char *title = circuit->headings[i].title;
        if (!is_text(title))
            return glint_fail(err, GLINT_BAD_INPUT, "circuit %s: heading %d has no title",
                              circuit->name, i);
        for (int j = 0; j < i; j++)
            if (strcmp(circuit->headings[j].title, title) == 0)
                return glint_fail(err, GLINT_BAD_INPUT, "circuit %s: heading \"%s\" appears twice",
                                  circuit->name, title);
    }
    return GLINT_OK;
}

/* ---- Parameters ------------------------------------------------------------------------------ */

/* "data-width": a letter first. */
static bool is_option(const char *name)
{
    if (name == NULL || !isalpha((unsigned char)*name))
        return false;
    while (isalnum((unsigned char)*name) || *name == '_' || *name == '-')
        name++;
    return *name == '\0';
}

static glint_status check_parameter_names(const glint_circuit *circuit, int index, glint_error *err)
{
    const glint_parameter *parameter = &circuit->parameters[index];
    if (!is_option(parameter->name))
        return glint_fail(
            err, GLINT_BAD_INPUT,
            "circuit %s: the name of parameter %d may only contain letters, digits, _ and -",
            circuit->name, index);
    if (parameter->verilog != NULL && !glint_is_identifier(parameter->verilog))
        return glint_fail(err, GLINT_BAD_INPUT,
                          "circuit %s: parameter %s: \"%s\" is not a Verilog parameter name",
                          circuit->name, parameter->name, parameter->verilog);
    if (strlen(parameter->name) > NAME_LENGTH ||
        (parameter->verilog != NULL && strlen(parameter->verilog) > NAME_LENGTH))
        return glint_fail(err, GLINT_BAD_INPUT,
                          "circuit %s: parameter %.20s…: its name is longer than %d", circuit->name,
                          parameter->name, NAME_LENGTH);
    if (!is_text(parameter->meaning))
        return glint_fail(err, GLINT_BAD_INPUT, "circuit %s: parameter %s has no meaning",
                          circuit->name, parameter->name);
    for (int i = 0; i < index; i++) {
        const glint_parameter *other = &circuit->parameters[i];
        if (strcmp(other->name, parameter->name) == 0)
            return glint_fail(err, GLINT_BAD_INPUT, "circuit %s: parameter %s appears twice",
                              circuit->name, parameter->name);
        if (other->verilog != NULL && parameter->verilog != NULL &&
            strcmp(other->verilog, parameter->verilog) == 0)
            return glint_fail(err, GLINT_BAD_INPUT,
                              "circuit %s: parameters %s and %s both set the Verilog's %s",
                              circuit->name, other->name, parameter->name, parameter->verilog);
    }
    return GLINT_OK;
}

static glint_status check_choices(const glint_circuit *circuit, const glint_parameter *parameter,
                                  glint_error *err)
{
    if (parameter->choices == NULL)
        return GLINT_OK;
    if (parameter->min != 0)
        return glint_fail(err, GLINT_BAD_INPUT,
                          "circuit %s: parameter %s has choices, so its min must be 0, not %d",
                          circuit->name, parameter->name, parameter->min);
    for (int i = 0; i <= parameter->max; i++)
        if (!is_text(parameter->choices[i]))
            return glint_fail(err, GLINT_BAD_INPUT,
                              "circuit %s: parameter %s: choice %d has no name", circuit->name,
                              parameter->name, i);
    return GLINT_OK;
}

static bool is_in_range(const glint_parameter *parameter, int value)
{
    return value >= parameter->min && value <= parameter->max;
}

static glint_status check_listed(const glint_circuit *circuit, const glint_parameter *parameter,
                                 glint_error *err)
{
    const int64_t values = (int64_t)parameter->max - parameter->min + 1;
    if (parameter->listed == NULL && values > UNLISTED_MAX)
        return glint_fail(err, GLINT_BAD_INPUT,
                          "circuit %s: parameter %s has %lld values: list the ones to try",
                          circuit->name, parameter->name, (long long)values);
    if (parameter->listed != NULL && parameter->listed_count < 1)
        return glint_fail(err, GLINT_BAD_INPUT, "circuit %s: parameter %s lists %d values",
                          circuit->name, parameter->name, parameter->listed_count);
    for (int i = 0; parameter->listed != NULL && i < parameter->listed_count; i++)
        if (!is_in_range(parameter, parameter->listed[i]))
            return glint_fail(err, GLINT_BAD_INPUT,
                              "circuit %s: parameter %s lists %d, which is not from %d to %d",
                              circuit->name, parameter->name, parameter->listed[i], parameter->min,
                              parameter->max);
    return GLINT_OK;
}

static glint_status check_range(const glint_circuit *circuit, const glint_parameter *parameter,
                                glint_error *err)
{
    if (parameter->max < parameter->min)
        return glint_fail(err, GLINT_BAD_INPUT,
                          "circuit %s: parameter %s: the range %d to %d is empty", circuit->name,
                          parameter->name, parameter->min, parameter->max);
    if (!is_in_range(parameter, parameter->standard))
        return glint_fail(err, GLINT_BAD_INPUT,
                          "circuit %s: parameter %s: its standard, %d, is not from %d to %d",
                          circuit->name, parameter->name, parameter->standard, parameter->min,
                          parameter->max);
    return GLINT_OK;
}

static glint_status check_parameters(const glint_circuit *circuit, glint_error *err)
{
    glint_status status = GLINT_OK;
    if (circuit->parameter_count < 0 || circuit->parameter_count > GLINT_PARAMETERS_MAX)
        return glint_fail(err, GLINT_BAD_INPUT,
                          "circuit %s: parameter_count is %d, not from 0 to %d", circuit->name,
                          circuit->parameter_count, GLINT_PARAMETERS_MAX);
    if (circuit->parameter_count > 0 && circuit->parameters == NULL)
        return glint_fail(err, GLINT_BAD_INPUT,
                          "circuit %s: parameter_count is %d, but parameters is NULL",
                          circuit->name, circuit->parameter_count);
    for (int i = 0; i < circuit->parameter_count && status == GLINT_OK; i++) {
        const glint_parameter *parameter = &circuit->parameters[i];
        status = check_parameter_names(circuit, i, err);
        if (status == GLINT_OK)
            status = check_range(circuit, parameter, err);
        if (status == GLINT_OK)
            status = check_choices(circuit, parameter, err);
        if (status == GLINT_OK)
            status = check_listed(circuit, parameter, err);
    }
    return status;
}

/* ---- All of it ------------------------------------------------------------------------------- */

static glint_status check_settings(const glint_circuit *circuit, glint_error *err)
{
    glint_setting setting = glint_setting_standard(circuit);
    glint_status status = glint_circuit_check_tables(&setting, err);
    for (int i = 0;
         status == GLINT_OK && i < SETTINGS_MAX && glint_setting_listed(circuit, i, &setting); i++)
        status = glint_circuit_check_tables(&setting, err);
    return status;
}

glint_status glint_circuit_check(const glint_circuit *circuit, glint_error *err)
{
    static glint_status (*const checks[])(const glint_circuit *, glint_error *) = {
        check_names,  check_lane_scope, check_functions,  check_model,    check_stimulus,
        check_domain, check_headings,   check_parameters, check_settings,
    };
    glint_status status = GLINT_OK;
    for (size_t i = 0; i < sizeof checks / sizeof checks[0] && status == GLINT_OK; i++)
        status = checks[i](circuit, err);
    return status;
}
