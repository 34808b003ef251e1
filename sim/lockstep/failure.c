#include "lockstep/failure.h"

#include <inttypes.h>

#include "file/directory.h"
#include "wave/save_file.h"
#include "wave/waveform.h"

#define CLOCKS_BEFORE 32
#define CLOCKS_AFTER  8

/* A value as a reader wants it: its bits, and the number they stand for. */
static void print_value(FILE *out, const glint_signal_info *signal, uint64_t bits)
{
    int width = signal->int_bits + signal->frac_bits;
    double value = (double)bits;
    if (signal->is_signed && (bits >> (width - 1) & 1) != 0)
        value -= (double)(UINT64_C(1) << width);
    value /= (double)(UINT64_C(1) << signal->frac_bits);
    fprintf(out, "0x%0*" PRIx64 " (%.9g)", (width + 3) / 4, bits, value);
}

static void print_mismatch(FILE *out, const glint_mismatch *mismatch)
{
    const glint_signal_info *signal = &mismatch->signal;
    fprintf(out, "  clock %" PRIu64 ": %s", mismatch->clock, signal->name);
    if (signal->lane >= 0)
        fprintf(out, ", lane %d", signal->lane);
    if (signal->block != 0)
        fprintf(out, ", block %d", signal->block);
    fprintf(out, ", %s: model ", signal->meaning);
    print_value(out, signal, mismatch->model);
    fprintf(out, ", rtl ");
    print_value(out, signal, mismatch->rtl);
    fprintf(out, "\n");
}

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
    for (int i = 0; i < result->kept; i++)
        print_mismatch(out, &result->mismatch[i]);
    fprintf(out,
            "inputs that led to the first (registers 2 to 5 held n = %u, %u, %u, %u before):\n",
            result->material.n, result->material.r, result->material.g, result->material.b);
    for (int i = 0; i < result->history_count; i++)
        print_pins(out, result->history_clock + (uint64_t)i, &result->history[i], config->lanes);
    fprintf(out, "totals:\n");
    for (int i = 0; i < result->totals_count; i++)
        fprintf(out, "  %-10s block %2d: %" PRIu64 "\n", result->totals[i].name,
                result->totals[i].block, result->totals[i].mismatches);
}

static int format_paths(const glint_lockstep_options *options, const char *directory,
                        glint_failure_files *files)
{
    char stem[GLINT_FAILURE_PATH];
    int length = snprintf(stem, sizeof stem, "%s/mismatch_%s_%s_%d", directory,
                          glint_gate_name(options->config.gate),
                          glint_pipeline_name(options->config.pipeline), options->config.lanes);
    if (length < 0 || (size_t)length >= sizeof stem - sizeof ".gtkw")
        return -1;
    (void)snprintf(files->waveform, sizeof files->waveform, "%.*s.fst", length, stem);
    (void)snprintf(files->save_file, sizeof files->save_file, "%.*s.gtkw", length, stem);
    return 0;
}

/* Writes the waveform and looks whether all of it arrived; a part of one is removed. */
static glint_status write_waveform(const glint_lockstep_options *options, const char *path,
                                   uint64_t first, uint64_t last, glint_error *err)
{
    glint_wave_info info;
    glint_status status = glint_lockstep_trace(options, path, first, last, err);
    if (status == GLINT_OK) {
        status = glint_wave_read_info(path, &info, err);
        if (status != GLINT_OK)
            (void)remove(path);
    }
    return status;
}

glint_status glint_lockstep_failure_wave(const glint_lockstep_options *options,
                                         const glint_lockstep_result *result, const char *directory,
                                         glint_failure_files *files, glint_error *err)
{
    uint64_t failing = result->first_clock;
    uint64_t first = failing > CLOCKS_BEFORE ? failing - CLOCKS_BEFORE : 1;
    uint64_t last = failing + CLOCKS_AFTER;
    /* The reset of creation is the circuit's clock 1, so lockstep's clocks come one later. */
    const glint_wave_view view = {
        .config = &options->config,
        .waveform = files->waveform,
        .first_time = first * GLINT_RTL_TRACE_PERIOD,
        .last_time = (last + 2) * GLINT_RTL_TRACE_PERIOD,
        .marker_time = (int64_t)((failing + 1) * GLINT_RTL_TRACE_PERIOD),
    };
    if (format_paths(options, directory, files) != 0)
        return glint_fail(err, GLINT_IO_ERROR, "%s: the path is too long", directory);
    glint_status status = glint_directory_make(directory, err);
    if (status == GLINT_OK)
        status = write_waveform(options, files->waveform, first, last, err);
    if (status == GLINT_OK)
        status = glint_wave_save_file(&view, files->save_file, err);
    return status;
}
