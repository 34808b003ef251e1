/* Writes the failure packet and prints its report, for every subcommand that can find a mismatch.
 * */
#define _GNU_SOURCE /* program_invocation_name */

#include "cli/failure_output.h"

#include <errno.h>
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

#include "cli/output.h"
#include "failure/report.h"
#include "failure/shell.h"

static void show(void *context, uint64_t done, uint64_t total)
{
    glint_progress_update(context, done, total);
}

glint_status glint_failure_find(const char *command, const glint_lockstep_options *options,
                                const glint_lockstep_result *result, glint_failure **failure,
                                glint_error *err)
{
    glint_progress progress;
    glint_lockstep_options again = *options;
    again.stop = glint_stop_flag();
    again.progress = show;
    again.progress_context = &progress;
    glint_progress_begin(&progress, command, "clocks replayed");
    const glint_status status = glint_failure_of_lockstep(&again, result, failure, err);
    glint_progress_end(&progress);
    return status;
}

/* What is to be had without a capture does not make a packet. */
static bool write_packet(const char *command, const glint_failure *failure,
                         const glint_packet_frames *frames, const char *directory)
{
    glint_error err;
    if (failure->interrupted) {
        (void)glint_complain(command, GLINT_EXIT_TROUBLE, "interrupted: %s was not written",
                             directory);
        return false;
    }
    if (glint_packet_write(failure, frames, directory, &err) == GLINT_OK)
        return true;
    (void)glint_complain_error(command, &err);
    return false;
}

bool glint_failure_output(const char *command, const glint_failure *failure,
                          const glint_packet_frames *frames, const char *directory,
                          glint_failure_detail detail, FILE *out)
{
    const bool written = write_packet(command, failure, frames, directory);
    if (detail == GLINT_FAILURE_REPORT)
        glint_failure_report(out, failure, failure->capture, written ? directory : NULL);
    if (written)
        fprintf(out, "packet: %s\n", directory);
    else if (detail == GLINT_FAILURE_BRIEFLY) /* it ends a line */
        fprintf(out, "no packet\n");
    return written;
}

void glint_failure_name_circuit(glint_failure *failure, const char *directory)
{
    (void)snprintf(failure->circuit_dir, sizeof failure->circuit_dir, "%s",
                   directory != NULL ? directory : "");
}

/* argv[0] of the process, which works from the same directory or through the PATH. */
const char *glint_failure_program(void)
{
    return program_invocation_name;
}

void glint_failure_command(int argc, char *const *argv, char *text, size_t size)
{
    text[0] = '\0';
    glint_shell_append(text, size, glint_failure_program());
    for (int i = 0; i < argc; i++) {
        const size_t used = strlen(text);
        (void)snprintf(text + used, size - used, " ");
        glint_shell_append(text, size, argv[i]);
    }
}
