/* Ctrl-C, SIGTERM, SIGHUP and SIGKILL in every command that takes its time, at several moments: it
 * ends at once, nothing of it lives on, and what has a final name is whole. */
#define _XOPEN_SOURCE 700

#include <setjmp.h>
#include <signal.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "../scratch.h"

#include "../child.h"
#include "abuse.h"

typedef struct victim {
    const char *line; /* D: the directory to write to, S: the test's own with what is read */
    const char
        *wrong; /* the circuit, wrong on purpose, that this is tried with; NULL: the right ones */
    bool endless_in;
    int status; /* of one that was interrupted */
    const char
        *said; /* by it, which takes longer than any of the moments; "": it may be done before */
} victim;

/* When the signal comes. */
typedef struct moment {
    int milliseconds; /* after the start */
    bool once_caught; /* rather: after the command has its own handler */
} moment;

static const victim victims[] = {
    {"render --size 5000x5000 --backend both --threads 2 --out D/a.png", NULL, false, 2,
     "interrupted"},
    {"render --model S/endless.smd --out D/a.png", NULL, false, 2, "interrupted"},
    {"render --out S/unread.png", NULL, false, 2, "interrupted"},
    {"render --size 3000x3000 --out S/stuck.png", NULL, false, 2, "interrupted"},
    {"verify --clocks 1000000000000 --out D/p", NULL, false, 2, "(interrupted)"},
    {"verify --clocks 1000000000000 --json --out D/p", NULL, false, 2, "\"interrupted\":\ttrue"},
    {"verify --exhaustive --gate all --pipeline all --out D/p", NULL, false, 2, "(interrupted)"},
    {"verify --clocks 300000 --lanes 1 --gate cosine --circuit specular --out D/p", "truncating",
     false, 2, ""},
    {"verify --clocks 1500000 --lanes 1 --gate cosine --circuit specular --seed 2 --out D/p",
     "worn_out", false, 2, ""},
    {"replay S/far", NULL, false, 2, "interrupted"},
    {"replay S/far --json --out D/p", NULL, false, 2, "interrupted"},
    {"bench --seconds 5", NULL, false, 2, "interrupted"},
    {"report --out D/r", NULL, false, 2, "interrupted"},
    {"report --chapter divider --out D/r", NULL, false, 2, "interrupted"},
    {"study --size 1920x1080 --frames 1000 --out D/s", NULL, false, 2, "interrupted"},
    {"energy --method both", NULL, false, 2, "interrupted"},
    {"energy --json", NULL, false, 2, "interrupted"},
    {"eval", NULL, true, 2, "interrupted"},
    {"divide --json", NULL, true, 2, "interrupted"},
    {"compare S/large.png S/large.png --diff D/d.png", NULL, false, 2, "interrupted"},
    {"wave --out D/w", NULL, false, 2, ""},
    {"wave --format vcd --out D/w", NULL, false, 2, ""},
};

static char own[1024], out[1024];

static void line_of(const victim *v, char line[4096])
{
    char *end = line;
    for (const char *c = v->line; *c != '\0'; c++)
        if ((*c == 'D' || *c == 'S') && c[1] == '/')
            end += snprintf(end, 1024, "%s", *c == 'D' ? out : own);
        else
            *end++ = *c;
    (void)strcpy(end, v->wrong != NULL ? abuse_wrong_circuit(v->wrong) : "");
}

/* The next command that writes to a directory clears what a killed one has left there. */
static void clear_up(void)
{
    static const char *const below[] = {"", "/p", "/w", "/s", "/r"};
    const char *glint = getenv("GLINT");
    for (size_t i = 0; i < sizeof below / sizeof below[0]; i++) {
        char picture[2048];
        (void)snprintf(picture, sizeof picture, "%s%s", out, below[i]);
        if (access(picture, F_OK) != 0)
            continue;
        (void)snprintf(picture, sizeof picture, "%s%s/next.png", out, below[i]);
        const char *const next[] = {glint != NULL ? glint : "build/glint",
                                    "render",
                                    "--model",
                                    "quad",
                                    "--size",
                                    "8x8",
                                    "--out",
                                    picture,
                                    NULL};
        assert_int_equal(child_run(next, 60.0), 0);
    }
    (void)abuse_expect_whole(out, false);
}

static void try_signal(const victim *v, int signal, moment when)
{
    char line[4096];
    line_of(v, line);
    assert_int_equal(mkdir(out, 0777), 0);
    const abuse how = {.endless_in = v->endless_in,
                       .signal = signal,
                       .milliseconds = when.milliseconds,
                       .once_caught = when.once_caught,
                       .seconds = 10.0};
    outcome done = abuse_run(signal == SIGKILL ? "kill" : "Ctrl-C, SIGTERM and SIGHUP", line, &how);
    const bool killed = done.status == 128 + signal;
    const bool finished =
        v->said[0] == '\0' && (done.status == 0 || (v->wrong != NULL && done.status == 1));
    const bool answered = done.status == v->status &&
                          (strstr(done.err, v->said) != NULL || strstr(done.out, v->said) != NULL);
    /* Until it has a handler, the signal just ends it. */
    const bool fitting = when.once_caught && v->said[0] != '\0' ? answered
                         : killed                               ? !done.caught
                                  : finished || (signal != SIGKILL && answered);
    if (done.survived || !fitting) {
        fail_msg("%s: signal %d after %d ms: exit status %d%s, \"%s\"", line, signal,
                 when.milliseconds, done.status, done.survived ? ", processes left behind" : "",
                 done.err);
    }
    (void)abuse_expect_whole(out, signal == SIGKILL || killed);
    clear_up();
    abuse_forget(&done);
    assert_int_equal(nftw(out, scratch_remove_entry, 8, FTW_DEPTH | FTW_PHYS), 0);
}

/* moments: milliseconds after the start, the last is 0. */
static void each_command_at(int signal, const int *moments)
{
    for (size_t i = 0; i < sizeof victims / sizeof victims[0]; i++)
        for (const int *after = moments; *after != 0; after++)
            try_signal(&victims[i], signal, (moment){*after, false});
}

/* At work and not yet done, by its own account. */
static void interrupted_at_work(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof victims / sizeof victims[0]; i++)
        try_signal(&victims[i], SIGINT, (moment){5, true});
    abuse_all_tried();
}

static void interrupted(void **state)
{
    (void)state;
    each_command_at(SIGINT, (const int[]){2, 12, 80, 250, 0});
    abuse_all_tried();
}

static void terminated(void **state)
{
    (void)state;
    each_command_at(SIGTERM, (const int[]){90, 0});
    each_command_at(SIGHUP, (const int[]){90, 0});
    abuse_all_tried();
}

static void killed(void **state)
{
    (void)state;
    each_command_at(SIGKILL, (const int[]){2, 20, 150, 0});
    abuse_all_tried();
}

/* The command inherits what is ignored here: SIGINT in a job that a shell runs in the background,
 * SIGHUP under nohup. */
static void ignore_no_signal(void)
{
    (void)signal(SIGINT, SIG_DFL);
    (void)signal(SIGHUP, SIG_DFL);
}

/* A packet whose mismatch is days away. */
static int write_far_packet(void)
{
    static const char text[] =
        "{\"format\":\"glint failure\",\"version\":1,\"kind\":\"random\",\"command\":\"\","
        "\"circuit\":\"specular\",\"gate\":\"cosine\",\"pipeline\":\"pipelined\",\"lanes\":1,"
        "\"seed\":\"2\",\"found\":{\"lockstep_differs\":true,\"clock\":1000000000000,"
        "\"mismatches\":[]}}";
    if (mkdir(scratch_path("far"), 0777) != 0)
        return -1;
    scratch_write(scratch_path("far/failure.json"), text, sizeof text - 1);
    return 0;
}

/* A pipe without a reader, and one that is open for reading but never read. */
static int make_pipes(void)
{
    return mkfifo(scratch_path("unread.png"), 0666) == 0 &&
                   mkfifo(scratch_path("stuck.png"), 0666) == 0 &&
                   open(scratch_path("stuck.png"), O_RDONLY | O_NONBLOCK | O_CLOEXEC) >= 0
               ? 0
               : -1;
}

static int set_up(void **state)
{
    ignore_no_signal();
    if (scratch_make(state) != 0 || write_far_packet() != 0 || make_pipes() != 0 ||
        abuse_build_circuits(scratch_directory) != 0)
        return -1;
    (void)snprintf(out, sizeof out, "%s", scratch_path("out"));
    (void)snprintf(own, sizeof own, "%s", scratch_directory);
    scratch_write(scratch_path("endless.smd"), "version 1\nnodes\n", 16);
    const char *glint = getenv("GLINT");
    const char *const large[] = {glint != NULL ? glint : "build/glint",
                                 "render",
                                 "--size",
                                 "3000x3000",
                                 "--out",
                                 scratch_path("large.png"),
                                 NULL};
    return child_run(large, 60.0);
}

enum { TESTS = 4 };

/* The last: all others have been counted. */
static void the_counts_are_documented(void **state)
{
    (void)state;
    abuse_expect_documented(
        "signals", "signals at any moment: the command ends; no partial file under a final name",
        TESTS);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(interrupted),
        cmocka_unit_test(interrupted_at_work),
        cmocka_unit_test(terminated),
        cmocka_unit_test(killed),
        cmocka_unit_test(the_counts_are_documented),
    };
    _Static_assert(sizeof tests / sizeof tests[0] == TESTS + 1, "the tests before the last");
    return cmocka_run_group_tests(tests, set_up, scratch_remove);
}
