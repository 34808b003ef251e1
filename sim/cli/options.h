/* The command line of a subcommand, declared as a table and read strictly.
 *
 *     int64_t n = 100;
 *     const char *out = NULL;
 *     const glint_option options[] = {
 *         {.name = "n", .help = "exponent", .kind = GLINT_OPTION_INTEGER,
 *          .integer = {&n, 0, 1023}},
 *         {.name = "out", .placeholder = "FILE", .help = "the picture", .required = true,
 *          .kind = GLINT_OPTION_STRING, .string = &out},
 *     };
 *     const glint_command_line line = {.command = "render", .summary = "Renders a frame.",
 *                                      .options = options, .option_count = 2};
 *     const int status = glint_options_parse(&line, argc, argv);
 *     if (status != GLINT_OPTIONS_RUN) {
 *         return status;
 *     }
 *
 * The initial values of the variables are the defaults, which --help shows; they exist only once.
 * --help (or -h) is generated from the table and goes to standard output: usage, summary, options,
 * details, exit status, examples, within 80 columns.
 *
 * Rejected, each with one line on standard error and exit status 2: an unknown option (names may
 * not be abbreviated), an option given twice, a missing or superfluous value, a value that is not
 * entirely of the stated kind and range, too many or too few positional arguments, a missing
 * required option. A similar name is suggested. Values follow as --n 50 or --n=50, integers as
 * 1000000, 1e6 or 1M; "--" ends the options. */
#ifndef GLINT_SIM_CLI_OPTIONS_H
#define GLINT_SIM_CLI_OPTIONS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef enum glint_option_kind {
    GLINT_OPTION_FLAG,
    GLINT_OPTION_INTEGER,
    GLINT_OPTION_COUNT_OR, /* the same, or a word */
    GLINT_OPTION_REAL,
    GLINT_OPTION_CHOICE,
    GLINT_OPTION_STRING,
    GLINT_OPTION_SIZE,      /* WxH */
    GLINT_OPTION_REALS,     /* three numbers, X,Y,Z */
    GLINT_OPTION_COLOR,     /* any form of glint_parse_color() */
    GLINT_OPTION_INTENSITY, /* of a light: 0 to 1, or R,G,B each 0 to 255 */
} glint_option_kind;

typedef struct glint_option {
    const char *name;        /* without the dashes */
    const char *placeholder; /* of the value in --help; NULL: the kind's own (N, X, a|b|c, WxH …) */
    const char *help;        /* one sentence; the default is added to it */
    const char *usually;     /* a default that is not a value: "one per processor"; else NULL */
    glint_option_kind kind;
    bool required;
    bool *given; /* set to true if the option was given; may be NULL */
    union {
        bool *flag; /* set to true */
        struct {
            int64_t *value;
            int64_t min, max;
        } integer;
        struct {
            int64_t *value;
            int64_t min, max;
            const char *word; /* stands for meant, which is not in min…max */
            int64_t meant;
        } count_or;
        struct {
            double *value;
            double min, max; /* both finite */
        } real;
        struct {
            int *value;               /* index into names */
            const char *const *names; /* ends with NULL */
        } choice;
        const char **string; /* never empty; points into argv */
        struct {
            int *width, *height;
            int max; /* each side is 1…max */
        } size;
        struct {
            double *value; /* three */
            double min, max;
            bool alike; /* one number stands for three alike */
        } reals;
        uint8_t *color;    /* three: R, G, B */
        double *intensity; /* three: R, G, B, each 0…1 */
    };
} glint_option;

typedef struct glint_positional {
    const char *name;   /* FILE.png, for --help and messages */
    const char **value; /* points into argv */
    bool optional;      /* may be left out; those after it are optional too */
} glint_positional;

/* A line to try, for the end of --help. */
typedef struct glint_example {
    const char *what;    /* what it does; NULL ends a list of them */
    const char *command; /* "glint render --out a.png" */
} glint_example;

typedef struct glint_command_line {
    const char *command;   /* the subcommand's name */
    const char *summary;   /* what it does, a sentence or a few */
    const char *details;   /* more text below the options, in paragraphs; indented lines are not
                              broken   anew; may be NULL */
    const char *done;      /* meaning of exit status 0, unless it is just "done" */
    const char *different; /* meaning of exit status 1 for a command that compares; else NULL */
    const glint_example *examples;
    const glint_option *options;
    size_t option_count; /* at most GLINT_OPTIONS_MAX */
    const glint_positional *positionals;
    size_t positional_count;
} glint_command_line;

#define GLINT_OPTIONS_MAX 64

/* Returned by glint_options_parse() if the subcommand should proceed; otherwise it returns the exit
 * status to leave with: 0 after --help, 2 after an error or if --help could not be written. */
#define GLINT_OPTIONS_RUN (-1)

/* argv[0] is the subcommand's name, as main() passes it. */
int glint_options_parse(const glint_command_line *line, int argc, char **argv);

/* The names of the settings, in the order of their enums, for GLINT_OPTION_CHOICE and for output:
 * glint_gate_names[GLINT_GATE_SIGN] is "sign". Each list ends with NULL. */
extern const char *const glint_gate_names[];
extern const char *const glint_pipeline_names[];
extern const char *const glint_backend_names[];
extern const char *const glint_divider_form_names[];

#endif
