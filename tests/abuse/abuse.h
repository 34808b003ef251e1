/* Runs the command where things go wrong, and holds it to what it promises there: it ends in time,
 * by itself, with an exit status of 0 to 2 and one line on standard error when that is not 0; what
 * lies under a final name is whole.
 *
 * In time: so much work of its own, as child.h measures it.
 *
 * Every run is counted under the heading it was tried under; docs/abuse.md has each heading with
 * its count, and abuse_expect_documented() fails when it has not. */
#ifndef GLINT_TESTS_ABUSE_ABUSE_H
#define GLINT_TESTS_ABUSE_ABUSE_H

#include <stdbool.h>
#include <stddef.h>
#include <sys/types.h>

enum { ABUSE_TIMED_OUT = -1 };

/* What is done to a run. */
typedef struct abuse {
    const char *in;  /* a path for standard input; NULL: /dev/null */
    const char *out; /* a path for standard output; NULL: kept */
    bool close_in, close_out, close_err;
    bool broken_out; /* standard output is a pipe that nobody reads */
    bool endless_in; /* standard input is a pipe that stays open and empty */
    bool as_nobody;  /* without root's privileges */
    long file_limit; /* largest file it can write, bytes; 0: no limit */
    int signal;      /* sent after milliseconds; 0: none */
    int milliseconds;
    bool once_caught; /* they count from when it has a handler of its own for the signal */
    double seconds;   /* of work after which it counts as endless; 0: 20 */
} abuse;

typedef struct outcome {
    int status; /* exit status; 128 + the signal's number; ABUSE_TIMED_OUT */
    char *out, *err;
    bool caught;   /* it had a handler of its own for the signal when that was sent */
    bool survived; /* a process that it had started was still there one second after it ended */
} outcome;

/* Builds every circuit that the runs below need, with the command, so that what is tried is the
 * command and not Verilator; not counted. scratch is the test's
 * directory. To be called by a group's set-up; 0 when it went well. */
int abuse_build_circuits(const char *scratch);

/* " --rtl DIR" for a command line: the circuit of that name that is wrong on purpose. */
const char *abuse_wrong_circuit(const char *name);

/* Runs a command line (words apart by spaces) and counts it under a heading. */
outcome abuse_run(const char *heading, const char *command_line, const abuse *how);
void abuse_forget(outcome *done);

/* The promises above, for a run that may succeed or fail. */
void abuse_expect_sane(const outcome *done, const char *command_line);

/* The same, and that it failed with `status`, saying `part`. */
void abuse_expect_failure(const outcome *done, const char *command_line, int status,
                          const char *part);

/* Everything in the directory and below is whole: pictures, waveforms and JSON can be read, no file
 * is empty. Names of files in the making (.glint-….tmp) only if allowed. Returns how
 * many files there are. */
int abuse_expect_whole(const char *directory, bool in_the_making);

/* Each test's last line: it has tried all that it was to try. */
void abuse_all_tried(void);

/* Prints the counts, expects the same in docs/abuse.md, and notes them for docs/verified.md as
 * abuse-`name`. A group's last test. Skipped when not all of the `tests` before it came to their
 * end: then their runs are not all counted, and that is no fault of the page. */
void abuse_expect_documented(const char *name, const char *what, int tests);

#endif
