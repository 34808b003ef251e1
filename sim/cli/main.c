/* `glint SUBCOMMAND …`: finds the subcommand and hands over to it. */
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "circuit/guard.h"
#include "cli/commands.h"
#include "cli/output.h"
#include "cli/parse.h"
#include "cli/suggest.h"
#include "cli/version.h"
#include "rtl/command.h"

static const struct {
    const char *name;
    const char *help;
    int (*run)(int argc, char **argv);
} subcommands[] = {
    {"info", "settings, number formats, latency, ROM checksums", glint_cmd_info},
    {"models", "the reflectance models and their deviation from cos^n", glint_cmd_models},
    {"eval", "the device's answers to points on standard input, as CSV", glint_cmd_eval},
    {"divide", "the divider's answers to divisions on standard input, as CSV", glint_cmd_divide},
    {"render", "a lit mesh as a PNG, every highlight computed by the device", glint_cmd_render},
    {"compare", "how two PNG pictures differ", glint_cmd_compare},
    {"convert", "a mesh as a .3ds, .obj, .ply, .stl or .glb file", glint_cmd_convert},
    {"study", "a scene by two methods, compared and timed", glint_cmd_study},
    {"verify", "C model and Verilog in lockstep: every register, every clock", glint_cmd_verify},
    {"replay", "a mismatch from verify or render, replayed from its packet", glint_cmd_replay},
    {"wave", "a waveform of a short scene, with a GTKWave save file", glint_cmd_wave},
    {"draw", "a circuit's block diagram, from its description", glint_cmd_draw},
    {"energy", "how much light the reflectance models give back", glint_cmd_energy},
    {"report", "the thesis's claims, measured, as a page to read", glint_cmd_report},
    {"bench", "fragments, divisions, clocks and frames per second", glint_cmd_bench},
};

#define SUBCOMMAND_COUNT (sizeof subcommands / sizeof subcommands[0])

static int print_help(void)
{
    printf("Usage: glint SUBCOMMAND [OPTION]...\n"
           "The specular-colour device and the span divider, in C and in Verilog:\n"
           "evaluated, rendered, verified.\n"
           "\n"
           "Subcommands:\n");
    for (size_t i = 0; i < SUBCOMMAND_COUNT; i++)
        printf("  %-10s%s\n", subcommands[i].name, subcommands[i].help);
    printf("\n"
           "glint SUBCOMMAND --help   its options, their defaults, examples;\n"
           "                          also: glint help SUBCOMMAND\n"
           "glint --circuit-dir DIR SUBCOMMAND ...   a circuit of your own (verify, eval,\n"
           "                          wave, replay, info, draw)\n"
           "glint --version, -V       the version\n"
           "\n"
           "Exit status:\n"
           "  0  done; equal, if something was compared\n"
           "  1  compared and different\n"
           "  2  trouble: a bad command line or input, an unreadable or unwritable file,\n"
           "     an interrupt\n"
           "\n"
           "Examples:\n"
           "  # a teapot, every highlight computed in Verilog\n"
           "  glint render --backend rtl --out a.png\n"
           "  # C model and Verilog in lockstep, all settings\n"
           "  glint verify --clocks 10k\n");
    return glint_output_finish(NULL, GLINT_EXIT_OK);
}

static int print_version(void)
{
    printf("glint %s\n", GLINT_VERSION);
    return glint_output_finish(NULL, GLINT_EXIT_OK);
}

static const char circuit_option[] = "--circuit-dir";

/* How many arguments --circuit-dir and its DIR are, if they stand here: 1 with `=`, 2, or 0. */
static int circuit_arguments(const char *word)
{
    const size_t length = sizeof circuit_option - 1;
    if (strncmp(word, circuit_option, length) != 0)
        return 0;
    return word[length] == '=' ? 1 : word[length] == '\0' ? 2 : 0;
}

static int refuse(const char *word)
{
    if (circuit_arguments(word) != 0)
        return glint_complain(NULL, GLINT_EXIT_TROUBLE, "%s is given twice: name one directory",
                              circuit_option);
    const char *names[SUBCOMMAND_COUNT + 4] = {NULL};
    const bool is_option = word[0] == '-';
    size_t count = 0;
    if (is_option) {
        names[count++] = "--help";
        names[count++] = "--version";
        names[count++] = circuit_option;
    }
    for (size_t i = 0; i < SUBCOMMAND_COUNT && !is_option; i++)
        names[count++] = subcommands[i].name;
    glint_quoted quoted;
    const char *meant = glint_suggest(word, names);
    return glint_complain(NULL, GLINT_EXIT_TROUBLE, "unknown %s %s (%s%s%ssee glint --help)",
                          is_option ? "option" : "subcommand", glint_quote(word, &quoted),
                          meant != NULL ? "did you mean " : "", meant != NULL ? meant : "",
                          meant != NULL ? "? " : "");
}

/* argv[0] is the subcommand's name. */
static int run(int argc, char **argv)
{
    for (size_t i = 0; i < SUBCOMMAND_COUNT; i++)
        if (strcmp(argv[0], subcommands[i].name) == 0)
            return subcommands[i].run != NULL ? subcommands[i].run(argc, argv)
                                              : glint_subcommand_is_not_here(argv[0]);
    return refuse(argv[0]);
}

/* `help SUBCOMMAND …` is `SUBCOMMAND … --help`: argv, with the word help before it, has the room.
 */
static int help_on(int argc, char **argv)
{
    static char help[] = "--help";
    for (int i = 0; i + 1 < argc; i++)
        argv[i] = argv[i + 1];
    argv[argc - 1] = help;
    return run(argc, argv);
}

/* `--circuit-dir DIR SUBCOMMAND …` is `SUBCOMMAND --circuit-dir DIR …`. Returns how many arguments
 * stood before the subcommand. */
static int move_circuit_dir(int argc, char **argv)
{
    const int moved = circuit_arguments(argv[1]);
    if (moved == 0 || argc < moved + 2)
        return moved;
    char *const subcommand = argv[1 + moved];
    memmove(argv + 2, argv + 1, (size_t)moved * sizeof *argv);
    argv[1] = subcommand;
    return moved;
}

/* Of the subcommands, those that do not take --circuit-dir; help does. */
static bool refuses_circuit(const char *name)
{
    static const char *const takes[] = {"info", "eval", "verify", "replay", "wave", "draw"};
    bool is_known = false;
    for (size_t i = 0; i < SUBCOMMAND_COUNT; i++)
        is_known |= strcmp(name, subcommands[i].name) == 0;
    for (size_t i = 0; i < sizeof takes / sizeof takes[0]; i++)
        is_known &= strcmp(name, takes[i]) != 0;
    return is_known;
}

static int command(int argc, char **argv)
{
    glint_output_init();
    glint_command_stop_when(glint_stop_flag());
    if (argc < 2)
        return glint_complain(NULL, GLINT_EXIT_TROUBLE, "no subcommand (see glint --help)");
    const int moved = move_circuit_dir(argc, argv);
    if (moved != 0 && argc < moved + 2) {
        return glint_complain(
            NULL, GLINT_EXIT_TROUBLE,
            "--circuit-dir DIR must be followed by a subcommand (see glint --help)");
    }
    if (moved != 0 && refuses_circuit(argv[1]))
        return glint_complain(NULL, GLINT_EXIT_TROUBLE, "%s does not take %s (see glint %s --help)",
                              argv[1], circuit_option, argv[1]);
    const bool is_help = strcmp(argv[1], "help") == 0;
    if (is_help && argc > 2 && argv[2][0] != '-')
        return help_on(argc - 1, argv + 1);
    if (is_help || strcmp(argv[1], "--help") == 0 || strcmp(argv[1], "-h") == 0)
        return print_help();
    if (strcmp(argv[1], "--version") == 0 || strcmp(argv[1], "-V") == 0)
        return print_version();
    return run(argc - 1, argv + 1);
}

int main(int argc, char **argv)
{
    const int status = command(argc, argv);
    glint_guard_end();
    return status;
}
