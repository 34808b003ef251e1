/* Reads a subcommand's command line by its table, with getopt_long; see options.h. */
#include "cli/options.h"

#include <getopt.h>
#include <string.h>

#include "backend/divider_backend.h"
#include "cli/options_help.h"
#include "cli/output.h"
#include "cli/parse.h"
#include "cli/suggest.h"

const char *const glint_gate_names[] = {
    [GLINT_GATE_COSINE] = "cosine",
    [GLINT_GATE_SIGN] = "sign",
    [GLINT_GATE_DRAWN] = "drawn",
    [GLINT_GATE_COUNT] = NULL,
};

const char *const glint_pipeline_names[] = {
    [GLINT_PIPELINE_COMBINATIONAL] = "combinational",
    [GLINT_PIPELINE_PIPELINED] = "pipelined",
    [GLINT_PIPELINE_COUNT] = NULL,
};

const char *const glint_backend_names[] = {
    [GLINT_BACKEND_C] = "c",
    [GLINT_BACKEND_RTL] = "rtl",
    [GLINT_BACKEND_REAL] = "real",
    [GLINT_BACKEND_COUNT] = NULL,
};

const char *const glint_divider_form_names[] = {
    [GLINT_DIVIDER_SEQUENTIAL] = "sequential",
    [GLINT_DIVIDER_PIPELINED] = "pipelined",
    [GLINT_DIVIDER_FORM_COUNT] = NULL,
};

/* getopt_long's value for option i is FIRST_OPTION + i: above every character it may return. */
#define FIRST_OPTION 256
#define HELP_OPTION  (FIRST_OPTION + GLINT_OPTIONS_MAX)

static bool store_color(const glint_option *option, const char *text)
{
    glint_rgb rgb;
    if (!glint_parse_color(text, &rgb))
        return false;
    const uint8_t components[3] = {rgb.r, rgb.g, rgb.b};
    memcpy(option->color, components, sizeof components);
    return true;
}

static bool store_reals(const glint_option *option, const char *text)
{
    double value[3];
    if (option->reals.alike &&
        glint_parse_real(text, option->reals.min, option->reals.max, &value[0]))
        value[2] = value[1] = value[0];
    else if (!glint_parse_reals(text, ',', 3, option->reals.min, option->reals.max, value))
        return false;
    memcpy(option->reals.value, value, sizeof value);
    return true;
}

static bool store_intensity(const glint_option *option, const char *text)
{
    double value[3];
    if (glint_parse_real(text, 0.0, 1.0, &value[0])) {
        value[2] = value[1] = value[0];
    } else {
        if (!glint_parse_reals(text, ',', 3, 0.0, 255.0, value))
            return false;
        for (int i = 0; i < 3; i++)
            value[i] /= 255.0;
    }
    memcpy(option->intensity, value, sizeof value);
    return true;
}

static bool store_size(const glint_option *option, const char *text)
{
    int64_t side[2];
    if (!glint_parse_integers(text, 'x', 2, 1, option->size.max, side))
        return false;
    *option->size.width = (int)side[0];
    *option->size.height = (int)side[1];
    return true;
}

static bool store_choice(const glint_option *option, const char *text)
{
    for (int i = 0; option->choice.names[i] != NULL; i++) {
        if (strcmp(option->choice.names[i], text) == 0) {
            *option->choice.value = i;
            return true;
        }
    }
    return false;
}

static bool store_count_or(const glint_option *option, const char *text)
{
    if (strcmp(text, option->count_or.word) == 0) {
        *option->count_or.value = option->count_or.meant;
        return true;
    }
    return glint_parse_count(text, option->count_or.min, option->count_or.max,
                             option->count_or.value);
}

static bool store_string(const glint_option *option, const char *text)
{
    if (*text == '\0')
        return false;
    *option->string = text;
    return true;
}

static bool store(const glint_option *option, const char *text)
{
    switch (option->kind) {
    case GLINT_OPTION_FLAG:
        *option->flag = true;
        return true;
    case GLINT_OPTION_INTEGER:
        return glint_parse_count(text, option->integer.min, option->integer.max,
                                 option->integer.value);
    case GLINT_OPTION_COUNT_OR:
        return store_count_or(option, text);
    case GLINT_OPTION_REAL:
        return glint_parse_real(text, option->real.min, option->real.max, option->real.value);
    case GLINT_OPTION_CHOICE:
        return store_choice(option, text);
    case GLINT_OPTION_STRING:
        return store_string(option, text);
    case GLINT_OPTION_SIZE:
        return store_size(option, text);
    case GLINT_OPTION_REALS:
        return store_reals(option, text);
    case GLINT_OPTION_COLOR:
        return store_color(option, text);
    case GLINT_OPTION_INTENSITY:
        return store_intensity(option, text);
    }
    return false;
}

static int refuse_value(const glint_command_line *line, const glint_option *option,
                        const char *text)
{
    char expected[320];
    glint_quoted quoted;
    glint_suggestion suggestion = {""};
    glint_option_expectation(option, expected, sizeof expected);
    if (option->kind == GLINT_OPTION_CHOICE)
        (void)glint_did_you_mean(text, option->choice.names, "", &suggestion);
    return glint_complain(line->command, GLINT_EXIT_TROUBLE, "--%s: %s is not %s%s", option->name,
                          glint_quote(text, &quoted), expected, suggestion.text);
}

/* getopt_long also accepts abbreviated names, which scripts must not rely on. */
static bool is_abbreviation(const glint_option *option, const char *token)
{
    return strcspn(token + 2, "=") != strlen(option->name);
}

static int refuse_unknown(const glint_command_line *line, const char *token)
{
    char name[64];
    const char *names[GLINT_OPTIONS_MAX + 2] = {NULL};
    glint_quoted quoted;
    glint_next_part(token, '=', name);
    for (size_t i = 0; i < line->option_count; i++)
        names[i] = line->options[i].name;
    names[line->option_count] = "help";
    const char *meant = glint_suggest(name + strspn(name, "-"), names);
    return glint_complain(
        line->command, GLINT_EXIT_TROUBLE, "unknown option %s (%s%s%ssee glint %s --help)",
        glint_quote(*name != '\0' ? name : token, &quoted), meant != NULL ? "did you mean --" : "",
        meant != NULL ? meant : "", meant != NULL ? "? " : "", line->command);
}

/* Reports what getopt_long rejected with '?' or ':', based on the current token. */
static int refuse_token(const glint_command_line *line, int result, const char *token)
{
    if (optopt == HELP_OPTION)
        return glint_complain(line->command, GLINT_EXIT_TROUBLE, "--help takes no value");
    if (optopt < FIRST_OPTION)
        return refuse_unknown(line, token);
    const glint_option *option = &line->options[optopt - FIRST_OPTION];
    if (is_abbreviation(option, token))
        return refuse_unknown(line, token);
    if (result == '?') {
        return glint_complain(line->command, GLINT_EXIT_TROUBLE, "--%s takes no value",
                              option->name);
    }
    char expected[320];
    glint_option_expectation(option, expected, sizeof expected);
    return glint_complain(line->command, GLINT_EXIT_TROUBLE, "--%s needs a value: %s", option->name,
                          expected);
}

static int take_positional(const glint_command_line *line, size_t *taken, const char *text)
{
    if (*taken == line->positional_count) {
        glint_quoted quoted;
        return glint_complain(line->command, GLINT_EXIT_TROUBLE, "unexpected argument %s",
                              glint_quote(text, &quoted));
    }
    *line->positionals[*taken].value = text;
    ++*taken;
    return GLINT_OPTIONS_RUN;
}

static int take_option(const glint_command_line *line, int index, bool *given, const char *token)
{
    const glint_option *option = &line->options[index];
    if (is_abbreviation(option, token))
        return refuse_unknown(line, token);
    if (given[index]) {
        return glint_complain(line->command, GLINT_EXIT_TROUBLE, "--%s is given twice",
                              option->name);
    }
    given[index] = true;
    if (option->given != NULL)
        *option->given = true;
    return store(option, optarg) ? GLINT_OPTIONS_RUN : refuse_value(line, option, optarg);
}

static int take_help(const glint_command_line *line, const char *token)
{
    if (token[1] == '-' && strcmp(token, "--help") != 0)
        return refuse_unknown(line, token);
    glint_options_print_help(line);
    return glint_output_finish(line->command, GLINT_EXIT_OK);
}

static int check_complete(const glint_command_line *line, const bool *given, size_t taken)
{
    if (taken < line->positional_count && !line->positionals[taken].optional) {
        return glint_complain(line->command, GLINT_EXIT_TROUBLE,
                              "%s is missing (see glint %s --help)", line->positionals[taken].name,
                              line->command);
    }
    for (size_t i = 0; i < line->option_count; i++) {
        if (line->options[i].required && !given[i]) {
            return glint_complain(line->command, GLINT_EXIT_TROUBLE,
                                  "--%s is required (see glint %s --help)", line->options[i].name,
                                  line->command);
        }
    }
    return GLINT_OPTIONS_RUN;
}

static void make_long_options(const glint_command_line *line, struct option *table)
{
    memset(table, 0, (GLINT_OPTIONS_MAX + 2) * sizeof *table);
    for (size_t i = 0; i < line->option_count; i++) {
        table[i].name = line->options[i].name;
        table[i].has_arg =
            line->options[i].kind == GLINT_OPTION_FLAG ? no_argument : required_argument;
        table[i].val = FIRST_OPTION + (int)i;
    }
    table[line->option_count].name = "help";
    table[line->option_count].val = HELP_OPTION;
}

int glint_options_parse(const glint_command_line *line, int argc, char **argv)
{
    struct option table[GLINT_OPTIONS_MAX + 2];
    bool given[GLINT_OPTIONS_MAX] = {false};
    size_t taken = 0;
    make_long_options(line, table);

    int status = GLINT_OPTIONS_RUN;
    opterr = 0;
    optind = 0; /* glibc: begin anew */
    while (status == GLINT_OPTIONS_RUN) {
        /* "-": arguments come in order, so that argv[before] is the token being read. */
        const int before = optind > 0 ? optind : 1;
        const int result = getopt_long(argc, argv, "-:h", table, NULL);
        if (result == -1)
            break;
        if (result == '?' || result == ':')
            status = refuse_token(line, result, argv[before]);
        else if (result == 'h' || result == HELP_OPTION)
            status = take_help(line, argv[before]);
        else if (result == 1)
            status = take_positional(line, &taken, optarg);
        else
            status = take_option(line, result - FIRST_OPTION, given, argv[before]);
    }
    while (status == GLINT_OPTIONS_RUN && optind < argc)
        status = take_positional(line, &taken, argv[optind++]); /* what follows "--" */
    return status == GLINT_OPTIONS_RUN ? check_complete(line, given, taken) : status;
}
