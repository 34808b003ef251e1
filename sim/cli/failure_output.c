#define _GNU_SOURCE /* program_invocation_name */

#include "cli/failure_output.h"

#include <errno.h>
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

#include "cli/output.h"
#include "failure/report.h"
#include "failure/shell.h"

static void print_report(const char *command, const glint_failure *failure, const char *directory,
                         FILE *out)
{
    glint_failure_finding finding;
    glint_capture *capture = NULL;
    glint_error err;
    if (glint_failure_playable(failure) &&
        glint_failure_play(failure, NULL, &finding, &capture, &err) != GLINT_OK)
        (void)glint_complain_error(command, &err);
    glint_failure_report(out, failure, capture, directory);
    free(capture);
}

bool glint_failure_output(const char *command, const glint_failure *failure,
                          const glint_packet_frames *frames, const char *directory,
                          glint_failure_detail detail, FILE *out)
{
    glint_error err;
    const bool written = glint_packet_write(failure, frames, directory, &err) == GLINT_OK;
    if (!written)
        (void)glint_complain_error(command, &err);
    if (detail == GLINT_FAILURE_REPORT)
        print_report(command, failure, written ? directory : NULL, out);
    if (written)
        fprintf(out, "packet: %s\n", directory);
    return written;
}

/* As argv[0] of the process: it is found again from the same directory, or on the path. */
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
