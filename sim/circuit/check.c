#include "circuit/check.h"

#include <ctype.h>
#include <string.h>

#include "circuit/words.h"

#define WIDTH_MAX (64 * GLINT_VALUE_WORDS)

/* ---- Functions and parameters ---------------------------------------------------------------- */

/* Letters, digits, underscores and what else is allowed, no digit first. */
static bool is_name(const char *name, const char *allowed)
{
    if (name == NULL || name[0] == '\0' || isdigit((unsigned char)name[0]))
        return false;
    for (; *name != '\0'; name++)
        if (!isalnum((unsigned char)*name) && *name != '_' && strchr(allowed, *name) == NULL)
            return false;
    return true;
}

static const char *missing_function(const glint_circuit *circuit)
{
    return circuit->top == NULL            ? "top"
           : circuit->pin_count == NULL    ? "pin_count"
           : circuit->pin == NULL          ? "pin"
           : circuit->signal_count == NULL ? "signal_count"
           : circuit->signal == NULL       ? "signal"
           : circuit->latency == NULL      ? "latency"
           : circuit->create == NULL       ? "create"
           : circuit->destroy == NULL      ? "destroy"
           : circuit->clock == NULL        ? "clock"
           : circuit->signals == NULL      ? "signals"
                                           : NULL;
}

static const char *missing_part(const glint_circuit *circuit)
{
    const glint_domain *domain = circuit->domain;
    const bool random = circuit->stimulus_begin != NULL;
    if (circuit->title == NULL)
        return "title";
    if (random != (circuit->stimulus_next != NULL))
        return random ? "stimulus_next" : "stimulus_begin";
    if (domain != NULL && (domain->what == NULL || domain->points == NULL || domain->put == NULL))
        return "a part of the domain";
    return NULL;
}

/* What is wrong with a parameter; NULL: nothing. */
static const char *parameter_fault(const glint_parameter *parameter)
{
    if (!is_name(parameter->name, "-"))
        return "a name of letters, digits, _ and - is wanted";
    if (parameter->meaning == NULL)
        return "it has no meaning";
    if (parameter->min > parameter->max)
        return "min is above max";
    if (parameter->standard < parameter->min || parameter->standard > parameter->max)
        return "the standard value is not in min to max";
    for (int i = 0; i <= parameter->max && parameter->choices != NULL; i++)
        if (parameter->min != 0 || parameter->choices[i] == NULL)
            return "its choices are those of 0 to max, min is 0";
    for (int i = 0; i < parameter->listed_count && parameter->listed != NULL; i++)
        if (parameter->listed[i] < parameter->min || parameter->listed[i] > parameter->max)
            return "a listed value is not in min to max";
    if (parameter->listed != NULL && parameter->listed_count < 1)
        return "listed_count is below 1";
    return NULL;
}

static glint_status check_parameters(const glint_circuit *circuit, glint_error *err)
{
    if (circuit->parameter_count < 0 || circuit->parameter_count > GLINT_PARAMETERS_MAX)
        return glint_fail(err, GLINT_BAD_INPUT, "circuit %s: %d parameters, 0 to %d are possible",
                          circuit->name, circuit->parameter_count, GLINT_PARAMETERS_MAX);
    for (int i = 0; i < circuit->parameter_count; i++) {
        const glint_parameter *parameter = &circuit->parameters[i];
        const char *fault = parameter_fault(parameter);
        if (fault != NULL)
            return glint_fail(err, GLINT_BAD_INPUT, "circuit %s: parameter %d, %s: %s",
                              circuit->name, i,
                              parameter->name != NULL ? parameter->name : "(no name)", fault);
    }
    return GLINT_OK;
}

glint_status glint_circuit_check(const glint_circuit *circuit, glint_error *err)
{
    if (!is_name(circuit->name, ""))
        return glint_fail(err, GLINT_BAD_INPUT,
                          "the circuit's name is no C identifier: letters, digits and _");
    const char *missing = missing_function(circuit);
    if (missing != NULL)
        return glint_fail(err, GLINT_BAD_INPUT, "circuit %s: it has no function %s", circuit->name,
                          missing);
    missing = missing_part(circuit);
    if (missing != NULL)
        return glint_fail(err, GLINT_BAD_INPUT, "circuit %s: it has no %s", circuit->name, missing);
    if (circuit->pins_size > GLINT_PINS_SIZE_MAX)
        return glint_fail(err, GLINT_BAD_INPUT, "circuit %s: pins_size is %zu, at most %d are held",
                          circuit->name, circuit->pins_size, GLINT_PINS_SIZE_MAX);
    if (circuit->stimulus_size > GLINT_STIMULUS_SIZE_MAX)
        return glint_fail(err, GLINT_BAD_INPUT,
                          "circuit %s: stimulus_size is %zu, at most %d are held", circuit->name,
                          circuit->stimulus_size, GLINT_STIMULUS_SIZE_MAX);
    return check_parameters(circuit, err);
}

/* ---- Pins and signals of a setting ----------------------------------------------------------- */

static bool is_width(int int_bits, int frac_bits)
{
    return int_bits >= 0 && frac_bits >= 0 && int_bits <= WIDTH_MAX && frac_bits <= WIDTH_MAX &&
           int_bits + frac_bits >= 1 && int_bits + frac_bits <= WIDTH_MAX;
}

/* An integer of up to 64 bits, or words. */
static bool has_room(const glint_pin_info *pin)
{
    const size_t width = (size_t)glint_pin_width(pin);
    const bool is_size = pin->size == 1 || pin->size == 2 || pin->size == 4 ||
                         (pin->size != 0 && pin->size % sizeof(uint64_t) == 0);
    return is_size && 8 * pin->size >= width;
}

static const char *pin_fault(const glint_circuit *circuit, const glint_pin_info *pin)
{
    const bool controls = pin->role != GLINT_PIN_DATA && pin->role != GLINT_PIN_VALID;
    if ((unsigned)pin->role > GLINT_PIN_DATA)
        return "it has no role";
    if (!is_width(pin->int_bits, pin->frac_bits))
        return "its width is not in 1 to 4096";
    if (!has_room(pin))
        return "its bits do not fit the bytes of its member, 1, 2, 4 or 8, or 8 a word";
    if (pin->offset > circuit->pins_size || pin->size > circuit->pins_size - pin->offset)
        return "it lies beyond pins_size";
    if (pin->lane < -1)
        return "its lane is below -1";
    if (controls && glint_pin_width(pin) != 1)
        return "a reset, an enable or a strobe has one bit";
    return NULL;
}

/* The lanes of a port stand one behind the other, alike, from 0 on. */
static const char *order_fault(const glint_pin_info *pin, const glint_pin_info *before)
{
    const bool same_port = before != NULL && strcmp(pin->name, before->name) == 0;
    const int expected = same_port && before->lane >= 0 ? before->lane + 1 : 0;
    if (pin->lane < 0 && !same_port)
        return NULL;
    if (same_port && (pin->lane < 0 || before->lane < 0))
        return "it is there twice; lanes are numbered from 0 on, -1 is a pin without lanes";
    if (pin->lane != expected)
        return "the lanes of a port stand one behind the other, from 0 on";
    if (same_port && glint_pin_width(pin) != glint_pin_width(before))
        return "the lanes of a port have one width";
    return NULL;
}

static glint_status check_pins(const glint_setting *setting, const char *what, glint_error *err)
{
    const glint_circuit *circuit = setting->circuit;
    const int count = circuit->pin_count(setting->values);
    glint_pin_info before;
    for (int i = 0; i < count; i++) {
        const glint_pin_info pin = circuit->pin(setting->values, i);
        if (!is_name(pin.name, "$"))
            return glint_fail(err, GLINT_BAD_INPUT, "%s: pin %d has no name of a Verilog port",
                              what, i);
        const char *fault = pin_fault(circuit, &pin);
        if (fault == NULL)
            fault = order_fault(&pin, i > 0 ? &before : NULL);
        if (fault != NULL)
            return glint_fail(err, GLINT_BAD_INPUT, "%s: pin %s: %s", what, pin.name, fault);
        before = pin;
    }
    return GLINT_OK;
}

static bool is_heading(const glint_circuit *circuit, const char *title)
{
    for (int i = 0; i < circuit->heading_count; i++)
        if (circuit->headings[i].title != NULL && strcmp(circuit->headings[i].title, title) == 0)
            return true;
    return false;
}

static const char *signal_fault(const glint_circuit *circuit, const glint_signal_info *signal)
{
    if ((unsigned)signal->kind > GLINT_SIGNAL_OUTPUT)
        return "it has no kind";
    if (signal->meaning == NULL)
        return "it has no meaning";
    if (!is_width(signal->int_bits, signal->frac_bits))
        return "its width is not in 1 to 4096";
    if (signal->offset % sizeof(int64_t) != 0)
        return "it lies at no int64_t of the model's signals";
    if (signal->lane < -1)
        return "its lane is below -1";
    if (signal->lane >= 0 && circuit->lane_name == NULL)
        return "it has a lane and the circuit no lane_name; -1 is a signal without lanes";
    if (signal->lane >= 0 && signal->kind != GLINT_SIGNAL_OUTPUT && circuit->lane_scope == NULL)
        return "it has a lane and the circuit no lane_scope to find it in";
    if (signal->heading != NULL && !is_heading(circuit, signal->heading))
        return "its heading is none of the circuit's";
    return NULL;
}

static glint_status check_signals(const glint_setting *setting, const char *what, glint_error *err)
{
    const glint_circuit *circuit = setting->circuit;
    const int count = circuit->signal_count(setting->values);
    int words = 0;
    if (count < 1)
        return glint_fail(err, GLINT_BAD_INPUT, "%s: it has no signals: nothing to compare", what);
    for (int i = 0; i < count; i++) {
        const glint_signal_info signal = circuit->signal(setting->values, i);
        if (signal.name == NULL || signal.name[0] == '\0')
            return glint_fail(err, GLINT_BAD_INPUT, "%s: signal %d has no name", what, i);
        const char *fault = signal_fault(circuit, &signal);
        if (fault != NULL)
            return glint_fail(err, GLINT_BAD_INPUT, "%s: signal %s: %s", what, signal.name, fault);
        words += glint_words_of(glint_signal_width(&signal));
        if (words > GLINT_SIGNAL_WORDS_MAX)
            return glint_fail(err, GLINT_BAD_INPUT,
                              "%s: signals up to %s have more than %d words of 64 bits", what,
                              signal.name, GLINT_SIGNAL_WORDS_MAX);
    }
    return GLINT_OK;
}

glint_status glint_circuit_check_tables(const glint_setting *setting, glint_error *err)
{
    const glint_circuit *circuit = setting->circuit;
    char what[GLINT_SETTING_TEXT];
    glint_setting_describe(setting, what);
    if (!is_name(circuit->top(setting->values), "$"))
        return glint_fail(err, GLINT_BAD_INPUT, "%s: top is no name of a Verilog module", what);
    if (circuit->latency(setting->values) < 0)
        return glint_fail(err, GLINT_BAD_INPUT, "%s: the latency is below 0", what);
    const glint_status status = check_pins(setting, what, err);
    return status == GLINT_OK ? check_signals(setting, what, err) : status;
}
