/* fork, exec, pipes and signals for one child process; see command.h. */
#define _GNU_SOURCE /* memfd_create */

#include "rtl/command.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#define POLL_NANOSECONDS 5000000

/* Of the process, as its signals are; NULL: nothing stops it. */
static const volatile bool *stop_flag;

void glint_command_stop_when(const volatile bool *stop)
{
    stop_flag = stop;
}

static bool is_stopped(void)
{
    return stop_flag != NULL && *stop_flag;
}

void glint_arguments_add(glint_arguments *line, const char *word)
{
    if (line->count < GLINT_ARGUMENTS_MAX)
        line->word[line->count++] = word;
    line->word[line->count] = NULL;
}

void glint_arguments_add_all(glint_arguments *line, const char *const *words)
{
    for (; *words != NULL; words++)
        glint_arguments_add(line, *words);
}

static glint_status interrupted(glint_error *err)
{
    return glint_fail(err, GLINT_INTERRUPTED, "interrupted");
}

/* In the child: only what is safe between fork() and exec() of a program with threads. */
static void become(const char *const *arguments, const char *directory, int words, pid_t parent)
{
    static const char text[] = "cannot be started\n";
    const int nothing = open("/dev/null", O_RDONLY | O_CLOEXEC);
    sigset_t none;
    sigemptyset(&none); /* a crew's thread blocks all, and Ctrl-C and SIGTERM are to end a tool */
    (void)sigprocmask(SIG_SETMASK, &none, NULL);
    (void)prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent)
        _exit(127);
    if (nothing >= 0)
        (void)dup2(nothing, STDIN_FILENO);
    (void)dup2(words, STDOUT_FILENO);
    (void)dup2(words, STDERR_FILENO);
    if (directory == NULL || chdir(directory) == 0)
        (void)execvp(arguments[0], (char *const *)(uintptr_t)arguments);
    (void)!write(STDERR_FILENO, text, sizeof text - 1);
    _exit(127);
}

glint_status glint_command_start(const char *const *arguments, const char *directory,
                                 glint_command *command, glint_error *err)
{
    *command = (glint_command){0, -1};
    if (is_stopped())
        return interrupted(err);
    command->words = memfd_create("glint", MFD_CLOEXEC);
    if (command->words < 0)
        return glint_fail(err, GLINT_IO_ERROR, "cannot start %s: %s", arguments[0],
                          strerror(errno));
    const pid_t parent = getpid();
    command->process = fork();
    if (command->process == 0)
        become(arguments, directory, command->words, parent);
    if (command->process < 0) {
        const int cause = errno;
        command->process = 0;
        glint_command_kill(command);
        return glint_fail(err, GLINT_IO_ERROR, "cannot start %s: %s", arguments[0],
                          strerror(cause));
    }
    return GLINT_OK;
}

/* All of an open file; NULL without memory. */
static char *read_all(int fd)
{
    struct stat info;
    const size_t size = fstat(fd, &info) == 0 ? (size_t)info.st_size : 0;
    char *text = malloc(size + 1);
    if (text == NULL)
        return NULL;
    size_t got = 0;
    ssize_t more;
    while (got < size && (more = pread(fd, text + got, size - got, (off_t)got)) > 0)
        got += (size_t)more;
    text[got] = '\0';
    return text;
}

static bool is_interruption(int state)
{
    if (!WIFSIGNALED(state))
        return false;
    const int number = WTERMSIG(state);
    return number == SIGINT || number == SIGTERM || number == SIGHUP;
}

static glint_status wait_for(glint_command *command, int *state, glint_error *err)
{
    pid_t ended;
    bool told = false;
    while ((ended = waitpid(command->process, state, stop_flag != NULL ? WNOHANG : 0)) == 0 ||
           (ended < 0 && errno == EINTR)) {
        if (is_stopped() && !told) {
            (void)kill(command->process, SIGTERM);
            told = true;
        }
        if (ended == 0)
            (void)nanosleep(&(struct timespec){.tv_nsec = POLL_NANOSECONDS}, NULL);
    }
    command->process = 0;
    if (ended < 0)
        return glint_fail(err, GLINT_IO_ERROR, "cannot wait for a tool to finish: %s",
                          strerror(errno));
    if (is_interruption(*state) || is_stopped())
        return interrupted(err);
    return GLINT_OK;
}

glint_status glint_command_wait(glint_command *command, bool *success, char **said,
                                glint_error *err)
{
    int state = 0;
    glint_status status = wait_for(command, &state, err);
    *success = status == GLINT_OK && WIFEXITED(state) && WEXITSTATUS(state) == 0;
    if (said != NULL) {
        *said = status == GLINT_OK ? read_all(command->words) : NULL;
        if (status == GLINT_OK && *said == NULL)
            status = glint_fail(err, GLINT_NO_MEMORY, "not enough memory for a tool's output");
    }
    glint_command_kill(command);
    return status;
}

void glint_command_kill(glint_command *command)
{
    if (command->process > 0) {
        (void)kill(command->process, SIGTERM);
        while (waitpid(command->process, NULL, 0) < 0 && errno == EINTR)
            ;
    }
    if (command->words >= 0)
        (void)close(command->words);
    *command = (glint_command){0, -1};
}

glint_status glint_command_run(const char *const *arguments, const char *directory, bool *success,
                               char **said, glint_error *err)
{
    glint_command command;
    *success = false;
    if (said != NULL)
        *said = NULL;
    const glint_status status = glint_command_start(arguments, directory, &command, err);
    return status != GLINT_OK ? status : glint_command_wait(&command, success, said, err);
}
