/* `glint verify`: the C model and the Verilog in lockstep. */
#define _POSIX_C_SOURCE 200809L

#include <inttypes.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "cli/commands.h"
#include "cli/failure_output.h"
#include "cli/options.h"
#include "cli/output.h"
#include "cli/verify_reach.h"
#include "failure/shell.h"
#include "lockstep/lockstep.h"

#define SETTINGS_MAX 64
#define THREADS_MAX  64

enum { SPECULAR, DIVIDER, ALL_CIRCUITS };
enum {
    ALL_GATES = GLINT_GATE_COUNT,
    ALL_PIPELINES = GLINT_PIPELINE_COUNT,
    ALL_FORMS = GLINT_DIVIDER_FORM_COUNT,
};

typedef struct verify_options {
    int circuit, gate, pipeline, form;
    int64_t lanes, shifts, clocks, seed, threads;
    const char *out;
    bool json;
    bool of_specular, of_divider; /* an option that only this circuit has was given */
} verify_options;

/* One setting's run and what came of it. */
typedef struct task {
    glint_lockstep_options options;
    glint_lockstep_result result;
    glint_status status;
    glint_error err;
    char packet[FILENAME_MAX]; /* where it is; "": none */
    _Atomic uint64_t done;
} task;

typedef struct verification {
    task tasks[SETTINGS_MAX];
    int count;
    _Atomic int next;     /* the first task that no thread has taken */
    _Atomic int finished; /* threads */
} verification;

static const char *const circuit_choices[] = {"specular", "divider", "all", NULL};
static const char *const form_choices[] = {"sequential", "pipelined", "all", NULL};
static const char *const gate_choices[] = {"cosine", "sign", "drawn", "all", NULL};
static const char *const pipeline_choices[] = {"combinational", "pipelined", "all", NULL};

static int parse(int argc, char **argv, verify_options *chosen)
{
    const glint_option options[] = {
        {.name = "clocks",
         .help = "how many for each setting: 100000, 1e6, 10M",
         .kind = GLINT_OPTION_INTEGER,
         .integer = {&chosen->clocks, 1, INT64_C(1000000000000)}},
        {.name = "seed",
         .help = "of the random inputs",
         .usually = "taken from the time",
         .kind = GLINT_OPTION_INTEGER,
         .integer = {&chosen->seed, 0, INT64_MAX}},
        {.name = "circuit",
         .help = "what to verify; an option that only one circuit has leaves the other out",
         .kind = GLINT_OPTION_CHOICE,
         .choice = {&chosen->circuit, circuit_choices}},
        {.name = "gate",
         .given = &chosen->of_specular,
         .help = "what bounds the highlight",
         .kind = GLINT_OPTION_CHOICE,
         .choice = {&chosen->gate, gate_choices}},
        {.name = "pipeline",
         .given = &chosen->of_specular,
         .help = "where the registers are",
         .kind = GLINT_OPTION_CHOICE,
         .choice = {&chosen->pipeline, pipeline_choices}},
        {.name = "lanes",
         .given = &chosen->of_specular,
         .help = "cosines a clock: 1, 2, 4, 8 or 16; 0: each of them",
         .kind = GLINT_OPTION_INTEGER,
         .integer = {&chosen->lanes, 0, GLINT_LANES_MAX}},
        {.name = "form",
         .given = &chosen->of_divider,
         .help = "of the divider",
         .kind = GLINT_OPTION_CHOICE,
         .choice = {&chosen->form, form_choices}},
        {.name = "shifts",
         .given = &chosen->of_divider,
         .help = "of the divider, 6 to 16; 0: each of them",
         .kind = GLINT_OPTION_INTEGER,
         .integer = {&chosen->shifts, 0, GLINT_DIVIDER_SHIFTS_MAX}},
        {.name = "threads",
         .usually = "one a processor",
         .help = "settings verified at a time",
         .kind = GLINT_OPTION_INTEGER,
         .integer = {&chosen->threads, 1, THREADS_MAX}},
        {.name = "out",
         .placeholder = "DIR",
         .help = "where the packets of mismatches go, for glint replay; made if needed",
         .kind = GLINT_OPTION_STRING,
         .string = &chosen->out},
        {.name = "json",
         .help = "the result as JSON",
         .kind = GLINT_OPTION_FLAG,
         .flag = &chosen->json},
    };
    static const glint_example examples[] = {
        {"every setting, a million clocks each", "glint verify --clocks 1M"},
        {"one setting again, with the inputs of a seed",
         "glint verify --gate sign --lanes 4 --clocks 1e5 --seed 7"},
        {NULL, NULL},
    };
    const glint_command_line line = {
        .command = "verify",
        .summary = "Drives the C model and the Verilog with the same random inputs and compares "
                   "every register and every named internal value after every clock. A mismatch "
                   "leaves a packet: a report, a waveform of both, and what glint replay needs. "
                   "Says how deep it got: 100000 clocks hold 65536 enabled ones without a reset, "
                   "1200000 hold 1048576.",
        .details = "With --exhaustive: every n and every cosine code instead of random ones; see\n"
                   "glint verify --exhaustive --help.",
        .done = "no mismatch",
        .different = "a mismatch was found, whatever else went wrong",
        .examples = examples,
        .options = options,
        .option_count = sizeof options / sizeof options[0],
    };
    int status = glint_options_parse(&line, argc, argv);
    if (status != GLINT_OPTIONS_RUN)
        return status;
    /* Refused whatever the circuit: with all of them the others would be verified and pass. */
    if ((chosen->lanes & (chosen->lanes - 1)) != 0)
        return glint_complain("verify", GLINT_EXIT_TROUBLE,
                              "--lanes: %d is not 1, 2, 4, 8, 16 or 0", (int)chosen->lanes);
    if (chosen->shifts != 0 && chosen->shifts < GLINT_DIVIDER_SHIFTS_MIN)
        return glint_complain("verify", GLINT_EXIT_TROUBLE, "--shifts: %d is not 6 to 16 or 0",
                              (int)chosen->shifts);
    return GLINT_OPTIONS_RUN;
}

/* An option that only one circuit has leaves the other one out, and makes no sense for it. */
static int narrow_circuit(verify_options *chosen)
{
    if ((chosen->of_specular && (chosen->of_divider || chosen->circuit == DIVIDER)) ||
        (chosen->of_divider && chosen->circuit == SPECULAR))
        return glint_complain("verify", GLINT_EXIT_TROUBLE,
                              "--gate, --pipeline, --lanes are for the specular device, --form, "
                              "--shifts for the divider");
    if (chosen->circuit == ALL_CIRCUITS && chosen->of_specular)
        chosen->circuit = SPECULAR;
    if (chosen->circuit == ALL_CIRCUITS && chosen->of_divider)
        chosen->circuit = DIVIDER;
    return GLINT_OPTIONS_RUN;
}

static bool is_chosen(const verify_options *chosen, const glint_specular_config *config)
{
    return (chosen->gate == ALL_GATES || chosen->gate == (int)config->gate) &&
           (chosen->pipeline == ALL_PIPELINES || chosen->pipeline == (int)config->pipeline) &&
           (chosen->lanes == 0 || chosen->lanes == config->lanes);
}

static void count_done(void *context, uint64_t done, uint64_t total)
{
    (void)total;
    *(_Atomic uint64_t *)context = done;
}

static void add_task(const verify_options *chosen, verification *all, const glint_setting *setting)
{
    if (all->count == SETTINGS_MAX)
        return;
    task *task = &all->tasks[all->count++];
    task->options = (glint_lockstep_options){.setting = *setting,
                                             .clocks = (uint64_t)chosen->clocks,
                                             .seed = (uint64_t)chosen->seed,
                                             .stop = glint_stop_flag(),
                                             .progress = count_done,
                                             .progress_context = &task->done};
}

static void choose_specular(const verify_options *chosen, verification *all)
{
    const glint_specular_config *config;
    for (int i = 0; (config = glint_rtl_built(i)) != NULL; i++)
        if (is_chosen(chosen, config))
            add_task(chosen, all, &(glint_setting){.specular = *config});
}

static void choose_divider(const verify_options *chosen, verification *all, glint_divider_form form)
{
    for (int shifts = GLINT_DIVIDER_SHIFTS_MIN; shifts <= GLINT_DIVIDER_SHIFTS_MAX; shifts++)
        if (chosen->shifts == 0 || chosen->shifts == shifts)
            add_task(chosen, all,
                     &(glint_setting){.is_divider = true, .form = form, .shifts = shifts});
}

static void choose_settings(const verify_options *chosen, verification *all)
{
    if (chosen->circuit != DIVIDER)
        choose_specular(chosen, all);
    for (int f = 0; f < GLINT_DIVIDER_FORM_COUNT && chosen->circuit != SPECULAR; f++)
        if (chosen->form == ALL_FORMS || chosen->form == f)
            choose_divider(chosen, all, (glint_divider_form)f);
}

static void *verify_settings(void *context)
{
    verification *all = context;
    int i;
    while ((i = all->next++) < all->count) {
        task *task = &all->tasks[i];
        task->status = glint_lockstep_run(&task->options, &task->result, &task->err);
        task->done = task->result.clocks;
    }
    all->finished++;
    return NULL;
}

static void show_progress(const verification *all, int threads, uint64_t clocks_each)
{
    glint_progress progress;
    glint_progress_begin(&progress, "verify", "clocks");
    while (all->finished < threads) {
        uint64_t done = 0;
        for (int i = 0; i < all->count; i++)
            done += all->tasks[i].done;
        glint_progress_update(&progress, done, clocks_each * (uint64_t)all->count);
        nanosleep(&(struct timespec){.tv_nsec = 20000000}, NULL);
    }
    glint_progress_end(&progress);
}

/* Runs all settings on the threads asked for; with none to be had, on this one. */
static void run_all(verification *all, const verify_options *chosen)
{
    pthread_t threads[THREADS_MAX];
    int started = 0;
    while (started < chosen->threads && started < all->count &&
           pthread_create(&threads[started], NULL, verify_settings, all) == 0)
        started++;
    if (started == 0)
        (void)verify_settings(all);
    else
        show_progress(all, started, (uint64_t)chosen->clocks);
    for (int i = 0; i < started; i++)
        pthread_join(threads[i], NULL);
}

typedef struct sums {
    uint64_t mismatches, comparisons, clocks;
    int settings; /* that compared anything */
    bool interrupted;
    glint_reach_sum reach;
} sums;

static sums add_up(const verification *all)
{
    sums sums = {0};
    for (int i = 0; i < all->count; i++) {
        const glint_lockstep_result *result = &all->tasks[i].result;
        sums.mismatches += result->mismatches;
        sums.comparisons += result->comparisons;
        sums.clocks += result->clocks;
        sums.settings += result->comparisons != 0;
        if (result->clocks != 0)
            glint_reach_sum_add(&sums.reach, &all->tasks[i].options.setting, &result->reach);
        sums.interrupted |= all->tasks[i].status == GLINT_INTERRUPTED;
    }
    return sums;
}

/* The command that runs this setting again, whole. */
static void write_command(const verify_options *chosen, const glint_setting *setting, char *text,
                          size_t size)
{
    char options[GLINT_SETTING_OPTIONS];
    glint_setting_options(setting, options);
    text[0] = '\0';
    glint_shell_append(text, size, glint_failure_program());
    const size_t used = strlen(text);
    (void)snprintf(text + used, size - used, " verify %s --seed %" PRId64 " --clocks %" PRId64,
                   options, chosen->seed, chosen->clocks);
}

/* The packet of a setting that failed, and what it says. */
static void report_failure(const verify_options *chosen, task *task, glint_failure_detail detail,
                           FILE *out)
{
    char name[GLINT_SETTING_TEXT], directory[FILENAME_MAX];
    glint_failure *failure;
    if (glint_failure_find("verify", &task->options, &task->result, &failure, &task->err) !=
        GLINT_OK) {
        (void)glint_complain_error("verify", &task->err);
        return;
    }
    failure->program = glint_failure_program();
    write_command(chosen, &failure->setting, failure->command, sizeof failure->command);
    glint_setting_name(&failure->setting, name);
    (void)snprintf(directory, sizeof directory, "%s/%s", chosen->out, name);
    if (detail == GLINT_FAILURE_BRIEFLY)
        fprintf(out, "also %" PRIu64 " mismatches of %" PRIu64 ", ", task->result.mismatches,
                task->result.comparisons);
    if (glint_failure_output("verify", failure, NULL, directory, detail, out))
        memcpy(task->packet, directory, sizeof directory);
    glint_failure_destroy(failure);
}

static int report_all(const verify_options *chosen, verification *all, FILE *out)
{
    int status = GLINT_EXIT_OK;
    glint_failure_detail detail = GLINT_FAILURE_REPORT;
    for (int i = 0; i < all->count; i++) {
        task *task = &all->tasks[i];
        if (task->result.mismatches != 0) {
            report_failure(chosen, task, detail, out);
            /* A fault that all settings share would be told over and over. */
            detail = GLINT_FAILURE_BRIEFLY;
            status = GLINT_EXIT_DIFFERENT;
        } else if (task->status != GLINT_OK && task->status != GLINT_INTERRUPTED) {
            const int trouble = glint_complain_error("verify", &task->err);
            status = status != GLINT_EXIT_DIFFERENT ? trouble : status;
        }
    }
    return status;
}

static void describe(cJSON *entry, const glint_setting *setting)
{
    const glint_specular_config *config = &setting->specular;
    cJSON_AddStringToObject(entry, "circuit", setting->is_divider ? "divider" : "specular");
    if (setting->is_divider) {
        cJSON_AddStringToObject(entry, "form", glint_divider_form_name(setting->form));
        cJSON_AddNumberToObject(entry, "shifts", setting->shifts);
        return;
    }
    cJSON_AddStringToObject(entry, "gate", glint_gate_name(config->gate));
    cJSON_AddStringToObject(entry, "pipeline", glint_pipeline_name(config->pipeline));
    cJSON_AddNumberToObject(entry, "lanes", config->lanes);
}

/* What a setting that failed can say of it. */
static void add_failure(cJSON *entry, const task *task)
{
    if (task->status != GLINT_OK && task->status != GLINT_INTERRUPTED)
        cJSON_AddStringToObject(entry, "error", task->err.text);
    if (task->packet[0] != '\0')
        cJSON_AddStringToObject(entry, "packet", task->packet);
    cJSON *list = cJSON_AddArrayToObject(entry, "first_mismatches");
    for (int i = 0; i < task->result.kept; i++) {
        const glint_mismatch *m = &task->result.mismatch[i];
        cJSON *mismatch = cJSON_CreateObject();
        cJSON_AddNumberToObject(mismatch, "clock", (double)m->clock);
        cJSON_AddStringToObject(mismatch, "signal", m->signal.name);
        cJSON_AddNumberToObject(mismatch, "block", m->signal.block);
        cJSON_AddNumberToObject(mismatch, "lane", m->signal.lane);
        cJSON_AddNumberToObject(mismatch, "model", (double)m->model);
        cJSON_AddNumberToObject(mismatch, "rtl", (double)m->rtl);
        cJSON_AddItemToArray(list, mismatch);
    }
}

static bool print_json(const verify_options *chosen, const verification *all, const sums *sums,
                       double seconds)
{
    char seed[32]; /* a JSON number would lose the low bits of a large seed */
    cJSON *json = cJSON_CreateObject();
    (void)snprintf(seed, sizeof seed, "%" PRId64, chosen->seed);
    cJSON_AddNumberToObject(json, "mismatches", (double)sums->mismatches);
    cJSON_AddNumberToObject(json, "comparisons", (double)sums->comparisons);
    cJSON_AddNumberToObject(json, "clocks", (double)sums->clocks);
    cJSON_AddStringToObject(json, "seed", seed);
    cJSON_AddBoolToObject(json, "interrupted", sums->interrupted);
    cJSON_AddNumberToObject(json, "seconds", seconds);
    glint_reach_sum_json(json, &sums->reach);
    cJSON *list = cJSON_AddArrayToObject(json, "settings");
    for (int i = 0; i < all->count; i++) {
        const task *task = &all->tasks[i];
        cJSON *entry = cJSON_CreateObject();
        describe(entry, &task->options.setting);
        cJSON_AddNumberToObject(entry, "clocks", (double)task->result.clocks);
        cJSON_AddNumberToObject(entry, "comparisons", (double)task->result.comparisons);
        cJSON_AddNumberToObject(entry, "mismatches", (double)task->result.mismatches);
        glint_reach_json(entry, &task->options.setting, &task->result.reach);
        add_failure(entry, task);
        cJSON_AddItemToArray(list, entry);
    }
    return glint_output_json(json);
}

static void print_text(const verify_options *chosen, const sums *sums, double seconds)
{
    glint_print_verdict(stdout, sums->mismatches == 0, "%" PRIu64 " mismatches", sums->mismatches);
    printf(" of %" PRIu64 " comparisons: every register and named value, "
           "%" PRIu64 " clocks, %d settings, seed %" PRId64 ", %.1f s%s\n",
           sums->comparisons, sums->clocks, sums->settings, chosen->seed, seconds,
           sums->interrupted ? " (interrupted)" : "");
    glint_reach_sum_print(&sums->reach);
}

static int verify(const verify_options *chosen)
{
    verification *all = calloc(1, sizeof *all);
    if (all == NULL)
        return glint_complain("verify", GLINT_EXIT_TROUBLE, "out of memory");
    choose_settings(chosen, all);
    if (all->count == 0) {
        free(all);
        return glint_complain("verify", GLINT_EXIT_TROUBLE,
                              "no such circuit: --lanes is 1, 2, 4, 8, 16 or 0, "
                              "--shifts is 6 to 16 or 0");
    }
    double start = glint_seconds();
    run_all(all, chosen);
    double seconds = glint_seconds() - start;
    sums sums = add_up(all);
    /* The report of a failure is for people; with --json it must not mix with the result. */
    int status = report_all(chosen, all, chosen->json ? stderr : stdout);
    if (!chosen->json)
        print_text(chosen, &sums, seconds);
    else if (!print_json(chosen, all, &sums, seconds))
        status = glint_complain("verify", GLINT_EXIT_TROUBLE, "out of memory");
    if (sums.mismatches == 0 && (sums.interrupted || sums.comparisons == 0))
        status = GLINT_EXIT_TROUBLE;
    free(all);
    return status;
}

static bool is_exhaustive(int argc, char **argv)
{
    for (int i = 1; i < argc; i++)
        if (strcmp(argv[i], "--exhaustive") == 0)
            return true;
    return false;
}

int glint_cmd_verify(int argc, char **argv)
{
    if (is_exhaustive(argc, argv))
        return glint_cmd_verify_exhaustive(argc, argv);
    verify_options chosen = {.circuit = ALL_CIRCUITS,
                             .form = ALL_FORMS,
                             .gate = ALL_GATES,
                             .pipeline = ALL_PIPELINES,
                             .lanes = 0,
                             .clocks = 100000,
                             .seed = (int64_t)time(NULL),
                             .threads = sysconf(_SC_NPROCESSORS_ONLN),
                             .out = "glint-failure",
                             .json = false};
    if (chosen.threads < 1)
        chosen.threads = 1;
    if (chosen.threads > THREADS_MAX)
        chosen.threads = THREADS_MAX;
    int status = parse(argc, argv, &chosen);
    if (status != GLINT_OPTIONS_RUN)
        return status;
    status = narrow_circuit(&chosen);
    if (status != GLINT_OPTIONS_RUN)
        return status;
    return glint_output_finish("verify", verify(&chosen));
}
