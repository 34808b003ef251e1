#include "lockstep/failure.h"

#include <inttypes.h>

#include "file/directory.h"
#include "lockstep/mismatch.h"
#include "wave/save_file.h"
#include "wave/waveform.h"

#define CLOCKS_BEFORE 32
#define CLOCKS_AFTER  8

static void print_pins(FILE *out, uint64_t clock, const glint_specular_inputs *in, int lanes)
{
    fprintf(out,
            "  clock %" PRIu64 ": reset %d en %d n_we %d n %u rgb_we %d rgb %u,%u,%u in_valid 0x%x "
            "cos",
            clock, in->reset, in->en, in->n_we, in->n, in->rgb_we, in->r, in->g, in->b,
            in->in_valid);
    for (int i = 0; i < lanes; i++)
        fprintf(out, " 0x%05" PRIx32, in->cos[i]);
    fprintf(out, "\n");
}

void glint_lockstep_report(FILE *out, const glint_lockstep_options *options,
                           const glint_lockstep_result *result)
{
    const glint_specular_config *config = &options->config;
    fprintf(out, "gate %s, pipeline %s, lanes %d: %" PRIu64 " mismatches of %" PRIu64 "\n",
            glint_gate_name(config->gate), glint_pipeline_name(config->pipeline), config->lanes,
            result->mismatches, result->comparisons);
    glint_mismatch_print(out, result, "lane");
    fprintf(out,
            "inputs that led to the first (registers 2 to 5 held n = %u, %u, %u, %u before):\n",
            result->material.n, result->material.r, result->material.g, result->material.b);
    for (int i = 0; i < result->history_count; i++)
        print_pins(out, result->history_clock + (uint64_t)i, &result->history[i], config->lanes);
    glint_mismatch_print_totals(out, result);
}

bool glint_failure_name(glint_failure_files *files, const char *directory, const char *name)
{
    int length =
        snprintf(files->save_file, sizeof files->save_file, "%s/mismatch_%s.gtkw", directory, name);
    (void)snprintf(files->waveform, sizeof files->waveform, "%s/mismatch_%s.fst", directory, name);
    return length >= 0 && (size_t)length < sizeof files->save_file;
}

glint_failure_window glint_failure_window_of(uint64_t failing, const char *waveform)
{
    const uint64_t first = failing > CLOCKS_BEFORE ? failing - CLOCKS_BEFORE : 1;
    const uint64_t last = failing + CLOCKS_AFTER;
    /* The reset of creation is the circuit's clock 1, so lockstep's clocks come one later. */
    return (glint_failure_window){
        .first = first,
        .last = last,
        .window = {.waveform = waveform,
                   .first_time = first * GLINT_RTL_TRACE_PERIOD,
                   .last_time = (last + 2) * GLINT_RTL_TRACE_PERIOD,
                   .marker_time = (int64_t)((failing + 1) * GLINT_RTL_TRACE_PERIOD)}};
}

glint_status glint_failure_check_waveform(const char *path, glint_error *err)
{
    glint_wave_info info;
    glint_status status = glint_wave_read_info(path, &info, err);
    if (status != GLINT_OK)
        (void)remove(path);
    return status;
}

glint_status glint_lockstep_failure_wave(const glint_lockstep_options *options,
                                         const glint_lockstep_result *result, const char *directory,
                                         glint_failure_files *files, glint_error *err)
{
    char name[64];
    (void)snprintf(name, sizeof name, "%s_%s_%d", glint_gate_name(options->config.gate),
                   glint_pipeline_name(options->config.pipeline), options->config.lanes);
    if (!glint_failure_name(files, directory, name))
        return glint_fail(err, GLINT_IO_ERROR, "%s: the path is too long", directory);
    const glint_failure_window around =
        glint_failure_window_of(result->first_clock, files->waveform);
    const glint_wave_view view = {.config = &options->config, .window = around.window};
    glint_status status = glint_directory_make(directory, err);
    if (status == GLINT_OK)
        status = glint_lockstep_trace(options, files->waveform, around.first, around.last, err);
    if (status == GLINT_OK)
        status = glint_failure_check_waveform(files->waveform, err);
    if (status == GLINT_OK)
        status = glint_wave_save_file(&view, files->save_file, err);
    return status;
}
