/* Runs another program with a time limit, in its own process group, with its output kept in files
 * of the scratch directory. Include it after cmocka.h and scratch.h.
 *
 * The limit is on the program's own processor time, which is independent of other load. Wall-clock
 * time ends a program only after child_patience, with a note that the machine may be to blame. */
#ifndef GLINT_TESTS_CHILD_H
#define GLINT_TESTS_CHILD_H

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <stdbool.h>
#include <sys/wait.h>
#include <time.h>

extern char **environ;

enum { CHILD_TIMED_OUT = -1 };

static inline double child_seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + (double)now.tv_nsec * 1e-9;
}

static inline void child_pause(void)
{
    nanosleep(&(struct timespec){.tv_nsec = 10000000}, NULL);
}

/* Starts argv[0], looked for in PATH; its standard output and error go to the two files. */
static inline pid_t child_start(const char *const *argv, const char *out, const char *err)
{
    pid_t child;
    posix_spawn_file_actions_t actions;
    posix_spawnattr_t attributes;
    const int flags = O_WRONLY | O_CREAT | O_TRUNC;
    assert_int_equal(posix_spawn_file_actions_init(&actions), 0);
    assert_int_equal(posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0), 0);
    assert_int_equal(posix_spawn_file_actions_addopen(&actions, 1, out, flags, 0666), 0);
    assert_int_equal(posix_spawn_file_actions_addopen(&actions, 2, err, flags, 0666), 0);
    assert_int_equal(posix_spawnattr_init(&attributes), 0);
    assert_int_equal(posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP), 0);
    const int failed = posix_spawnp(&child, argv[0], &actions, &attributes,
                                    (char *const *)(uintptr_t)argv, environ);
    if (failed != 0)
        fail_msg("cannot start %s: %s", argv[0], strerror(failed));
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    return child;
}

/* Wall-clock seconds after which an event is assumed never to happen. */
static double child_patience = 600.0;

/* Processor time of a process that has not been waited for. */
static inline double child_worked(pid_t child)
{
    clockid_t clock;
    struct timespec worked = {0};
    if (clock_getcpuclockid(child, &clock) == 0)
        clock_gettime(clock, &worked);
    return (double)worked.tv_sec + (double)worked.tv_nsec * 1e-9;
}

/* Whether a program running since `start` has used up its time; prints a message if so. */
static inline bool child_is_overdue(pid_t child, double start, double seconds)
{
    const double worked = child_worked(child), passed = child_seconds() - start;
    if (worked > seconds) {
        print_error("process %d does not end: it has worked for %.1f s, its limit is %.1f s\n",
                    (int)child, worked, seconds);
    } else if (passed > child_patience) {
        print_error(
            "process %d has not ended in %.0f s by the clock, in which it worked for %.1f s: "
            "it waits for something, or this machine is too busy for this test\n",
            (int)child, passed, worked);
    }
    return worked > seconds || passed > child_patience;
}

/* Whether it has ended, or was even waited for; it is not waited for by this. */
static inline bool child_has_ended(pid_t child)
{
    siginfo_t info = {0};
    return waitid(P_PID, (id_t)child, &info, WEXITED | WNOHANG | WNOWAIT) != 0 ||
           info.si_pid == child;
}

/* Its exit status, or 128 + the signal's number; CHILD_TIMED_OUT if it used more than that many
 * seconds, after killing it and everything it started. */
static inline int child_wait(pid_t child, double seconds)
{
    const double start = child_seconds();
    int status;
    pid_t ended;
    while ((ended = waitpid(child, &status, WNOHANG)) == 0) {
        if (child_is_overdue(child, start, seconds)) {
            kill(-child, SIGKILL);
            waitpid(child, &status, 0);
            return CHILD_TIMED_OUT;
        }
        child_pause();
    }
    assert_int_equal(ended, child);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

/* Whether a process has a SIGINT handler, according to /proc. */
static inline int child_catches_sigint(pid_t process)
{
    char path[64];
    char line[256];
    unsigned long long caught = 0;
    (void)snprintf(path, sizeof path, "/proc/%d/status", (int)process);
    FILE *status = fopen(path, "r");
    assert_non_null(status);
    while (fgets(line, sizeof line, status) != NULL)
        (void)sscanf(line, "SigCgt: %llx", &caught);
    fclose(status);
    return (caught >> (SIGINT - 1) & 1) != 0;
}

/* Waits until a program handles SIGINT; before that, it would just die. Fails the test if it ends
 * without ever handling it. */
static inline void child_wait_for_handler(pid_t child)
{
    const double start = child_seconds();
    while (!child_catches_sigint(child)) {
        if (child_has_ended(child) || child_seconds() - start > child_patience)
            fail_msg("process %d never had a handler for SIGINT", (int)child);
        child_pause();
    }
}

/* Runs argv[0] to its end: as child_wait(). */
static inline int child_run(const char *const *argv, double seconds)
{
    return child_wait(child_start(argv, scratch_path("child.out"), scratch_path("child.err")),
                      seconds);
}

#endif
