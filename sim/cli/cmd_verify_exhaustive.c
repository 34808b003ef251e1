/* `glint verify --exhaustive`: the Verilog against the C model over the whole domain. */
#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "circuit/circuits.h"
#include "circuit/units.h"
#include "cli/build_first.h"
#include "cli/commands.h"
#include "cli/exhaustive_options.h"
#include "cli/failure_output.h"
#include "cli/info_circuit.h"
#include "cli/output.h"
#include "failure/shell.h"
#include "lockstep/exhaustive.h"

/* One run and what the progress line needs. */
typedef struct run {
    glint_exhaustive_options options;
    glint_exhaustive_result result;
    glint_error err;
    glint_status status;
    glint_progress progress;
    double start, seconds;
    char unit[64];
    char packet[FILENAME_MAX]; /* where it is; "": none */
} run;

/* A value that `all` was said of: all that are listed, but of the lanes the most. False: more than
 * fit. */
static bool choose_settings(const glint_exhaustive_choice *chosen,
                            glint_exhaustive_options *options)
{
    static const int all_lanes = 16;
    glint_circuit_options circuits = chosen->circuits;
    int *lanes = &circuits.value[0][circuits.chosen[0]->parameter_count - 1];
    glint_setting setting;
    if (*lanes == GLINT_EVERY_VALUE)
        *lanes = all_lanes;
    while (glint_circuit_options_setting(&circuits, options->settings, &setting)) {
        if (options->settings == GLINT_EXHAUSTIVE_CIRCUITS_MAX)
            return false;
        options->setting[options->settings++] = setting;
    }
    return true;
}

/* Rate and time left are part of the unit that glint_progress shows. */
static void show_progress(void *context, uint64_t done, uint64_t total)
{
    run *run = context;
    const double rate = (double)done / (glint_seconds() - run->start);
    (void)snprintf(run->unit, sizeof run->unit, "points, %.1f million per second, %.0f s left",
                   rate / 1e6, (double)(total - done) / rate);
    glint_progress_update(&run->progress, done, total);
}

static glint_exhaustive_circuit sum_of(const run *run)
{
    glint_exhaustive_circuit sum = {0};
    for (int c = 0; c < run->options.settings; c++) {
        sum.points += run->result.circuit[c].points;
        sum.comparisons += run->result.circuit[c].comparisons;
        sum.mismatches += run->result.circuit[c].mismatches;
        sum.w_untried += run->result.circuit[c].w_untried;
    }
    return sum;
}

/* ---- What it prints -----------------------------------------------------------------------------
 */

/* " --every-lane --stride N --seed N", each if it was given. */
#define POINTS_TEXT 96
static void points_options(const glint_exhaustive_choice *chosen, char text[POINTS_TEXT])
{
    const char *lanes = chosen->every_lane ? " --every-lane" : "";
    if (chosen->stride != 1)
        (void)snprintf(text, POINTS_TEXT, "%s --stride %" PRId64 " --seed %" PRId64, lanes,
                       chosen->stride, chosen->seed);
    else
        (void)snprintf(text, POINTS_TEXT, "%s", lanes);
}

/* " --gate cosine --pipeline all --lanes all": as it was chosen; of other units their name first.
 */
static void append_values(const glint_circuit *circuit, const int *values, char *text, size_t size)
{
    if (circuit != &glint_circuit_specular)
        (void)snprintf(text + strlen(text), size - strlen(text), " --circuit %s", circuit->name);
    for (int i = 0; i < circuit->parameter_count; i++) {
        const glint_parameter *parameter = &circuit->parameters[i];
        const size_t used = strlen(text);
        if (values[i] == GLINT_EVERY_VALUE)
            (void)snprintf(text + used, size - used, " --%s all", parameter->name);
        else if (parameter->choices != NULL)
            (void)snprintf(text + used, size - used, " --%s %s", parameter->name,
                           parameter->choices[values[i]]);
        else
            (void)snprintf(text + used, size - used, " --%s %d", parameter->name, values[i]);
    }
}

/* Every given option that affects the comparison, starting at an n. */
static void write_command_from(const glint_exhaustive_choice *chosen, uint32_t from, char *text,
                               size_t size)
{
    char points[POINTS_TEXT];
    points_options(chosen, points);
    text[0] = '\0';
    glint_shell_append(text, size, glint_failure_program());
    (void)snprintf(text + strlen(text), size - strlen(text), " verify --exhaustive");
    append_values(chosen->circuits.chosen[0], chosen->circuits.value[0], text, size);
    const size_t used = strlen(text);
    (void)snprintf(text + used, size - used, " --shard %s --from %" PRIu32 "%s", chosen->shard,
                   from, points);
    glint_circuit_options_append(&chosen->circuits, text, size);
}

/* All that was tried with this n. */
static void write_command(const glint_exhaustive_choice *chosen,
                          const glint_exhaustive_mismatch *first, char *text, size_t size)
{
    char points[POINTS_TEXT];
    points_options(chosen, points);
    text[0] = '\0';
    glint_shell_append(text, size, glint_failure_program());
    (void)snprintf(text + strlen(text), size - strlen(text), " verify --exhaustive");
    append_values(first->setting.circuit, first->setting.values, text, size);
    const size_t used = strlen(text);
    (void)snprintf(text + used, size - used, " --shard %" PRIu32 "/%u%s", first->n + 1,
                   GLINT_N_COUNT, points);
    glint_circuit_options_append(&chosen->circuits, text, size);
}

static void print_mismatch(const glint_exhaustive_mismatch *m, FILE *out)
{
    const glint_answer *answer = &m->answer;
    fprintf(out,
            "  n %u, cosine 0x%05" PRIx32 ", R,G,B %u,%u,%u, lane %d: %s: model %" PRId32
            ", rtl %" PRId32 "\n",
            answer->material.n, answer->cos_code[answer->at], answer->material.r,
            answer->material.g, answer->material.b, answer->at % glint_highlight_lanes(&m->setting),
            glint_answer_value_name(answer->value), answer->model, answer->rtl);
}

/* The packet for the first mismatch, or for a circuit that failed to answer, and its report. */
static void report_failure(const glint_exhaustive_choice *chosen, run *run, FILE *out)
{
    char name[GLINT_SETTING_TEXT], directory[FILENAME_MAX];
    const glint_exhaustive_mismatch *first = run->result.kept != 0 ? run->result.mismatch : NULL;
    const glint_setting setting =
        first != NULL ? first->setting : *glint_history_setting(run->result.history);
    glint_failure *failure;
    glint_error err;
    if (glint_failure_of_history(GLINT_FAILURE_EXHAUSTIVE, &setting,
                                 first != NULL ? &first->answer : NULL, run->result.history,
                                 glint_stop_flag(), &failure, &err) != GLINT_OK) {
        (void)glint_complain_error("verify", &err);
        return;
    }
    failure->program = glint_failure_program();
    if (failure->pins == NULL && first != NULL)
        write_command(chosen, first, failure->command, sizeof failure->command);
    else /* what went before that n may matter */
        write_command_from(chosen, (uint32_t)chosen->from, failure->command,
                           sizeof failure->command);
    glint_setting_name(&setting, name);
    (void)snprintf(directory, sizeof directory, "%s/%s_exhaustive", chosen->out, name);
    if (glint_failure_playable(failure) &&
        glint_failure_output("verify", failure, NULL, directory, GLINT_FAILURE_REPORT, out))
        memcpy(run->packet, directory, sizeof directory);
    glint_failure_destroy(failure);
}

static void print_mismatches(const glint_exhaustive_choice *chosen, run *run, FILE *out)
{
    if (run->result.kept != 0)
        fprintf(out, "the first mismatches:\n");
    for (int i = 0; i < run->result.kept; i++)
        print_mismatch(&run->result.mismatch[i], out);
    if (run->result.kept != 0 || run->result.history != NULL)
        report_failure(chosen, run, out);
}

static void print_resume(const glint_exhaustive_choice *chosen, const run *run, FILE *out)
{
    char command[GLINT_FAILURE_COMMAND];
    if (run->status != GLINT_INTERRUPTED)
        return;
    write_command_from(chosen, run->result.next, command, sizeof command);
    glint_exhaustive_options_append(chosen, command, sizeof command);
    fprintf(out, "resume: %s\n", command);
}

static void print_circuits(const glint_exhaustive_choice *chosen, const run *run)
{
    for (int c = 0; c < run->options.settings; c++) {
        const glint_exhaustive_circuit *circuit = &run->result.circuit[c];
        char setting[GLINT_SETTING_TEXT];
        glint_setting_describe(&run->options.setting[c], setting);
        printf("%s: %" PRIu64 " mismatches; %" PRIu32 " of %" PRIu32
               " W codes occurred; multipliers: %" PRIu64 " of %" PRIu64
               " pairs of such a W and a colour%s\n",
               setting, circuit->mismatches, circuit->w_codes, circuit->w_possible, circuit->pairs,
               circuit->pairs_total, chosen->every_lane ? ", in every lane" : "");
    }
}

/* Of the points, which; and what no run of this kind reaches. */
static void print_reach(const glint_exhaustive_choice *chosen, const run *run)
{
    int lanes = 1;
    for (int c = 0; c < run->options.settings; c++)
        if (glint_highlight_lanes(&run->options.setting[c]) > lanes)
            lanes = glint_highlight_lanes(&run->options.setting[c]);
    if (chosen->stride == 1)
        printf("reached: all");
    else
        printf("reached: 1 in %" PRId64, chosen->stride);
    printf(" of the %u codes of the cosine pin for every n tried, in white and in colour; ",
           GLINT_EXHAUSTIVE_CODES);
    if (lanes == 1 || chosen->every_lane)
        printf("each lane saw all of them\n");
    else
        printf("each lane saw 1 in %d of them, different ones for each n\n", lanes);
    printf("not reached: %s\n", GLINT_NOT_REACHED);
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
    const glint_exhaustive_circuit sum = sum_of(run);
    print_mismatches(chosen, run, stdout);
    print_circuits(chosen, run);
    print_reach(chosen, run);
    if (sum.comparisons == 0) {
        printf("no verdict: nothing was compared, %.1f s%s\n", run->seconds, ending(run));
        print_resume(chosen, run, stdout);
        return;
    }
    glint_print_verdict(stdout, sum.mismatches == 0, "%" PRIu64 " mismatches", sum.mismatches);
    printf(" of %" PRIu64 " comparisons: W and three colours of %" PRIu64 " points, %" PRIu32
           " values of n, ",
           sum.comparisons, sum.points, run->result.n_done);
    if (chosen->stride != 1)
        printf("stride %" PRId64 ", seed %" PRId64 ", ", chosen->stride, chosen->seed);
    printf("%.1f s%s\n", run->seconds, ending(run));
    print_resume(chosen, run, stdout);
}

static void add_circuits(json_t *json, const run *run)
{
    json_t *list = glint_json_add(json, "circuits", json_array());
    for (int c = 0; c < run->options.settings; c++) {
        const glint_exhaustive_circuit *circuit = &run->result.circuit[c];
        json_t *entry = json_object();
        glint_info_add_values(entry, &run->options.setting[c]);
        glint_json_add_number(entry, "points", (double)circuit->points);
        glint_json_add_number(entry, "mismatches", (double)circuit->mismatches);
        glint_json_add_number(entry, "w_codes", circuit->w_codes);
        glint_json_add_number(entry, "pairs", (double)circuit->pairs);
        glint_json_add_number(entry, "pairs_total", (double)circuit->pairs_total);
        json_array_append_new(list, entry);
    }
}

static void add_mismatches(json_t *json, const run *run)
{
    json_t *list = glint_json_add(json, "first_mismatches", json_array());
    for (int i = 0; i < run->result.kept; i++) {
        const glint_exhaustive_mismatch *m = &run->result.mismatch[i];
        const glint_answer *answer = &m->answer;
        json_t *entry = json_object();
        glint_info_add_values(entry, &m->setting);
        glint_json_add_number(entry, "lane", answer->at % glint_highlight_lanes(&m->setting));
        glint_json_add_number(entry, "n", answer->material.n);
        glint_json_add_number(entry, "cos_code", answer->cos_code[answer->at]);
        glint_json_add_number(entry, "r", answer->material.r);
        glint_json_add_number(entry, "g", answer->material.g);
        glint_json_add_number(entry, "b", answer->material.b);
        glint_json_add_text(entry, "value", glint_answer_value_name(answer->value));
        glint_json_add_number(entry, "model", answer->model);
        glint_json_add_number(entry, "rtl", answer->rtl);
        json_array_append_new(list, entry);
    }
}

static bool print_json(const glint_exhaustive_choice *chosen, const run *run)
{
    char seed[32]; /* a JSON number would lose the low bits of a large seed */
    const glint_exhaustive_circuit sum = sum_of(run);
    json_t *json = json_object();
    glint_json_add_text(json, "circuit", chosen->circuits.chosen[0]->name);
    glint_json_add_number(json, "mismatches", (double)sum.mismatches);
    glint_json_add_number(json, "comparisons", (double)sum.comparisons);
    glint_json_add_number(json, "points", (double)sum.points);
    glint_json_add_number(json, "n_done", run->result.n_done);
    glint_json_add_number(json, "next", run->result.next);
    glint_json_add_text(json, "shard", chosen->shard);
    glint_json_add_number(json, "stride", (double)chosen->stride);
    (void)snprintf(seed, sizeof seed, "%" PRId64, chosen->seed);
    if (chosen->stride != 1)
        glint_json_add_text(json, "seed", seed);
    json_object_set_new(json, "every_lane", json_boolean(chosen->every_lane));
    glint_json_add_text(json, "not_reached", GLINT_NOT_REACHED);
    json_object_set_new(json, "interrupted", json_boolean(run->status == GLINT_INTERRUPTED));
    glint_json_add_number(json, "seconds", run->seconds);
    if (run->status != GLINT_OK && run->status != GLINT_INTERRUPTED)
        glint_json_add_text(json, "error", run->err.text);
    add_circuits(json, run);
    add_mismatches(json, run);
    if (run->packet[0] != '\0')
        glint_json_add_text(json, "packet", run->packet);
    return glint_output_json(json);
}

/* The mismatches are for people; with --json they must not mix with the result. */
static int report(const glint_exhaustive_choice *chosen, run *run)
{
    const glint_exhaustive_circuit sum = sum_of(run);
    if (!chosen->json) {
        print_text(chosen, run);
    } else {
        print_mismatches(chosen, run, stderr);
        print_resume(chosen, run, stderr);
        if (!print_json(chosen, run))
            return glint_complain("verify", GLINT_EXIT_TROUBLE, "out of memory");
    }
    /* A missing answer is a difference: the C model has one. */
    const bool differs = sum.mismatches != 0 || run->status == GLINT_DEVICE_FAULT;
    if (run->status != GLINT_OK && run->status != GLINT_INTERRUPTED)
        (void)glint_complain_error("verify", &run->err);
    if (differs)
        return GLINT_EXIT_DIFFERENT;
    if (sum.w_untried != 0)
        return glint_complain("verify", GLINT_EXIT_TROUBLE,
                              "%" PRIu32
                              " W codes occurred that the multipliers were not tested with",
                              sum.w_untried);
    return run->status == GLINT_OK && sum.points != 0 ? GLINT_EXIT_OK : GLINT_EXIT_TROUBLE;
}

/* Findings before a failure are still reported; options that select nothing leave nothing to
 * report. */
static int end(const glint_exhaustive_choice *chosen, run *run)
{
    return run->status == GLINT_BAD_ARGUMENT ? glint_complain_error("verify", &run->err)
                                             : report(chosen, run);
}

static int verify(const glint_exhaustive_choice *chosen)
{
    run run = {.options = {.from = (uint32_t)chosen->from,
                           .shard = (uint32_t)chosen->shard_number,
                           .shards = (uint32_t)chosen->shard_count,
                           .stride = (uint32_t)chosen->stride,
                           .seed = (uint64_t)chosen->seed,
                           .every_lane = chosen->every_lane,
                           .threads = (int)chosen->threads,
                           .stop = glint_stop_flag(),
                           .progress = show_progress,
                           .progress_context = &run,
                           .keep_history = true}};
    if (!choose_settings(chosen, &run.options))
        return glint_complain("verify", GLINT_EXIT_TROUBLE,
                              "more than %d settings: narrow them down with options",
                              GLINT_EXHAUSTIVE_CIRCUITS_MAX);
    run.start = glint_seconds();
    run.status = glint_build_first("verify", run.options.setting, run.options.settings,
                                   GLINT_RTL_FAST, run.options.threads, &run.err);
    run.result.next = run.options.from;
    glint_progress_begin(&run.progress, "verify", run.unit);
    if (run.status == GLINT_OK) {
        run.start = glint_seconds();
        run.status = glint_exhaustive_run(&run.options, &run.result, &run.err);
    }
    run.seconds = glint_seconds() - run.start;
    glint_progress_end(&run.progress);
    const int status = end(chosen, &run);
    glint_history_destroy(run.result.history);
    return status;
}

int glint_cmd_verify_exhaustive(int argc, char **argv)
{
    glint_exhaustive_choice chosen;
    const int status = glint_exhaustive_options_parse(argc, argv, &chosen);
    if (status != GLINT_OPTIONS_RUN)
        return status;
    return glint_output_finish("verify", glint_is_highlight(chosen.circuits.chosen[0])
                                             ? verify(&chosen)
                                             : glint_verify_domain(&chosen));
}
