/* Numbers on standard input, a circuit's outputs on standard output; see eval_circuit.h. */
#define _POSIX_C_SOURCE 200809L

#include "cli/eval_circuit.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "circuit/model.h"
#include "circuit/words.h"
#include "cli/input.h"
#include "cli/output.h"
#include "lockstep/signals.h"
#include "rtl/rtl.h"

#define NAME_TEXT 128

/* A data pin or an output, as a column. */
typedef struct column {
    char name[NAME_TEXT];
    int index; /* of the pin, or of the signal */
} column;

typedef struct evaluation {
    const glint_setting *setting;
    bool json, at_once;
    uint64_t printed;
    glint_columns columns;
    int pins, outputs;
    int controls; /* the last of the pins: those that are no data */
    bool has_header;
    column pin[GLINT_COLUMNS_MAX];
    glint_column field[GLINT_COLUMNS_MAX];
    char values[96]; /* "the 3 values a b c", as far as it has room */
    column output[GLINT_SIGNAL_WORDS_MAX];
    void *model;    /* the C model, or */
    glint_rtl *rtl; /* the Verilog */
    glint_signals signals;
    glint_pins rest, asking;
    uint64_t words[GLINT_SIGNAL_WORDS_MAX];
} evaluation;

/* ---- Columns -----------------------------------------------------------------------------------
 */

/* "sum", or of a lane "sum[3]". */
static void name_column(column *column, int index, const char *name, int lane)
{
    column->index = index;
    if (lane >= 0)
        (void)snprintf(column->name, sizeof column->name, "%s[%d]", name, lane);
    else
        (void)snprintf(column->name, sizeof column->name, "%s", name);
}

/* Those that are data, or the others, behind the `count` there are. Returns how many there are
 * then, those included that have no room. */
static int add_pins(const glint_setting *setting, bool data, column *pin, int count)
{
    for (int i = 0; i < glint_setting_pin_count(setting); i++) {
        const glint_pin_info info = glint_setting_pin(setting, i);
        if ((info.role == GLINT_PIN_DATA) != data)
            continue;
        if (count < GLINT_COLUMNS_MAX)
            name_column(&pin[count], i, info.name, info.lane);
        count++;
    }
    return count;
}

static int find_outputs(const glint_setting *setting, column *output)
{
    int count = 0;
    for (int i = 0; i < glint_setting_signal_count(setting); i++) {
        const glint_signal_info info = glint_setting_signal(setting, i);
        if (glint_signal_is_port(info.kind) && count < GLINT_SIGNAL_WORDS_MAX)
            name_column(&output[count++], i, info.name, info.lane);
    }
    return count;
}

static int find_columns(evaluation *e)
{
    const int data = add_pins(e->setting, true, e->pin, 0);
    e->pins = add_pins(e->setting, false, e->pin, data);
    e->controls = e->pins - data;
    e->outputs = find_outputs(e->setting, e->output);
    if (e->pins == 0)
        return glint_complain("eval", GLINT_EXIT_TROUBLE,
                              "circuit %s has no pins, so there is nothing to read",
                              e->setting->circuit->name);
    if (e->pins > GLINT_COLUMNS_MAX)
        return glint_complain("eval", GLINT_EXIT_TROUBLE,
                              "circuit %s has %d pins: at most %d are supported",
                              e->setting->circuit->name, e->pins, GLINT_COLUMNS_MAX);
    for (int i = 0; i < e->pins; i++)
        e->field[i] = (glint_column){e->pin[i].name, NULL};
    if (data == 0)
        (void)snprintf(e->values, sizeof e->values,
                       "0 values: without data pins, a header must name the columns");
    else
        (void)snprintf(e->values, sizeof e->values, "the %d value%s of the data pins", data,
                       data == 1 ? "" : "s");
    return GLINT_EXIT_OK;
}

static void append(char *text, size_t size, const char *before, const char *what)
{
    const size_t used = strlen(text);
    (void)snprintf(text + used, size - used, "%s%s", before, what);
}

void glint_eval_circuit_details(const glint_setting *setting, char *text, size_t size)
{
    static column columns[GLINT_SIGNAL_WORDS_MAX];
    const int found = add_pins(setting, true, columns, 0);
    const int pins = found < GLINT_COLUMNS_MAX ? found : GLINT_COLUMNS_MAX;
    text[0] = '\0';
    append(text, size, "A line is:", "");
    for (int i = 0; i < pins; i++)
        append(text, size, " ", columns[i].name);
    append(text, size, pins == 0 ? " nothing, since the circuit has no data pins" : "",
           ", separated by blanks or commas: integers, or codes\n"
           "for pins with a binary point, in decimal or 0x. Blank lines and lines starting with #\n"
           "are skipped. The first line may be a header, as in this command's own output: columns\n"
           "are matched by name, others ignored. It may name the other pins, too.\n"
           "\n"
           "Each line goes in on one clock, back to back, with no reset in between; valid pins\n"
           "are 1, enables active, other controls 0, unless the header names them. The output is\n"
           "these values and, after the circuit's latency, its outputs:");
    const int outputs = find_outputs(setting, columns);
    for (int i = 0; i < outputs; i++)
        append(text, size, " ", columns[i].name);
    append(text, size, ".\n", "Values of more than 64 bits are printed in hex.");
}

/* ---- The circuit -------------------------------------------------------------------------------
 */

static void put(const glint_pin_info *pin, glint_pins *pins, bool all_ones)
{
    uint64_t words[GLINT_VALUE_WORDS];
    for (int i = 0; i < GLINT_VALUE_WORDS; i++)
        words[i] = all_ones ? UINT64_MAX : 0;
    glint_pin_set(pin, pins, words);
}

/* The pins of an idle clock, and those that accept a line, except for its values. */
static void make_pins(evaluation *e)
{
    for (int i = 0; i < glint_setting_pin_count(e->setting); i++) {
        const glint_pin_info pin = glint_setting_pin(e->setting, i);
        const bool is_on = pin.role == GLINT_PIN_ENABLE || pin.role == GLINT_PIN_RESET_LOW;
        put(&pin, &e->rest, is_on);
        put(&pin, &e->asking, is_on || pin.role == GLINT_PIN_VALID);
    }
}

static glint_status create(evaluation *e, bool is_rtl, glint_error *err)
{
    glint_status status = glint_signals_find(e->setting, &e->signals, err);
    if (status != GLINT_OK)
        return status;
    make_pins(e);
    if (is_rtl)
        return glint_rtl_open(e->setting, GLINT_RTL_OBSERVED, &e->rtl, err);
    return glint_model_create(e->setting, &e->model, err);
}

static void destroy(evaluation *e)
{
    glint_rtl_destroy(e->rtl);
    glint_model_destroy(e->setting, e->model);
}

static void clock_with(evaluation *e, const glint_pins *pins)
{
    if (e->rtl != NULL)
        glint_rtl_clock(e->rtl, pins);
    else
        glint_model_clock(e->setting, e->model, pins);
}

static void read_signals(evaluation *e)
{
    if (e->rtl != NULL)
        glint_rtl_read(e->rtl, e->words);
    else
        glint_signals_read(&e->signals, glint_model_signals(e->setting, e->model), e->words);
}

/* The line's clock and those until its result is out, then those until the next line can go in. */
static void ask(evaluation *e, const glint_pins *pins)
{
    const int latency = glint_setting_latency(e->setting);
    const int pace = glint_setting_pace(e->setting);
    clock_with(e, pins);
    for (int i = 1; i < latency; i++)
        clock_with(e, &e->rest);
    read_signals(e);
    for (int i = latency > 1 ? latency : 1; i < pace; i++)
        clock_with(e, &e->rest);
}

/* ---- Lines -------------------------------------------------------------------------------------
 */

/* Whether the lines have pin i: data, or a control that the header names. */
static bool is_read(const evaluation *e, int i)
{
    return i < e->pins - e->controls || (e->columns.width != 0 && e->columns.at[i] >= 0);
}

static void print_value(const evaluation *e, int width, bool is_signed, const uint64_t *words)
{
    char text[GLINT_VALUE_TEXT];
    if (width > 64)
        glint_words_hex(words, width, text);
    else
        glint_words_decimal(words, width, is_signed, text);
    const bool is_text = e->json && width > 53; /* a JSON number would lose bits */
    printf(is_text ? "\"%s\"" : "%s", text);
}

static void print_name(const evaluation *e, int number, const char *name)
{
    if (number != 0)
        putchar(',');
    if (e->json)
        printf("\"%s\":", name);
}

static void print_row(const evaluation *e, const glint_pins *pins)
{
    uint64_t words[GLINT_VALUE_WORDS];
    int printed = 0;
    if (e->json)
        printf("%s\n{", e->printed != 0 ? "," : "");
    for (int i = 0; i < e->pins; i++) {
        if (!is_read(e, i))
            continue;
        const glint_pin_info pin = glint_setting_pin(e->setting, e->pin[i].index);
        glint_pin_get(&pin, pins, words);
        print_name(e, printed++, e->pin[i].name);
        print_value(e, glint_pin_width(&pin), pin.is_signed, words);
    }
    for (int i = 0; i < e->outputs; i++) {
        const glint_signal_info *signal = &e->signals.info[e->output[i].index];
        print_name(e, printed++, e->output[i].name);
        print_value(e, glint_signal_width(signal), signal->is_signed,
                    e->words + e->signals.place[e->output[i].index]);
    }
    fputs(e->json ? "}" : "\n", stdout);
}

static glint_line_kind read_values(evaluation *e, char **value, glint_pins *pins, glint_error *err)
{
    uint64_t words[GLINT_VALUE_WORDS];
    char expected[64];
    for (int i = 0; i < e->pins; i++) {
        if (value[i] == NULL)
            continue;
        const glint_pin_info pin = glint_setting_pin(e->setting, e->pin[i].index);
        const int width = glint_pin_width(&pin);
        (void)snprintf(expected, sizeof expected, "an integer of %d bit%s%s, in decimal or 0x",
                       width, width == 1 ? "" : "s", pin.is_signed ? " with the sign" : "");
        if (!glint_words_parse(value[i], width, pin.is_signed, words))
            return glint_line_refuse(e->pin[i].name, value[i], expected, err);
        glint_pin_set(&pin, pins, words);
    }
    return GLINT_LINE_VALUES;
}

static glint_line_kind read_line(evaluation *e, char *line, size_t length, glint_pins *pins,
                                 glint_error *err)
{
    const glint_line_form form = {e->field, e->pins, e->values, e->controls};
    char *value[GLINT_COLUMNS_MAX];
    const glint_line_kind kind = glint_line_cut(&form, &e->columns, line, length, value, err);
    *pins = e->asking;
    return kind == GLINT_LINE_VALUES ? read_values(e, value, pins, err) : kind;
}

/* Once: when it is known whether the lines begin with a header of their own. */
static void print_header(evaluation *e)
{
    if (e->json || e->has_header)
        return;
    e->has_header = true;
    int printed = 0;
    for (int i = 0; i < e->pins; i++)
        if (is_read(e, i))
            printf("%s%s", printed++ > 0 ? "," : "", e->pin[i].name);
    for (int i = 0; i < e->outputs; i++)
        printf("%s%s", printed++ > 0 ? "," : "", e->output[i].name);
    putchar('\n');
}

static int take_line(void *context, uint64_t number, char *line, size_t length)
{
    evaluation *e = context;
    glint_pins pins;
    glint_error err;
    const glint_line_kind kind =
        line != NULL ? read_line(e, line, length, &pins, &err) : GLINT_LINE_NOTHING;
    if (line == NULL || e->columns.begun)
        print_header(e);
    switch (kind) {
    case GLINT_LINE_NOTHING:
        return GLINT_EXIT_OK;
    case GLINT_LINE_VALUES:
        ask(e, &pins);
        print_row(e, &pins);
        e->printed++;
        if (e->at_once)
            fflush(stdout);
        return ferror(stdout) ? glint_output_finish("eval", GLINT_EXIT_TROUBLE) : GLINT_EXIT_OK;
    case GLINT_LINE_MALFORMED:
        break;
    }
    fflush(stdout);
    return glint_complain("eval", GLINT_EXIT_TROUBLE, "line %" PRIu64 ": %s", number, err.text);
}

static int evaluate(evaluation *e)
{
    if (e->json)
        putchar('[');
    const int status = glint_input_lines("eval", e->values, take_line, e);
    if (status != GLINT_EXIT_OK && ferror(stdout)) /* which has been said */
        return status;
    if (e->json) /* closed in any case: the rows so far are valid */
        fputs("\n]\n", stdout);
    return glint_output_finish("eval", status);
}

int glint_eval_circuit(const glint_setting *setting, bool is_rtl, bool json)
{
    glint_error err;
    evaluation *e = calloc(1, sizeof *e);
    if (e == NULL)
        return glint_complain("eval", GLINT_EXIT_TROUBLE, "out of memory");
    e->setting = setting;
    e->json = json;
    e->at_once = isatty(STDIN_FILENO) == 1; /* at a terminal, each answer should appear at once */
    int status = find_columns(e);
    if (status == GLINT_EXIT_OK)
        status =
            create(e, is_rtl, &err) == GLINT_OK ? evaluate(e) : glint_complain_error("eval", &err);
    destroy(e);
    free(e);
    return status;
}
