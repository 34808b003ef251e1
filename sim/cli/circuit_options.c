/* Which circuits and settings a command line means; see circuit_options.h. */
#define _POSIX_C_SOURCE 200809L

#include "cli/circuit_options.h"

#include <errno.h>
#include <inttypes.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "circuit/circuits.h"
#include "circuit/guard.h"
#include "circuit/own.h"
#include "cli/output.h"
#include "cli/parse.h"
#include "cli/suggest.h"
#include "failure/shell.h"

static const char all[] = "all";

static const glint_parameter *parameter_of(const glint_circuit *circuit, const char *name,
                                           int *index)
{
    for (int i = 0; i < circuit->parameter_count; i++)
        if (strcmp(circuit->parameters[i].name, name) == 0) {
            *index = i;
            return &circuit->parameters[i];
        }
    return NULL;
}

static bool has_parameter(const glint_circuit *circuit, const char *name)
{
    int index;
    return parameter_of(circuit, name, &index) != NULL;
}

/* ---- The rows ----------------------------------------------------------------------------------
 */

/* "DIR" of `--circuit-dir DIR` or `--circuit-dir=DIR`; NULL if absent. */
static const char *find_directory(int argc, char **argv)
{
    static const char option[] = "--circuit-dir";
    const size_t length = sizeof option - 1;
    for (int i = 1; i < argc && strcmp(argv[i], "--") != 0; i++) {
        if (strncmp(argv[i], option, length) != 0)
            continue;
        if (argv[i][length] == '=')
            return argv[i] + length + 1;
        if (argv[i][length] == '\0' && i + 1 < argc)
            return argv[i + 1];
    }
    return NULL;
}

static void append_text(char *text, size_t size, const char *what)
{
    const size_t used = strlen(text);
    (void)snprintf(text + used, size - used, "%s", what);
}

static void append_choice(char *text, size_t size, const char *separator, const char *name)
{
    if (text[0] != '\0')
        append_text(text, size, separator);
    append_text(text, size, name);
}

/* The names of a parameter's values, or their range. */
static void append_values(const glint_parameter *parameter, const char *separator, char *text,
                          size_t size)
{
    char number[48];
    for (int i = 0; parameter->choices != NULL && i <= parameter->max; i++)
        append_choice(text, size, separator, parameter->choices[i]);
    if (parameter->choices != NULL)
        return;
    (void)snprintf(number, sizeof number, "%d to %d", parameter->min, parameter->max);
    append_choice(text, size, separator, number);
}

/* What the subcommand takes when nothing is said; NULL: what the circuit does. That it has 16 lanes
 * is for circuits that it knows. */
static const char *usual_of(const glint_circuit_options *options, const char *parameter)
{
    const char *usual = options->use.usual(parameter);
    return usual != NULL && options->is_own && strcmp(usual, all) != 0 ? NULL : usual;
}

/* What is taken when nothing is said: of several circuits, if it is the same. */
static void describe_usual(const glint_circuit_options *options, const glint_parameter *parameter,
                           glint_parameter_option *row)
{
    const char *usual = usual_of(options, parameter->name);
    char number[32];
    if (usual == NULL && parameter->choices != NULL)
        usual = parameter->choices[parameter->standard];
    if (usual == NULL) {
        (void)snprintf(number, sizeof number, "%d", parameter->standard);
        usual = number;
    }
    if (row->usual[0] == '\0')
        (void)snprintf(row->usual, sizeof row->usual, "%s", usual);
    else if (strcmp(row->usual, usual) != 0)
        (void)snprintf(row->usual, sizeof row->usual, "the circuit's");
}

static bool is_alike(const glint_parameter *a, const glint_parameter *b)
{
    return a->choices == b->choices && a->min == b->min && a->max == b->max && a->meaning != NULL &&
           b->meaning != NULL && strcmp(a->meaning, b->meaning) == 0;
}

/* The circuits from…to−1 that have this parameter. */
static bool append_owners(const glint_circuit_options *options, const glint_parameter *parameter,
                          int from, int to, char *text, size_t size)
{
    bool any = false;
    for (int c = from; c < to; c++) {
        int index;
        const glint_parameter *own = parameter_of(options->circuit[c], parameter->name, &index);
        if (own != parameter && (own == NULL || !is_alike(own, parameter)))
            continue;
        append_choice(text, size, ", ", options->circuit[c]->name);
        any = true;
    }
    return any;
}

/* Said once, by the first of the circuits that have it alike. */
static void describe_parameter(const glint_circuit_options *options, int number,
                               const glint_parameter *parameter, glint_parameter_option *row)
{
    char range[64] = "", owners[192] = "", text[512];
    const bool is_first = row->help[0] == '\0';
    describe_usual(options, parameter, row);
    if (append_owners(options, parameter, 0, number, owners, sizeof owners))
        return;
    (void)append_owners(options, parameter, number, options->circuit_count, owners, sizeof owners);
    if (parameter->choices != NULL && is_first)
        append_values(parameter, "|", row->placeholder, sizeof row->placeholder);
    if (parameter->choices == NULL)
        append_values(parameter, "", range, sizeof range);
    (void)snprintf(text, sizeof text, "%s%s of %s: %s%s%s", is_first ? "" : "; ", parameter->name,
                   owners, parameter->meaning != NULL ? parameter->meaning : "a parameter",
                   range[0] != '\0' ? ", " : "", range);
    const char *shown = strchr(text, ':') + 2;
    append_text(row->help, sizeof row->help,
                is_first && options->circuit_count == 1 ? shown : text);
}

static glint_parameter_option *row_of(glint_circuit_options *options, const char *name)
{
    int i = 0;
    while (i < options->parameter_count && strcmp(options->parameter[i].name, name) != 0)
        i++;
    if (i == GLINT_PARAMETER_NAMES_MAX)
        return NULL;
    if (i == options->parameter_count) {
        options->parameter[i] = (glint_parameter_option){.name = name};
        options->parameter_count++;
    }
    return &options->parameter[i];
}

/* Names that a user's circuit cannot use for options, because some subcommand already does. */
static const char *taken_name(const glint_circuit *circuit)
{
    static const char *const taken[] = {
        "backend", "circuit", "circuit-dir", "clocks",  "device", "every-lane", "exhaustive",
        "force",   "format",  "from",        "help",    "json",   "out",        "rtl",
        "seed",    "shard",   "stride",      "threads", "to"};
    for (size_t i = 0; i < sizeof taken / sizeof taken[0]; i++)
        if (has_parameter(circuit, taken[i]))
            return taken[i];
    return NULL;
}

static void add_circuit(glint_circuit_options *options, const glint_circuit *circuit)
{
    if (options->circuit_count == GLINT_CIRCUITS_MAX)
        return;
    options->names[options->circuit_count] = circuit->name;
    options->circuit[options->circuit_count++] = circuit;
}

static void describe_all(glint_circuit_options *options)
{
    for (int c = 0; c < options->circuit_count; c++)
        for (int i = 0; i < options->circuit[c]->parameter_count; i++) {
            const glint_parameter *parameter = &options->circuit[c]->parameters[i];
            glint_parameter_option *row = row_of(options, parameter->name);
            if (row != NULL)
                describe_parameter(options, c, parameter, row);
        }
    for (int i = 0; i < options->parameter_count && options->use.takes_all; i++)
        if (options->parameter[i].placeholder[0] != '\0')
            append_choice(options->parameter[i].placeholder,
                          sizeof options->parameter[i].placeholder, "|", all);
}

int glint_circuit_options_begin(glint_circuit_options *options, const glint_circuit_use *use,
                                int argc, char **argv)
{
    const glint_circuit *circuit;
    glint_error err;
    *options = (glint_circuit_options){.use = *use};
    const char *directory = find_directory(argc, argv);
    if (directory != NULL) {
        glint_guard_begin(directory);
        if (glint_circuit_load(directory, &circuit, &err) != GLINT_OK)
            return glint_complain_error(use->command, &err);
        const char *taken = taken_name(circuit);
        if (taken != NULL)
            return glint_complain(
                use->command, GLINT_EXIT_TROUBLE,
                "%s: circuit %s: a parameter cannot be named %s, because --%s is already an option",
                directory, circuit->name, taken, taken);
        options->is_own = true;
        add_circuit(options, circuit);
    }
    for (int i = 0; directory == NULL && (circuit = glint_circuit_number(i)) != NULL; i++)
        add_circuit(options, circuit);
    describe_all(options);
    if (use->takes_all && !use->one_circuit && options->circuit_count > 1)
        options->names[options->circuit_count] = all;
    for (int i = 0; options->names[i] != NULL; i++)
        if (strcmp(options->names[i], use->circuit) == 0)
            options->named = options->device = i;
    return GLINT_OPTIONS_RUN;
}

/* "one of specular divider …", which is what a shell's completion looks for. */
static void describe_circuits(glint_circuit_options *options)
{
    (void)snprintf(options->help, sizeof options->help, "one of");
    for (int i = 0; options->names[i] != NULL; i++)
        append_choice(options->help, sizeof options->help, " ", options->names[i]);
    append_text(options->help, sizeof options->help,
                options->use.takes_all
                    ? "; circuits that lack one of the options given are skipped"
                    : "; may be left out if an option belongs to one circuit only");
}

size_t glint_circuit_options_add(glint_circuit_options *options, glint_option *rows)
{
    size_t count = 0;
    describe_circuits(options);
    rows[count++] = (glint_option){.name = "circuit",
                                   .placeholder = "CIRCUIT",
                                   .given = &options->is_named,
                                   .help = options->help,
                                   .kind = GLINT_OPTION_CHOICE,
                                   .choice = {&options->named, options->names}};
    rows[count++] = (glint_option){.name = "device",
                                   .placeholder = "NAME",
                                   .given = &options->is_device,
                                   .help = "another name of --circuit",
                                   .usually = "--circuit's",
                                   .kind = GLINT_OPTION_CHOICE,
                                   .choice = {&options->device, options->names}};
    for (int i = 0; i < options->parameter_count; i++) {
        glint_parameter_option *parameter = &options->parameter[i];
        rows[count++] =
            (glint_option){.name = parameter->name,
                           .placeholder = parameter->placeholder[0] != '\0' ? parameter->placeholder
                                          : options->use.takes_all          ? "N|all"
                                                                            : "N",
                           .help = parameter->help,
                           .usually = parameter->usual,
                           .kind = GLINT_OPTION_STRING,
                           .string = &parameter->text};
    }
    rows[count++] = (glint_option)GLINT_RTL_OPTION(&options->verilog);
    rows[count++] = (glint_option)GLINT_CIRCUIT_DIR_OPTION(&options->directory);
    return count;
}

/* ---- What was chosen ---------------------------------------------------------------------------
 */

/* Whether a circuit on request is meant: it is named, or an option is given that is not one of the
 * others. */
static bool is_requested(const glint_circuit_options *options, int number)
{
    const glint_circuit *circuit = options->circuit[number];
    if (options->is_named && options->named == number)
        return true;
    for (int i = 0; i < circuit->parameter_count; i++) {
        bool is_usual = false;
        for (int c = 0; c < options->circuit_count; c++)
            is_usual |= !options->circuit[c]->on_request &&
                        has_parameter(options->circuit[c], circuit->parameters[i].name);
        if (!is_usual && glint_circuit_options_given(options, circuit->parameters[i].name))
            return true;
    }
    return false;
}

/* "--gate, --lanes are for specular, --form for divider". */
static int refuse_together(const glint_circuit_options *options)
{
    char text[900] = "";
    for (int c = 0; c < options->circuit_count; c++) {
        const glint_circuit *circuit = options->circuit[c];
        if (circuit->parameter_count == 0 || (circuit->on_request && !is_requested(options, c)))
            continue;
        append_text(text, sizeof text, text[0] != '\0' ? ", " : "");
        for (int i = 0; i < circuit->parameter_count; i++) {
            append_text(text, sizeof text, i > 0 ? ", --" : "--");
            append_text(text, sizeof text, circuit->parameters[i].name);
        }
        const bool is_first = strstr(text, " for ") == NULL;
        append_text(text, sizeof text,
                    !is_first                       ? " for "
                    : circuit->parameter_count == 1 ? " is for "
                                                    : " are for ");
        append_text(text, sizeof text, circuit->name);
    }
    return glint_complain(options->use.command, GLINT_EXIT_TROUBLE, "%s", text);
}

static bool fits(const glint_circuit_options *options, const glint_circuit *circuit)
{
    for (int i = 0; i < options->parameter_count; i++)
        if (options->parameter[i].text != NULL &&
            !has_parameter(circuit, options->parameter[i].name))
            return false;
    return true;
}

static bool read_value(const glint_circuit_options *options, const glint_parameter *parameter,
                       const char *text, int *value)
{
    int64_t number;
    if (options->use.takes_all && strcmp(text, all) == 0) {
        *value = GLINT_EVERY_VALUE;
        return true;
    }
    for (int i = 0; parameter->choices != NULL && i <= parameter->max; i++)
        if (strcmp(text, parameter->choices[i]) == 0) {
            *value = i;
            return true;
        }
    if (parameter->choices != NULL ||
        !glint_parse_count(text, parameter->min, parameter->max, &number))
        return false;
    *value = (int)number;
    return true;
}

/* Whether the values given are all in range for the circuit, which has their options. */
static bool takes_values(const glint_circuit_options *options, const glint_circuit *circuit)
{
    bool takes = true;
    for (int i = 0; i < options->parameter_count; i++) {
        int index, value;
        const glint_parameter_option *row = &options->parameter[i];
        const glint_parameter *parameter = parameter_of(circuit, row->name, &index);
        takes &= row->text == NULL || read_value(options, parameter, row->text, &value);
    }
    return takes;
}

/* Of two circuits with options of the same name, a value may be in the range of one alone. */
static void leave_out_of_range(glint_circuit_options *options)
{
    int count = 0;
    for (int c = 0; c < options->chosen_count; c++)
        if (takes_values(options, options->chosen[c]))
            options->chosen[count++] = options->chosen[c];
    options->chosen_count = count;
}

static bool any_takes_values(const glint_circuit_options *options)
{
    bool any = false;
    for (int c = 0; c < options->chosen_count; c++)
        any |= takes_values(options, options->chosen[c]);
    return any;
}

static void choose_fitting(glint_circuit_options *options, bool on_request)
{
    for (int c = 0; c < options->circuit_count; c++)
        if (fits(options, options->circuit[c]) && (on_request || !options->circuit[c]->on_request))
            options->chosen[options->chosen_count++] = options->circuit[c];
}

/* By name, or those that have every option given: the usual one if it has; those on request if they
 * are named by "all", or no other has. */
static void choose_circuits(glint_circuit_options *options)
{
    const bool is_one = options->named < options->circuit_count;
    if (is_one && (options->is_named || fits(options, options->circuit[options->named]))) {
        options->chosen_count = fits(options, options->circuit[options->named]);
        options->chosen[0] = options->circuit[options->named];
        return;
    }
    choose_fitting(options, options->is_named);
    if (options->chosen_count == 0)
        choose_fitting(options, true);
    if (any_takes_values(options))
        leave_out_of_range(options);
}

static bool is_chosen(const glint_circuit_options *options, const glint_circuit *circuit)
{
    for (int c = 0; c < options->chosen_count; c++)
        if (options->chosen[c] == circuit)
            return true;
    return false;
}

const glint_circuit *glint_circuit_options_left(const glint_circuit_options *options, int index)
{
    for (int c = 0; !options->is_named && c < options->circuit_count; c++) {
        const glint_circuit *circuit = options->circuit[c];
        if (circuit->on_request && !is_chosen(options, circuit) && fits(options, circuit) &&
            takes_values(options, circuit) && index-- == 0)
            return circuit;
    }
    return NULL;
}

static int refuse_value(const glint_circuit_options *options, const glint_circuit *circuit,
                        const glint_parameter *parameter, const char *text)
{
    char expected[256] = "";
    const char *names[64] = {NULL};
    glint_quoted quoted;
    glint_suggestion suggestion = {""};
    append_values(parameter, ", ", expected, sizeof expected);
    if (options->use.takes_all)
        append_text(expected, sizeof expected, parameter->choices != NULL ? ", all" : " or all");
    for (int i = 0; parameter->choices != NULL && i <= parameter->max && i < 63; i++)
        names[i] = parameter->choices[i];
    if (parameter->choices != NULL)
        (void)glint_did_you_mean(text, names, "", &suggestion);
    return glint_complain(options->use.command, GLINT_EXIT_TROUBLE, "--%s: %s is not %s%s%s%s%s",
                          parameter->name, glint_quote(text, &quoted),
                          parameter->choices != NULL ? "one of " : "an integer from ", expected,
                          suggestion.text, options->chosen_count > 1 ? ", as it is to be for " : "",
                          options->chosen_count > 1 ? circuit->name : "");
}

/* The values of a chosen circuit's parameters. */
static int read_values(glint_circuit_options *options, int chosen)
{
    const glint_circuit *circuit = options->chosen[chosen];
    for (int i = 0; i < circuit->parameter_count; i++) {
        const glint_parameter *parameter = &circuit->parameters[i];
        const glint_parameter_option *row = row_of(options, parameter->name);
        const char *usual = usual_of(options, parameter->name);
        const char *text = row != NULL && row->text != NULL ? row->text : usual;
        int *value = &options->value[chosen][i];
        if (text == NULL)
            *value = parameter->standard;
        else if (!read_value(options, parameter, text, value)) {
            if (text != usual)
                return refuse_value(options, circuit, parameter, text);
            *value = parameter->standard; /* the usual one is of other circuits */
        }
    }
    return GLINT_OPTIONS_RUN;
}

static bool has_verilog(const char *directory, const char *top, const char *ending)
{
    char path[4096];
    const int length = snprintf(path, sizeof path, "%s/%s.%s", directory, top, ending);
    return length > 0 && (size_t)length < sizeof path && access(path, R_OK) == 0;
}

int glint_rtl_option_check(const char *command, const glint_setting *setting)
{
    struct stat found;
    const char *top = glint_setting_top(setting);
    if (setting->verilog == NULL)
        return GLINT_OPTIONS_RUN;
    if (stat(setting->verilog, &found) != 0)
        return glint_complain(command, GLINT_EXIT_TROUBLE, "--rtl: %s: %s", setting->verilog,
                              strerror(errno));
    if (!S_ISDIR(found.st_mode))
        return glint_complain(command, GLINT_EXIT_TROUBLE, "--rtl: %s is not a directory",
                              setting->verilog);
    if (!has_verilog(setting->verilog, top, "v") && !has_verilog(setting->verilog, top, "sv"))
        return glint_complain(command, GLINT_EXIT_TROUBLE,
                              "--rtl: %s has no %s.v, the top module of circuit %s",
                              setting->verilog, top, setting->circuit->name);
    return GLINT_OPTIONS_RUN;
}

int glint_rtl_option_settle(const char *command, const glint_setting *setting, bool is_used)
{
    if (setting->verilog != NULL && !is_used)
        return glint_complain(command, GLINT_EXIT_TROUBLE,
                              "--rtl names the Verilog's directory: use it with --backend rtl");
    return glint_rtl_option_check(command, setting);
}

static int check_verilog(const glint_circuit_options *options)
{
    glint_setting setting;
    int status = GLINT_OPTIONS_RUN;
    for (int i = 0; options->verilog != NULL && status == GLINT_OPTIONS_RUN &&
                    glint_circuit_options_setting(options, i, &setting);
         i++)
        status = glint_rtl_option_check(options->use.command, &setting);
    return status;
}

int glint_circuit_options_settle(glint_circuit_options *options)
{
    if (options->is_device && options->is_named)
        return glint_complain(options->use.command, GLINT_EXIT_TROUBLE,
                              "--device and --circuit name the same thing: give one of them");
    if (options->is_device)
        options->named = options->device;
    options->is_named |= options->is_device;
    choose_circuits(options);
    if (options->chosen_count == 0)
        return refuse_together(options);
    if (options->chosen_count > 1 && options->use.one_circuit)
        return glint_complain(options->use.command, GLINT_EXIT_TROUBLE,
                              "--circuit is required: both %s and %s have these options",
                              options->chosen[0]->name, options->chosen[1]->name);
    for (int c = 0; c < options->chosen_count; c++) {
        const int status = read_values(options, c);
        if (status != GLINT_OPTIONS_RUN)
            return status;
    }
    return check_verilog(options);
}

/* ---- Settings ----------------------------------------------------------------------------------
 */

static int values_of(const glint_parameter *parameter, int value)
{
    return value != GLINT_EVERY_VALUE  ? 1
           : parameter->listed != NULL ? parameter->listed_count
                                       : parameter->max - parameter->min + 1;
}

static int value_at(const glint_parameter *parameter, int value, int turn)
{
    return value != GLINT_EVERY_VALUE  ? value
           : parameter->listed != NULL ? parameter->listed[turn]
                                       : parameter->min + turn;
}

static const char *verilog_of(const glint_circuit_options *options)
{
    return options->verilog != NULL ? options->verilog : options->directory;
}

bool glint_circuit_options_setting(const glint_circuit_options *options, int index,
                                   glint_setting *setting)
{
    for (int c = 0; c < options->chosen_count; c++) {
        const glint_circuit *circuit = options->chosen[c];
        int64_t rest = index, settings = 1;
        *setting = (glint_setting){.circuit = circuit, .verilog = verilog_of(options)};
        for (int i = circuit->parameter_count - 1; i >= 0; i--) {
            const glint_parameter *parameter = &circuit->parameters[i];
            const int value = options->value[c][i];
            const int count = values_of(parameter, value);
            setting->values[i] = value_at(parameter, value, (int)(rest % count));
            rest /= count;
            settings *= settings <= INT_MAX ? count : 1; /* more than any index */
        }
        if (rest == 0)
            return true;
        index -= (int)settings; /* at most index */
    }
    return false;
}

glint_setting glint_circuit_options_first(const glint_circuit_options *options, int chosen)
{
    glint_setting setting = glint_setting_standard(options->chosen[chosen]);
    setting.verilog = verilog_of(options);
    for (int i = 0; i < setting.circuit->parameter_count; i++)
        if (options->value[chosen][i] != GLINT_EVERY_VALUE)
            setting.values[i] = options->value[chosen][i];
    return setting;
}

bool glint_circuit_options_given(const glint_circuit_options *options, const char *parameter)
{
    for (int i = 0; i < options->parameter_count; i++)
        if (strcmp(options->parameter[i].name, parameter) == 0)
            return options->parameter[i].text != NULL;
    return false;
}

static void append_option(const char *name, const char *directory, char *text, size_t size)
{
    if (directory == NULL)
        return;
    append_text(text, size, name);
    glint_shell_append(text, size, directory);
}

void glint_circuit_options_append(const glint_circuit_options *options, char *text, size_t size)
{
    append_option(" --circuit-dir ", options->directory, text, size);
    append_option(" --rtl ", options->verilog, text, size);
}
