/* Runs the command under adverse conditions and checks its guarantees: it ends in time, by itself,
 * with an exit status of 0 to 2 and one line on standard error unless that is 0, and every file
 * under its final name is complete.
 *
 * Time is the command's own processor time, as measured by child.h.
 *
 * Every run is counted under a heading. docs/abuse.md must list each heading with its count, which
 * abuse_expect_documented() checks. */
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
    bool broken_out; /* standard output is a pipe without a reader */
    bool endless_in; /* standard input is a pipe that stays open and empty */
    bool as_nobody;  /* without root's privileges */
    long file_limit; /* largest file it can write, bytes; 0: no limit */
    int signal;      /* sent after milliseconds; 0: none */
    int milliseconds;
    bool once_caught; /* counted from when it has installed a handler for the signal */
    double seconds;   /* of work after which it counts as endless; 0: 20 */
} abuse;

typedef struct outcome {
    int status; /* exit status; 128 + the signal's number; ABUSE_TIMED_OUT */
    char *out, *err;
    bool caught;   /* it had installed a handler for the signal when that was sent */
    bool survived; /* one of its child processes was still alive one second after it ended */
} outcome;

/* Uses the command to build every circuit that the runs below need, so that they test the command
 * and not Verilator; not counted. scratch is the test's directory. Call it in a group's set-up;
 * returns 0 on success. */
int abuse_build_circuits(const char *scratch);

/* " --rtl DIR" for a command line: the circuit of that name that is wrong on purpose. */
const char *abuse_wrong_circuit(const char *name);

/* Runs a command line (words apart by spaces) and counts it under a heading. */
outcome abuse_run(const char *heading, const char *command_line, const abuse *how);
void abuse_forget(outcome *done);

/* The guarantees above, for a run that may succeed or fail. */
void abuse_expect_sane(const outcome *done, const char *command_line);

/* The same, and that it failed with `status`, saying `part`. */
void abuse_expect_failure(const outcome *done, const char *command_line, int status,
                          const char *part);

/* Everything in the directory and below is whole: pictures, waveforms and JSON can be read, no file
 * is empty. Temporary names (.glint-….tmp) only if allowed. Returns the number of files. */
int abuse_expect_whole(const char *directory, bool in_the_making);

/* Each test's last line: it tried everything it was meant to. */
void abuse_all_tried(void);

/* Prints the counts, expects the same in docs/abuse.md, and notes them for docs/verified.md as
 * abuse-`name`. A group's last test. Skipped unless all of the `tests` before it finished:
 * otherwise the counts are incomplete, which is not the page's fault. */
void abuse_expect_documented(const char *name, const char *what, int tests);

#endif
