/* The options that select circuits and their settings, generated from the circuits' descriptions.
 *
 *     glint_circuit_options circuits;
 *     int status = glint_circuit_options_begin(&circuits, &use, argc, argv);
 *     … glint_option options[OWN + GLINT_CIRCUIT_OPTIONS] = {…};
 *     const size_t count = OWN + glint_circuit_options_add(&circuits, options + OWN);
 *     … glint_options_parse() …
 *     status = glint_circuit_options_settle(&circuits);
 *     for (int i = 0; glint_circuit_options_setting(&circuits, i, &setting); i++) …
 *
 * Each parameter name is one option, shared by all circuits that have it. Giving an option excludes
 * the circuits that lack it; its value must be in range for every circuit that remains. */
#ifndef GLINT_SIM_CLI_CIRCUIT_OPTIONS_H
#define GLINT_SIM_CLI_CIRCUIT_OPTIONS_H

#include <limits.h>
#include <stdbool.h>
#include <stddef.h>

#include "circuit/setting.h"
#include "cli/options.h"

#define GLINT_CIRCUITS_MAX        16
#define GLINT_PARAMETER_NAMES_MAX 24
#define GLINT_CIRCUIT_OPTIONS     (GLINT_PARAMETER_NAMES_MAX + 4) /* rows at most */

/* What a subcommand accepts, and its defaults. */
typedef struct glint_circuit_use {
    const char *command;
    const char *circuit; /* by its name; "all" */
    bool takes_all;      /* `all` for the values of a parameter, and for the circuits, */
    bool one_circuit;    /* unless there is to be one */
    /* A parameter's value as text, "all" too; NULL: what the circuit has as its standard. */
    const char *(*usual)(const char *parameter);
} glint_circuit_use;

/* The values of a parameter that has them all. */
#define GLINT_EVERY_VALUE INT_MIN

/* An option of a parameter's name, and the words that --help has for it. */
typedef struct glint_parameter_option {
    const char *name;
    const char *text; /* that was given; NULL: none */
    char placeholder[96], help[512], usual[64];
} glint_parameter_option;

/* Must not move once rows point into it. */
typedef struct glint_circuit_options {
    glint_circuit_use use;
    bool is_own;       /* of --circuit-dir: what a parameter usually is, its description says */
    int circuit_count; /* that there are */
    const glint_circuit *circuit[GLINT_CIRCUITS_MAX];
    const char *names[GLINT_CIRCUITS_MAX + 2]; /* theirs, "all", NULL */
    char help[256];                            /* of --circuit */
    int named, device;                         /* of names, by --circuit and --device */
    bool is_named, is_device;
    int parameter_count;
    glint_parameter_option parameter[GLINT_PARAMETER_NAMES_MAX];
    const char *verilog;   /* --rtl; NULL: the circuit's own */
    const char *directory; /* --circuit-dir; NULL: none */
    /* Once settled: */
    int chosen_count;
    const glint_circuit *chosen[GLINT_CIRCUITS_MAX];
    int value[GLINT_CIRCUITS_MAX][GLINT_PARAMETERS_MAX]; /* or GLINT_EVERY_VALUE */
} glint_circuit_options;

/* First looks for --circuit-dir among the arguments, since its circuit determines the options; that
 * circuit is then the only one. Returns GLINT_OPTIONS_RUN, or the exit status to leave with. */
int glint_circuit_options_begin(glint_circuit_options *options, const glint_circuit_use *use,
                                int argc, char **argv);

/* Fills rows; returns how many. */
size_t glint_circuit_options_add(glint_circuit_options *options, glint_option *rows);

/* After parsing: which circuits, which values, and whether --rtl has their Verilog. Returns as
 * above. */
int glint_circuit_options_settle(glint_circuit_options *options);

/* The index-th selected setting, circuit by circuit, with parameters that were not given iterating
 * over their listed values; false past the last. */
bool glint_circuit_options_setting(const glint_circuit_options *options, int index,
                                   glint_setting *setting);

/* The standard setting of a chosen circuit but for the values that were given alone. */
glint_setting glint_circuit_options_first(const glint_circuit_options *options, int chosen);

/* The index-th circuit that has every option given but is taken on request only, and was not
 * (glint_circuit.h); NULL past the last. */
const glint_circuit *glint_circuit_options_left(const glint_circuit_options *options, int index);

/* Whether this parameter was given for any circuit. */
bool glint_circuit_options_given(const glint_circuit_options *options, const char *parameter);

/* " --circuit-dir DIR --rtl DIR", each where it was given, quoted for a shell: appended to a
 * command that has the rest. */
void glint_circuit_options_append(const glint_circuit_options *options, char *text, size_t size);

/* The row of --rtl for a command without the others, and its check: for a setting whose verilog it
 * is; and where it is of no use but with the Verilog (is_used). Each returns as above. */
#define GLINT_RTL_OPTION(directory)                                                                \
    {                                                                                              \
        .name = "rtl", .placeholder = "DIR",                                                       \
        .help = "use the Verilog in this directory instead of "                                    \
                "Glint's own",                                                                     \
        .kind = GLINT_OPTION_STRING, .string = (directory)                                         \
    }
#define GLINT_CIRCUIT_DIR_OPTION(directory)                                                        \
    {                                                                                              \
        .name = "circuit-dir", .placeholder = "DIR",                                               \
        .help = "a circuit of your own: its description and C model (*.c) and its Verilog",        \
        .kind = GLINT_OPTION_STRING, .string = (directory)                                         \
    }
int glint_rtl_option_check(const char *command, const glint_setting *setting);
int glint_rtl_option_settle(const char *command, const glint_setting *setting, bool is_used);

#endif
