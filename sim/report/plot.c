/* Runs gnuplot; see plot.h. Each picture comes through a pipe from gnuplot's standard output:
 * gnuplot itself does not notice a full disk. */
#define _GNU_SOURCE

#include "report/plot.h"

#include <errno.h>
#include <fcntl.h>
#include <spawn.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "file/new_file.h"
#include "report/place.h"

extern char **environ;

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
 * is for this program, which says so when the picture is done, and not a failure of gnuplot.
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

/* To its end, whether it can be written or not. Returns 0 or the errno of what first failed. */
static int copy(int from, FILE *out)
{
    char bytes[16384];
    int failed = 0;
    for (;;) {
        const ssize_t count = read(from, bytes, sizeof bytes);
        if (count < 0 && errno == EINTR)
            continue;
        if (failed == 0 && (count < 0 || fwrite(bytes, 1, (size_t)count, out) < (size_t)count ||
                            (count == 0 && fflush(out) != 0)))
            failed = errno;
        if (count <= 0)
            return failed;
    }
}

/* Its exit status; -1 for any other end. */
static int wait_for(pid_t child)
{
    int status;
    while (waitpid(child, &status, 0) < 0)
        if (errno != EINTR)
            return -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

static glint_status run_gnuplot(const char *directory, const char *terminal, const char *script,
                                FILE *out, bool *found, glint_error *err)
{
    pid_t child;
    int ends[2], unwritten = 0;
    int failed = pipe2(ends, O_CLOEXEC) == 0 ? 0 : errno;
    if (failed == 0) {
        failed = start(directory, terminal, script, ends[1], &child);
        close(ends[1]);
        if (failed == 0)
            unwritten = copy(ends[0], out);
        close(ends[0]);
    }
    *found = failed != ENOENT;
    if (failed == ENOENT)
        return GLINT_OK;
    if (failed != 0)
        return glint_fail(err, GLINT_IO_ERROR, "cannot start gnuplot: %s", strerror(failed));
    if (wait_for(child) != 0)
        return glint_fail(err, GLINT_IO_ERROR, "gnuplot failed; run it in %.300s on %s to see why",
                          directory, script);
    return unwritten == 0
               ? GLINT_OK
               : glint_fail(err, GLINT_IO_ERROR, "cannot write the picture of %.300s/%s: %s",
                            directory, script, strerror(unwritten));
}

static glint_status make_picture(const char *directory, const char *name, int kind, bool *found,
                                 glint_error *err)
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
    status = run_gnuplot(directory, kinds[kind].terminal, script, glint_new_file_stream(file),
                         found, err);
    if (status == GLINT_OK && *found)
        return glint_new_file_commit(file, err);
    glint_new_file_discard(file);
    return status;
}

glint_status glint_plot(const char *directory, const char *name, bool *plotted, glint_error *err)
{
    *plotted = true;
    for (int kind = 0; *plotted && kind < (int)(sizeof kinds / sizeof kinds[0]); kind++) {
        const glint_status status = make_picture(directory, name, kind, plotted, err);
        if (status != GLINT_OK)
            return status;
    }
    return GLINT_OK;
}
