/* `glint draw`: the drawing of a circuit in one setting, from its description. */
#include <stdio.h>
#include <string.h>

#include "cli/circuit_options.h"
#include "cli/commands.h"
#include "cli/options.h"
#include "cli/output.h"
#include "cli/picture.h"
#include "draw/draw.h"
#include "file/kind.h"
#include "file/new_file.h"

typedef struct draw_options {
    glint_circuit_options circuits;
    const char *out;
    bool force;
} draw_options;

static const char *usual(const char *parameter)
{
    (void)parameter;
    return NULL;
}

#define OWN_ROWS 2

static int parse(int argc, char **argv, draw_options *chosen)
{
    const glint_circuit_use use = {
        .command = "draw", .circuit = "specular", .one_circuit = true, .usual = usual};
    const int begun = glint_circuit_options_begin(&chosen->circuits, &use, argc, argv);
    if (begun != GLINT_OPTIONS_RUN)
        return begun;
    glint_option options[OWN_ROWS + GLINT_CIRCUIT_OPTIONS] = {
        {.name = "out",
         .placeholder = "FILE",
         .required = true,
         .help = "output file: a name ending in .svg, or in .dot for the input to Graphviz",
         .kind = GLINT_OPTION_STRING,
         .string = &chosen->out},
        GLINT_FORCE_OPTION(&chosen->force),
    };
    const size_t count =
        OWN_ROWS + glint_circuit_options_add(&chosen->circuits, options + OWN_ROWS);
    static const glint_example examples[] = {
        {"the specular-colour device", "glint draw --out device.svg"},
        {"the divider as drawn in the thesis",
         "glint draw --circuit divider --form sequential --out divider.svg"},
        {NULL, NULL},
    };
    static const glint_example own[] = {
        {"its standard setting", "glint --circuit-dir DIR draw --out circuit.svg"},
        {NULL, NULL},
    };
    const glint_command_line line = {
        .command = "draw",
        .summary = "Draws the block diagram of a circuit from its description: blocks with the "
                   "numbers of the thesis's figure, number formats on the wires, and the clock "
                   "edges at which registers load. Needs Graphviz for the layout.",
        .examples = chosen->circuits.is_own ? own : examples,
        .options = options,
        .option_count = count,
    };
    const int status = glint_options_parse(&line, argc, argv);
    return status == GLINT_OPTIONS_RUN ? glint_circuit_options_settle(&chosen->circuits) : status;
}

static bool ends_with(const char *text, const char *end)
{
    const size_t length = strlen(text), end_length = strlen(end);
    return length > end_length && strcmp(text + length - end_length, end) == 0;
}

static glint_status draw(const glint_setting *setting, const char *path, glint_error *err)
{
    glint_new_file *file;
    glint_status status = glint_new_file_open(path, &file, err);
    if (status != GLINT_OK)
        return status;
    status = (ends_with(path, ".svg") ? glint_draw_svg
                                      : glint_draw_plan)(setting, glint_new_file_stream(file), err);
    if (status == GLINT_OK)
        return glint_new_file_commit(file, err);
    glint_new_file_discard(file);
    return status;
}

int glint_cmd_draw(int argc, char **argv)
{
    draw_options chosen = {.out = NULL};
    glint_error err;
    int status = parse(argc, argv, &chosen);
    if (status != GLINT_OPTIONS_RUN)
        return status;
    if (!ends_with(chosen.out, ".svg") && !ends_with(chosen.out, ".dot"))
        return glint_complain("draw", GLINT_EXIT_TROUBLE,
                              "--out: the name must end in .svg or .dot");
    const glint_setting setting = glint_circuit_options_first(&chosen.circuits, 0);
    if (!chosen.force && glint_file_replaceable(chosen.out, &err) != GLINT_OK)
        return glint_complain_error("draw", &err);
    if (draw(&setting, chosen.out, &err) != GLINT_OK)
        return glint_complain_error("draw", &err);
    char text[GLINT_SETTING_TEXT];
    glint_setting_describe(&setting, text);
    printf("%s: %s, %s\n", chosen.out, setting.circuit->title, text);
    return glint_output_finish("draw", GLINT_EXIT_OK);
}
