/* What `glint verify --exhaustive` is asked for; see exhaustive_options.h. */
#define _POSIX_C_SOURCE 200809L

#include "cli/exhaustive_options.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "circuit/units.h"
#include "cli/output.h"
#include "cli/parse.h"
#include "failure/shell.h"
#include "lockstep/domain.h"
#include "lockstep/exhaustive.h"

/* Of any circuit; highlight units count values of n. */
#define PARTS_MAX INT64_C(1000000000000)

_Static_assert(GLINT_DOMAIN_THREADS_MAX == GLINT_EXHAUSTIVE_THREADS_MAX, "one option for both");

static bool is_highlight(const glint_exhaustive_choice *chosen)
{
    return glint_is_highlight(chosen->circuits.chosen[0]);
}

static int refuse_shard(const char *text, int64_t most)
{
    glint_quoted quoted;
    return glint_complain("verify", GLINT_EXIT_TROUBLE,
                          "--shard: %s is not I/N with I from 1 to N and N from 1 to %" PRId64,
                          glint_quote(text, &quoted), most);
}

static int parse_shard(glint_exhaustive_choice *chosen)
{
    char number[32];
    const int64_t most = is_highlight(chosen) ? GLINT_N_COUNT : PARTS_MAX;
    const char *slash = strchr(chosen->shard, '/');
    if (slash == NULL || slash - chosen->shard >= (ptrdiff_t)sizeof number)
        return refuse_shard(chosen->shard, most);
    (void)snprintf(number, sizeof number, "%.*s", (int)(slash - chosen->shard), chosen->shard);
    if (!glint_parse_integer(slash + 1, 1, most, &chosen->shard_count) ||
        !glint_parse_integer(number, 1, chosen->shard_count, &chosen->shard_number))
        return refuse_shard(chosen->shard, most);
    return GLINT_OPTIONS_RUN;
}

/* What the options' own ranges leave open, as they are for every circuit. */
static int check_highlight(const glint_exhaustive_choice *chosen)
{
    if (chosen->from > GLINT_N_MAX)
        return glint_complain("verify", GLINT_EXIT_TROUBLE,
                              "--from: \"%" PRId64 "\" is not an integer from 0 to %u",
                              chosen->from, GLINT_N_MAX);
    if (chosen->stride > GLINT_EXHAUSTIVE_CODES)
        return glint_complain("verify", GLINT_EXIT_TROUBLE,
                              "--stride: \"%" PRId64 "\" is not an integer from 1 to %u",
                              chosen->stride, GLINT_EXHAUSTIVE_CODES);
    return GLINT_OPTIONS_RUN;
}

static int check(glint_exhaustive_choice *chosen)
{
    int status = glint_circuit_options_settle(&chosen->circuits);
    if (status == GLINT_OPTIONS_RUN && is_highlight(chosen))
        status = check_highlight(chosen);
    if (status != GLINT_OPTIONS_RUN)
        return status;
    if (chosen->every_lane && !is_highlight(chosen))
        return glint_complain("verify", GLINT_EXIT_TROUBLE,
                              "--every-lane needs a circuit that computes highlights, not %s",
                              chosen->circuits.chosen[0]->name);
    if (chosen->seed_given && chosen->stride == 1)
        return glint_complain(
            "verify", GLINT_EXIT_TROUBLE,
            "--seed needs --stride, whose starting point it sets: nothing else is random");
    return parse_shard(chosen);
}

/* A highlight unit is the faster, the more lanes it has. */
static const char *usual(const char *parameter)
{
    return strcmp(parameter, "lanes") == 0 ? "16" : NULL;
}

#define OWN_ROWS 9

static int parse(int argc, char **argv, glint_exhaustive_choice *chosen)
{
    const glint_circuit_use use = {.command = "verify",
                                   .circuit = "specular",
                                   .takes_all = true,
                                   .one_circuit = true,
                                   .usual = usual};
    const int begun = glint_circuit_options_begin(&chosen->circuits, &use, argc, argv);
    if (begun != GLINT_OPTIONS_RUN)
        return begun;
    glint_option options[OWN_ROWS + GLINT_CIRCUIT_OPTIONS] = {
        {.name = "exhaustive",
         .help = "all inputs instead of random ones",
         .kind = GLINT_OPTION_FLAG,
         .flag = &chosen->exhaustive},
        {.name = "every-lane",
         .help = "every code through every lane, with every n: 16 lanes take 16 times as long",
         .kind = GLINT_OPTION_FLAG,
         .flag = &chosen->every_lane},
        {.name = "shard",
         .placeholder = "I/N",
         .help = "only the n, or points, with n mod N = I-1",
         .kind = GLINT_OPTION_STRING,
         .string = &chosen->shard},
        {.name = "from",
         .help = "the first n, or point: where an interrupted run tells you to resume",
         .kind = GLINT_OPTION_INTEGER,
         .integer = {&chosen->from, 0, INT64_MAX}},
        {.name = "stride",
         .help = "only every N-th code, or point, starting at random",
         .kind = GLINT_OPTION_INTEGER,
         .integer = {&chosen->stride, 1, PARTS_MAX}},
        {.name = "seed",
         .given = &chosen->seed_given,
         .help = "seed of the stride's start",
         .usually = "from the time of day",
         .kind = GLINT_OPTION_INTEGER,
         .integer = {&chosen->seed, 0, INT64_MAX}},
        {.name = "threads",
         .usually = "one per processor",
         .given = &chosen->threads_given,
         .help = "each with circuits of its own",
         .kind = GLINT_OPTION_INTEGER,
         .integer = {&chosen->threads, 1, GLINT_EXHAUSTIVE_THREADS_MAX}},
        {.name = "out",
         .given = &chosen->out_given,
         .placeholder = "DIR",
         .help = "directory for the first mismatch's packet, for glint replay; created if needed",
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
        {"all of the default circuit", "glint verify --exhaustive"},
        {"every 64th code only, every gate", "glint verify --exhaustive --stride 64 --gate all"},
        {"the first of eight parts", "glint verify --exhaustive --shard 1/8"},
        {"the power device", "glint verify --exhaustive --circuit power"},
        {"the divider", "glint verify --exhaustive --circuit divider"},
        {NULL, NULL},
    };
    const glint_command_line line = {
        .command = "verify",
        .summary = "Compares the Verilog with the C model for every input. Highlight units: W and "
                   "colours for every n with every cosine code, and for every reachable W code "
                   "with every colour. Other circuits: every output after every clock, for every "
                   "point of the domain that the description names.",
        .details =
            "With each n, a code goes through one lane only, a different one for the next n.\nNot "
            "covered here, but by glint verify and make formal:\n" GLINT_NOT_REACHED ".\n",
        .done = "no mismatch",
        .different = "a mismatch was found, or a circuit failed to answer",
        .examples = examples,
        .options = options,
        .option_count = count,
    };
    const int status = glint_options_parse(&line, argc, argv);
    return status == GLINT_OPTIONS_RUN ? check(chosen) : status;
}

static int64_t processors(void)
{
    const int64_t online = sysconf(_SC_NPROCESSORS_ONLN);
    if (online < 1)
        return 1;
    return online < GLINT_EXHAUSTIVE_THREADS_MAX ? online : GLINT_EXHAUSTIVE_THREADS_MAX;
}

int glint_exhaustive_options_parse(int argc, char **argv, glint_exhaustive_choice *chosen)
{
    *chosen = (glint_exhaustive_choice){.shard = "1/1",
                                        .stride = 1,
                                        .seed = (int64_t)time(NULL),
                                        .threads = processors(),
                                        .out = "glint-failure"};
    return parse(argc, argv, chosen);
}

void glint_exhaustive_options_append(const glint_exhaustive_choice *chosen, char *text, size_t size)
{
    size_t used = strlen(text);
    if (chosen->threads_given)
        (void)snprintf(text + used, size - used, " --threads %" PRId64, chosen->threads);
    used = strlen(text);
    if (chosen->out_given) {
        (void)snprintf(text + used, size - used, " --out ");
        glint_shell_append(text, size, chosen->out);
    }
    used = strlen(text);
    if (chosen->json)
        (void)snprintf(text + used, size - used, " --json");
}
