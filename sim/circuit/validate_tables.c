/* Checks of the pin and signal tables that a description returns for one setting. */
#include "circuit/validate.h"

#include <ctype.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "circuit/model.h"
#include "circuit/words.h"

#define WIDTH_MAX (64 * GLINT_VALUE_WORDS)

/* A setting, and its tables as the circuit's functions give them. */
typedef struct described {
    const glint_setting *setting;
    int pin_count, signal_count;
    glint_pin_info *pins;
    glint_signal_info *signals;
    glint_error *err;
} described;

static glint_status wrong(const described *d, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

static glint_status wrong(const described *d, const char *format, ...)
{
    char setting[GLINT_SETTING_TEXT], what[256];
    va_list arguments;
    va_start(arguments, format);
    (void)vsnprintf(what, sizeof what, format, arguments);
    va_end(arguments);
    glint_setting_describe(d->setting, setting);
    return glint_fail(d->err, GLINT_BAD_INPUT, "circuit %s (%s): %s", d->setting->circuit->name,
                      setting, what);
}

/* What a pin and a signal have alike. */
typedef struct number {
    const char *sort; /* "pin" */
    const char *name, *meaning;
    int int_bits, frac_bits, is_signed, lane;
    bool has_path;
} number;

static glint_status check_number(const described *d, const number *n, int index)
{
    const int64_t width = (int64_t)n->int_bits + n->frac_bits;
    if (!glint_is_identifier(n->name))
        return wrong(d, "the name of %s %d, \"%.40s\", is not a C identifier%s", n->sort, index,
                     n->name != NULL ? n->name : "", n->has_path ? ": it may be its path" : "");
    if (n->meaning == NULL)
        return wrong(d, "%s %s has no meaning", n->sort, n->name);
    if (n->int_bits < 0 || n->frac_bits < 0 || width < 1 || width > WIDTH_MAX)
        return wrong(d, "%s %s: its width, %d + %d bits, is not from 1 to %d", n->sort, n->name,
                     n->int_bits, n->frac_bits, WIDTH_MAX);
    if (n->is_signed && n->int_bits < 1)
        return wrong(d, "%s %s is signed but has no integer bit for the sign", n->sort, n->name);
    if (n->lane < -1)
        return wrong(d, "%s %s: lane %d does not exist", n->sort, n->name, n->lane);
    return GLINT_OK;
}

/* ---- Pins ------------------------------------------------------------------------------------ */

static glint_status check_role(const described *d, const glint_pin_info *pin)
{
    switch (pin->role) {
    case GLINT_PIN_RESET:
    case GLINT_PIN_RESET_LOW:
    case GLINT_PIN_ENABLE:
    case GLINT_PIN_ENABLE_LOW:
    case GLINT_PIN_STROBE:
        return glint_pin_width(pin) == 1
                   ? GLINT_OK
                   : wrong(d, "pin %s: a reset, enable or strobe has one bit, not %d", pin->name,
                           glint_pin_width(pin));
    case GLINT_PIN_VALID:
    case GLINT_PIN_DATA:
        return GLINT_OK;
    }
    return wrong(d, "pin %s: unknown role number %d", pin->name, (int)pin->role);
}

static glint_status check_place(const described *d, const glint_pin_info *pin)
{
    const size_t all = d->setting->circuit->pins_size;
    const size_t word = sizeof(uint64_t);
    const size_t alignment = pin->size < word ? pin->size : word;
    const bool is_integer = pin->size == 1 || pin->size == 2 || pin->size == 4;
    if (!is_integer && (pin->size == 0 || pin->size % word != 0))
        return wrong(d, "pin %s: its size, %zu bytes, is neither 1, 2, 4 nor a multiple of 8",
                     pin->name, pin->size);
    if (8 * pin->size < (size_t)glint_pin_width(pin))
        return wrong(d, "pin %s: its %d bits do not fit in %zu bytes", pin->name,
                     glint_pin_width(pin), pin->size);
    if (pin->offset > all || pin->size > all - pin->offset)
        return wrong(d, "pin %s: %zu bytes at offset %zu are outside a struct of %zu", pin->name,
                     pin->size, pin->offset, all);
    if (pin->offset % alignment != 0)
        return wrong(d, "pin %s: offset %zu is not a multiple of its %zu bytes", pin->name,
                     pin->offset, alignment);
    return GLINT_OK;
}

/* The lanes of a port are consecutive, starting at 0; otherwise names are unique. */
static glint_status check_port(const described *d, int index)
{
    const glint_pin_info *pin = &d->pins[index];
    const glint_pin_info *before = index > 0 ? &d->pins[index - 1] : NULL;
    if (pin->lane > 0) {
        if (before == NULL || strcmp(before->name, pin->name) != 0 || before->lane != pin->lane - 1)
            return wrong(d, "pin %s: lane %d does not follow lane %d", pin->name, pin->lane,
                         pin->lane - 1);
        if (glint_pin_width(before) != glint_pin_width(pin) || before->is_signed != pin->is_signed)
            return wrong(d, "pin %s: lanes %d and %d differ in width or sign", pin->name,
                         before->lane, pin->lane);
        return GLINT_OK;
    }
    for (int i = 0; i < index; i++)
        if (strcmp(d->pins[i].name, pin->name) == 0)
            return wrong(d, "pin %s appears twice", pin->name);
    const char *clock = d->setting->circuit->clock_port;
    if (clock != NULL && strcmp(clock, pin->name) == 0)
        return wrong(d, "pin %s is the clock, which must not be among the pins", pin->name);
    return GLINT_OK;
}

static glint_status check_pin(const described *d, int index)
{
    const glint_pin_info *pin = &d->pins[index];
    const number n = {"pin",          pin->name,      pin->meaning, pin->int_bits,
                      pin->frac_bits, pin->is_signed, pin->lane,    false};
    glint_status status = check_number(d, &n, index);
    if (status == GLINT_OK)
        status = check_role(d, pin);
    if (status == GLINT_OK)
        status = check_place(d, pin);
    return status == GLINT_OK ? check_port(d, index) : status;
}

/* Two pins in the same bytes: a row was copied. */
static glint_status check_overlaps(const described *d)
{
    int owner[GLINT_PINS_SIZE_MAX] = {0}; /* 1 + index; 0: none */
    for (int i = 0; i < d->pin_count; i++)
        for (size_t byte = 0; byte < d->pins[i].size; byte++) {
            int *whose = &owner[d->pins[i].offset + byte];
            if (*whose != 0)
                return wrong(d, "pins %s and %s share bytes", d->pins[*whose - 1].name,
                             d->pins[i].name);
            *whose = i + 1;
        }
    return GLINT_OK;
}

static glint_status check_pins(const described *d)
{
    glint_status status = GLINT_OK;
    for (int i = 0; i < d->pin_count && status == GLINT_OK; i++)
        status = check_pin(d, i);
    return status == GLINT_OK ? check_overlaps(d) : status;
}

/* ---- Signals --------------------------------------------------------------------------------- */

/* Without a table any is. */
static bool has_heading(const glint_circuit *circuit, const char *title)
{
    if (circuit->heading_count == 0)
        return true;
    for (int i = 0; i < circuit->heading_count; i++)
        if (strcmp(circuit->headings[i].title, title) == 0)
            return true;
    return false;
}

static glint_status check_heading(const described *d, const glint_signal_info *signal)
{
    if (signal->heading != NULL && !has_heading(d->setting->circuit, signal->heading))
        return wrong(d, "signal %s: the circuit has no heading \"%s\"", signal->name,
                     signal->heading);
    return GLINT_OK;
}

/* Paths consist of names, dots and indices. */
static bool is_path(const char *path)
{
    if (*path == '\0')
        return false;
    while (isalnum((unsigned char)*path) || (*path != '\0' && strchr("_$.[]", *path) != NULL))
        path++;
    return *path == '\0';
}

static glint_status check_way(const described *d, const glint_signal_info *signal)
{
    const glint_circuit *circuit = d->setting->circuit;
    if (signal->lane >= 0 && circuit->lane_name == NULL)
        return wrong(d, "signal %s belongs to lane %d, but the circuit has no lane_name",
                     signal->name, signal->lane);
    if (glint_signal_is_port(signal->kind))
        return GLINT_OK;
    if (signal->lane >= 0 && circuit->lane_scope == NULL)
        return wrong(d, "signal %s belongs to lane %d, but the circuit has no lane_scope",
                     signal->name, signal->lane);
    if (signal->path != NULL && !is_path(signal->path))
        return wrong(d, "signal %s: \"%s\" is not a Verilog path", signal->name, signal->path);
    return GLINT_OK;
}

static int find_signal(const described *d, int before, const char *name, int lane)
{
    for (int i = 0; i < before; i++)
        if (d->signals[i].lane == lane && strcmp(d->signals[i].name, name) == 0)
            return i;
    return -1;
}

/* A port of lanes is cut into as many equal parts. */
static glint_status check_output(const described *d, int index)
{
    const glint_signal_info *signal = &d->signals[index];
    for (int i = 0; i < d->pin_count; i++)
        if (strcmp(d->pins[i].name, signal->name) == 0)
            return wrong(d, "output %s has the same name as a pin", signal->name);
    if (signal->lane < 1)
        return GLINT_OK;
    const int before = find_signal(d, index, signal->name, signal->lane - 1);
    if (before < 0)
        return wrong(d, "output %s: lane %d does not follow lane %d", signal->name, signal->lane,
                     signal->lane - 1);
    if (glint_signal_width(&d->signals[before]) != glint_signal_width(signal))
        return wrong(d, "output %s: lanes %d and %d differ in width", signal->name,
                     signal->lane - 1, signal->lane);
    return GLINT_OK;
}

/* Its words lie in the member that the row names, and that in the model where it begins with them.
 */
static glint_status check_room(const described *d, const glint_signal_info *signal)
{
    const glint_circuit *circuit = d->setting->circuit;
    const int width = glint_signal_width(signal);
    const size_t needed = sizeof(uint64_t) * (size_t)glint_words_of(width);
    if (signal->offset % sizeof(int64_t) != 0)
        return wrong(d, "signal %s: offset %zu is not aligned for an int64_t inside its struct",
                     signal->name, signal->offset);
    if (signal->size != 0 && signal->size < needed)
        return wrong(d, "signal %s: its %d bits want %s, not %zu bytes", signal->name, width,
                     width > 64 ? "an array of uint64_t" : "an int64_t", signal->size);
    if (circuit->signals == NULL && signal->offset + needed > circuit->model_size)
        return wrong(d, "signal %s: offset %zu is not in a model of %zu bytes", signal->name,
                     signal->offset, circuit->model_size);
    return GLINT_OK;
}

static glint_status check_name_once(const described *d, int index)
{
    const glint_signal_info *signal = &d->signals[index];
    if (find_signal(d, index, signal->name, signal->lane) < 0)
        return GLINT_OK;
    return signal->lane < 0
               ? wrong(d, "two signals %s", signal->name)
               : wrong(d, "signal %s of lane %d appears twice", signal->name, signal->lane);
}

static glint_status check_signal(const described *d, int index)
{
    const glint_signal_info *signal = &d->signals[index];
    const number n = {"signal",          signal->name,      signal->meaning, signal->int_bits,
                      signal->frac_bits, signal->is_signed, signal->lane,    true};
    glint_status status = check_number(d, &n, index);
    if (status == GLINT_OK && (unsigned)signal->kind > GLINT_SIGNAL_MEALY)
        status = wrong(d, "signal %s: unknown kind number %d", signal->name, (int)signal->kind);
    if (status == GLINT_OK && signal->kind == GLINT_SIGNAL_MEALY &&
        d->setting->circuit->clock_port == NULL)
        status = wrong(d, "signal %s: without a clock its kind is OUTPUT, not MEALY", signal->name);
    if (status == GLINT_OK)
        status = check_room(d, signal);
    if (status == GLINT_OK)
        status = check_name_once(d, index);
    if (status == GLINT_OK)
        status = check_heading(d, signal);
    if (status == GLINT_OK)
        status = check_way(d, signal);
    if (status == GLINT_OK && glint_signal_is_port(signal->kind))
        status = check_output(d, index);
    return status;
}

static glint_status check_signals(const described *d)
{
    int words = 0;
    glint_status status = GLINT_OK;
    for (int i = 0; i < d->signal_count && status == GLINT_OK; i++) {
        status = check_signal(d, i);
        words += glint_words_of(glint_signal_width(&d->signals[i]));
    }
    if (status == GLINT_OK && words > GLINT_SIGNAL_WORDS_MAX)
        status = wrong(d, "its signals take %d 64-bit words; at most %d are allowed", words,
                       GLINT_SIGNAL_WORDS_MAX);
    return status;
}

/* ---- The rest -------------------------------------------------------------------------------- */

static glint_status check_clocks(const described *d)
{
    const glint_circuit *circuit = d->setting->circuit;
    const int *values = d->setting->values;
    const int latency = glint_setting_latency(d->setting);
    if (!glint_is_identifier(glint_setting_top(d->setting)))
        return wrong(d, "the name of its top module is not a C identifier");
    if (latency < 0)
        return wrong(d, "its latency is negative: %d clocks", latency);
    if (latency > 0 && circuit->clock_port == NULL)
        return wrong(d, "it has no clock but a latency of %d", latency);
    if (circuit->pace != NULL && circuit->pace(values) < 1)
        return wrong(d, "its pace is below 1: %d clocks", circuit->pace(values));
    return GLINT_OK;
}

static glint_status check_model(const described *d)
{
    void *model;
    glint_error why;
    const glint_status created = glint_model_create(d->setting, &model, &why);
    if (created == GLINT_NO_MEMORY)
        return glint_fail(d->err, created, "%s", why.text);
    if (created != GLINT_OK)
        return wrong(d, "%s", why.text);
    const bool readable = glint_model_signals(d->setting, model) != NULL;
    glint_model_destroy(d->setting, model);
    return readable ? GLINT_OK : wrong(d, "signals() of the C model returns NULL");
}

static glint_status check_counts(const described *d)
{
    const size_t size = d->setting->circuit->pins_size;
    if (size > GLINT_PINS_SIZE_MAX)
        return wrong(d, "pins_size is %zu; at most %d is allowed", size, GLINT_PINS_SIZE_MAX);
    if (d->pin_count < 0 || d->pin_count > GLINT_PINS_SIZE_MAX)
        return wrong(d, "it has %d pins, not from 0 to %d", d->pin_count, GLINT_PINS_SIZE_MAX);
    if (d->signal_count < 1 || d->signal_count > GLINT_SIGNAL_WORDS_MAX)
        return wrong(d, "it has %d signals, not from 1 to %d", d->signal_count,
                     GLINT_SIGNAL_WORDS_MAX);
    return GLINT_OK;
}

static glint_status fill_and_check(described *d)
{
    const glint_circuit *circuit = d->setting->circuit;
    d->pins = calloc((size_t)d->pin_count + 1, sizeof *d->pins);
    d->signals = calloc((size_t)d->signal_count, sizeof *d->signals);
    if (d->pins == NULL || d->signals == NULL)
        return glint_fail(d->err, GLINT_NO_MEMORY, "not enough memory for the tables of a circuit");
    for (int i = 0; i < d->pin_count; i++)
        d->pins[i] = circuit->pin(d->setting->values, i);
    for (int i = 0; i < d->signal_count; i++)
        d->signals[i] = circuit->signal(d->setting->values, i);
    glint_status status = check_pins(d);
    if (status == GLINT_OK)
        status = check_signals(d);
    if (status == GLINT_OK)
        status = check_clocks(d);
    return status == GLINT_OK ? check_model(d) : status;
}

glint_status glint_circuit_check_tables(const glint_setting *setting, glint_error *err)
{
    described d = {.setting = setting,
                   .pin_count = setting->circuit->pin_count(setting->values),
                   .signal_count = setting->circuit->signal_count(setting->values),
                   .err = err};
    glint_status status = check_counts(&d);
    if (status == GLINT_OK)
        status = fill_and_check(&d);
    free(d.pins);
    free(d.signals);
    return status;
}
