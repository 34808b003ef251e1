/* `glint models`: the reflectance models, and how far each is from cosⁿ. */
#include <stdio.h>

#include "cli/commands.h"
#include "cli/options.h"
#include "cli/output.h"
#include "reflectance/accuracy.h"

/* The thesis's range of n. */
#define N_FIRST 1
#define N_LAST  1000

typedef struct choices {
    double n, level;
    bool coefficients, as_json;
} choices;

/* false for a model that does not approximate a power of one cosine or does not accept this n. */
static bool measure(glint_reflectance_model model, const choices *chosen, glint_accuracy *accuracy)
{
    glint_reflectance prepared;
    const glint_reflectance_parameters parameters = {.n = chosen->n, .f0 = GLINT_F0_DEFAULT};
    return glint_reflectance_prepare(model, &parameters, &prepared, NULL) == GLINT_OK &&
           glint_accuracy_measure(&prepared, chosen->level, accuracy, NULL) == GLINT_OK;
}

static void print_text(const choices *chosen)
{
    printf(
        "Differences from cos^n for n = %g: the largest overall, the largest in the "
        "epicentre\n(cos^n >= %g), and the largest there relative to cos^n. c is the cosine.\n\n",
        chosen->n, chosen->level);
    printf("%-25s %-20s %11s %11s %11s  formula\n", "model", "equation", "largest", "epicentre",
           "relative");
    for (int i = 0; i < GLINT_REFLECTANCE_COUNT; i++) {
        const glint_reflectance_model model = (glint_reflectance_model)i;
        const glint_reflectance_info *info = glint_reflectance_describe(model);
        glint_accuracy a;
        printf("%-25s %-20s", glint_reflectance_names[i], info->equation);
        if (measure(model, chosen, &a)) {
            printf(" %11.5f %11.5f %11.5f", a.absolute.error, a.epicentre_absolute.error,
                   a.epicentre_relative.error);
        } else {
            printf(" %11s %11s %11s", "-", "-", "-");
        }
        printf("  %s\n    %s\n", info->formula, info->edges);
    }
}

static void add_errors(json_t *json, const glint_accuracy *a)
{
    glint_json_add_number(json, "largest_error", a->absolute.error);
    glint_json_add_number(json, "largest_error_cosine", a->absolute.cosine);
    glint_json_add_number(json, "epicentre_error", a->epicentre_absolute.error);
    glint_json_add_number(json, "epicentre_relative_error", a->epicentre_relative.error);
}

static bool print_json(const choices *chosen)
{
    static const char *const cosines[] = {
        [GLINT_REFLECTANCE_OF_NL] = "N.L",
        [GLINT_REFLECTANCE_OF_RV] = "R.V",
        [GLINT_REFLECTANCE_OF_NH] = "N.H",
        [GLINT_REFLECTANCE_OF_GEOMETRY] = "N.L N.V N.H V.H",
    };
    json_t *json = json_object();
    glint_json_add_number(json, "n", chosen->n);
    glint_json_add_number(json, "level", chosen->level);
    json_t *list = glint_json_add(json, "models", json_array());
    for (int i = 0; i < GLINT_REFLECTANCE_COUNT; i++) {
        const glint_reflectance_model model = (glint_reflectance_model)i;
        const glint_reflectance_info *info = glint_reflectance_describe(model);
        json_t *entry = json_object();
        glint_json_add_text(entry, "name", glint_reflectance_names[i]);
        glint_json_add_text(entry, "title", info->title);
        glint_json_add_text(entry, "equation", info->equation);
        glint_json_add_text(entry, "formula", info->formula);
        glint_json_add_text(entry, "edges", info->edges);
        glint_json_add_text(entry, "cosine", cosines[info->cosine]);
        glint_json_add_number(entry, "n_min", info->n_min);
        glint_json_add_number(entry, "n_max", info->n_max);
        glint_accuracy a;
        if (measure(model, chosen, &a))
            add_errors(entry, &a);
        json_array_append_new(list, entry);
    }
    return glint_output_json(json);
}

/* Whatever depends only on n, for filling tables. */
static void print_coefficients(void)
{
    static const int members[] = {2, 4, 8, 16};
    printf("n,quadratic_a,schlick_modified_power_a");
    for (int i = 0; i < 4; i++)
        printf(",lyon_%d_slope,lyon_%d_minimax_slope", members[i], members[i]);
    putchar('\n');
    for (int n = N_FIRST; n <= N_LAST && !glint_stop_requested(); n++) {
        printf("%d,%.17g,%.17g", n, glint_quadratic_a(n), glint_schlick_power_a(n));
        for (int i = 0; i < 4; i++) {
            printf(",%.17g,%.17g", glint_lyon_slope_equal(members[i], n),
                   glint_lyon_slope_minimax(members[i], n));
        }
        putchar('\n');
    }
}

static int run(const choices *chosen)
{
    if (chosen->coefficients) {
        print_coefficients();
        return glint_stop_requested() ? glint_complain("models", GLINT_EXIT_TROUBLE,
                                                       "interrupted: the table is incomplete")
                                      : GLINT_EXIT_OK;
    }
    if (chosen->as_json) {
        return print_json(chosen) ? GLINT_EXIT_OK
                                  : glint_complain("models", GLINT_EXIT_TROUBLE, "out of memory");
    }
    print_text(chosen);
    return GLINT_EXIT_OK;
}

int glint_cmd_models(int argc, char **argv)
{
    choices chosen = {.n = 100, .level = GLINT_EPICENTRE_LEVEL};
    const glint_option options[] = {
        {.name = "n",
         .help = "exponent at which the errors are measured",
         .kind = GLINT_OPTION_REAL,
         .real = {&chosen.n, N_FIRST, GLINT_EXPONENT_MAX}},
        {.name = "level",
         .help = "the epicentre is where cos^n is at least this",
         .kind = GLINT_OPTION_REAL,
         .real = {&chosen.level, 0.01, 0.99}},
        {.name = "coefficients",
         .help = "print instead, as CSV, the coefficients that depend only on n, for n = 1 to 1000",
         .kind = GLINT_OPTION_FLAG,
         .flag = &chosen.coefficients},
        {.name = "json", .help = "print JSON", .kind = GLINT_OPTION_FLAG, .flag = &chosen.as_json},
    };
    static const glint_example examples[] = {
        {"the models and their errors at n = 20", "glint models --n 20"},
        {"coefficients for every n, as CSV", "glint models --coefficients > coefficients.csv"},
        {NULL, NULL},
    };
    const glint_command_line line = {
        .command = "models",
        .summary = "Lists the reflectance models: name, equation in the thesis, formula, behaviour "
                   "at the ends of the domain, and deviation from cos^n.",
        .examples = examples,
        .options = options,
        .option_count = sizeof options / sizeof options[0],
    };
    const int status = glint_options_parse(&line, argc, argv);
    if (status != GLINT_OPTIONS_RUN)
        return status;
    if (chosen.coefficients && chosen.as_json) {
        return glint_complain("models", GLINT_EXIT_TROUBLE,
                              "--coefficients prints CSV: it cannot be used with --json");
    }
    return glint_output_finish("models", run(&chosen));
}
