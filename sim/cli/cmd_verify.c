/* `glint verify`: the C model and the Verilog in lockstep. */
#define _POSIX_C_SOURCE 200809L

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "cli/build_first.h"
#include "cli/circuit_options.h"
#include "cli/commands.h"
#include "cli/failure_output.h"
#include "cli/info_circuit.h"
#include "cli/options.h"
#include "cli/output.h"
#include "cli/verify_reach.h"
#include "failure/shell.h"
#include "lockstep/lockstep.h"
#include "lockstep/mismatch.h"
#include "thread/crew.h"

#define SETTINGS_MAX 4096
#define THREADS_MAX  64

typedef struct verify_options {
    glint_circuit_options circuits;
    int64_t clocks, seed, threads;
    const char *out;
    bool json;
} verify_options;

/* One setting's run and its outcome. */
typedef struct task {
    glint_lockstep_options options;
    glint_lockstep_result result;
    glint_status status;
    glint_error err;
    char packet[FILENAME_MAX]; /* where it is; "": none */
    bool is_first;             /* its circuit's first setting: its verdict is printed before the
                                * others run */
    bool is_left_out;          /* not tried, as its circuit's first did not build */
    bool is_told;              /* its error has been */
    _Atomic uint64_t done;
    _Atomic bool has_ended;
} task;

typedef struct verification {
    task *tasks;
    int count;
    double start;
    /* Those that run now: the first ones of each circuit, or the rest. */
    int *turn;
    int turns;
    _Atomic int next;     /* the first of them that no thread has taken */
    _Atomic int finished; /* threads */
} verification;

static const char *usual(const char *parameter)
{
    (void)parameter;
    return "all";
}

#define OWN_ROWS 5

static int parse(int argc, char **argv, verify_options *chosen)
{
    const glint_circuit_use use = {
        .command = "verify", .circuit = "all", .takes_all = true, .usual = usual};
    const int begun = glint_circuit_options_begin(&chosen->circuits, &use, argc, argv);
    if (begun != GLINT_OPTIONS_RUN)
        return begun;
    glint_option options[OWN_ROWS + GLINT_CIRCUIT_OPTIONS] = {
        {.name = "clocks",
         .help = "clocks per setting: 100000, 1e6, 10M",
         .kind = GLINT_OPTION_INTEGER,
         .integer = {&chosen->clocks, 1, INT64_C(1000000000000)}},
        {.name = "seed",
         .help = "seed of the random inputs",
         .usually = "from the time of day",
         .kind = GLINT_OPTION_INTEGER,
         .integer = {&chosen->seed, 0, INT64_MAX}},
        {.name = "threads",
         .usually = "one per processor",
         .help = "settings built and verified in parallel",
         .kind = GLINT_OPTION_INTEGER,
         .integer = {&chosen->threads, 1, THREADS_MAX}},
        {.name = "out",
         .placeholder = "DIR",
         .help = "directory for failure packets, for glint replay; created if needed",
         .kind = GLINT_OPTION_STRING,
         .string = &chosen->out},
        {.name = "json",
         .help = "print the result as JSON",
         .kind = GLINT_OPTION_FLAG,
         .flag = &chosen->json},
    };
    const size_t count =
        OWN_ROWS + glint_circuit_options_add(&chosen->circuits, options + OWN_ROWS);
    static const glint_example examples[] = {
        {"every setting, a million clocks each", "glint verify --clocks 1M"},
        {"one setting again, with a given seed",
         "glint verify --gate sign --lanes 4 --clocks 1e5 --seed 7"},
        {"your own edited copy of the Verilog", "glint verify --rtl my-rtl --circuit specular"},
        {NULL, NULL},
    };
    static const glint_example own[] = {
        {"every listed setting, a million clocks each",
         "glint --circuit-dir DIR verify --clocks 1M"},
        {"again, with a given seed", "glint --circuit-dir DIR verify --clocks 1e5 --seed 7"},
        {"the Verilog in another directory", "glint --circuit-dir DIR verify --rtl EDITED"},
        {NULL, NULL},
    };
    const glint_command_line line = {
        .command = "verify",
        .summary = "Drives the C model and the Verilog with the same random inputs and compares "
                   "every register and every named internal value after every clock. Each "
                   "circuit's default setting goes first, with its own verdict, then the others. A "
                   "mismatch leaves a packet: a report, a waveform of both sides, and what glint "
                   "replay needs. Also reports how deep the run got: 100000 clocks include 65536 "
                   "enabled ones without a reset, 1200000 include 1048576.",
        .details = "With --exhaustive: every input of a circuit that has few enough of them, "
                   "instead of\nrandom ones; see glint verify --exhaustive --help.",
        .done = "no mismatch",
        .different = "a mismatch was found, regardless of any other trouble",
        .examples = chosen->circuits.is_own ? own : examples,
        .options = options,
        .option_count = count,
    };
    const int status = glint_options_parse(&line, argc, argv);
    return status == GLINT_OPTIONS_RUN ? glint_circuit_options_settle(&chosen->circuits) : status;
}

static void count_done(void *context, uint64_t done, uint64_t total)
{
    (void)total;
    *(_Atomic uint64_t *)context = done;
}

static void fill_task(const verify_options *chosen, task *task, const glint_setting *setting)
{
    task->options = (glint_lockstep_options){.setting = *setting,
                                             .clocks = (uint64_t)chosen->clocks,
                                             .seed = (uint64_t)chosen->seed,
                                             .stop = glint_stop_flag(),
                                             .progress = count_done,
                                             .progress_context = &task->done};
}

/* Of each circuit the standard setting, else the first that there is. */
static void mark_first(const verify_options *chosen, verification *all)
{
    for (int c = 0; c < chosen->circuits.chosen_count; c++) {
        const glint_setting first = glint_circuit_options_first(&chosen->circuits, c);
        int found = -1;
        for (int i = all->count - 1; i >= 0; i--)
            if (all->tasks[i].options.setting.circuit == first.circuit &&
                (found < 0 || !glint_setting_equal(&all->tasks[found].options.setting, &first)))
                found = i;
        if (found >= 0)
            all->tasks[found].is_first = true;
    }
}

static int count_settings(const verify_options *chosen)
{
    glint_setting setting;
    int count = 0;
    while (count <= SETTINGS_MAX &&
           glint_circuit_options_setting(&chosen->circuits, count, &setting))
        count++;
    return count;
}

static void free_all(verification *all)
{
    if (all != NULL) {
        free(all->tasks);
        free(all->turn);
    }
    free(all);
}

/* Returns NULL after saying why. */
static verification *choose_settings(const verify_options *chosen)
{
    const int count = count_settings(chosen);
    glint_setting setting;
    if (count > SETTINGS_MAX) {
        (void)glint_complain(
            "verify", GLINT_EXIT_TROUBLE,
            "more than %d settings: choose values by the options, or list fewer in "
            "the description",
            SETTINGS_MAX);
        return NULL;
    }
    verification *all = calloc(1, sizeof *all);
    if (all != NULL) {
        all->tasks = calloc((size_t)count, sizeof *all->tasks);
        all->turn = calloc((size_t)count, sizeof *all->turn);
    }
    if (all == NULL || all->tasks == NULL || all->turn == NULL) {
        (void)glint_complain("verify", GLINT_EXIT_TROUBLE, "out of memory");
        free_all(all);
        return NULL;
    }
    for (; all->count < count; all->count++) {
        (void)glint_circuit_options_setting(&chosen->circuits, all->count, &setting);
        fill_task(chosen, &all->tasks[all->count], &setting);
    }
    mark_first(chosen, all);
    return all;
}

/* Pins of a reset or an enable, by name. */
static void name_controls(const glint_setting *setting, char *text, size_t size)
{
    size_t used = 0;
    text[0] = '\0';
    for (int i = 0; i < glint_setting_pin_count(setting) && used < size; i++) {
        const glint_pin_info pin = glint_setting_pin(setting, i);
        if (pin.role <= GLINT_PIN_ENABLE_LOW)
            used +=
                (size_t)snprintf(text + used, size - used, "%s%s", used != 0 ? ", " : "", pin.name);
    }
}

/* Two circuits that stand still agree: that is no verdict. */
static glint_status refuse_still(task *task)
{
    const glint_setting *setting = &task->options.setting;
    char name[GLINT_SETTING_TEXT], controls[128];
    glint_setting_describe(setting, name);
    name_controls(setting, controls, sizeof controls);
    return glint_fail(&task->err, GLINT_BAD_INPUT,
                      "%s: no signal changed in %" PRIu64
                      " clocks that neither reset nor stall, so there is "
                      "no verdict: do the roles of %s have the right polarity?",
                      name, task->result.roles.still, controls);
}

static void verify_settings(verification *all)
{
    int i;
    while ((i = all->next++) < all->turns) {
        task *task = &all->tasks[all->turn[i]];
        task->status = glint_lockstep_run(&task->options, &task->result, &task->err);
        if (task->status == GLINT_OK && task->result.mismatches == 0 &&
            glint_roles_stand_still(&task->result.roles))
            task->status = refuse_still(task);
        task->done = task->result.clocks;
        task->has_ended = true;
    }
    all->finished++;
}

/* Whether it ran, and both sides stood still. */
static bool is_still(const task *task)
{
    return task->has_ended && task->status == GLINT_BAD_INPUT && task->result.clocks != 0;
}

/* Whether it failed to run, for a reason of its own. */
static bool has_failed(const task *task)
{
    return task->has_ended && task->status != GLINT_OK && task->status != GLINT_INTERRUPTED &&
           task->result.clocks == 0;
}

/* If a circuit's first setting did not build, none of its others will: reported once. */
static bool first_has_failed(const verification *all, const glint_circuit *circuit)
{
    bool failed = false;
    for (int i = 0; i < all->count; i++)
        failed |= all->tasks[i].is_first && all->tasks[i].options.setting.circuit == circuit &&
                  has_failed(&all->tasks[i]);
    return failed;
}

/* Without the `told` first settings, and without those of a circuit whose first one failed. */
static int still_to_try(const verification *all, int told)
{
    int left = all->turns - told;
    for (int i = 0; i < all->count; i++) {
        const task *task = &all->tasks[i];
        left += !task->is_first && !first_has_failed(all, task->options.setting.circuit);
    }
    return left;
}

/* Printed as soon as it is available, while others still run: which setting, the verdict, and how
 * many remain. */
static void print_first(const verify_options *chosen, const verification *all, task *task, int told)
{
    if (has_failed(task)) {
        (void)glint_complain_error("verify", &task->err);
        task->is_told = true;
    }
    FILE *out = chosen->json ? stderr : stdout;
    char setting[GLINT_SETTING_TEXT];
    const int left = still_to_try(all, told);
    /* A script has all of it at the end, and standard error for what went wrong. */
    if (task->result.comparisons == 0 || is_still(task) || (chosen->json && !isatty(STDERR_FILENO)))
        return;
    glint_setting_describe(&task->options.setting, setting);
    fprintf(out, "first verdict: %s: ", setting);
    glint_print_verdict(out, task->result.mismatches == 0, "%" PRIu64 " mismatches",
                        task->result.mismatches);
    fprintf(out, " of %" PRIu64 " comparisons, %.1f s; %d setting%s to go\n",
            task->result.comparisons, glint_seconds() - all->start, left, left == 1 ? "" : "s");
    fflush(out);
}

/* Waits for all threads to finish. first: prints verdicts as they become available. */
static void watch(verification *all, int threads, const verify_options *chosen, bool first)
{
    glint_progress progress;
    int told = 0;
    glint_progress_begin(&progress, "verify", "clocks");
    for (bool last = false; !last;) {
        last = all->finished == threads;
        uint64_t done = 0;
        for (int i = 0; i < all->turns; i++)
            done += all->tasks[all->turn[i]].done;
        while (first && told < all->turns && all->tasks[all->turn[told]].has_ended) {
            glint_progress_end(&progress);
            told++;
            print_first(chosen, all, &all->tasks[all->turn[told - 1]], told);
        }
        if (done == 0)
            glint_progress_say(&progress, "building");
        else
            glint_progress_update(&progress, done, (uint64_t)chosen->clocks * (uint64_t)all->turns);
        if (!last)
            nanosleep(&(struct timespec){.tv_nsec = 20000000}, NULL);
    }
    glint_progress_end(&progress);
}

typedef struct turn {
    verification *all;
    const verify_options *chosen;
    bool first;
    int threads; /* that verify */
} turn;

/* The caller's thread watches; with none but it to be had, it verifies before that. */
static void take_turn(void *context, int worker)
{
    const turn *turn = context;
    if (worker != 0 || turn->threads == 0)
        verify_settings(turn->all);
    if (worker == 0)
        watch(turn->all, turn->threads != 0 ? turn->threads : 1, turn->chosen, turn->first);
}

/* Runs the settings that are due on the requested number of threads. */
static void run_turn(verification *all, const verify_options *chosen, bool first)
{
    const int threads = chosen->threads < all->turns ? (int)chosen->threads : all->turns;
    turn turn = {.all = all, .chosen = chosen, .first = first};
    glint_crew *crew;
    all->next = 0;
    all->finished = 0;
    if (glint_crew_create(threads + 1, &crew, NULL) != GLINT_OK) {
        take_turn(&turn, 0);
        return;
    }
    turn.threads = glint_crew_size(crew) - 1;
    glint_crew_run(crew, take_turn, &turn);
    glint_crew_destroy(crew);
}

static void choose_turn(verification *all, bool first)
{
    all->turns = 0;
    for (int i = 0; i < all->count; i++) {
        task *task = &all->tasks[i];
        if (task->is_first != first)
            continue;
        task->is_left_out = !first && first_has_failed(all, task->options.setting.circuit);
        if (!task->is_left_out)
            all->turn[all->turns++] = i;
    }
}

/* Builds everything missing from the cache before any of it runs. False: interrupted. */
static bool build_turn(const verification *all, const verify_options *chosen)
{
    glint_setting *settings = calloc((size_t)all->turns, sizeof *settings);
    if (settings == NULL)
        return true; /* each is built when it runs */
    for (int i = 0; i < all->turns; i++)
        settings[i] = all->tasks[all->turn[i]].options.setting;
    const glint_status status = glint_build_first("verify", settings, all->turns,
                                                  GLINT_RTL_OBSERVED, (int)chosen->threads, NULL);
    free(settings);
    return status == GLINT_OK;
}

/* The first setting of each circuit, then the others; if there are no others, no first verdict is
 * needed. */
static void run_all(verification *all, const verify_options *chosen)
{
    choose_turn(all, true);
    run_turn(all, chosen, all->turns < all->count);
    choose_turn(all, false);
    if (all->turns == 0 || glint_stop_requested())
        return;
    if (build_turn(all, chosen))
        run_turn(all, chosen, false);
}

typedef struct sums {
    uint64_t mismatches, comparisons, clocks;
    int settings; /* that compared anything */
    int still;    /* of those: without a verdict */
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
        sums.still += is_still(&all->tasks[i]);
        if (result->clocks != 0)
            glint_reach_sum_add(&sums.reach, &all->tasks[i].options.setting, result);
        sums.interrupted |= all->tasks[i].status == GLINT_INTERRUPTED ||
                            (!all->tasks[i].has_ended && !all->tasks[i].is_left_out);
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
    glint_circuit_options_append(&chosen->circuits, text, size);
}

/* The packet of a failing setting, and its report. */
static void report_failure(const verify_options *chosen, task *task, glint_failure_detail detail,
                           FILE *out)
{
    char name[GLINT_SETTING_TEXT], setting[GLINT_SETTING_TEXT], directory[FILENAME_MAX];
    glint_failure *failure;
    if (glint_failure_find("verify", &task->options, &task->result, &failure, &task->err) !=
        GLINT_OK) {
        (void)glint_complain_error("verify", &task->err);
        return;
    }
    failure->program = glint_failure_program();
    glint_failure_name_circuit(failure, chosen->circuits.directory);
    write_command(chosen, &failure->setting, failure->command, sizeof failure->command);
    glint_setting_name(&failure->setting, name);
    glint_setting_describe(&failure->setting, setting);
    (void)snprintf(directory, sizeof directory, "%s/%s", chosen->out, name);
    if (detail == GLINT_FAILURE_BRIEFLY)
        fprintf(out, "also %s: %" PRIu64 " mismatches of %" PRIu64 ", ", setting,
                task->result.mismatches, task->result.comparisons);
    if (glint_failure_output("verify", failure, NULL, directory, detail, out))
        memcpy(task->packet, directory, sizeof directory);
    glint_failure_destroy(failure);
}

/* The worse of two exit statuses: a difference outranks any trouble. */
static int worse(int a, int b)
{
    return a == GLINT_EXIT_DIFFERENT || b == GLINT_EXIT_DIFFERENT ? GLINT_EXIT_DIFFERENT
           : a != GLINT_EXIT_OK                                   ? a
                                                                  : b;
}

static int report_task(const verify_options *chosen, task *task, glint_failure_detail *detail,
                       FILE *out)
{
    if (task->result.mismatches != 0) {
        report_failure(chosen, task, *detail, out);
        /* Otherwise a fault shared by all settings would be reported over and over. */
        *detail = GLINT_FAILURE_BRIEFLY;
        return GLINT_EXIT_DIFFERENT;
    }
    if (task->status == GLINT_OK || task->status == GLINT_INTERRUPTED)
        return GLINT_EXIT_OK;
    return task->is_told ? GLINT_EXIT_TROUBLE : glint_complain_error("verify", &task->err);
}

/* In the order in which they were tried. */
static int report_all(const verify_options *chosen, verification *all, FILE *out)
{
    int status = GLINT_EXIT_OK;
    glint_failure_detail detail = GLINT_FAILURE_REPORT;
    for (int first = 1; first >= 0; first--)
        for (int i = 0; i < all->count; i++)
            if (all->tasks[i].is_first == (first != 0))
                status = worse(status, report_task(chosen, &all->tasks[i], &detail, out));
    return status;
}

/* A JSON number has no more than 53 bits. */
static void add_value(json_t *entry, const char *name, const glint_signal_info *signal,
                      const uint64_t *words)
{
    char text[GLINT_VALUE_TEXT];
    if (glint_signal_width(signal) <= 53) {
        glint_json_add_number(entry, name, (double)words[0]);
        return;
    }
    glint_mismatch_bits(signal, words, text);
    glint_json_add_text(entry, name, text);
}

/* The summary lines of a failing setting. */
static void add_failure(json_t *entry, const task *task)
{
    if (task->status != GLINT_OK && task->status != GLINT_INTERRUPTED)
        glint_json_add_text(entry, "error", task->err.text);
    if (task->packet[0] != '\0')
        glint_json_add_text(entry, "packet", task->packet);
    json_t *list = glint_json_add(entry, "first_mismatches", json_array());
    for (int i = 0; i < task->result.kept; i++) {
        const glint_mismatch *m = &task->result.mismatch[i];
        json_t *mismatch = json_object();
        glint_json_add_number(mismatch, "clock", (double)m->clock);
        glint_json_add_text(mismatch, "signal", m->signal.name);
        glint_json_add_number(mismatch, "block", m->signal.block);
        glint_json_add_number(mismatch, "lane", m->signal.lane);
        add_value(mismatch, "model", &m->signal, m->model);
        add_value(mismatch, "rtl", &m->signal, m->rtl);
        json_array_append_new(list, mismatch);
    }
}

static void add_not_tried(json_t *json, const verify_options *chosen)
{
    const glint_circuit *circuit;
    json_t *list = glint_json_add(json, "not_tried", json_array());
    for (int i = 0; (circuit = glint_circuit_options_left(&chosen->circuits, i)) != NULL; i++)
        json_array_append_new(list, glint_json_text_of(circuit->name));
}

static bool print_json(const verify_options *chosen, const verification *all, const sums *sums,
                       double seconds)
{
    char seed[32]; /* a JSON number would lose the low bits of a large seed */
    json_t *json = json_object();
    (void)snprintf(seed, sizeof seed, "%" PRId64, chosen->seed);
    glint_json_add_number(json, "mismatches", (double)sums->mismatches);
    glint_json_add_number(json, "comparisons", (double)sums->comparisons);
    glint_json_add_number(json, "clocks", (double)sums->clocks);
    glint_json_add_text(json, "seed", seed);
    json_object_set_new(json, "interrupted", json_boolean(sums->interrupted));
    glint_json_add_number(json, "seconds", seconds);
    glint_reach_sum_json(json, &sums->reach);
    add_not_tried(json, chosen);
    json_t *list = glint_json_add(json, "settings", json_array());
    for (int i = 0; i < all->count; i++) {
        const task *task = &all->tasks[i];
        json_t *entry = json_object();
        glint_json_add_text(entry, "circuit", task->options.setting.circuit->name);
        glint_info_add_values(entry, &task->options.setting);
        glint_json_add_number(entry, "clocks", (double)task->result.clocks);
        glint_json_add_number(entry, "comparisons", (double)task->result.comparisons);
        glint_json_add_number(entry, "mismatches", (double)task->result.mismatches);
        glint_reach_json(entry, &task->options.setting, &task->result);
        add_failure(entry, task);
        json_array_append_new(list, entry);
    }
    return glint_output_json(json);
}

/* Of a circuit whose first setting did not build, the others. */
static void print_left_out(const verify_options *chosen, const verification *all)
{
    for (int c = 0; c < chosen->circuits.chosen_count; c++) {
        const glint_circuit *circuit = chosen->circuits.chosen[c];
        int count = 0;
        for (int i = 0; i < all->count; i++)
            count += all->tasks[i].is_left_out && all->tasks[i].options.setting.circuit == circuit;
        if (count != 0)
            printf("skipped: %d setting%s of %s, after its first one failed\n", count,
                   count == 1 ? "" : "s", circuit->name);
    }
}

/* Circuits that this command line would have verified, were they not on request only. */
static void print_not_tried(const verify_options *chosen)
{
    const glint_circuit *circuit;
    int count = 0;
    for (; (circuit = glint_circuit_options_left(&chosen->circuits, count)) != NULL; count++)
        printf("%s%s", count == 0 ? "not tried: " : ", ", circuit->name);
    if (count != 0)
        puts(" (--circuit all)");
}

static void print_text(const verify_options *chosen, const sums *sums, double seconds)
{
    glint_print_verdict(stdout, sums->mismatches == 0, "%" PRIu64 " mismatches", sums->mismatches);
    printf(" of %" PRIu64 " comparisons: every register and named value, "
           "%" PRIu64 " clocks, %d setting%s, seed %" PRId64 ", %.1f s%s\n",
           sums->comparisons, sums->clocks, sums->settings, sums->settings == 1 ? "" : "s",
           chosen->seed, seconds, sums->interrupted ? " (interrupted)" : "");
    glint_reach_sum_print(&sums->reach);
}

static int verify(const verify_options *chosen)
{
    verification *all = choose_settings(chosen);
    if (all == NULL)
        return GLINT_EXIT_TROUBLE;
    all->start = glint_seconds();
    run_all(all, chosen);
    const double seconds = glint_seconds() - all->start;
    sums sums = add_up(all);
    /* The report of a failure is for people; with --json it must not mix with the result. */
    int status = report_all(chosen, all, chosen->json ? stderr : stdout);
    /* If nothing was compared, the error was already reported and there is no summary. */
    if (!chosen->json && sums.comparisons == 0 && sums.interrupted) {
        printf("no verdict: nothing was compared, %.1f s (interrupted)\n", seconds);
    } else if (!chosen->json && sums.mismatches == 0 && sums.still != 0) {
        printf("no verdict: %d of %d settings stood still, %.1f s\n", sums.still, sums.settings,
               seconds);
    } else if (!chosen->json && sums.comparisons != 0) {
        print_text(chosen, &sums, seconds);
        print_left_out(chosen, all);
        print_not_tried(chosen);
    } else if (chosen->json && !print_json(chosen, all, &sums, seconds))
        status = glint_complain("verify", GLINT_EXIT_TROUBLE, "out of memory");
    if (sums.mismatches == 0 && (sums.interrupted || sums.comparisons == 0))
        status = GLINT_EXIT_TROUBLE;
    free_all(all);
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
        return glint_cmd_verify_exhaustive != NULL
                   ? glint_cmd_verify_exhaustive(argc, argv)
                   : glint_subcommand_is_not_here("verify --exhaustive");
    verify_options chosen = {.clocks = 100000,
                             .seed = (int64_t)time(NULL),
                             .threads = sysconf(_SC_NPROCESSORS_ONLN),
                             .out = "glint-failure",
                             .json = false};
    if (chosen.threads < 1)
        chosen.threads = 1;
    if (chosen.threads > THREADS_MAX)
        chosen.threads = THREADS_MAX;
    const int status = parse(argc, argv, &chosen);
    if (status != GLINT_OPTIONS_RUN)
        return status;
    return glint_output_finish("verify", verify(&chosen));
}
