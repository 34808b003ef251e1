/* Runs gnuplot; see plot.h. Each picture is gnuplot's standard output, so that it appears whole or
 * not at all. */
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
static int prepare(posix_spawn_file_actions_t *actions, const char *directory, FILE *out)
{
    int failed = posix_spawn_file_actions_addopen(actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    if (failed == 0)
        failed = posix_spawn_file_actions_adddup2(actions, fileno(out), STDOUT_FILENO);
    if (failed == 0)
        failed = posix_spawn_file_actions_addopen(actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    return failed != 0 ? failed : posix_spawn_file_actions_addchdir_np(actions, directory);
}

/* Starts gnuplot (without the user's settings) on a script. Returns 0 or an errno. */
static int start(const char *directory, const char *terminal, const char *script, FILE *out,
                 pid_t *child)
{
    const char *const argv[] = {"gnuplot", "-d", "-e", terminal, script, NULL};
    posix_spawn_file_actions_t actions;
    int failed = posix_spawn_file_actions_init(&actions);
    if (failed != 0)
        return failed;
    failed = prepare(&actions, directory, out);
    if (failed == 0)
        failed =
            posix_spawnp(child, argv[0], &actions, NULL, (char *const *)(uintptr_t)argv, environ);
    posix_spawn_file_actions_destroy(&actions);
    return failed;
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
    const int failed = start(directory, terminal, script, out, &child);
    *found = failed != ENOENT;
    if (failed == ENOENT)
        return GLINT_OK;
    if (failed != 0)
        return glint_fail(err, GLINT_IO_ERROR, "cannot start gnuplot: %s", strerror(failed));
    if (wait_for(child) != 0)
        return glint_fail(err, GLINT_IO_ERROR, "gnuplot failed; run it in %.300s on %s to see why",
                          directory, script);
    return GLINT_OK;
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
