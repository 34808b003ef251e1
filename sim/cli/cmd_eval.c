/* `glint eval`: points on standard input, the device's answers on standard output. */
#define _POSIX_C_SOURCE 200809L

#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "backend/backend.h"
#include "circuit/circuits.h"
#include "circuit/units.h"
#include "cli/build_first.h"
#include "cli/circuit_options.h"
#include "cli/commands.h"
#include "cli/divide.h"
#include "cli/eval_circuit.h"
#include "cli/eval_line.h"
#include "cli/input.h"
#include "cli/options.h"
#include "cli/output.h"

#define RUN_MAX 4096

typedef struct eval_options {
    glint_circuit_options circuits;
    int backend;
    bool json;
} eval_options;

/* Consecutive input points with the same material, shaded together. */
typedef struct run {
    glint_backend *backend;
    bool json;
    glint_columns columns;
    uint64_t printed; /* points of earlier runs */
    size_t limit;     /* shade when this many are waiting */
    size_t count;
    glint_material material;
    uint32_t cos_code[RUN_MAX];
    uint32_t w_code[RUN_MAX];
    uint8_t r[RUN_MAX], g[RUN_MAX], b[RUN_MAX];
} run;

/* The specular device is the faster, the more lanes it has. */
static const char *usual(const char *parameter)
{
    return strcmp(parameter, "lanes") == 0 ? "16" : NULL;
}

/* The help's paragraphs, with the numbers of the formats. */
static void write_details(char *text, size_t size)
{
    (void)snprintf(
        text, size,
        "A line is: n cos r g b, separated by blanks or commas. n is 0 to %u; cos is a\n"
        "number from 0 to 1, or a code of register 1, 0x0 to 0x%x or code:0 to\n"
        "code:%u (it saturates above 0x%x, code:%u, which is 1.0); r, g, b are\n"
        "0 to %u. Blank lines and lines starting with # are skipped.\n"
        "\n"
        "The first line may be a header, as in this command's own output: the columns n, r, g,\nb "
        "and cos, or cos_code with decimal codes, are matched by name, others ignored.\n"
        "\n"
        "The output columns are n,cos_code,w_code,r,g,b: cos_code is the content of\nregister 1, "
        "w_code the output of the key block, both in units of 2^-%d; another highlight\nunit "
        "(--device) has a W of its own width.\n"
        "\n"
        "--circuit divider reads divisions and prints quotients as glint divide does. For "
        "a\ncircuit of your own, see glint --circuit-dir DIR eval --help.",
        GLINT_N_MAX, GLINT_COS_CODE_MAX, GLINT_COS_CODE_MAX, GLINT_COS_ONE, GLINT_COS_ONE,
        GLINT_COLOR_MAX, GLINT_COS_FRAC_BITS);
}

#define OWN_ROWS 2

static int parse(int argc, char **argv, eval_options *chosen)
{
    static char details[4096];
    char by_code[80];
    const glint_circuit_use use = {
        .command = "eval", .circuit = "specular", .one_circuit = true, .usual = usual};
    const int begun = glint_circuit_options_begin(&chosen->circuits, &use, argc, argv);
    if (begun != GLINT_OPTIONS_RUN)
        return begun;
    glint_option options[OWN_ROWS + GLINT_CIRCUIT_OPTIONS] = {
        {.name = "backend",
         .help = "what computes: the C model, the Verilog, or the formula in floating point",
         .kind = GLINT_OPTION_CHOICE,
         .choice = {&chosen->backend, glint_backend_names}},
        {.name = "json",
         .help = "print a JSON array of objects instead of CSV",
         .kind = GLINT_OPTION_FLAG,
         .flag = &chosen->json},
    };
    const size_t count =
        OWN_ROWS + glint_circuit_options_add(&chosen->circuits, options + OWN_ROWS);
    const glint_setting first = glint_setting_standard(chosen->circuits.circuit[0]);
    const bool is_device = first.circuit == &glint_circuit_specular;
    if (is_device)
        write_details(details, sizeof details);
    else
        glint_eval_circuit_details(&first, details, sizeof details);
    (void)snprintf(by_code, sizeof by_code, "echo '80 code:%u 255 190 110' | glint eval --json",
                   glint_cos_code(0.99));
    static const glint_example none[] = {{NULL, NULL}};
    const glint_example examples[] = {
        {"one point, in Verilog", "echo '80 0.99 255 190 110' | glint eval --backend rtl"},
        {"a code of register 1, as eval prints it", by_code},
        {NULL, NULL},
    };
    const glint_command_line line = {
        .command = "eval",
        .summary = is_device ? "Reads points from standard input, one per line, and prints the "
                               "device's answer to each, in order."
                             : "Reads numbers from standard input, one clock per line, and prints "
                               "the circuit's answer to each line, in order.",
        .details = details,
        .examples = is_device ? examples : none,
        .options = options,
        .option_count = count,
    };
    const int status = glint_options_parse(&line, argc, argv);
    return status == GLINT_OPTIONS_RUN ? glint_circuit_options_settle(&chosen->circuits) : status;
}

static void print_row(const run *points, size_t i)
{
    const uint32_t code = points->cos_code[i];
    const uint32_t reg1 = code < GLINT_COS_ONE ? code : GLINT_COS_ONE;
    if (!points->json) {
        printf("%u,%" PRIu32 ",%" PRIu32 ",%u,%u,%u\n", points->material.n, reg1, points->w_code[i],
               points->r[i], points->g[i], points->b[i]);
        return;
    }
    /* Written by hand: a tree of millions of points would not fit, and these are integers only. */
    printf("%s\n{\"n\":%u,\"cos_code\":%" PRIu32 ",\"w_code\":%" PRIu32
           ",\"r\":%u,\"g\":%u,\"b\":%u}",
           points->printed + i > 0 ? "," : "", points->material.n, reg1, points->w_code[i],
           points->r[i], points->g[i], points->b[i]);
}

/* Shades and prints the points that wait. Returns an exit status. */
static int flush_run(run *points)
{
    if (points->count == 0)
        return GLINT_EXIT_OK;
    glint_error err;
    const glint_points shaded = {.cos = points->cos_code,
                                 .count = points->count,
                                 .w = points->w_code,
                                 .r = points->r,
                                 .g = points->g,
                                 .b = points->b};
    if (glint_backend_shade(points->backend, &points->material, &shaded, &err) != GLINT_OK)
        return glint_complain_error("eval", &err);
    for (size_t i = 0; i < points->count; i++)
        print_row(points, i);
    points->printed += points->count;
    points->count = 0;
    if (points->limit == 1)
        fflush(stdout);
    return ferror(stdout) ? glint_output_finish("eval", GLINT_EXIT_TROUBLE) : GLINT_EXIT_OK;
}

static bool same_material(const glint_material *a, const glint_material *b)
{
    return a->n == b->n && a->r == b->r && a->g == b->g && a->b == b->b;
}

static int add_point(run *points, const glint_eval_point *point)
{
    if (points->count == points->limit || !same_material(&points->material, &point->material)) {
        const int status = flush_run(points);
        if (status != GLINT_EXIT_OK)
            return status;
        points->material = point->material;
    }
    points->cos_code[points->count++] = point->cos_code;
    return points->count == points->limit ? flush_run(points) : GLINT_EXIT_OK;
}

static int take_line(void *context, uint64_t number, char *line, size_t length)
{
    run *points = context;
    glint_eval_point point;
    glint_error err;
    if (line == NULL)
        return flush_run(points);
    switch (glint_eval_read_line(&points->columns, line, length, &point, &err)) {
    case GLINT_LINE_VALUES:
        return add_point(points, &point);
    case GLINT_LINE_NOTHING:
        return GLINT_EXIT_OK;
    case GLINT_LINE_MALFORMED:
        break;
    }
    const int status = flush_run(points);
    if (status != GLINT_EXIT_OK)
        return status;
    fflush(stdout);
    return glint_complain("eval", GLINT_EXIT_TROUBLE, "line %" PRIu64 ": %s", number, err.text);
}

static int eval(run *points)
{
    fputs(points->json ? "[" : "n,cos_code,w_code,r,g,b\n", stdout);
    const int status =
        glint_input_lines("eval", "points, one per line: n cos r g b, such as 80 0.99 255 190 110",
                          take_line, points);
    if (status != GLINT_EXIT_OK && ferror(stdout)) /* which has been said */
        return status;
    if (points->json) /* closed in any case: the rows so far are valid */
        fputs("\n]\n", stdout);
    return glint_output_finish("eval", status);
}

static int eval_points(const eval_options *chosen, const glint_setting *setting)
{
    const glint_backend_config config =
        glint_backend_config_of((glint_backend_kind)chosen->backend, setting);
    glint_error err;
    run *points = calloc(1, sizeof *points);
    if (points == NULL)
        return glint_complain("eval", GLINT_EXIT_TROUBLE, "out of memory");
    /* Whoever types the points wants each answer at once. */
    points->limit = isatty(STDIN_FILENO) == 1 ? 1 : RUN_MAX;
    points->json = chosen->json;
    const int status = glint_backend_create(&config, &points->backend, &err) == GLINT_OK
                           ? eval(points)
                           : glint_complain_error("eval", &err);
    glint_backend_destroy(points->backend);
    free(points);
    return status;
}

static int eval_divisions(const eval_options *chosen, const glint_setting *setting)
{
    const glint_divider_config config = {
        .kind = (glint_backend_kind)chosen->backend,
        .form = (glint_divider_form)setting->values[GLINT_DIVIDER_FORM],
        .shifts = setting->values[GLINT_DIVIDER_SHIFTS],
        .verilog = setting->verilog};
    return glint_divide_lines("eval", &config, chosen->json);
}

static int eval_setting(const eval_options *chosen, const glint_setting *setting)
{
    const bool is_rtl = chosen->backend == GLINT_BACKEND_RTL;
    if (chosen->circuits.verilog != NULL && !is_rtl)
        return glint_rtl_option_settle("eval", setting, false);
    if (is_rtl) {
        const bool is_typed =
            glint_is_highlight(setting->circuit) || setting->circuit == &glint_circuit_divider;
        glint_error err;
        if (glint_build_first("eval", setting, 1, is_typed ? GLINT_RTL_FAST : GLINT_RTL_OBSERVED, 0,
                              &err) != GLINT_OK)
            return glint_complain_error("eval", &err);
    }
    if (glint_is_highlight(setting->circuit))
        return eval_points(chosen, setting);
    if (setting->circuit == &glint_circuit_divider)
        return eval_divisions(chosen, setting);
    if (chosen->backend == GLINT_BACKEND_REAL) {
        return glint_complain("eval", GLINT_EXIT_TROUBLE,
                              "--backend real: circuit %s has no formula; use c or rtl",
                              setting->circuit->name);
    }
    return glint_eval_circuit(setting, is_rtl, chosen->json);
}

int glint_cmd_eval(int argc, char **argv)
{
    eval_options chosen = {.backend = GLINT_BACKEND_C};
    const int parsed = parse(argc, argv, &chosen);
    if (parsed != GLINT_OPTIONS_RUN)
        return parsed;
    const glint_setting setting = glint_circuit_options_first(&chosen.circuits, 0);
    return eval_setting(&chosen, &setting);
}
