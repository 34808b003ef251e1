/* `glint energy`: how much of the light the reflectance models give back. */
#define _POSIX_C_SOURCE 200809L

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "cli/commands.h"
#include "cli/model_names.h"
#include "cli/number_list.h"
#include "cli/options.h"
#include "cli/output.h"
#include "cli/parse.h"
#include "cli/picture.h"
#include "energy/furnace.h"
#include "file/directory.h"
#include "file/kind.h"
#include "file/new_file.h"
#include "report/place.h"

enum { METHOD_QUADRATURE, METHOD_MONTE_CARLO, METHOD_BOTH };
static const char *const method_names[] = {"quadrature", "monte-carlo", "both", NULL};

#define THREADS_MAX 64
#define SAMPLES_MAX 100000000
#define ANGLE_MAX   89.9999 /* degrees: at 90 no light arrives */

/* The furnace's default exponents. */
#define FURNACE_N "1,3,10,30,100,300,1000"

typedef struct energy_options {
    const char *model, *n, *angle, *out;
    int method;
    int64_t samples, seed, threads, width;
    double f0;
    bool furnace, json, force, n_given, samples_given, seed_given, width_given;
} energy_options;

/* What is asked for, and how far it is. */
typedef struct run {
    const energy_options *chosen;
    glint_reflectance_model model[GLINT_REFLECTANCE_COUNT];
    glint_number_list n, angle;
    glint_energy_plan plan;
    glint_progress progress;
    uint64_t rows_before; /* those of the models that are done */
    json_t *json;         /* an array, with --json */
} run;

static int64_t online_cores(void)
{
    const long cores = sysconf(_SC_NPROCESSORS_ONLN);
    return cores < 1 ? 1 : cores > THREADS_MAX ? THREADS_MAX : cores;
}

/* ---- Command line ------------------------------------------------------------------------------
 */

static int check(const energy_options *chosen)
{
    if (chosen->method == METHOD_QUADRATURE && (chosen->samples_given || chosen->seed_given))
        return glint_complain("energy", GLINT_EXIT_TROUBLE,
                              "--samples and --seed need --method monte-carlo or both");
    if (chosen->furnace && chosen->method == METHOD_MONTE_CARLO)
        return glint_complain("energy", GLINT_EXIT_TROUBLE,
                              "--furnace needs quadrature: use --method quadrature or both");
    if (chosen->furnace && chosen->out == NULL)
        return glint_complain("energy", GLINT_EXIT_TROUBLE, "--furnace needs --out");
    if (chosen->width_given && !chosen->furnace)
        return glint_complain("energy", GLINT_EXIT_TROUBLE, "--width needs --furnace");
    return GLINT_OPTIONS_RUN;
}

static int parse(int argc, char **argv, energy_options *chosen)
{
    const glint_option options[] = {
        {.name = "model",
         .placeholder = "NAMES",
         .help = "comma-separated models, or all",
         .kind = GLINT_OPTION_STRING,
         .string = &chosen->model},
        {.name = "n",
         .placeholder = "LIST",
         .given = &chosen->n_given,
         .help = "exponents, 0 to 1e6; microfacets get the roughness √(2/(n+2))",
         .kind = GLINT_OPTION_STRING,
         .string = &chosen->n},
        {.name = "angle",
         .placeholder = "LIST",
         .help = "angles of incidence, 0 to 89.9999 degrees",
         .kind = GLINT_OPTION_STRING,
         .string = &chosen->angle},
        {.name = "method",
         .help = "method of integration",
         .kind = GLINT_OPTION_CHOICE,
         .choice = {&chosen->method, method_names}},
        {.name = "samples",
         .given = &chosen->samples_given,
         .help = "Monte Carlo samples per cell",
         .kind = GLINT_OPTION_INTEGER,
         .integer = {&chosen->samples, GLINT_SAMPLES_MIN, SAMPLES_MAX}},
        {.name = "seed",
         .given = &chosen->seed_given,
         .help = "seed of the samples",
         .kind = GLINT_OPTION_INTEGER,
         .integer = {&chosen->seed, 0, INT64_MAX}},
        {.name = "f0",
         .help = "normal reflectance of the microfacets; 1 is a mirror",
         .kind = GLINT_OPTION_REAL,
         .real = {&chosen->f0, 0.0, 1.0}},
        {.name = "out",
         .placeholder = "DIR",
         .help = "directory for the tables, albedo-NAME.csv; created if missing",
         .kind = GLINT_OPTION_STRING,
         .string = &chosen->out},
        {.name = "furnace",
         .help = "furnace.png too, and for the n " FURNACE_N " if none are given",
         .kind = GLINT_OPTION_FLAG,
         .flag = &chosen->furnace},
        {.name = "width",
         .given = &chosen->width_given,
         .help = "width of a furnace sphere, pixels",
         .kind = GLINT_OPTION_INTEGER,
         .integer = {&chosen->width, 8, 2048}},
        {.name = "threads",
         .usually = "one per processor",
         .help = "does not change the results",
         .kind = GLINT_OPTION_INTEGER,
         .integer = {&chosen->threads, 1, THREADS_MAX}},
        GLINT_FORCE_OPTION(&chosen->force),
        {.name = "json",
         .help = "print the summary as JSON",
         .kind = GLINT_OPTION_FLAG,
         .flag = &chosen->json},
    };
    static const glint_example examples[] = {
        {"three models, fifty exponents",
         "glint energy --model blinn,phong,energy-conserving --n 1..50"},
        {"tables and the furnace picture",
         "glint energy --model all --n 1,10,100 --furnace --out energy"},
        {NULL, NULL},
    };
    const glint_command_line line = {
        .command = "energy",
        .summary = "Integrates the directional albedo R(L) (2.21) of the reflectance models: the "
                   "fraction of a beam of light that the surface reflects. Above 1, the surface "
                   "reflects more light than it receives.",
        .details =
            "A LIST is ascending numbers, separated by commas; A..B stands for the integers\nfrom "
            "A to B, A..B:STEP for every STEP-th of them. Incidences run from 0 to below 90.\n"
            "\n"
            "Tables have the columns n, angle, quadrature, monte_carlo and standard_error, as far\n"
            "as the method provides them. The summary shows where R is largest, for how many\n"
            "exponents it exceeds 1 and, with both methods, how many cells agree within 1, 2 and\n"
            "3 standard errors: expect 68, 95 and 99.7 %.\n"
            "\n"
            "furnace.png has a row per model and a column per n: a sphere lit uniformly with 1\n"
            "from all directions, each pixel showing the albedo at its viewing angle, on white.\n"
            "Grey reflects less light than it receives; yellow (just above 1), red (1.5) and\n"
            "black (3 and more) reflect more.",
        .examples = examples,
        .options = options,
        .option_count = sizeof options / sizeof options[0],
    };
    const int status = glint_options_parse(&line, argc, argv);
    return status == GLINT_OPTIONS_RUN ? check(chosen) : status;
}

static bool is_there(const run *all, glint_reflectance_model model)
{
    for (int i = 0; i < all->plan.model_count; i++)
        if (all->model[i] == model)
            return true;
    return false;
}

/* The names between commas. Returns an exit status or GLINT_OPTIONS_RUN. */
static int find_models(run *all)
{
    const char *text = all->chosen->model;
    int *count = &all->plan.model_count;
    if (strcmp(text, "all") == 0) {
        for (; *count < GLINT_REFLECTANCE_COUNT; ++*count)
            all->model[*count] = (glint_reflectance_model)*count;
        return GLINT_OPTIONS_RUN;
    }
    for (bool more = true; more; text++) {
        char name[64];
        const size_t length = strcspn(text, ",");
        (void)snprintf(name, sizeof name, "%.*s", length < 60 ? (int)length : 60, text);
        glint_reflectance_model model;
        if (!glint_reflectance_find(name, &model))
            return glint_refuse_model("energy", "model", name);
        if (is_there(all, model))
            return glint_complain("energy", GLINT_EXIT_TROUBLE, "--model: %s is given twice", name);
        all->model[(*count)++] = model;
        more = text[length] != '\0';
        text += length;
    }
    return GLINT_OPTIONS_RUN;
}

static int find_numbers(const char *option, const char *text, double max, const char *what,
                        const char *example, glint_number_list *list)
{
    glint_quoted quoted;
    return glint_number_list_parse(text, 0.0, max, list)
               ? GLINT_OPTIONS_RUN
               : glint_complain(
                     "energy", GLINT_EXIT_TROUBLE,
                     "--%s: %s is not an ascending list of %s from 0 to %.7g, such as %s", option,
                     glint_quote(text, &quoted), what, max, example);
}

/* Whether the furnace's picture can be as large. */
static int check_picture(const run *all)
{
    const int longest = all->n.count > all->plan.model_count ? all->n.count : all->plan.model_count;
    const int most = GLINT_IMAGE_SIDE_MAX / (int)(all->chosen->width + all->chosen->width / 8 + 1);
    return !all->chosen->furnace || longest < most
               ? GLINT_OPTIONS_RUN
               : glint_complain(
                     "energy", GLINT_EXIT_TROUBLE,
                     "--furnace: %d spheres side by side are too many (fewer than %d fit)", longest,
                     most);
}

/* Before the long work: checks that each model accepts each n. */
static int check_exponents(const run *all)
{
    for (int i = 0; i < all->plan.model_count; i++) {
        const glint_reflectance_info *info = glint_reflectance_describe(all->model[i]);
        for (int j = 0; j < all->n.count; j++) {
            const double n = all->n.value[j];
            if (n < info->n_min || n > info->n_max || (info->whole_n && floor(n) != n))
                return glint_complain(
                    "energy", GLINT_EXIT_TROUBLE, "--n: model %s takes %s from %g to %g, not %g",
                    glint_reflectance_names[all->model[i]], info->whole_n ? "integers" : "numbers",
                    info->n_min, info->n_max, n);
        }
    }
    return GLINT_OPTIONS_RUN;
}

static int find_what(run *all)
{
    const energy_options *chosen = all->chosen;
    int status = find_models(all);
    if (status == GLINT_OPTIONS_RUN)
        status = find_numbers("n", chosen->furnace && !chosen->n_given ? FURNACE_N : chosen->n,
                              GLINT_EXPONENT_MAX, "exponents", "1..1000 or 1,5,80", &all->n);
    if (status == GLINT_OPTIONS_RUN)
        status = find_numbers("angle", chosen->angle, ANGLE_MAX, "degrees", "0..89 or 0,45",
                              &all->angle);
    if (status == GLINT_OPTIONS_RUN)
        status = check_exponents(all);
    return status == GLINT_OPTIONS_RUN ? check_picture(all) : status;
}

/* ---- Files -------------------------------------------------------------------------------------
 */

static void write_cell(FILE *out, const glint_energy_plan *plan, const glint_energy_cell *cell)
{
    if (plan->quadrature)
        fprintf(out, ",%.9g", cell->quadrature);
    if (plan->samples > 0)
        fprintf(out, ",%.9g,%.3g", cell->monte_carlo.mean, cell->monte_carlo.error);
    fputc('\n', out);
}

static glint_status write_table(const char *directory, const glint_energy_table *table, int model,
                                glint_error *err)
{
    char name[64];
    glint_place place;
    glint_new_file *file;
    const glint_energy_plan *plan = &table->plan;
    (void)snprintf(name, sizeof name, "albedo-%s.csv", glint_reflectance_names[plan->model[model]]);
    glint_status status = glint_place_in(directory, name, &place, err);
    if (status == GLINT_OK)
        status = glint_new_file_open(place.path, &file, err);
    if (status != GLINT_OK)
        return status;
    FILE *out = glint_new_file_stream(file);
    fprintf(out, "n,angle%s%s\n", plan->quadrature ? ",quadrature" : "",
            plan->samples > 0 ? ",monte_carlo,standard_error" : "");
    for (int i = 0; i < plan->n_count; i++)
        for (int j = 0; j < plan->angle_count; j++) {
            fprintf(out, "%.12g,%.12g", plan->n[i], plan->angle[j]);
            write_cell(out, plan, glint_energy_at(table, model, i, j));
        }
    return glint_new_file_commit(file, err);
}

/* Before the long work: checks that existing files may be replaced. */
static glint_status check_files(const run *all, glint_error *err)
{
    char name[64] = "furnace.png";
    glint_place place;
    glint_status status = GLINT_OK;
    for (int i = all->chosen->furnace ? -1 : 0; i < all->plan.model_count && status == GLINT_OK;
         i++) {
        if (i >= 0)
            (void)snprintf(name, sizeof name, "albedo-%s.csv",
                           glint_reflectance_names[all->model[i]]);
        status = glint_place_in(all->chosen->out, name, &place, err);
        if (status == GLINT_OK && !all->chosen->force)
            status = glint_file_replaceable(place.path, err);
    }
    return status;
}

static glint_status write_furnace(const run *all, const glint_energy_table *table, glint_error *err)
{
    glint_place place;
    glint_image *image;
    glint_status status = glint_place_in(all->chosen->out, "furnace.png", &place, err);
    if (status == GLINT_OK)
        status = glint_furnace_picture(table, 0, table->plan.model_count, (int)all->chosen->width,
                                       &image, err);
    if (status != GLINT_OK)
        return status;
    status = glint_image_write_png(image, place.path, err);
    glint_image_destroy(image);
    return status;
}

static glint_status write_files(const run *all, const glint_energy_table *table, glint_error *err)
{
    glint_status status = GLINT_OK;
    for (int i = 0; i < table->plan.model_count && status == GLINT_OK; i++)
        status = write_table(all->chosen->out, table, i, err);
    return status == GLINT_OK && all->chosen->furnace ? write_furnace(all, table, err) : status;
}

/* ---- Summary -----------------------------------------------------------------------------------
 */

static double share(uint64_t part, const glint_energy_summary *summary)
{
    return (double)part / (double)summary->cells;
}

static void print_summary(const char *name, const glint_energy_summary *summary)
{
    printf("%-25s R up to %.6f (n = %g, %g°), ", name, summary->largest, summary->largest_n,
           summary->largest_angle);
    if (summary->n_above == 0)
        printf("never above 1");
    else
        printf("above 1 for %d n (%g…%g)", summary->n_above, summary->first_above,
               summary->last_above);
    if (summary->cells > 0)
        printf("; of %" PRIu64 " cells %.2f, %.2f, %.2f %% within 1, 2, 3 errors, farthest %.2f",
               summary->cells, 100.0 * share(summary->within_1, summary),
               100.0 * share(summary->within_2, summary), 100.0 * share(summary->within_3, summary),
               summary->farthest);
    putchar('\n');
    fflush(stdout); /* so that a long run can be followed */
}

static bool add_agreement(json_t *object, const glint_energy_summary *summary)
{
    return summary->cells == 0 ||
           (glint_json_add_number(object, "cells", (double)summary->cells) &&
            glint_json_add_number(object, "within_1", share(summary->within_1, summary)) &&
            glint_json_add_number(object, "within_2", share(summary->within_2, summary)) &&
            glint_json_add_number(object, "within_3", share(summary->within_3, summary)) &&
            glint_json_add_number(object, "farthest", summary->farthest));
}

static bool add_summary(json_t *array, const char *name, const glint_energy_summary *summary)
{
    json_t *object = json_object();
    if (json_array_append_new(array, object) != 0)
        return false;
    return glint_json_add_text(object, "model", name) &&
           glint_json_add_number(object, "largest", summary->largest) &&
           glint_json_add_number(object, "largest_n", summary->largest_n) &&
           glint_json_add_number(object, "largest_angle", summary->largest_angle) &&
           glint_json_add_number(object, "exponents_above_1", summary->n_above) &&
           (summary->n_above == 0 ||
            (glint_json_add_number(object, "first_above_1", summary->first_above) &&
             glint_json_add_number(object, "last_above_1", summary->last_above))) &&
           add_agreement(object, summary);
}

static int print_models(const run *all, const glint_energy_table *table)
{
    for (int i = 0; i < table->plan.model_count; i++) {
        const char *name = glint_reflectance_names[table->plan.model[i]];
        glint_energy_summary summary;
        glint_energy_summarize(table, i, &summary);
        if (!all->chosen->json)
            print_summary(name, &summary);
        else if (!add_summary(all->json, name, &summary))
            return glint_complain("energy", GLINT_EXIT_TROUBLE, "out of memory");
    }
    return GLINT_EXIT_OK;
}

static int print_json(run *all)
{
    json_t *object = json_object();
    bool whole = json_object_set(object, "models", all->json) == 0 &&
                 glint_json_add_number(object, "exponents", all->n.count) &&
                 glint_json_add_number(object, "incidences", all->angle.count) &&
                 glint_json_add_number(object, "f0", all->chosen->f0);
    if (all->plan.samples > 0)
        whole = whole && glint_json_add_number(object, "samples", all->plan.samples) &&
                glint_json_add_number(object, "seed", (double)all->plan.seed);
    if (whole)
        return glint_output_json(object)
                   ? GLINT_EXIT_OK
                   : glint_complain("energy", GLINT_EXIT_TROUBLE, "out of memory");
    json_decref(object);
    return glint_complain("energy", GLINT_EXIT_TROUBLE, "out of memory");
}

/* ---- Work --------------------------------------------------------------------------------------
 */

static void show_progress(void *context, uint64_t rows_done, uint64_t rows)
{
    run *all = context;
    (void)rows;
    glint_progress_update(&all->progress, all->rows_before + rows_done,
                          (uint64_t)all->plan.model_count * (uint64_t)all->plan.n_count);
}

/* `count` models from `first` on. */
static int do_models(run *all, int first, int count)
{
    glint_energy_plan plan = all->plan;
    glint_energy_table *table;
    glint_error err;
    plan.model += first;
    plan.model_count = count;
    glint_progress_begin(&all->progress, "energy", "rows");
    glint_status status = glint_energy_table_make(&plan, &table, &err);
    glint_progress_end(&all->progress);
    if (status != GLINT_OK)
        return glint_complain_error("energy", &err);
    all->rows_before += (uint64_t)count * (uint64_t)plan.n_count;
    if (all->chosen->out != NULL)
        status = write_files(all, table, &err);
    const int done =
        status == GLINT_OK ? print_models(all, table) : glint_complain_error("energy", &err);
    glint_energy_table_destroy(table);
    return done;
}

/* Model by model, so that an interrupted run keeps what is done; all at once for a picture. */
static int do_all(run *all)
{
    const int group = all->chosen->furnace ? all->plan.model_count : 1;
    if (all->plan.samples > 0 && !all->chosen->json)
        printf("seed %" PRIu64 ", %d samples a cell\n", all->plan.seed, all->plan.samples);
    int status = GLINT_EXIT_OK;
    for (int i = 0; i < all->plan.model_count && status == GLINT_EXIT_OK; i += group)
        status = do_models(all, i, group);
    return status == GLINT_EXIT_OK && all->chosen->json ? print_json(all) : status;
}

static void fill_plan(run *all)
{
    const energy_options *chosen = all->chosen;
    all->plan.model = all->model;
    all->plan.n = all->n.value;
    all->plan.n_count = all->n.count;
    all->plan.angle = all->angle.value;
    all->plan.angle_count = all->angle.count;
    all->plan.f0 = chosen->f0;
    all->plan.quadrature = chosen->method != METHOD_MONTE_CARLO;
    all->plan.samples = chosen->method != METHOD_QUADRATURE ? (int)chosen->samples : 0;
    all->plan.seed = (uint64_t)chosen->seed;
    all->plan.threads = (int)chosen->threads;
    all->plan.stop = glint_stop_flag();
    all->plan.progress = show_progress;
    all->plan.context = all;
}

static int start(run *all)
{
    glint_error err;
    fill_plan(all);
    if (all->chosen->out != NULL && (glint_directory_make(all->chosen->out, &err) != GLINT_OK ||
                                     check_files(all, &err) != GLINT_OK))
        return glint_complain_error("energy", &err);
    all->json = json_array();
    return all->json != NULL ? glint_output_finish("energy", do_all(all))
                             : glint_complain("energy", GLINT_EXIT_TROUBLE, "out of memory");
}

int glint_cmd_energy(int argc, char **argv)
{
    energy_options chosen = {.model = "all",
                             .n = "1..1000",
                             .angle = "0..89",
                             .samples = 256,
                             .seed = 1,
                             .f0 = 1.0,
                             .width = 96,
                             .threads = online_cores()};
    int status = parse(argc, argv, &chosen);
    if (status != GLINT_OPTIONS_RUN)
        return status;
    run all = {.chosen = &chosen};
    status = find_what(&all);
    if (status == GLINT_OPTIONS_RUN)
        status = start(&all);
    json_decref(all.json);
    free(all.angle.value);
    free(all.n.value);
    return status;
}
