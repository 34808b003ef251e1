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
