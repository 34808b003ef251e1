/* `glint divide`: divisions on standard input, the divider's answers on standard output. */
#define _POSIX_C_SOURCE 200809L

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "circuit/circuits.h"
#include "cli/build_first.h"
#include "cli/circuit_options.h"
#include "cli/commands.h"
#include "cli/divide.h"
#include "cli/input.h"
#include "cli/options.h"
#include "cli/output.h"
#include "cli/parse.h"

#define RUN_MAX 4096

typedef struct divide_options {
    int backend, form;
    int64_t shifts;
    const char *verilog;
    bool json;
} divide_options;

/* A row of the output that waits: component `component` of division `division`. */
typedef struct row {
    uint64_t line;
    int32_t difference, k;
    size_t division;
    int component;
} row;

/* The numbers of a row, as text. There are only as many divisions as pairs of difference and
 * length, far fewer than rows, and finding the fewest decimals takes much longer than a
 * division. */
#define NUMBER      32
#define DIFFERENCES (2 * GLINT_DIVIDER_DIFFERENCE_MAX + 1)
typedef struct numbers {
    bool known;
    int32_t code;
    char text[3][NUMBER]; /* quotient, exact, error */
} numbers;

/* Rows that are divided together. Neighbours of one k are components of one division. */
typedef struct run {
    const char *command;
    glint_divider_backend *backend;
    int shifts;
    bool json, printed;
    size_t limit; /* divide when this many wait */
    size_t row_count, division_count;
    row rows[RUN_MAX];
    glint_division divisions[RUN_MAX];
    glint_quotients quotients[RUN_MAX];
    glint_columns columns;
    numbers numbers[DIFFERENCES][GLINT_DIVIDER_K_MAX]; /* k from 1 on */
} run;

static int parse(int argc, char **argv, divide_options *chosen)
{
    const glint_option options[] = {
        {.name = "backend",
         .help = "what divides: the C model, the Verilog, or exact division rounded half up",
         .kind = GLINT_OPTION_CHOICE,
         .choice = {&chosen->backend, glint_backend_names}},
        {.name = "shifts",
         .help = "n, the number of shifts, and of fraction bits in the quotient",
         .kind = GLINT_OPTION_INTEGER,
         .integer = {&chosen->shifts, GLINT_DIVIDER_SHIFTS_MIN, GLINT_DIVIDER_SHIFTS_MAX}},
        {.name = "form",
         .help = "of the Verilog; both forms give the same quotients",
         .kind = GLINT_OPTION_CHOICE,
         .choice = {&chosen->form, glint_divider_form_names}},
        GLINT_RTL_OPTION(&chosen->verilog),
        {.name = "json",
         .help = "print a JSON array of objects instead of CSV",
         .kind = GLINT_OPTION_FLAG,
         .flag = &chosen->json},
    };
    static const glint_example examples[] = {
        {"255/7 with six shifts, in Verilog",
         "echo '255 7' | glint divide --shifts 6 --backend rtl"},
        {"the output of divide, divided again with more shifts",
         "echo '255 7' | glint divide | glint divide --shifts 16"},
        {NULL, NULL},
    };
    const glint_command_line line = {
        .command = "divide",
        .summary = "Reads divisions from standard input, one per line, and prints the "
                   "shift-accumulate divider's answer to each, in order.",
        .details = GLINT_DIVIDE_DETAILS,
        .examples = examples,
        .options = options,
        .option_count = sizeof options / sizeof options[0],
    };
    return glint_options_parse(&line, argc, argv);
}

/* The fewest decimals that read back as the same number, never with an exponent: values are below
 * 256, and above 10⁻⁸ where they are not 0. */
static void write_real(double value, char text[NUMBER])
{
    char tried[NUMBER];
    for (int decimals = 0; decimals <= 28; decimals++) {
        (void)snprintf(tried, sizeof tried, "%.*f", decimals, value);
        if (strtod(tried, NULL) == value)
            break;
    }
    memcpy(text, tried, sizeof tried);
}

static void fill_numbers(numbers *of, int shifts, int32_t difference, int32_t k, int32_t code)
{
    const int32_t one = INT32_C(1) << shifts;
    /* Integers up to the one division: each is the double nearest to the true value. */
    const double values[] = {(double)code / one, (double)difference / k,
                             (double)(code * k - difference * one) / (double)(k * one)};
    for (int i = 0; i < 3; i++)
        write_real(values[i], of->text[i]);
    of->known = true;
    of->code = code;
}

/* Of a row whose k is in the table. A wrong circuit may answer the same division twice with
 * different codes. */
static const numbers *numbers_of(run *all, const row *r, int32_t code)
{
    numbers *of = &all->numbers[r->difference + GLINT_DIVIDER_DIFFERENCE_MAX][r->k - 1];
    if (!of->known || of->code != code)
        fill_numbers(of, all->shifts, r->difference, r->k, code);
    return of;
}

static void print_row(run *all, const row *r)
{
    static const char *const names[] = {"quotient", "exact", "error"};
    const int32_t code = all->quotients[r->division].code[r->component];
    const numbers *of = numbers_of(all, r, code);
    printf(all->json ? "%s\n{\"difference\":%" PRId32 ",\"k\":%" PRId32
                       ",\"shifts\":%d,\"quotient_code\":%" PRId32
                     : "%s%" PRId32 ",%" PRId32 ",%d,%" PRId32,
           all->json && all->printed ? "," : "", r->difference, r->k, all->shifts, code);
    for (int i = 0; i < 3; i++) {
        if (all->json)
            printf(",\"%s\":", names[i]);
        else
            putchar(',');
        fputs(of->text[i], stdout);
    }
    fputs(all->json ? "}" : "\n", stdout);
}

/* The circuit has flagged this row's k. */
static int refuse_row(const run *all, const row *r)
{
    fflush(stdout);
    return glint_complain(all->command, GLINT_EXIT_TROUBLE,
                          "line %" PRIu64 ": k = %" PRId32 " is not in the table (1 to %d)",
                          r->line, r->k, GLINT_DIVIDER_K_MAX);
}

static int print_rows(run *all)
{
    for (size_t i = 0; i < all->row_count; i++) {
        if (all->quotients[all->rows[i].division].out_of_table)
            return refuse_row(all, &all->rows[i]);
        print_row(all, &all->rows[i]);
        all->printed = true;
    }
    return GLINT_EXIT_OK;
}

/* Divides and prints the rows that wait. Returns an exit status. */
static int flush_run(run *all)
{
    glint_error err;
    if (glint_divider_backend_divide(all->backend, all->divisions, all->division_count,
                                     all->quotients, &err) != GLINT_OK)
        return glint_complain_error(all->command, &err);
    const int status = print_rows(all);
    all->row_count = 0;
    all->division_count = 0;
    if (status != GLINT_EXIT_OK)
        return status;
    if (all->limit == 1)
        fflush(stdout);
    return ferror(stdout) ? glint_output_finish(all->command, GLINT_EXIT_TROUBLE) : GLINT_EXIT_OK;
}

/* Whether the row can be one more component of the division of the row before it. */
static bool joins_previous(const run *all, int32_t k)
{
    if (all->row_count == 0)
        return false;
    const row *previous = &all->rows[all->row_count - 1];
    return previous->k == k && previous->component + 1 < GLINT_DIVIDER_COMPONENTS;
}

static int add_row(run *all, uint64_t line, int32_t difference, int32_t k)
{
    row added = {.line = line, .difference = difference, .k = k};
    if (joins_previous(all, k)) {
        added.division = all->division_count - 1;
        added.component = all->rows[all->row_count - 1].component + 1;
    } else {
        added.division = all->division_count++;
        all->divisions[added.division] = (glint_division){.k = (uint8_t)k};
    }
    all->divisions[added.division].difference[added.component] = (int16_t)difference;
    all->rows[all->row_count++] = added;
    return all->row_count == all->limit ? flush_run(all) : GLINT_EXIT_OK;
}

static glint_line_kind read_line(glint_columns *columns, char *line, size_t length,
                                 int64_t *difference, int64_t *k, glint_error *err)
{
    static const glint_column fields[] = {{"difference", NULL}, {"k", NULL}};
    static const glint_line_form form = {fields, 2, "two values (difference k)", 0};
    char *value[2];
    const glint_line_kind kind = glint_line_cut(&form, columns, line, length, value, err);
    if (kind != GLINT_LINE_VALUES)
        return kind;
    if (!glint_parse_integer(value[0], -GLINT_DIVIDER_DIFFERENCE_MAX, GLINT_DIVIDER_DIFFERENCE_MAX,
                             difference))
        return glint_line_refuse("difference", value[0], "an integer from -255 to 255", err);
    if (!glint_parse_integer(value[1], 0, (1 << GLINT_DIVIDER_K_BITS) - 1, k))
        return glint_line_refuse("k", value[1], "an integer from 0 to 255", err);
    return GLINT_LINE_VALUES;
}

static int take_line(void *context, uint64_t number, char *line, size_t length)
{
    run *all = context;
    int64_t difference, k;
    glint_error err;
    if (line == NULL)
        return flush_run(all);
    switch (read_line(&all->columns, line, length, &difference, &k, &err)) {
    case GLINT_LINE_VALUES:
        return add_row(all, number, (int32_t)difference, (int32_t)k);
    case GLINT_LINE_NOTHING:
        return GLINT_EXIT_OK;
    case GLINT_LINE_MALFORMED:
        break;
    }
    const int status = flush_run(all);
    if (status != GLINT_EXIT_OK)
        return status;
    fflush(stdout);
    return glint_complain(all->command, GLINT_EXIT_TROUBLE, "line %" PRIu64 ": %s", number,
                          err.text);
}

static int divide(run *all)
{
    fputs(all->json ? "[" : "difference,k,shifts,quotient_code,quotient,exact,error\n", stdout);
    const int status = glint_input_lines(
        all->command, "divisions, one per line: difference k, such as 255 7", take_line, all);
    if (status != GLINT_EXIT_OK && ferror(stdout)) /* which has been said */
        return status;
    if (all->json) /* closed in any case: the rows so far are valid */
        fputs("\n]\n", stdout);
    return glint_output_finish(all->command, status);
}

int glint_divide_lines(const char *command, const glint_divider_config *config, bool json)
{
    run *all = calloc(1, sizeof *all);
    if (all == NULL)
        return glint_complain(command, GLINT_EXIT_TROUBLE, "out of memory");
    /* Whoever types the divisions wants each answer at once. */
    all->limit = isatty(STDIN_FILENO) == 1 ? 1 : RUN_MAX;
    all->command = command;
    all->json = json;
    all->shifts = config->shifts;
    glint_error err;
    const int status = glint_divider_backend_create(config, &all->backend, &err) == GLINT_OK
                           ? divide(all)
                           : glint_complain_error(command, &err);
    glint_divider_backend_destroy(all->backend);
    free(all);
    return status;
}

int glint_cmd_divide(int argc, char **argv)
{
    divide_options chosen = {.backend = GLINT_BACKEND_C,
                             .form = GLINT_DIVIDER_PIPELINED,
                             .shifts = GLINT_DIVIDER_SHIFTS_DEFAULT};
    int status = parse(argc, argv, &chosen);
    if (status != GLINT_OPTIONS_RUN)
        return status;
    const glint_divider_config config = {.kind = (glint_backend_kind)chosen.backend,
                                         .form = (glint_divider_form)chosen.form,
                                         .shifts = (int)chosen.shifts,
                                         .verilog = chosen.verilog};
    glint_setting setting = glint_setting_divider(config.form, config.shifts);
    setting.verilog = chosen.verilog;
    status = glint_rtl_option_settle("divide", &setting, config.kind == GLINT_BACKEND_RTL);
    if (status != GLINT_OPTIONS_RUN)
        return status;
    glint_error err;
    if (config.kind == GLINT_BACKEND_RTL &&
        glint_build_first("divide", &setting, 1, GLINT_RTL_FAST, 0, &err) != GLINT_OK)
        return glint_complain_error("divide", &err);
    return glint_divide_lines("divide", &config, chosen.json);
}
