/* Runs another program with a limit on its time: in a process group of its own, its output kept in
 * files of the scratch directory. Include it after cmocka.h and scratch.h. */
#ifndef GLINT_TESTS_CHILD_H
#define GLINT_TESTS_CHILD_H

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
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
    if (failed != 0) {
        fail_msg("cannot start %s: %s", argv[0], strerror(failed));
    }
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    return child;
}

/* Its exit status, or 128 + the signal's number; CHILD_TIMED_OUT after ending it and all it
 * started. */
static inline int child_wait(pid_t child, double seconds)
{
    const double limit = child_seconds() + seconds;
    int status;
    pid_t ended;
    while ((ended = waitpid(child, &status, WNOHANG)) == 0) {
        if (child_seconds() > limit) {
            kill(-child, SIGKILL);
            waitpid(child, &status, 0);
            return CHILD_TIMED_OUT;
        }
        child_pause();
    }
    assert_int_equal(ended, child);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

/* Whether a process has a handler of its own for SIGINT: /proc says which signals it catches. */
static inline int child_catches_sigint(pid_t process)
{
    char path[64];
    char line[256];
    unsigned long long caught = 0;
    (void)snprintf(path, sizeof path, "/proc/%d/status", (int)process);
    FILE *status = fopen(path, "r");
    assert_non_null(status);
    while (fgets(line, sizeof line, status) != NULL) {
        (void)sscanf(line, "SigCgt: %llx", &caught);
    }
    fclose(status);
    return (caught >> (SIGINT - 1) & 1) != 0;
}

/* Waits until a program listens to SIGINT: before, it would just end. */
static inline void child_wait_for_handler(pid_t child, double seconds)
{
    const double limit = child_seconds() + seconds;
    while (!child_catches_sigint(child) && child_seconds() < limit) {
        child_pause();
    }
}

static inline int child_run(const char *const *argv, double seconds)
{
    return child_wait(child_start(argv, scratch_path("child.out"), scratch_path("child.err")),
                      seconds);
}

#endif
