/* Messages and exit statuses; see output.h. */
#define _XOPEN_SOURCE 700

#include "cli/output.h"

#include <errno.h>
#include <fcntl.h>
#include <inttypes.h>
#include <signal.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <sys/select.h>
#include <time.h>
#include <unistd.h>

#include "file/json.h"

/* The one variable of the process: a signal handler can reach nothing else. One byte, written only
 * with true, so that a reader in any thread sees the old value or the new one. */
static volatile bool stop_requested;

static void request_stop(int signal_number)
{
    (void)signal_number;
    stop_requested = true;
}

static const int stop_signals[] = {SIGINT, SIGTERM, SIGHUP};

/* Keeps a closed descriptor's number taken. open() returns the lowest free number, which is fd, as
 * all below it are open by now. */
static void hold_descriptor(int fd, int flags)
{
    if (fcntl(fd, F_GETFD) == -1 && errno == EBADF && open("/dev/null", flags) != fd)
        _Exit(GLINT_EXIT_TROUBLE);
}

void glint_output_init(void)
{
    hold_descriptor(STDIN_FILENO, O_WRONLY);
    hold_descriptor(STDOUT_FILENO, O_RDONLY);
    hold_descriptor(STDERR_FILENO, O_RDONLY);

    struct sigaction action;
    memset(&action, 0, sizeof action);
    sigemptyset(&action.sa_mask);
    action.sa_handler = SIG_IGN;
    sigaction(SIGPIPE, &action, NULL);
    sigaction(SIGXFSZ, &action, NULL); /* a write beyond ulimit -f fails, as on a full disk */
    /* No SA_RESTART: a subcommand waiting for input must wake up. */
    action.sa_handler = request_stop;
    action.sa_flags = (int)SA_RESETHAND;
    struct sigaction inherited;
    for (size_t i = 0; i < sizeof stop_signals / sizeof stop_signals[0]; i++) {
        const int number = stop_signals[i];
        const bool kept = number == SIGHUP && sigaction(number, NULL, &inherited) == 0 &&
                          inherited.sa_handler == SIG_IGN; /* by nohup */
        if (!kept)
            sigaction(number, &action, NULL);
    }
}

int glint_output_finish(const char *command, int status)
{
    /* If more was printed than fits the stream's buffer, errno still holds the cause of the failed
     * write: later output does not set it. */
    const int earlier = ferror(stdout) ? errno : 0;
    errno = 0;
    const bool flushed = fflush(stdout) == 0;
    if (flushed && !ferror(stdout))
        return status;
    const int why = errno != 0 ? errno : earlier;
    if (why == EINTR && stop_requested)
        return glint_complain(command, GLINT_EXIT_TROUBLE, "interrupted");
    return glint_complain(command, GLINT_EXIT_TROUBLE, "cannot write to standard output: %s",
                          why != 0 ? strerror(why) : "an earlier write failed");
}

/* Whether the stream may be sent colours. */
static bool takes_colors(FILE *out)
{
    const char *no_color = getenv("NO_COLOR");
    const char *term = getenv("TERM");
    return (no_color == NULL || *no_color == '\0') && (term == NULL || strcmp(term, "dumb") != 0) &&
           isatty(fileno(out)) == 1;
}

#define BOLD_RED   "\033[1;31m"
#define BOLD_GREEN "\033[1;32m"
#define PLAIN      "\033[0m"

void glint_print_verdict(FILE *out, bool good, const char *format, ...)
{
    const bool colors = takes_colors(out);
    va_list arguments;
    va_start(arguments, format);
    fputs(!colors ? "" : good ? BOLD_GREEN : BOLD_RED, out);
    vfprintf(out, format, arguments);
    fputs(colors ? PLAIN : "", out);
    va_end(arguments);
}

int glint_complain(const char *command, int exit_status, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    char message[1024];
    vsnprintf(message, sizeof message, format, arguments);
    va_end(arguments);
    /* A file name may hold a newline; the message stays one line. */
    for (char *c = message; *c != '\0'; c++)
        if ((unsigned char)*c < 0x20 || *c == 0x7f)
            *c = '?';
    glint_print_verdict(stderr, false, "glint%s%s:", command != NULL ? " " : "",
                        command != NULL ? command : "");
    fprintf(stderr, " %s\n", message);
    return exit_status;
}

int glint_complain_error(const char *command, const glint_error *err)
{
    return glint_complain(command, GLINT_EXIT_TROUBLE, "%s", err->text);
}

void glint_tell_remarks(const char *command, const char *path, const char *remarks)
{
    if (remarks[0] != '\0')
        (void)glint_complain(command, GLINT_EXIT_OK, "%s: %s", path, remarks);
}

bool glint_output_json(json_t *json)
{
    char *text = glint_json_text(json);
    json_decref(json);
    if (text == NULL)
        return false;
    puts(text);
    free(text);
    return true;
}

bool glint_stop_requested(void)
{
    return stop_requested;
}

bool glint_wait_readable(int fd)
{
    sigset_t stopping, before;
    sigemptyset(&stopping);
    for (size_t i = 0; i < sizeof stop_signals / sizeof stop_signals[0]; i++)
        sigaddset(&stopping, stop_signals[i]);
    sigprocmask(SIG_BLOCK, &stopping, &before);
    bool again = true;
    while (again && !stop_requested) {
        fd_set readable;
        FD_ZERO(&readable);
        FD_SET(fd, &readable);
        again = pselect(fd + 1, &readable, NULL, NULL, NULL, &before) == -1 && errno == EINTR;
    }
    sigprocmask(SIG_SETMASK, &before, NULL);
    return !stop_requested;
}

const volatile bool *glint_stop_flag(void)
{
    return &stop_requested;
}

double glint_seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

void glint_progress_begin(glint_progress *progress, const char *command, const char *unit)
{
    progress->command = command;
    progress->unit = unit;
    progress->shown = isatty(STDERR_FILENO) == 1;
    progress->next = 0.0;
}

/* Whether the line is due again. */
static bool is_due(glint_progress *progress)
{
    if (!progress->shown || glint_seconds() < progress->next)
        return false;
    progress->next = glint_seconds() + 0.1;
    return true;
}

void glint_progress_say(glint_progress *progress, const char *what)
{
    if (is_due(progress)) {
        fprintf(stderr, "\rglint %s: %s\033[K", progress->command, what);
        fflush(stderr);
    }
}

void glint_progress_update(glint_progress *progress, uint64_t done, uint64_t total)
{
    if (!is_due(progress))
        return;
    const double percent = total > 0 ? 100.0 * (double)done / (double)total : 100.0;
    fprintf(stderr, "\rglint %s: %" PRIu64 " of %" PRIu64 " %s, %.0f %%\033[K", progress->command,
            done, total, progress->unit, percent);
    fflush(stderr);
}

void glint_progress_end(glint_progress *progress)
{
    if (progress->shown && progress->next > 0.0)
        fputs("\r\033[K", stderr);
}
