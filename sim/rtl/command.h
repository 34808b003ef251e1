/* A child process with what it says kept, for Verilator and the compiler.
 *
 * It stays in the process group of the terminal, so that Ctrl-C ends it as well, and goes when who
 * started it is killed. */
#ifndef GLINT_SIM_RTL_COMMAND_H
#define GLINT_SIM_RTL_COMMAND_H

#include <stdbool.h>
#include <sys/types.h>

#include "glint_status.h"

/* From now on, once *stop is true, no command is started any more and those that run are ended, all
 * with GLINT_INTERRUPTED: Ctrl-C reaches the tools as well, but some of them only say that they
 * failed, and who waited for their builder would begin anew. stop is to stay. */
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

/* Waits until it has ended. *success: it exited with 0; *said (may be NULL): all that it wrote to
 * standard output and error, to be freed. GLINT_INTERRUPTED when SIGINT, SIGTERM or SIGHUP ended
 * it. */
glint_status glint_command_wait(glint_command *command, bool *success, char **said,
                                glint_error *err);

/* Ends a command that is not waited for any more; one of all zeros with words −1 is none. */
void glint_command_kill(glint_command *command);

/* Both in one. */
glint_status glint_command_run(const char *const *arguments, const char *directory, bool *success,
                               char **said, glint_error *err);

#endif
