/* `glint verify --exhaustive` of a circuit by its description: every point of its domain. */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cli/build_first.h"
#include "cli/exhaustive_options.h"
#include "cli/failure_output.h"
#include "cli/info_circuit.h"
#include "cli/output.h"
#include "failure/shell.h"
#include "lockstep/domain.h"
#include "lockstep/mismatch.h"

#define SETTINGS_MAX 4096
#define NOT_REACHED  "stalls, resets, and signals other than outputs"

/* One setting's run and what the progress line needs. */
typedef struct run {
    glint_domain_options options;
    glint_domain_result result;
    glint_error err;
    glint_status status;
    bool has_run;
    glint_progress progress;
    double start, seconds;
    char unit[64];
    char packet[FILENAME_MAX]; /* where it is; "": none */
} run;

/* Rate and time left are part of the unit that glint_progress shows. */
static void show_progress(void *context, uint64_t done, uint64_t total)
{
    run *run = context;
    const double rate = (double)done / (glint_seconds() - run->start);
    (void)snprintf(run->unit, sizeof run->unit, "points, %.1f million per second, %.0f s left",
                   rate / 1e6, rate > 0.0 ? (double)(total - done) / rate : 0.0);
    glint_progress_update(&run->progress, done, total);
}

static void run_setting(const glint_exhaustive_choice *chosen, const glint_setting *setting,
                        run *run)
{
    run->options = (glint_domain_options){.setting = *setting,
                                          .from = (uint64_t)chosen->from,
                                          .shard = (uint64_t)chosen->shard_number,
                                          .shards = (uint64_t)chosen->shard_count,
                                          .stride = (uint64_t)chosen->stride,
                                          .seed = (uint64_t)chosen->seed,
                                          .threads = (int)chosen->threads,
                                          .stop = glint_stop_flag(),
                                          .progress = show_progress,
                                          .progress_context = run};
    run->has_run = true;
    run->status = glint_build_first("verify", setting, 1, GLINT_RTL_OBSERVED, (int)chosen->threads,
                                    &run->err);
    run->result.next = (uint64_t)chosen->from;
    if (run->status != GLINT_OK)
        return;
    run->start = glint_seconds();
    glint_progress_begin(&run->progress, "verify", run->unit);
    run->status = glint_domain_run(&run->options, &run->result, &run->err);
    glint_progress_end(&run->progress);
    run->seconds = glint_seconds() - run->start;
}

/* ---- What it prints ----------------------------------------------------------------------------
 */

/* Every given option that affects the comparison, starting at a point. */
static void write_command(const glint_exhaustive_choice *chosen, const run *run, uint64_t from,
                          char *text, size_t size)
{
    char options[GLINT_SETTING_OPTIONS];
    glint_setting_options(&run->options.setting, options);
    text[0] = '\0';
    glint_shell_append(text, size, glint_failure_program());
    size_t used = strlen(text);
    (void)snprintf(text + used, size - used, " verify --exhaustive %s", options);
    used = strlen(text);
    if (chosen->shard_count != 1)
        (void)snprintf(text + used, size - used, " --shard %s", chosen->shard);
    used = strlen(text);
    if (from != 0)
        (void)snprintf(text + used, size - used, " --from %" PRIu64, from);
    used = strlen(text);
    if (chosen->stride != 1)
        (void)snprintf(text + used, size - used, " --stride %" PRId64 " --seed %" PRId64,
                       chosen->stride, chosen->seed);
    glint_circuit_options_append(&chosen->circuits, text, size);
}

/* The packet of the first mismatch, and its report. */
static void report_failure(const glint_exhaustive_choice *chosen, run *run, FILE *out)
{
    char name[GLINT_SETTING_TEXT], directory[FILENAME_MAX];
    glint_failure *failure;
    glint_error err;
    if (glint_failure_of_domain(&run->options, &run->result.mismatch[0], &failure, &err) !=
        GLINT_OK) {
        (void)glint_complain_error("verify", &err);
        return;
    }
    failure->program = glint_failure_program();
    glint_failure_name_circuit(failure, chosen->circuits.directory);
    write_command(chosen, run, (uint64_t)chosen->from, failure->command, sizeof failure->command);
    glint_setting_name(&run->options.setting, name);
    (void)snprintf(directory, sizeof directory, "%s/%s_exhaustive", chosen->out, name);
    if (glint_failure_playable(failure) &&
        glint_failure_output("verify", failure, NULL, directory, GLINT_FAILURE_REPORT, out))
        memcpy(run->packet, directory, sizeof directory);
    glint_failure_destroy(failure);
}

static void print_mismatches(const glint_exhaustive_choice *chosen, run *run, FILE *out)
{
    if (run->result.kept == 0)
        return;
    fprintf(out, "the first mismatches:\n");
    for (int i = 0; i < run->result.kept; i++) {
        const glint_domain_mismatch *mismatch = &run->result.mismatch[i];
        fprintf(out, "  point %" PRIu64 ",", mismatch->point);
        glint_mismatch_print_one(out, &run->options.setting, &mismatch->signal);
    }
    report_failure(chosen, run, out);
}

static void print_resume(const glint_exhaustive_choice *chosen, const run *run, FILE *out)
{
    char command[GLINT_FAILURE_COMMAND];
    if (run->status != GLINT_INTERRUPTED)
        return;
    write_command(chosen, run, run->result.next, command, sizeof command);
    glint_exhaustive_options_append(chosen, command, sizeof command);
    fprintf(out, "resume: %s\n", command);
}

/* After the seconds: why this is not the whole. */
static const char *ending(const run *run)
{
    return run->status == GLINT_OK            ? ""
           : run->status == GLINT_INTERRUPTED ? " (interrupted)"
                                              : " (stopped early)";
}

static void print_text(const glint_exhaustive_choice *chosen, run *run)
{
    char setting[GLINT_SETTING_TEXT];
    const glint_domain_result *result = &run->result;
    print_mismatches(chosen, run, stdout);
    glint_setting_describe(&run->options.setting, setting);
    printf("%s: %s: %" PRIu64 " of %" PRIu64 " points", setting,
           run->options.setting.circuit->domain->what, result->points, result->points_total);
    if (chosen->stride != 1)
        printf(", stride %" PRId64 ", seed %" PRId64, chosen->stride, chosen->seed);
    printf("\n");
    if (result->comparisons == 0) {
        printf("no verdict: nothing was compared, %.1f s%s\n", run->seconds, ending(run));
    } else {
        glint_print_verdict(stdout, result->mismatches == 0, "%" PRIu64 " mismatches",
                            result->mismatches);
        printf(" of %" PRIu64 " comparisons: every output after each of %" PRIu64
               " clocks, %.1f s%s\n",
               result->comparisons, result->clocks, run->seconds, ending(run));
    }
    print_resume(chosen, run, stdout);
}

static void add_mismatches(json_t *json, const run *run)
{
    char text[GLINT_VALUE_TEXT];
    json_t *list = glint_json_add(json, "first_mismatches", json_array());
    for (int i = 0; i < run->result.kept; i++) {
        const glint_domain_mismatch *mismatch = &run->result.mismatch[i];
        const glint_mismatch *signal = &mismatch->signal;
        json_t *entry = json_object();
        glint_json_add_number(entry, "point", (double)mismatch->point);
        glint_json_add_text(entry, "signal", signal->signal.name);
        glint_json_add_number(entry, "lane", signal->signal.lane);
        glint_mismatch_bits(&signal->signal, signal->model, text);
        glint_json_add_text(entry, "model", text);
        glint_mismatch_bits(&signal->signal, signal->rtl, text);
        glint_json_add_text(entry, "rtl", text);
        json_array_append_new(list, entry);
    }
}

static json_t *setting_json(const run *run)
{
    const glint_domain_result *result = &run->result;
    json_t *json = json_object();
    glint_info_add_values(json, &run->options.setting);
    glint_json_add_number(json, "points", (double)result->points);
    glint_json_add_number(json, "points_total", (double)result->points_total);
    glint_json_add_number(json, "next", (double)result->next);
    glint_json_add_number(json, "clocks", (double)result->clocks);
    glint_json_add_number(json, "comparisons", (double)result->comparisons);
    glint_json_add_number(json, "mismatches", (double)result->mismatches);
    glint_json_add_number(json, "seconds", run->seconds);
    if (run->status != GLINT_OK && run->status != GLINT_INTERRUPTED)
        glint_json_add_text(json, "error", run->err.text);
    add_mismatches(json, run);
    if (run->packet[0] != '\0')
        glint_json_add_text(json, "packet", run->packet);
    return json;
}

/* Of all settings together. */
typedef struct sums {
    uint64_t mismatches, comparisons, points;
    bool interrupted, failed;
} sums;

static sums add_up(const run *runs, int count)
{
    sums sum = {0};
    for (int i = 0; i < count; i++) {
        const run *run = &runs[i];
        sum.mismatches += run->result.mismatches;
        sum.comparisons += run->result.comparisons;
        sum.points += run->result.points;
        sum.interrupted |= !run->has_run || run->status == GLINT_INTERRUPTED;
        sum.failed |= run->has_run && run->status != GLINT_OK && run->status != GLINT_INTERRUPTED;
    }
    return sum;
}

static bool print_json(const glint_exhaustive_choice *chosen, const run *runs, int count)
{
    char seed[32]; /* a JSON number would lose the low bits of a large seed */
    const sums sum = add_up(runs, count);
    const glint_circuit *circuit = chosen->circuits.chosen[0];
    json_t *json = json_object();
    glint_json_add_text(json, "circuit", circuit->name);
    glint_json_add_text(json, "domain", circuit->domain->what);
    glint_json_add_number(json, "mismatches", (double)sum.mismatches);
    glint_json_add_number(json, "comparisons", (double)sum.comparisons);
    glint_json_add_number(json, "points", (double)sum.points);
    glint_json_add_text(json, "shard", chosen->shard);
    glint_json_add_number(json, "stride", (double)chosen->stride);
    (void)snprintf(seed, sizeof seed, "%" PRId64, chosen->seed);
    if (chosen->stride != 1)
        glint_json_add_text(json, "seed", seed);
    glint_json_add_text(json, "not_reached", NOT_REACHED);
    json_object_set_new(json, "interrupted", json_boolean(sum.interrupted));
    json_t *list = glint_json_add(json, "settings", json_array());
    for (int i = 0; i < count && runs[i].has_run; i++)
        json_array_append_new(list, setting_json(&runs[i]));
    return glint_output_json(json);
}

/* ---- All settings ------------------------------------------------------------------------------
 */

/* A setting without a domain gets its own line; earlier findings remain reported. */
static void report_setting(const glint_exhaustive_choice *chosen, run *run)
{
    char setting[GLINT_SETTING_TEXT];
    const bool failed = run->status != GLINT_OK && run->status != GLINT_INTERRUPTED;
    if (!failed || run->result.comparisons != 0) {
        if (!chosen->json) {
            print_text(chosen, run);
        } else {
            print_mismatches(chosen, run, stderr);
            print_resume(chosen, run, stderr);
        }
    }
    if (!failed)
        return;
    glint_setting_describe(&run->options.setting, setting);
    (void)glint_complain("verify", GLINT_EXIT_TROUBLE, "%s: %s", setting, run->err.text);
}

static int run_all(const glint_exhaustive_choice *chosen, run *runs, int count)
{
    glint_setting setting;
    for (int i = 0; i < count && !glint_stop_requested(); i++) {
        (void)glint_circuit_options_setting(&chosen->circuits, i, &setting);
        run_setting(chosen, &setting, &runs[i]);
        report_setting(chosen, &runs[i]);
    }
    const sums sum = add_up(runs, count);
    if (!chosen->json && count == 1 && sum.comparisons != 0)
        printf("not reached: %s\n", NOT_REACHED);
    else if (!chosen->json && sum.comparisons != 0)
        printf("%d settings: %" PRIu64 " mismatches of %" PRIu64 " comparisons\nnot reached: %s\n",
               count, sum.mismatches, sum.comparisons, NOT_REACHED);
    if (chosen->json && sum.comparisons != 0 && !print_json(chosen, runs, count))
        return glint_complain("verify", GLINT_EXIT_TROUBLE, "out of memory");
    if (sum.mismatches != 0)
        return GLINT_EXIT_DIFFERENT;
    return sum.failed || sum.interrupted || sum.points == 0 ? GLINT_EXIT_TROUBLE : GLINT_EXIT_OK;
}

int glint_verify_domain(const glint_exhaustive_choice *chosen)
{
    const glint_circuit *circuit = chosen->circuits.chosen[0];
    glint_setting setting;
    int count = 0;
    if (circuit->domain == NULL)
        return glint_complain("verify", GLINT_EXIT_TROUBLE,
                              "circuit %s has no domain to enumerate: add one to its description "
                              "(glint_circuit.h), or omit --exhaustive to use random inputs",
                              circuit->name);
    while (count <= SETTINGS_MAX &&
           glint_circuit_options_setting(&chosen->circuits, count, &setting))
        count++;
    if (count > SETTINGS_MAX)
        return glint_complain("verify", GLINT_EXIT_TROUBLE,
                              "more than %d settings: narrow them down with options", SETTINGS_MAX);
    run *runs = calloc((size_t)count, sizeof *runs);
    if (runs == NULL)
        return glint_complain("verify", GLINT_EXIT_TROUBLE, "out of memory");
    const int status = run_all(chosen, runs, count);
    free(runs);
    return status;
}
