/* `glint wave`: the demonstration scene as waveforms, ready for GTKWave. */
#include <stdio.h>

#include "cli/commands.h"
#include "cli/options.h"
#include "cli/output.h"
#include "file/directory.h"
#include "rtl/rtl.h"
#include "wave/save_file.h"
#include "wave/waveform.h"

enum { BOTH_PIPELINES = GLINT_PIPELINE_COUNT };

typedef struct wave_options {
    const char *out;
    int gate, pipeline, format;
    int64_t lanes, from, to;
    bool json;
} wave_options;

static const char *const pipeline_choices[] = {"drawn", "pipelined", "both", NULL};
static const char *const format_choices[] = {"fst", "vcd", NULL};

static int parse(int argc, char **argv, wave_options *chosen)
{
    const glint_option options[] = {
        {.name = "out",
         .placeholder = "DIR",
         .help = "where the files go; made if missing",
         .kind = GLINT_OPTION_STRING,
         .string = &chosen->out},
        {.name = "gate",
         .help = "what bounds the highlight",
         .kind = GLINT_OPTION_CHOICE,
         .choice = {&chosen->gate, glint_gate_names}},
        {.name = "pipeline",
         .help = "where the registers are",
         .kind = GLINT_OPTION_CHOICE,
         .choice = {&chosen->pipeline, pipeline_choices}},
        {.name = "lanes",
         .help = "cosines a clock: 1, 2, 4, 8 or 16",
         .kind = GLINT_OPTION_INTEGER,
         .integer = {&chosen->lanes, 1, GLINT_LANES_MAX}},
        {.name = "format",
         .help = "of the waveform",
         .kind = GLINT_OPTION_CHOICE,
         .choice = {&chosen->format, format_choices}},
        {.name = "from",
         .placeholder = "CLOCK",
         .help = "first clock of the window",
         .kind = GLINT_OPTION_INTEGER,
         .integer = {&chosen->from, 1, GLINT_WAVE_SCENE_CLOCKS}},
        {.name = "to",
         .placeholder = "CLOCK",
         .help = "last clock of the window",
         .kind = GLINT_OPTION_INTEGER,
         .integer = {&chosen->to, 1, GLINT_WAVE_SCENE_CLOCKS}},
        {.name = "json",
         .help = "the files as JSON",
         .kind = GLINT_OPTION_FLAG,
         .flag = &chosen->json},
    };
    const glint_command_line line = {
        .command = "wave",
        .summary = "Writes waveforms of a short scene on the circuit, each with a GTKWave save "
                   "file: a scan line across a highlight with a stall in its middle, then a new "
                   "material with a point, a gap, a code above 1.0, and a new material between "
                   "points. docs/waveforms.md reads it clock by clock.",
        .options = options,
        .option_count = sizeof options / sizeof options[0],
    };
    int status = glint_options_parse(&line, argc, argv);
    if (status != GLINT_OPTIONS_RUN)
        return status;
    if ((chosen->lanes & (chosen->lanes - 1)) != 0)
        return glint_complain("wave", GLINT_EXIT_USAGE, "--lanes: %d is not 1, 2, 4, 8 or 16",
                              (int)chosen->lanes);
    if (chosen->from > chosen->to)
        return glint_complain("wave", GLINT_EXIT_USAGE, "--from %d is after --to %d",
                              (int)chosen->from, (int)chosen->to);
    return GLINT_OPTIONS_RUN;
}

static glint_status write_view(const wave_options *chosen, const glint_specular_config *config,
                               const char *waveform, const char *save_file, glint_error *err)
{
    const uint64_t period = GLINT_RTL_TRACE_PERIOD;
    /* The reset of creation is clock 1 of the circuit, so the scene's clocks come one later. */
    const glint_wave_view view = {
        .config = config,
        .waveform = waveform,
        .first_time = (uint64_t)chosen->from * period,
        .last_time = ((uint64_t)chosen->to + 2) * period,
        .marker_time = (int64_t)((uint64_t)(glint_wave_scene_centre(config->lanes) + 1) * period),
    };
    return glint_wave_save_file(&view, save_file, err);
}

static int write_one(const wave_options *chosen, glint_pipeline pipeline, cJSON *files)
{
    const glint_specular_config config = {(glint_gate)chosen->gate, pipeline, (int)chosen->lanes};
    char waveform[4096], save_file[4096];
    glint_error err;
    int length = snprintf(waveform, sizeof waveform, "%s/specular_%s_%s.%s", chosen->out,
                          glint_gate_name(config.gate), glint_pipeline_name(pipeline),
                          format_choices[chosen->format]);
    int length2 = snprintf(save_file, sizeof save_file, "%s/specular_%s_%s.gtkw", chosen->out,
                           glint_gate_name(config.gate), glint_pipeline_name(pipeline));
    if (length < 0 || length2 < 0 || (size_t)length >= sizeof waveform ||
        (size_t)length2 >= sizeof save_file)
        return glint_complain("wave", GLINT_EXIT_FAILURE, "--out: the path is too long");
    glint_status status = glint_wave_record(&config, (glint_wave_format)chosen->format,
                                            (int)chosen->from, (int)chosen->to, waveform, &err);
    if (status == GLINT_OK)
        status = write_view(chosen, &config, waveform, save_file, &err);
    if (status != GLINT_OK)
        return glint_complain_error("wave", &err);
    if (files != NULL) {
        cJSON *entry = cJSON_CreateObject();
        cJSON_AddStringToObject(entry, "waveform", waveform);
        cJSON_AddStringToObject(entry, "save_file", save_file);
        cJSON_AddItemToArray(files, entry);
    } else {
        printf("gtkwave %s %s\n", waveform, save_file);
    }
    return GLINT_EXIT_OK;
}

static int write_all(const wave_options *chosen, cJSON *files)
{
    for (int p = GLINT_PIPELINE_COUNT - 1; p >= 0; p--) {
        if (chosen->pipeline != BOTH_PIPELINES && chosen->pipeline != p)
            continue;
        int status = write_one(chosen, (glint_pipeline)p, files);
        if (status != GLINT_EXIT_OK)
            return status;
    }
    return GLINT_EXIT_OK;
}

int glint_cmd_wave(int argc, char **argv)
{
    wave_options chosen = {.out = "wave",
                           .gate = GLINT_GATE_COSINE,
                           .pipeline = BOTH_PIPELINES,
                           .format = GLINT_WAVE_FST,
                           .lanes = 1,
                           .from = 1,
                           .to = GLINT_WAVE_SCENE_CLOCKS};
    int status = parse(argc, argv, &chosen);
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
        status = glint_complain("wave", GLINT_EXIT_FAILURE, "out of memory");
    return glint_output_finish("wave", status);
}
