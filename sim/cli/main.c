/* `glint SUBCOMMAND …`: finds the subcommand and hands over to it. */
#include <stdio.h>
#include <string.h>

#include "cli/commands.h"
#include "cli/output.h"
#include "cli/parse.h"
#include "cli/version.h"

static const struct {
    const char *name;
    const char *help;
    int (*run)(int argc, char **argv);
} subcommands[] = {
    {"info", "settings, number formats, latency, ROM checksums", glint_cmd_info},
    {"models", "the reflectance models, and how far each is from cos^n", glint_cmd_models},
    {"eval", "the device's answer for points on standard input, as CSV", glint_cmd_eval},
    {"divide", "the divider's answer for divisions on standard input, as CSV", glint_cmd_divide},
    {"render", "a lit mesh as a PNG, every highlight by the device", glint_cmd_render},
    {"compare", "how two PNG pictures differ", glint_cmd_compare},
    {"study", "one scene by two methods, compared and timed", glint_cmd_study},
    {"verify", "C model and Verilog in lockstep, every register, every clock", glint_cmd_verify},
    {"replay", "a mismatch that verify or render left in a packet, again", glint_cmd_replay},
    {"wave", "a waveform of a short scene, with a GTKWave save file", glint_cmd_wave},
    {"energy", "how much light the reflectance models give back", glint_cmd_energy},
    {"report", "what the thesis claims, measured, as a page to read", glint_cmd_report},
    {"bench", "fragments, divisions, clocks and frames a second", glint_cmd_bench},
};

#define SUBCOMMAND_COUNT (sizeof subcommands / sizeof subcommands[0])

static int print_help(void)
{
    printf("Usage: glint SUBCOMMAND [OPTION]...\n"
           "The specular-colour device and the divider of spans, in C and in Verilog: evaluated,\n"
           "rendered, verified.\n"
           "\n"
           "Subcommands:\n");
    for (size_t i = 0; i < SUBCOMMAND_COUNT; i++) {
        printf("  %-10s%s\n", subcommands[i].name, subcommands[i].help);
    }
    printf("\n"
           "glint SUBCOMMAND --help   its options and their defaults\n"
           "glint --version           the version\n"
           "\n"
           "Exit status: 0 done, 1 failed or differing, 2 malformed command line or input.\n");
    return glint_output_finish(NULL, GLINT_EXIT_OK);
}

static int print_version(void)
{
    printf("glint %s\n", GLINT_VERSION);
    return glint_output_finish(NULL, GLINT_EXIT_OK);
}

int main(int argc, char **argv)
{
    glint_output_init();
    if (argc < 2) {
        return glint_complain(NULL, GLINT_EXIT_USAGE, "no subcommand (see glint --help)");
    }
    if (strcmp(argv[1], "--help") == 0 || strcmp(argv[1], "-h") == 0 ||
        strcmp(argv[1], "help") == 0) {
        return print_help();
    }
    if (strcmp(argv[1], "--version") == 0) {
        return print_version();
    }
    for (size_t i = 0; i < SUBCOMMAND_COUNT; i++) {
        if (strcmp(argv[1], subcommands[i].name) == 0) {
            return subcommands[i].run(argc - 1, argv + 1);
        }
    }
    glint_quoted quoted;
    return glint_complain(NULL, GLINT_EXIT_USAGE, "unknown %s %s (see glint --help)",
                          argv[1][0] == '-' ? "option" : "subcommand",
                          glint_quote(argv[1], &quoted));
}
