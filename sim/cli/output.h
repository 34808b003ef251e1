/* How the command reports and ends: exit statuses, one-line messages, checked standard output,
 * progress on a terminal, and Ctrl-C. */
#ifndef GLINT_SIM_CLI_OUTPUT_H
#define GLINT_SIM_CLI_OUTPUT_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

#include "file/json.h"
#include "glint_status.h"

/* What every subcommand returns, as cmp does. */
enum {
    GLINT_EXIT_OK = 0,        /* done; equal, for commands that compare */
    GLINT_EXIT_DIFFERENT = 1, /* a comparison found a difference; only commands that compare */
    GLINT_EXIT_TROUBLE = 2,   /* bad input, unreadable, unwritable or interrupted: no verdict */
};

/* Call once, first thing in main(). A closed standard stream is replaced by /dev/null, opened so
 * that using it still fails (otherwise the next file opened would get its number and receive its
 * text); a broken pipe and a limit on file sizes become write errors; SIGINT, SIGTERM and, except
 * under nohup, SIGHUP raise the stop flag, and a second one kills. */
void glint_output_init(void);

/* Flushes and checks standard output: the last thing a subcommand does. Returns status, or reports
 * the error and returns GLINT_EXIT_TROUBLE if any output was lost. */
int glint_output_finish(const char *command, int status);

/* Prints "glint COMMAND: message" as one line on standard error ("glint: message" when command is
 * NULL) and returns the exit status given: `return glint_complain("eval", GLINT_EXIT_TROUBLE, …);`
 */
int glint_complain(const char *command, int exit_status, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* Reports why a library call failed and returns its exit status, 2. */
int glint_complain_error(const char *command, const glint_error *err);

/* Prints to standard output or error, in bold green when it is good news and bold red when it is
 * not: on a terminal only, and not where NO_COLOR is set (no-color.org) or TERM is dumb. */
void glint_print_verdict(FILE *out, bool good, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* Says, where there is anything to say, what of a mesh file is not in the mesh. */
void glint_tell_remarks(const char *command, const char *path, const char *remarks);

/* Prints a JSON object on standard output, a newline after it, and deletes it. json may be NULL
 * (out of memory while it was built). Returns false when memory ran out. */
bool glint_output_json(json_t *json);

/* True once SIGINT, SIGTERM or SIGHUP has arrived. */
bool glint_stop_requested(void);

/* Waits until a read from fd would not block: for input, end of file, or an error that the read
 * will report. False if the stop flag is raised before or during the wait, without a race between
 * checking the flag and waiting. For single-threaded callers; fd must be below FD_SETSIZE. */
bool glint_wait_readable(int fd);

/* The same flag for library calls that poll it while they work, such as glint_render(). */
const volatile bool *glint_stop_flag(void);

/* A progress line on standard error, at most ten times per second, and only on a terminal. */
typedef struct glint_progress {
    const char *command;
    const char *unit; /* "clocks" */
    bool shown;       /* standard error is a terminal */
    double next;      /* when to print again, seconds */
} glint_progress;

void glint_progress_begin(glint_progress *progress, const char *command, const char *unit);
void glint_progress_update(glint_progress *progress, uint64_t done, uint64_t total);
void glint_progress_say(glint_progress *progress, const char *what); /* before there are numbers */
void glint_progress_end(glint_progress *progress);                   /* wipes the line */

/* Seconds on a monotonic clock. */
double glint_seconds(void);

#endif
