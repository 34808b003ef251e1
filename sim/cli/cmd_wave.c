/* `glint wave`: the demonstration scene as waveforms, ready for GTKWave. */
#include <stdio.h>

#include "cli/commands.h"
#include "cli/options.h"
#include "cli/output.h"
#include "cli/picture.h"
#include "failure/shell.h"
#include "file/directory.h"
#include "file/kind.h"
#include "rtl/rtl.h"
#include "wave/divider_wave.h"
#include "wave/save_file.h"
#include "wave/waveform.h"

#define PATH_SIZE   4096
#define QUOTED_SIZE (4 * PATH_SIZE)

enum { BOTH_PIPELINES = GLINT_PIPELINE_COUNT };
enum { SPECULAR, DIVIDER, ALL_CIRCUITS };

typedef struct wave_options {
    const char *out;
    int circuit, gate, pipeline, format;
    int64_t lanes, shifts, from, to;
    bool json, force;
    bool of_specular, of_divider; /* an option that only this circuit has was given */
} wave_options;

static const char *const circuit_choices[] = {"specular", "divider", "all", NULL};
static const char *const pipeline_choices[] = {"combinational", "pipelined", "both", NULL};
static const char *const format_choices[] = {"fst", "vcd", NULL};

static int parse(int argc, char **argv, wave_options *chosen)
{
    const glint_option options[] = {
        {.name = "out",
         .placeholder = "DIR",
         .help = "where the files go; made if missing",
         .kind = GLINT_OPTION_STRING,
         .string = &chosen->out},
        {.name = "circuit",
         .help = "which; an option that only one circuit has leaves the other out",
         .kind = GLINT_OPTION_CHOICE,
         .choice = {&chosen->circuit, circuit_choices}},
        {.name = "gate",
         .given = &chosen->of_specular,
         .help = "what bounds the highlight",
         .kind = GLINT_OPTION_CHOICE,
         .choice = {&chosen->gate, glint_gate_names}},
        {.name = "pipeline",
         .given = &chosen->of_specular,
         .help = "where the registers are",
         .kind = GLINT_OPTION_CHOICE,
         .choice = {&chosen->pipeline, pipeline_choices}},
        {.name = "lanes",
         .given = &chosen->of_specular,
         .help = "cosines a clock: 1, 2, 4, 8 or 16",
         .kind = GLINT_OPTION_INTEGER,
         .integer = {&chosen->lanes, 1, GLINT_LANES_MAX}},
        {.name = "shifts",
         .given = &chosen->of_divider,
         .help = "of the divider",
         .kind = GLINT_OPTION_INTEGER,
         .integer = {&chosen->shifts, GLINT_DIVIDER_SHIFTS_MIN, GLINT_DIVIDER_SHIFTS_MAX}},
        {.name = "format",
         .help = "of the waveform",
         .kind = GLINT_OPTION_CHOICE,
         .choice = {&chosen->format, format_choices}},
        {.name = "from",
         .given = &chosen->of_specular,
         .placeholder = "CLOCK",
         .help = "first clock of the specular device's window",
         .kind = GLINT_OPTION_INTEGER,
         .integer = {&chosen->from, 1, GLINT_WAVE_SCENE_CLOCKS}},
        {.name = "to",
         .given = &chosen->of_specular,
         .placeholder = "CLOCK",
         .help = "last clock of the specular device's window",
         .kind = GLINT_OPTION_INTEGER,
         .integer = {&chosen->to, 1, GLINT_WAVE_SCENE_CLOCKS}},
        GLINT_FORCE_OPTION(&chosen->force),
        {.name = "json",
         .help = "the files as JSON",
         .kind = GLINT_OPTION_FLAG,
         .flag = &chosen->json},
    };
    static const glint_example examples[] = {
        {"waveforms of everything, as FST", "glint wave --out wave"},
        {"16 lanes of the specular device, as VCD",
         "glint wave --lanes 16 --format vcd --out wave16"},
        {NULL, NULL},
    };
    const glint_command_line line = {
        .command = "wave",
        .summary = "Writes waveforms of a short scene on each circuit, with a GTKWave save file "
                   "each. Specular device: a scan line across a highlight with a stall in its "
                   "middle, then a new material with a point, a gap, a code above 1.0, and a new "
                   "material between points. Divider: five divisions, one stalled, one beyond "
                   "the table. docs/waveforms.md reads them clock by clock.",
        .examples = examples,
        .options = options,
        .option_count = sizeof options / sizeof options[0],
    };
    int status = glint_options_parse(&line, argc, argv);
    if (status != GLINT_OPTIONS_RUN)
        return status;
    if ((chosen->lanes & (chosen->lanes - 1)) != 0)
        return glint_complain("wave", GLINT_EXIT_TROUBLE, "--lanes: %d is not 1, 2, 4, 8 or 16",
                              (int)chosen->lanes);
    if (chosen->from > chosen->to)
        return glint_complain("wave", GLINT_EXIT_TROUBLE, "--from %d is after --to %d",
                              (int)chosen->from, (int)chosen->to);
    return GLINT_OPTIONS_RUN;
}

/* An option that only one circuit has leaves the other one out, and makes no sense for it. */
static int narrow_circuit(wave_options *chosen)
{
    if ((chosen->of_specular && (chosen->of_divider || chosen->circuit == DIVIDER)) ||
        (chosen->of_divider && chosen->circuit == SPECULAR))
        return glint_complain("wave", GLINT_EXIT_TROUBLE,
                              "--gate, --pipeline, --lanes, --from, --to are for the specular "
                              "device, --shifts for the divider");
    if (chosen->circuit == ALL_CIRCUITS && chosen->of_specular)
        chosen->circuit = SPECULAR;
    if (chosen->circuit == ALL_CIRCUITS && chosen->of_divider)
        chosen->circuit = DIVIDER;
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
static void announce(const wave_files *files, cJSON *list)
{
    if (list == NULL) {
        char waveform[QUOTED_SIZE] = "", save_file[QUOTED_SIZE] = "";
        glint_shell_append(waveform, sizeof waveform, files->waveform);
        glint_shell_append(save_file, sizeof save_file, files->save_file);
        printf("gtkwave %s %s\n", waveform, save_file);
        return;
    }
    cJSON *entry = cJSON_CreateObject();
    cJSON_AddStringToObject(entry, "waveform", files->waveform);
    cJSON_AddStringToObject(entry, "save_file", files->save_file);
    cJSON_AddItemToArray(list, entry);
}

static int write_specular(const wave_options *chosen, glint_pipeline pipeline, cJSON *list)
{
    const glint_specular_config config = {(glint_gate)chosen->gate, pipeline, (int)chosen->lanes};
    char name[64];
    wave_files files;
    glint_error err;
    (void)snprintf(name, sizeof name, "specular_%s_%s", glint_gate_name(config.gate),
                   glint_pipeline_name(pipeline));
    if (name_files(chosen, name, &files) != GLINT_EXIT_OK)
        return GLINT_EXIT_TROUBLE;
    glint_status status =
        glint_wave_record(&config, (glint_wave_format)chosen->format, (int)chosen->from,
                          (int)chosen->to, files.waveform, &err);
    const glint_wave_view view = {.config = &config,
                                  .window =
                                      window_of(files.waveform, (int)chosen->from, (int)chosen->to,
                                                glint_wave_scene_centre(config.lanes))};
    if (status == GLINT_OK)
        status = glint_wave_save_file(&view, files.save_file, &err);
    if (status != GLINT_OK)
        return glint_complain_error("wave", &err);
    announce(&files, list);
    return GLINT_EXIT_OK;
}

static int write_divider(const wave_options *chosen, glint_divider_form form, cJSON *list)
{
    const int shifts = (int)chosen->shifts;
    char name[64];
    wave_files files;
    glint_error err;
    (void)snprintf(name, sizeof name, "divider_%s_%d", glint_divider_form_name(form), shifts);
    if (name_files(chosen, name, &files) != GLINT_EXIT_OK)
        return GLINT_EXIT_TROUBLE;
    const glint_gtkw_window window =
        window_of(files.waveform, 1, glint_divider_scene_clocks(form, shifts),
                  glint_divider_scene_first_result(form, shifts) - 1);
    glint_status status = glint_divider_wave_record(form, shifts, (glint_wave_format)chosen->format,
                                                    files.waveform, &err);
    if (status == GLINT_OK)
        status = glint_divider_save_file(form, shifts, &window, files.save_file, &err);
    if (status != GLINT_OK)
        return glint_complain_error("wave", &err);
    announce(&files, list);
    return GLINT_EXIT_OK;
}

static int write_all(const wave_options *chosen, cJSON *list)
{
    int status = GLINT_EXIT_OK;
    for (int p = GLINT_PIPELINE_COUNT - 1; p >= 0 && chosen->circuit != DIVIDER; p--)
        if (status == GLINT_EXIT_OK &&
            (chosen->pipeline == BOTH_PIPELINES || chosen->pipeline == p))
            status = write_specular(chosen, (glint_pipeline)p, list);
    for (int f = 0; f < GLINT_DIVIDER_FORM_COUNT && chosen->circuit != SPECULAR; f++)
        if (status == GLINT_EXIT_OK)
            status = write_divider(chosen, (glint_divider_form)f, list);
    return status;
}

int glint_cmd_wave(int argc, char **argv)
{
    wave_options chosen = {.out = "wave",
                           .circuit = ALL_CIRCUITS,
                           .shifts = GLINT_DIVIDER_SHIFTS_DEFAULT,
                           .gate = GLINT_GATE_COSINE,
                           .pipeline = BOTH_PIPELINES,
                           .format = GLINT_WAVE_FST,
                           .lanes = 1,
                           .from = 1,
                           .to = GLINT_WAVE_SCENE_CLOCKS};
    int status = parse(argc, argv, &chosen);
    if (status != GLINT_OPTIONS_RUN)
        return status;
    status = narrow_circuit(&chosen);
    if (status != GLINT_OPTIONS_RUN)
        return status;
    glint_error err;
    if (glint_directory_make(chosen.out, &err) != GLINT_OK)
        return glint_complain_error("wave", &err);
    cJSON *json = chosen.json ? cJSON_CreateObject() : NULL;
    cJSON *files = cJSON_AddArrayToObject(json, "files");
    status = write_all(&chosen, files);
    if (!chosen.json)
        return glint_output_finish("wave", status);
    if (!glint_output_json(json))
        status = glint_complain("wave", GLINT_EXIT_TROUBLE, "out of memory");
    return glint_output_finish("wave", status);
}
