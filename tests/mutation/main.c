/* Runs the bench against every fault of a netlist, or against one:
 *
 *     bench --list mutants.list --out verdicts.tsv
 *     bench --list mutants.list --mutant 17
 *     bench --list mutants.list --mutant 17 --point n=80,cos=260000,rgb=255,190,110
 *
 * First of all against the netlist without a fault, where a difference is a failure. The table has
 * a line for each fault: number, "killed" or "survived", test, clock, pin, the model's value, the
 * netlist's, and the command of Yosys that makes the fault. Survivors are not judged here: prove.sh
 * does that. */
#define _POSIX_C_SOURCE 200809L

#include <getopt.h>
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

#include "bench.h"
#include "cli/output.h"
#include "cli/parse.h"
#include "file/new_file.h"

static const char command[] = "mutation";

enum { MUTANTS_MAX = 65535 }; /* 16 bits of mutsel */

typedef struct settings {
    const char *list, *out;
    int64_t mutant; /* 0: all */
    mutation_effort effort;
    glint_specular_inputs point;
} settings;

/* The faults, a line each; line[0] is fault 1. */
typedef struct fault_list {
    char *text;
    char **line;
    uint32_t count;
} fault_list;

static void print_help(void)
{
    printf("Usage: bench --list FILE [OPTION]...\n"
           "The C model against the netlist %s with each of its faults.\n"
           "\n"
           "  --list FILE    the faults, as tests/mutation/mutants.sh wrote them\n"
           "  --out FILE     the table of verdicts\n"
           "  --mutant N     this fault only\n"
           "  --point P      nothing but a steady flow of this point, as prove.sh prints it\n"
           "  --lockstep N   clocks of random pins (100000)\n"
           "  --sweep N      clocks of the sweep at most (all)\n"
           "  --seed N       of the random pins (1)\n"
           "\n"
           "Exit status 2 when the netlist without a fault differs, or nothing was compared.\n",
           mutation_netlist.circuit);
}

/* ---- The command line ------------------------------------------------------------------------ */

static bool read_number(const char *token, int64_t min, int64_t max, int64_t *value)
{
    glint_quoted quoted;
    if (glint_parse_integer(token, min, max, value))
        return true;
    glint_complain(command, GLINT_EXIT_TROUBLE, "%s is not an integer from %" PRId64 " to %" PRId64,
                   glint_quote(token, &quoted), min, max);
    return false;
}

/* n=…,cos=…,rgb=…,…,… */
static bool read_point(const char *token, settings *settings)
{
    glint_quoted quoted;
    unsigned n, cos, r, g, b;
    int used = 0;
    if (sscanf(token, "n=%4u,cos=%6u,rgb=%3u,%3u,%3u%n", &n, &cos, &r, &g, &b, &used) != 5 ||
        token[used] != '\0' || n >= GLINT_N_COUNT || cos > GLINT_COS_CODE_MAX ||
        r > GLINT_COLOR_MAX || g > GLINT_COLOR_MAX || b > GLINT_COLOR_MAX) {
        glint_complain(command, GLINT_EXIT_TROUBLE,
                       "%s is no point like n=80,cos=260000,rgb=255,190,110",
                       glint_quote(token, &quoted));
        return false;
    }
    settings->point = (glint_specular_inputs){.en = 1,
                                              .n_we = 1,
                                              .rgb_we = 1,
                                              .in_valid = 1,
                                              .n = (uint16_t)n,
                                              .r = (uint8_t)r,
                                              .g = (uint8_t)g,
                                              .b = (uint8_t)b,
                                              .cos = {cos}};
    settings->effort.point = &settings->point;
    return true;
}

/* Takes one option; false after saying what is wrong with it. */
static bool take_option(int option, settings *settings)
{
    int64_t number = 0;
    switch (option) {
    case 'l':
        settings->list = optarg;
        return true;
    case 'o':
        settings->out = optarg;
        return true;
    case 'm':
        return read_number(optarg, 1, MUTANTS_MAX, &settings->mutant);
    case 'p':
        return read_point(optarg, settings);
    case 'c':
        if (!read_number(optarg, 0, INT64_MAX, &number))
            return false;
        settings->effort.lockstep_clocks = (uint64_t)number;
        return true;
    case 'w':
        if (!read_number(optarg, 0, INT64_MAX, &number))
            return false;
        settings->effort.sweep_clocks = (uint64_t)number;
        return true;
    case 's':
        if (!read_number(optarg, 0, INT64_MAX, &number))
            return false;
        settings->effort.seed = (uint64_t)number;
        return true;
    default: /* getopt has said why */
        return false;
    }
}

/* −1, or the exit status. */
static int read_command_line(int argc, char **argv, settings *settings)
{
    static const struct option options[] = {{"list", required_argument, NULL, 'l'},
                                            {"out", required_argument, NULL, 'o'},
                                            {"mutant", required_argument, NULL, 'm'},
                                            {"point", required_argument, NULL, 'p'},
                                            {"lockstep", required_argument, NULL, 'c'},
                                            {"sweep", required_argument, NULL, 'w'},
                                            {"seed", required_argument, NULL, 's'},
                                            {"help", no_argument, NULL, 'h'},
                                            {NULL, 0, NULL, 0}};
    int option;
    while ((option = getopt_long(argc, argv, "", options, NULL)) != -1) {
        if (option == 'h') {
            print_help();
            return GLINT_EXIT_OK;
        }
        if (!take_option(option, settings))
            return GLINT_EXIT_TROUBLE;
    }
    if (optind < argc || settings->list == NULL)
        return glint_complain(command, GLINT_EXIT_TROUBLE,
                              "needs --list FILE and no other word; see --help");
    return -1;
}

/* ---- The list of faults ---------------------------------------------------------------------- */

static char *read_text(const char *path)
{
    char *text = NULL;
    size_t size = 0;
    FILE *stream = fopen(path, "r");
    if (stream == NULL || getdelim(&text, &size, '\0', stream) < 0) {
        glint_complain(command, GLINT_EXIT_TROUBLE, "%s cannot be read or is empty", path);
        free(text);
        text = NULL;
    }
    if (stream != NULL)
        fclose(stream);
    return text;
}

static bool read_list(const char *path, fault_list *list)
{
    memset(list, 0, sizeof *list);
    list->text = read_text(path);
    list->line = malloc(MUTANTS_MAX * sizeof *list->line);
    if (list->text == NULL || list->line == NULL)
        return false;
    char *rest = list->text;
    for (char *line; (line = strtok_r(rest, "\n", &rest)) != NULL;) {
        if (list->count == MUTANTS_MAX) {
            glint_complain(command, GLINT_EXIT_TROUBLE, "%s: more than %d faults", path,
                           MUTANTS_MAX);
            return false;
        }
        list->line[list->count++] = line;
    }
    return true;
}

static void free_list(fault_list *list)
{
    free(list->line);
    free(list->text);
}

/* ---- Runs ------------------------------------------------------------------------------------ */

static void write_verdict(FILE *stream, uint32_t mutant, const mutation_verdict *v,
                          const char *fault)
{
    if (v->killed)
        fprintf(stream,
                "%" PRIu32 "\tkilled\t%s\t%" PRIu64 "\t%s\t0x%" PRIx64 "\t0x%" PRIx64 "\t%s\n",
                mutant, v->test, v->clock, v->pin, v->model, v->netlist, fault);
    else
        fprintf(stream, "%" PRIu32 "\tsurvived\t-\t%" PRIu64 "\t-\t-\t-\t%s\n", mutant, v->clocks,
                fault);
}

/* The netlist without a fault must pass what kills the others. */
static int check_healthy(const settings *settings)
{
    mutation_verdict verdict;
    glint_error err;
    if (mutation_run(&mutation_netlist, 0, &settings->effort, &verdict, &err) != GLINT_OK)
        return glint_complain_error(command, &err);
    if (verdict.killed)
        return glint_complain(command, GLINT_EXIT_TROUBLE,
                              "%s without a fault differs, %s, clock %" PRIu64
                              ": %s model 0x%" PRIx64 ", netlist 0x%" PRIx64,
                              mutation_netlist.circuit, verdict.test, verdict.clock, verdict.pin,
                              verdict.model, verdict.netlist);
    printf("%s without a fault: 0 mismatches in %" PRIu64 " clocks\n", mutation_netlist.circuit,
           verdict.clocks);
    return GLINT_EXIT_OK;
}

static int run_one(const settings *settings, const fault_list *list)
{
    mutation_verdict verdict;
    glint_error err;
    const uint32_t mutant = (uint32_t)settings->mutant;
    if (mutant > list->count)
        return glint_complain(command, GLINT_EXIT_TROUBLE, "%s has %" PRIu32 " faults only",
                              settings->list, list->count);
    if (mutation_run(&mutation_netlist, mutant, &settings->effort, &verdict, &err) != GLINT_OK)
        return glint_complain_error(command, &err);
    write_verdict(stdout, mutant, &verdict, list->line[mutant - 1]);
    return GLINT_EXIT_OK;
}

typedef struct totals {
    uint32_t lockstep, sweep, survived;
} totals;

static glint_status run_each(const settings *settings, const fault_list *list, FILE *table,
                             totals *totals, glint_error *err)
{
    glint_progress progress;
    glint_status status = GLINT_OK;
    glint_progress_begin(&progress, command, "faults");
    for (uint32_t mutant = 1; status == GLINT_OK && mutant <= list->count; mutant++) {
        mutation_verdict verdict;
        status = mutation_run(&mutation_netlist, mutant, &settings->effort, &verdict, err);
        if (status != GLINT_OK)
            break;
        if (table != NULL)
            write_verdict(table, mutant, &verdict, list->line[mutant - 1]);
        if (!verdict.killed)
            totals->survived++;
        else if (strcmp(verdict.test, "lockstep") == 0)
            totals->lockstep++;
        else
            totals->sweep++;
        glint_progress_update(&progress, mutant, list->count);
    }
    glint_progress_end(&progress);
    return status;
}

static int run_all(const settings *settings, const fault_list *list)
{
    glint_new_file *file = NULL;
    glint_error err;
    totals totals = {0};
    const double begin = glint_seconds();
    if (settings->out != NULL && glint_new_file_open(settings->out, &file, &err) != GLINT_OK)
        return glint_complain_error(command, &err);
    glint_status status =
        run_each(settings, list, file != NULL ? glint_new_file_stream(file) : NULL, &totals, &err);
    if (status != GLINT_OK)
        glint_new_file_discard(file);
    else if (file != NULL)
        status = glint_new_file_commit(file, &err);
    if (status != GLINT_OK)
        return glint_complain_error(command, &err);
    printf("%s: %" PRIu32 " faults: %" PRIu32 " killed by lockstep, %" PRIu32
           " by the sweep, %" PRIu32 " survived; seed %" PRIu64 ", %.1f s\n",
           mutation_netlist.circuit, list->count, totals.lockstep, totals.sweep, totals.survived,
           settings->effort.seed, glint_seconds() - begin);
    return GLINT_EXIT_OK;
}

int main(int argc, char **argv)
{
    settings settings = {.effort = {.lockstep_clocks = 100000,
                                    .sweep_clocks = UINT64_MAX,
                                    .seed = 1,
                                    .stop = glint_stop_flag()}};
    fault_list list;
    glint_output_init();
    int status = read_command_line(argc, argv, &settings);
    if (status >= 0)
        return glint_output_finish(command, status);
    status = GLINT_EXIT_TROUBLE;
    if (read_list(settings.list, &list)) {
        status = check_healthy(&settings);
        if (status == GLINT_EXIT_OK)
            status = settings.mutant != 0 ? run_one(&settings, &list) : run_all(&settings, &list);
    }
    free_list(&list);
    return glint_output_finish(command, status);
}
