#include "cli/failure_output.h"

#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

#include "cli/output.h"
#include "failure/report.h"

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

void glint_failure_output(const char *command, const glint_failure *failure,
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
}

/* Whether a shell takes the word as it is. */
static bool is_plain(const char *word)
{
    static const char plain[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789"
                                "_-+./,:=%@";
    return word[0] != '\0' && strspn(word, plain) == strlen(word);
}

/* Appends what fits. */
static void append(char *text, size_t size, const char *part)
{
    const size_t used = strlen(text);
    (void)snprintf(text + used, size - used, "%s", part);
}

static void append_quoted(char *text, size_t size, const char *word)
{
    append(text, size, "'");
    for (; *word != '\0'; word++) {
        const char letter[] = {*word, '\0'};
        append(text, size, *word == '\'' ? "'\\''" : letter);
    }
    append(text, size, "'");
}

void glint_failure_command(int argc, char *const *argv, char *text, size_t size)
{
    text[0] = '\0';
    append(text, size, "build/glint");
    for (int i = 0; i < argc; i++) {
        append(text, size, " ");
        if (is_plain(argv[i]))
            append(text, size, argv[i]);
        else
            append_quoted(text, size, argv[i]);
    }
}
