/* Runs gnuplot; see plot.h. Each picture comes through a pipe from gnuplot's standard output:
 * gnuplot itself does not notice a full disk. */
#define _GNU_SOURCE

#include "report/plot.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "file/new_file.h"
#include "report/place.h"

extern char **environ;

/* How long a look at the stop flag may be away: a signal that comes just before a wait does not end
 * it. */
#define LOOK_MILLISECONDS 50

/* gnuplot at work, in a process group of its own. */
typedef struct drawing {
    const glint_plot_limits *limits;
    double end; /* when the time is up, seconds of now() */
    pid_t child;
    int status; /* of waitpid(), once it has ended by itself */
    int unwritten;
} drawing;

static double now(void)
{
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return (double)time.tv_sec + (double)time.tv_nsec * 1e-9;
}

static bool is_stopped(const drawing *d)
{
    return d->limits->stop != NULL && *d->limits->stop;
}

static bool may_go_on(const drawing *d)
{
    return !is_stopped(d) && now() < d->end;
}

static const struct {
    const char *suffix;
    const char *terminal;
} kinds[] = {
    {"svg", "set terminal svg size 800,500 font 'sans,14' background 'white'"},
    {"png", "set terminal pngcairo size 1200,750 font 'sans,16' linewidth 1.5"},
};

/* Returns 0 or an errno. */
static int prepare(posix_spawn_file_actions_t *actions, const char *directory, int out)
{
    int failed = posix_spawn_file_actions_addopen(actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    if (failed == 0)
        failed = posix_spawn_file_actions_adddup2(actions, out, STDOUT_FILENO);
    if (failed == 0)
        failed = posix_spawn_file_actions_addopen(actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    return failed != 0 ? failed : posix_spawn_file_actions_addchdir_np(actions, directory);
}

/* Starts gnuplot (without the user's settings) on a script. In a process group of its own: a Ctrl-C
 * is for this program, not a failure of gnuplot, and what gnuplot starts ends with it.
 * Returns 0 or an errno. */
static int start(const char *directory, const char *terminal, const char *script, int out,
                 pid_t *child)
{
    const char *const argv[] = {"gnuplot", "-d", "-e", terminal, script, NULL};
    posix_spawn_file_actions_t actions;
    posix_spawnattr_t attributes;
    int failed = posix_spawn_file_actions_init(&actions);
    if (failed != 0)
        return failed;
    failed = posix_spawnattr_init(&attributes);
    if (failed == 0) {
        failed = prepare(&actions, directory, out);
        if (failed == 0)
            failed = posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
        if (failed == 0)
            failed = posix_spawnp(child, argv[0], &actions, &attributes,
                                  (char *const *)(uintptr_t)argv, environ);
        posix_spawnattr_destroy(&attributes);
    }
    posix_spawn_file_actions_destroy(&actions);
    return failed;
}

/* What is there to be read of the picture; what cannot be written is read all the same. Returns
 * whether more may follow. */
static bool copy_piece(drawing *d, int from, FILE *out)
{
    char bytes[16384];
    const ssize_t count = read(from, bytes, sizeof bytes);
    if (count < 0 && errno == EINTR)
        return true;
    if (d->unwritten == 0 && (count < 0 || fwrite(bytes, 1, (size_t)count, out) < (size_t)count ||
                              (count == 0 && fflush(out) != 0)))
        d->unwritten = errno;
    return count > 0;
}

/* To the picture's end. Returns false where it may not go on. */
static bool copy(drawing *d, int from, FILE *out)
{
    while (may_go_on(d)) {
        struct pollfd ready = {.fd = from, .events = POLLIN};
        if (poll(&ready, 1, LOOK_MILLISECONDS) > 0 && !copy_piece(d, from, out))
            return true;
    }
    return false;
}

/* Until it ends. Returns false where it may not go on. */
static bool wait_for(drawing *d)
{
    pid_t ended;
    while ((ended = waitpid(d->child, &d->status, WNOHANG)) == 0) {
        if (!may_go_on(d))
            return false;
        poll(NULL, 0, 1);
    }
    if (ended < 0)
        d->status = -1; /* how it ended is not known */
    return true;
}

/* It and all that it has started. */
static void end(const drawing *d)
{
    kill(-d->child, SIGKILL);
    while (waitpid(d->child, NULL, 0) < 0 && errno == EINTR)
        ;
}

static glint_status outcome_of(const drawing *d, bool ended, const char *directory,
                               const char *script, glint_error *err)
{
    if (is_stopped(d))
        return glint_fail(err, GLINT_INTERRUPTED, "interrupted");
    if (!ended)
        return glint_fail(err, GLINT_IO_ERROR,
                          "gnuplot did not finish within %g s; run it in %.300s on %s to see why",
                          d->limits->seconds, directory, script);
    if (!WIFEXITED(d->status) || WEXITSTATUS(d->status) != 0)
        return glint_fail(err, GLINT_IO_ERROR, "gnuplot failed; run it in %.300s on %s to see why",
                          directory, script);
    return d->unwritten == 0
               ? GLINT_OK
               : glint_fail(err, GLINT_IO_ERROR, "cannot write the picture of %.300s/%s: %s",
                            directory, script, strerror(d->unwritten));
}

static glint_status run_gnuplot(const char *directory, const char *terminal, const char *script,
                                const glint_plot_limits *limits, FILE *out, bool *found,
                                glint_error *err)
{
    drawing d = {.limits = limits, .end = now() + limits->seconds};
    int ends[2];
    bool ended = false;
    int failed = pipe2(ends, O_CLOEXEC) == 0 ? 0 : errno;
    if (failed == 0) {
        failed = start(directory, terminal, script, ends[1], &d.child);
        close(ends[1]);
        if (failed == 0) {
            ended = copy(&d, ends[0], out) && wait_for(&d);
            if (!ended)
                end(&d);
        }
        close(ends[0]);
    }
    *found = failed != ENOENT;
    if (failed == ENOENT)
        return GLINT_OK;
    if (failed != 0)
        return glint_fail(err, GLINT_IO_ERROR, "cannot start gnuplot: %s", strerror(failed));
    return outcome_of(&d, ended, directory, script, err);
}

static glint_status make_picture(const char *directory, const char *name, int kind,
                                 const glint_plot_limits *limits, bool *found, glint_error *err)
{
    char script[64], picture[64];
    glint_place place;
    glint_new_file *file;
    snprintf(script, sizeof script, "%s.gnuplot", name);
    snprintf(picture, sizeof picture, "%s.%s", name, kinds[kind].suffix);
    glint_status status = glint_place_in(directory, picture, &place, err);
    if (status == GLINT_OK)
        status = glint_new_file_open(place.path, &file, err);
    if (status != GLINT_OK)
        return status;
    status = run_gnuplot(directory, kinds[kind].terminal, script, limits,
                         glint_new_file_stream(file), found, err);
    if (status == GLINT_OK && *found)
        return glint_new_file_commit(file, err);
    glint_new_file_discard(file);
    return status;
}

glint_status glint_plot(const char *directory, const char *name, const glint_plot_limits *limits,
                        bool *plotted, glint_error *err)
{
    *plotted = true;
    for (int kind = 0; *plotted && kind < (int)(sizeof kinds / sizeof kinds[0]); kind++) {
        const glint_status status = make_picture(directory, name, kind, limits, plotted, err);
        if (status != GLINT_OK)
            return status;
    }
    return GLINT_OK;
}
