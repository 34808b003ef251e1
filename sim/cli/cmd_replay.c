/* `glint replay`: reproduces a failure packet. */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "circuit/guard.h"
#include "circuit/own.h"
#include "cli/circuit_options.h"
#include "cli/commands.h"
#include "cli/failure_output.h"
#include "cli/options.h"
#include "cli/output.h"
#include "failure/report.h"
#include "failure/shell.h"
#include "file/same.h"
#include "lockstep/mismatch.h"

typedef struct replay_options {
    const char *directory, *out;
    const char *verilog;          /* --rtl; NULL: Glint's own, or that of circuit_dir */
    const char *circuit_dir;      /* NULL: none */
    const glint_circuit *circuit; /* its circuit */
    bool json;
    int argc; /* the command itself */
    char **argv;
} replay_options;

/* The packet, and the result of replaying it. */
typedef struct replay {
    glint_failure *packet;
    glint_failure_finding now;
    glint_capture *capture;
    bool same;
} replay;

/* A replay produces no pictures, and would overwrite the packet's. */
static bool is_same_packet(const char *a, const char *b)
{
    char data_of_a[FILENAME_MAX], data_of_b[FILENAME_MAX];
    (void)snprintf(data_of_a, sizeof data_of_a, "%s/%s", a, GLINT_PACKET_DATA);
    (void)snprintf(data_of_b, sizeof data_of_b, "%s/%s", b, GLINT_PACKET_DATA);
    return glint_file_same(data_of_a, data_of_b);
}

static int parse(int argc, char **argv, replay_options *chosen)
{
    const glint_option options[] = {
        {.name = "out",
         .placeholder = "DIR",
         .help = "if they differ, write a new packet here",
         .kind = GLINT_OPTION_STRING,
         .string = &chosen->out},
        {.name = "rtl",
         .placeholder = "DIR",
         .help = "use the Verilog in this directory, such as the one the packet was made with",
         .usually = "Glint's own",
         .kind = GLINT_OPTION_STRING,
         .string = &chosen->verilog},
        GLINT_CIRCUIT_DIR_OPTION(&chosen->circuit_dir),
        {.name = "json",
         .help = "print the result as JSON",
         .kind = GLINT_OPTION_FLAG,
         .flag = &chosen->json},
    };
    const glint_positional positionals[] = {{.name = "DIR", .value = &chosen->directory}};
    static const glint_example examples[] = {
        {"a packet from glint verify", "glint replay glint-failure/specular_cosine_pipelined_1"},
        {NULL, NULL},
    };
    const glint_command_line line = {
        .command = "replay",
        .summary = "Replays the inputs of a failure packet through the C model and the Verilog. "
                   "verify and render write a packet when the two differ.",
        .details = "To find the commit that introduced or fixed a fault:\n"
                   "\n"
                   "  git bisect run sh -c 'make -j2 build/glint || exit 125\n"
                   "                        build/glint replay DIR; s=$?\n"
                   "                        [ $s -le 1 ] && exit $s; exit 125'",
        .done = "the C model and the Verilog no longer differ",
        .different = "they differ, whether or not --out could be written",
        .examples = examples,
        .options = options,
        .option_count = sizeof options / sizeof options[0],
        .positionals = positionals,
        .positional_count = 1,
    };
    const int status = glint_options_parse(&line, argc, argv);
    glint_error err;
    if (status == GLINT_OPTIONS_RUN && chosen->out != NULL &&
        is_same_packet(chosen->directory, chosen->out))
        return glint_complain("replay", GLINT_EXIT_TROUBLE, "--out: %s is the packet itself",
                              chosen->out);
    if (status == GLINT_OPTIONS_RUN && chosen->circuit_dir != NULL)
        glint_guard_begin(chosen->circuit_dir);
    if (status == GLINT_OPTIONS_RUN && chosen->circuit_dir != NULL &&
        glint_circuit_load(chosen->circuit_dir, &chosen->circuit, &err) != GLINT_OK)
        return glint_complain_error("replay", &err);
    return status;
}

/* Whether the answer was asked again; a replay of pins does not need it. */
static bool has_answers(const replay *of)
{
    return of->packet->has_answer && of->packet->pins == NULL;
}

static void print_answers(const replay *of)
{
    const glint_answer *answer = &of->packet->answer;
    printf("%s: model %" PRId32 ", rtl %" PRId32 "; when the packet was written: model %" PRId32
           ", rtl %" PRId32 "\n",
           glint_answer_value_name(answer->value), of->now.model, of->now.rtl, answer->model,
           answer->rtl);
}

static const char *verdict(const replay *of)
{
    return !glint_failure_differs(&of->now) ? "gone: the C model and the Verilog agree"
           : of->same                       ? "the same mismatch"
                                            : "a different mismatch from the packet's";
}

static void print_text(const replay *of)
{
    char setting[GLINT_SETTING_TEXT];
    const glint_lockstep_result *found = &of->capture->found;
    glint_setting_describe(&of->packet->setting, setting);
    printf("%s: ", setting);
    glint_print_verdict(stdout, !glint_failure_differs(&of->now), "%s", verdict(of));
    printf("; %" PRIu64 " comparisons\n", found->comparisons);
    glint_failure_print_mismatches(stdout, of->packet, &of->now, found);
    if (has_answers(of))
        print_answers(of);
}

static json_t *mismatches_of(const replay *of)
{
    json_t *list = json_array();
    for (int i = 0; i < of->now.count; i++) {
        const glint_mismatch *mismatch = &of->now.mismatch[i];
        char text[GLINT_VALUE_TEXT];
        json_t *entry = json_object();
        glint_json_add_text(entry, "signal", mismatch->signal.name);
        glint_json_add_number(entry, glint_setting_lane_name(&of->packet->setting),
                              mismatch->signal.lane);
        glint_json_add_number(entry, "block", mismatch->signal.block);
        glint_mismatch_bits(&mismatch->signal, mismatch->model, text);
        glint_json_add_text(entry, "model", text);
        glint_mismatch_bits(&mismatch->signal, mismatch->rtl, text);
        glint_json_add_text(entry, "rtl", text);
        json_array_append_new(list, entry);
    }
    return list;
}

static bool print_json(const replay_options *chosen, const replay *of)
{
    json_t *json = json_object();
    glint_json_add_text(json, "packet", chosen->directory);
    glint_json_add_text(json, "kind", glint_failure_kind_names[of->packet->kind]);
    json_object_set_new(json, "mismatch", json_boolean(glint_failure_differs(&of->now)));
    json_object_set_new(json, "same", json_boolean(of->same));
    glint_json_add_number(json, "comparisons", (double)of->capture->found.comparisons);
    glint_json_add_number(json, "clock", (double)of->now.clock);
    json_object_set_new(json, "mismatches", mismatches_of(of));
    if (has_answers(of)) {
        glint_json_add_number(json, "model", of->now.model);
        glint_json_add_number(json, "rtl", of->now.rtl);
    }
    return glint_output_json(json);
}

/* The same inputs with what they lead to now. The command that is printed to be typed is this one,
 * not what the packet brings along as such. */
static glint_status write_packet(const replay_options *chosen, replay *of, glint_error *err)
{
    glint_failure fresh = *of->packet;
    fresh.program = glint_failure_program();
    glint_failure_command(chosen->argc, chosen->argv, fresh.command, sizeof fresh.command);
    glint_failure_name_verilog(&fresh);
    glint_failure_name_circuit(&fresh, chosen->circuit_dir);
    fresh.finding = of->now;
    fresh.capture = of->capture;
    if (has_answers(of)) {
        fresh.answer.model = of->now.model;
        fresh.answer.rtl = of->now.rtl;
    }
    return glint_packet_write(&fresh, NULL, chosen->out, err);
}

static int report(const replay_options *chosen, replay *of)
{
    glint_error err;
    if (!chosen->json)
        print_text(of);
    else if (!print_json(chosen, of))
        return glint_complain("replay", GLINT_EXIT_TROUBLE, "out of memory");
    if (!glint_failure_differs(&of->now))
        return GLINT_EXIT_OK;
    if (chosen->out != NULL && write_packet(chosen, of, &err) != GLINT_OK)
        (void)glint_complain_error("replay", &err);
    else if (chosen->out != NULL && !chosen->json)
        printf("packet: %s\n", chosen->out);
    return GLINT_EXIT_DIFFERENT;
}

static void show(void *context, uint64_t done, uint64_t total)
{
    glint_progress_update(context, done, total);
}

/* A run from its seed may take hours. */
static glint_status play(replay *of, glint_error *err)
{
    glint_progress progress;
    const glint_capture_control control = {glint_stop_flag(), show, &progress};
    glint_progress_begin(&progress, "replay", "clocks");
    const glint_status status =
        glint_failure_play(of->packet, &control, &of->now, &of->capture, err);
    glint_progress_end(&progress);
    return status;
}

/* A packet may come from anywhere, and building Verilog executes it, so a directory named only by
 * the packet is mentioned but never opened. */
static void choose_verilog(const replay_options *chosen, glint_failure *packet)
{
    char directory[GLINT_SHELL_WORD(GLINT_FAILURE_DIRECTORY)] = "";
    packet->setting.verilog = chosen->verilog != NULL ? chosen->verilog : chosen->circuit_dir;
    if (chosen->verilog != NULL || glint_failure_rtl(packet)[0] == '\0')
        return;
    glint_shell_append(directory, sizeof directory, packet->rtl);
    (void)glint_complain("replay", GLINT_EXIT_OK,
                         "with %s Verilog; the packet was made with other Verilog: --rtl %s",
                         chosen->circuit_dir != NULL ? "--circuit-dir's" : "Glint's own",
                         directory);
}

static int run(const replay_options *chosen, replay *of)
{
    glint_error err;
    glint_status status = glint_packet_read(chosen->directory, chosen->circuit, &of->packet, &err);
    if (status == GLINT_OK) {
        choose_verilog(chosen, of->packet);
        const int found = glint_rtl_option_check("replay", &of->packet->setting);
        if (found != GLINT_OPTIONS_RUN)
            return found;
        status = play(of, &err);
    }
    if (status != GLINT_OK)
        return glint_complain("replay", GLINT_EXIT_TROUBLE, "%s", err.text);
    of->same = glint_failure_same(&of->now, &of->packet->finding);
    return report(chosen, of);
}

int glint_cmd_replay(int argc, char **argv)
{
    replay_options chosen = {.argc = argc, .argv = argv};
    replay of = {0};
    const int parsed = parse(argc, argv, &chosen);
    if (parsed != GLINT_OPTIONS_RUN)
        return parsed;
    const int status = run(&chosen, &of);
    free(of.capture);
    glint_failure_destroy(of.packet);
    return glint_output_finish("replay", status);
}
