/* A child process with captured output, for Verilator and the compiler.
 *
 * It stays in the terminal's process group, so Ctrl-C ends it too, and it dies if its parent is
 * killed. */
#ifndef GLINT_SIM_RTL_COMMAND_H
#define GLINT_SIM_RTL_COMMAND_H

#include <stdbool.h>
#include <sys/types.h>

#include "glint_status.h"

/* From now on, once *stop is true, no command is started and running ones are ended, all with
 * GLINT_INTERRUPTED. (Ctrl-C also reaches the tools, but some just report failure, and callers
 * waiting for a builder would start over.) stop must stay valid. */
void glint_command_stop_when(const volatile bool *stop);

/* A command line, to be added to; what does not fit is left out. */
#define GLINT_ARGUMENTS_MAX 1023
typedef struct glint_arguments {
    const char *word[GLINT_ARGUMENTS_MAX + 1]; /* the last NULL */
    int count;
} glint_arguments;
void glint_arguments_add(glint_arguments *line, const char *word);
void glint_arguments_add_all(glint_arguments *line, const char *const *words); /* the last NULL */

typedef struct glint_command {
    pid_t process; /* 0: none */
    int words;     /* what it says: an open file without a name; −1: none */
} glint_command;

/* Starts arguments[0] (looked for in the PATH), the last of them NULL, in `directory` (NULL: here).
 */
glint_status glint_command_start(const char *const *arguments, const char *directory,
                                 glint_command *command, glint_error *err);

/* Waits for it to end. *success: it exited with 0; *said (may be NULL): everything it wrote to
 * standard output and error, for the caller to free. GLINT_INTERRUPTED when SIGINT, SIGTERM or
 * SIGHUP ended it. */
glint_status glint_command_wait(glint_command *command, bool *success, char **said,
                                glint_error *err);

/* Ends a command that is not waited for any more; one of all zeros with words −1 is none. */
void glint_command_kill(glint_command *command);

/* Both in one. */
glint_status glint_command_run(const char *const *arguments, const char *directory, bool *success,
                               char **said, glint_error *err);

#endif
