#include "lockstep/divider_failure.h"

#include <inttypes.h>

#include "file/directory.h"
#include "lockstep/mismatch.h"
#include "wave/divider_wave.h"

static void print_pins(FILE *out, uint64_t clock, const glint_divider_inputs *in)
{
    fprintf(out, "  clock %" PRIu64 ": reset %d en %d start %d k %d difference %d,%d,%d\n", clock,
            in->reset, in->en, in->start, in->k, in->difference[0], in->difference[1],
            in->difference[2]);
}

void glint_divider_lockstep_report(FILE *out, const glint_divider_lockstep_options *options,
                                   const glint_divider_lockstep_result *result)
{
    const glint_lockstep_result *found = &result->found;
    fprintf(out, "divider %s, %d shifts: %" PRIu64 " mismatches of %" PRIu64 "\n",
            glint_divider_form_name(options->form), options->shifts, found->mismatches,
            found->comparisons);
    glint_mismatch_print(out, found, "stage");
    fprintf(out, "inputs that led to the first:\n");
    for (int i = 0; i < result->history_count; i++)
        print_pins(out, found->first_clock - (uint64_t)(result->history_count - 1 - i),
                   &result->history[i]);
    glint_mismatch_print_totals(out, found);
}

glint_status glint_divider_failure_wave(const glint_divider_lockstep_options *options,
                                        const glint_divider_lockstep_result *result,
                                        const char *directory, glint_failure_files *files,
                                        glint_error *err)
{
    char name[64];
    (void)snprintf(name, sizeof name, "divider_%s_%d", glint_divider_form_name(options->form),
                   options->shifts);
    if (!glint_failure_name(files, directory, name))
        return glint_fail(err, GLINT_IO_ERROR, "%s: the path is too long", directory);
    const glint_failure_window around =
        glint_failure_window_of(result->found.first_clock, files->waveform);
    glint_status status = glint_directory_make(directory, err);
    if (status == GLINT_OK)
        status =
            glint_divider_lockstep_trace(options, files->waveform, around.first, around.last, err);
    if (status == GLINT_OK)
        status = glint_failure_check_waveform(files->waveform, err);
    if (status == GLINT_OK)
        status = glint_divider_save_file(options->form, options->shifts, &around.window,
                                         files->save_file, err);
    return status;
}
