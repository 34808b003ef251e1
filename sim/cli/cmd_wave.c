/* `glint wave`: a short scene on each circuit as waveforms, ready for GTKWave. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "circuit/circuits.h"
#include "cli/build_first.h"
#include "cli/circuit_options.h"
#include "cli/commands.h"
#include "cli/options.h"
#include "cli/output.h"
#include "cli/picture.h"
#include "failure/shell.h"
#include "file/directory.h"
#include "file/kind.h"
#include "rtl/rtl.h"
#include "wave/save_file.h"
#include "wave/waveform.h"

#define PATH_SIZE    4096
#define QUOTED_SIZE  (4 * PATH_SIZE)
#define CLOCKS_MAX   65536 /* of any scene */
#define SETTINGS_MAX 1024

typedef struct wave_options {
    glint_circuit_options circuits;
    const char *out;
    int format;
    int64_t from, to;
    bool json, force, from_given, to_given;
} wave_options;

static const char *const format_choices[] = {"fst", "vcd", NULL};

/* Both pipelines and both forms side by side; else one setting of each circuit. */
static const char *usual(const char *parameter)
{
    return strcmp(parameter, "pipeline") == 0 || strcmp(parameter, "form") == 0 ? "all" : NULL;
}

#define OWN_ROWS 6

static int parse(int argc, char **argv, wave_options *chosen)
{
    const glint_circuit_use use = {
        .command = "wave", .circuit = "all", .takes_all = true, .usual = usual};
    int status = glint_circuit_options_begin(&chosen->circuits, &use, argc, argv);
    if (status != GLINT_OPTIONS_RUN)
        return status;
    glint_option options[OWN_ROWS + GLINT_CIRCUIT_OPTIONS] = {
        {.name = "out",
         .placeholder = "DIR",
         .help = "directory for the files; created if missing",
         .kind = GLINT_OPTION_STRING,
         .string = &chosen->out},
        {.name = "format",
         .help = "file format of the waveform",
         .kind = GLINT_OPTION_CHOICE,
         .choice = {&chosen->format, format_choices}},
        {.name = "from",
         .given = &chosen->from_given,
         .placeholder = "CLOCK",
         .help = "first clock of the scene to show, for one circuit (default specular)",
         .kind = GLINT_OPTION_INTEGER,
         .integer = {&chosen->from, 1, CLOCKS_MAX}},
        {.name = "to",
         .given = &chosen->to_given,
         .usually = "the end of the scene",
         .placeholder = "CLOCK",
         .help = "last clock to show",
         .kind = GLINT_OPTION_INTEGER,
         .integer = {&chosen->to, 1, CLOCKS_MAX}},
        GLINT_FORCE_OPTION(&chosen->force),
        {.name = "json",
         .help = "print the file names as JSON",
         .kind = GLINT_OPTION_FLAG,
         .flag = &chosen->json},
    };
    const size_t count =
        OWN_ROWS + glint_circuit_options_add(&chosen->circuits, options + OWN_ROWS);
    static const glint_example examples[] = {
        {"every waveform, as FST", "glint wave --out wave"},
        {"16 lanes of the specular device, as VCD",
         "glint wave --lanes 16 --format vcd --out wave16"},
        {NULL, NULL},
    };
    static const glint_example own[] = {
        {"a waveform, as FST", "glint --circuit-dir DIR wave --out wave"},
        {"its first 20 clocks, as VCD",
         "glint --circuit-dir DIR wave --to 20 --format vcd --out wave20"},
        {NULL, NULL},
    };
    const glint_command_line line = {
        .command = "wave",
        .summary = "Writes a waveform of a short scene for each circuit, with a GTKWave save file. "
                   "Specular device: a scan line across a highlight with a stall in the middle, "
                   "then a material change along with a point, a gap, a code above 1.0, and a "
                   "material change between points. Divider: five divisions, one of them stalled, "
                   "one outside the table. Any other circuit: random pins, with a stall and a gap. "
                   "docs/waveforms.md goes through them clock by clock.",
        .examples = chosen->circuits.is_own ? own : examples,
        .options = options,
        .option_count = count,
    };
    return glint_options_parse(&line, argc, argv);
}

/* The given clocks belong to a single scene, the first circuit's. */
static int settle(wave_options *chosen)
{
    const int status = glint_circuit_options_settle(&chosen->circuits);
    if (status != GLINT_OPTIONS_RUN || !(chosen->from_given || chosen->to_given))
        return status;
    chosen->circuits.chosen_count = 1;
    const glint_setting first = glint_circuit_options_first(&chosen->circuits, 0);
    const int clocks = glint_wave_scene_clocks(&first);
    if (chosen->from > clocks || (chosen->to_given && chosen->to > clocks))
        return glint_complain("wave", GLINT_EXIT_TROUBLE,
                              "--%s: the scene of %s runs from clock 1 to %d",
                              chosen->from > clocks ? "from" : "to", first.circuit->name, clocks);
    if (chosen->from > chosen->to)
        return glint_complain("wave", GLINT_EXIT_TROUBLE, "--from %d is after --to %d",
                              (int)chosen->from, (int)chosen->to);
    return GLINT_OPTIONS_RUN;
}

/* The waveform of the scene's clocks from…to: the reset of creation is clock 1 of the circuit, so
 * the scene's clocks come one later, and a waveform begins and ends with a falling edge. */
static glint_gtkw_window window_of(const char *waveform, int from, int to, int marker)
{
    const uint64_t period = GLINT_RTL_TRACE_PERIOD;
    const int shown = marker < from ? from : marker > to ? to : marker;
    return (glint_gtkw_window){.waveform = waveform,
                               .first_time = (uint64_t)(from + 1) * period - period / 2,
                               .last_time = (uint64_t)(to + 1) * period + period / 2,
                               .marker_time = (int64_t)((uint64_t)(shown + 1) * period)};
}

/* DIR/NAME.ENDING; false when it is too long. */
static bool name_file(char path[PATH_SIZE], const char *directory, const char *name,
                      const char *ending)
{
    int length = snprintf(path, PATH_SIZE, "%s/%s.%s", directory, name, ending);
    return length >= 0 && length < PATH_SIZE;
}

/* A waveform and its save file, by their names. */
typedef struct wave_files {
    char waveform[PATH_SIZE], save_file[PATH_SIZE];
} wave_files;

static int name_files(const wave_options *chosen, const char *name, wave_files *files)
{
    if (!name_file(files->waveform, chosen->out, name, format_choices[chosen->format]) ||
        !name_file(files->save_file, chosen->out, name, "gtkw"))
        return glint_complain("wave", GLINT_EXIT_TROUBLE, "--out: the path is too long");
    glint_error err;
    if (!chosen->force && (glint_file_replaceable(files->waveform, &err) != GLINT_OK ||
                           glint_file_replaceable(files->save_file, &err) != GLINT_OK))
        return glint_complain_error("wave", &err);
    return GLINT_EXIT_OK;
}

/* Says what was written: the command that opens it, or an entry of the JSON list. */
static void announce(const wave_files *files, json_t *list)
{
    if (list == NULL) {
        char waveform[QUOTED_SIZE] = "", save_file[QUOTED_SIZE] = "";
        glint_shell_append(waveform, sizeof waveform, files->waveform);
        glint_shell_append(save_file, sizeof save_file, files->save_file);
        printf("gtkwave %s %s\n", waveform, save_file);
        return;
    }
    json_t *entry = json_object();
    glint_json_add_text(entry, "waveform", files->waveform);
    glint_json_add_text(entry, "save_file", files->save_file);
    json_array_append_new(list, entry);
}

/* Of the specular device without the lanes, unless waveforms of several counts are made. */
static void name_setting(const wave_options *chosen, const glint_setting *setting,
                         char name[GLINT_SETTING_TEXT])
{
    glint_setting_name(setting, name);
    char *last = strrchr(name, '_');
    if (setting->circuit == &glint_circuit_specular && last != NULL &&
        chosen->circuits.value[0][GLINT_SPECULAR_LANES] != GLINT_EVERY_VALUE)
        *last = '\0';
}

static glint_status record(const wave_options *chosen, const glint_setting *setting,
                           const wave_files *files, glint_error *err)
{
    glint_wave_scene scene;
    glint_status status = glint_wave_scene_make(setting, &scene, err);
    if (status != GLINT_OK)
        return status;
    const int from = (int)chosen->from;
    const int to = chosen->to < scene.clocks ? (int)chosen->to : scene.clocks;
    const glint_gtkw_window window = window_of(files->waveform, from, to, scene.marker);
    status = from > to ? glint_fail(err, GLINT_BAD_ARGUMENT, "--from: the scene has only %d clocks",
                                    scene.clocks)
                       : glint_wave_record(setting, &scene, (glint_wave_format)chosen->format, from,
                                           to, files->waveform, err);
    if (status == GLINT_OK)
        status = glint_wave_save_file(setting, &window, files->save_file, err);
    free(scene.pins);
    return status;
}

static int write_setting(const wave_options *chosen, const glint_setting *setting, json_t *list)
{
    char name[GLINT_SETTING_TEXT];
    wave_files files;
    glint_error err;
    name_setting(chosen, setting, name);
    if (name_files(chosen, name, &files) != GLINT_EXIT_OK)
        return GLINT_EXIT_TROUBLE;
    if (record(chosen, setting, &files, &err) != GLINT_OK)
        return glint_complain_error("wave", &err);
    announce(&files, list);
    return GLINT_EXIT_OK;
}

static bool is_first(const wave_options *chosen, const glint_setting *setting)
{
    for (int c = 0; c < chosen->circuits.chosen_count; c++) {
        const glint_setting first = glint_circuit_options_first(&chosen->circuits, c);
        if (glint_setting_equal(&first, setting))
            return true;
    }
    return false;
}

/* Circuit by circuit, of each the standard setting before the others. */
static int write_circuit(const wave_options *chosen, int circuit, json_t *list)
{
    const glint_setting first = glint_circuit_options_first(&chosen->circuits, circuit);
    glint_setting setting;
    int status = write_setting(chosen, &first, list);
    for (int i = 0;
         status == GLINT_EXIT_OK && glint_circuit_options_setting(&chosen->circuits, i, &setting);
         i++)
        if (setting.circuit == first.circuit && !is_first(chosen, &setting))
            status = write_setting(chosen, &setting, list);
    return status;
}

/* Builds everything missing at once; when out of memory, each in its turn. */
static int build_all(const wave_options *chosen)
{
    int count = 0;
    glint_setting *settings = calloc(SETTINGS_MAX, sizeof *settings);
    while (settings != NULL && count < SETTINGS_MAX &&
           glint_circuit_options_setting(&chosen->circuits, count, &settings[count]))
        count++;
    glint_error err;
    const glint_status status = glint_build_first(
        "wave", settings, count, chosen->format == GLINT_WAVE_VCD ? GLINT_RTL_VCD : GLINT_RTL_FST,
        0, &err);
    free(settings);
    return status == GLINT_OK ? GLINT_EXIT_OK : glint_complain_error("wave", &err);
}

static int write_all(const wave_options *chosen, json_t *list)
{
    int status = build_all(chosen);
    for (int c = 0; c < chosen->circuits.chosen_count && status == GLINT_EXIT_OK; c++)
        status = write_circuit(chosen, c, list);
    return status;
}

int glint_cmd_wave(int argc, char **argv)
{
    wave_options chosen = {.out = "wave", .format = GLINT_WAVE_FST, .from = 1, .to = CLOCKS_MAX};
    glint_setting last;
    int status = parse(argc, argv, &chosen);
    if (status == GLINT_OPTIONS_RUN)
        status = settle(&chosen);
    if (status != GLINT_OPTIONS_RUN)
        return status;
    if (glint_circuit_options_setting(&chosen.circuits, SETTINGS_MAX, &last))
        return glint_complain("wave", GLINT_EXIT_TROUBLE,
                              "more than %d settings: narrow them down with --%s and so on",
                              SETTINGS_MAX, last.circuit->parameters[0].name);
    glint_error err;
    if (glint_directory_make(chosen.out, &err) != GLINT_OK)
        return glint_complain_error("wave", &err);
    json_t *json = chosen.json ? json_object() : NULL;
    json_t *files = glint_json_add(json, "files", json_array());
    status = write_all(&chosen, files);
    if (!chosen.json)
        return glint_output_finish("wave", status);
    if (!glint_output_json(json))
        status = glint_complain("wave", GLINT_EXIT_TROUBLE, "out of memory");
    return glint_output_finish("wave", status);
}
