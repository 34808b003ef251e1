/* Running the command where things go wrong; see abuse.h. */
#define _GNU_SOURCE

#include "abuse.h"

#include <errno.h>
#include <fcntl.h>
#include <ftw.h>
#include <math.h>
#include <poll.h>
#include <setjmp.h>
#include <signal.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <cmocka.h>

#include "../scratch.h"
#include "file/json.h"

#include "../child.h"
#include "../record.h"
#include "image/image.h"
#include "wave/waveform.h"

#define WORDS_MAX    40
#define HEADINGS_MAX 32
#define KEPT_MAX     ((size_t)1 << 20)
#define SECONDS      20.0
#define SURVIVES     10.0 /* seconds: its children are gone by then, even on a busy machine */
#define NOBODY       65534

static struct {
    const char *name;
    int count;
} headings[HEADINGS_MAX];
static int heading_count;
static double begun;

static int index_of(const char *heading)
{
    for (int i = 0; i < heading_count; i++)
        if (strcmp(headings[i].name, heading) == 0)
            return i;
    assert_true(heading_count < HEADINGS_MAX);
    headings[heading_count].name = heading;
    return heading_count++;
}

static int tests_ended;

void abuse_all_tried(void)
{
    tests_ended++;
}

/* ---- The run ------------------------------------------------------------------------------------
 */

/* A pipe of which only the ends that the child is given outlive its exec. */
typedef struct line {
    int read, write;
} line;

static line make_line(void)
{
    int ends[2];
    assert_int_equal(pipe2(ends, O_CLOEXEC), 0);
    return (line){ends[0], ends[1]};
}

/* The pipes between a run and its test. */
typedef struct lines {
    line in, out, err;
    line alive; /* held open by the run and everything it starts */
} lines;

static void connect(int from, int to)
{
    if (from >= 0 && dup2(from, to) < 0)
        _exit(125);
}

static int input_of(const abuse *how, const lines *l)
{
    return how->endless_in ? l->in.read
                           : open(how->in != NULL ? how->in : "/dev/null", O_RDONLY | O_CLOEXEC);
}

static int output_of(const abuse *how, const lines *l)
{
    return how->out != NULL ? open(how->out, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666)
                            : l->out.write;
}

static void limit_files(long bytes)
{
    const struct rlimit bound = {(rlim_t)bytes, (rlim_t)bytes};
    if (setrlimit(RLIMIT_FSIZE, &bound) != 0)
        _exit(125);
}

/* The program is opened first, since the user nobody may not be able to find it. */
static _Noreturn void be_run(const char *program, char **argv, const abuse *how, const lines *l)
{
    const int file = open(program, O_RDONLY | O_CLOEXEC);
    connect(input_of(how, l), STDIN_FILENO);
    connect(output_of(how, l), STDOUT_FILENO);
    connect(l->err.write, STDERR_FILENO);
    (void)fcntl(l->alive.write, F_SETFD, 0);
    const struct {
        bool closed;
        int stream;
    } streams[] = {{how->close_in, 0}, {how->close_out, 1}, {how->close_err, 2}};
    for (int i = 0; i < 3; i++)
        if (streams[i].closed)
            (void)close(streams[i].stream);
    if (how->file_limit > 0)
        limit_files(how->file_limit);
    if (how->as_nobody && geteuid() == 0 && (setgid(NOBODY) != 0 || setuid(NOBODY) != 0))
        _exit(125);
    (void)fexecve(file, argv, environ);
    _exit(126);
}

/* Appends what a pipe still holds to the text; false at its end. */
static bool read_more(int pipe, char *text, size_t *length)
{
    char rest[4096];
    const ssize_t got = *length < KEPT_MAX ? read(pipe, text + *length, KEPT_MAX - *length)
                                           : read(pipe, rest, sizeof rest);
    if (got > 0 && *length < KEPT_MAX)
        *length += (size_t)got;
    return got > 0;
}

/* Whether the pipe reached its end in time, so that no process holds it any more. */
static bool ends_within(int pipe, int milliseconds)
{
    struct pollfd end = {.fd = pipe, .events = POLLIN};
    return poll(&end, 1, milliseconds) == 1;
}

/* Whether the process has a handler for the signal, according to /proc. */
static bool catches(pid_t process, int signal)
{
    char path[64], line[256];
    unsigned long long caught = 0;
    (void)snprintf(path, sizeof path, "/proc/%d/status", (int)process);
    FILE *status = fopen(path, "r");
    while (status != NULL && fgets(line, sizeof line, status) != NULL)
        (void)sscanf(line, "SigCgt: %llx", &caught);
    if (status != NULL)
        (void)fclose(status);
    return (caught >> (signal - 1) & 1) != 0;
}

/* Reads until the run has ended; sends the signal on the way. Returns waitpid()'s status, or -1. */
static int follow(pid_t child, const abuse *how, lines *l, outcome *done)
{
    char *const text[2] = {done->out, done->err};
    const double start = child_seconds();
    const double limit = how->seconds > 0.0 ? how->seconds : SECONDS;
    size_t length[2] = {0, 0};
    bool open[2] = {how->out == NULL && !how->broken_out, true};
    double end = 0.0;
    bool sent = how->signal == 0, ended = false, late = false;
    double send = how->once_caught ? HUGE_VAL : start + how->milliseconds * 1e-3;
    int status = 0;
    while (!ended || open[0] || open[1]) {
        struct pollfd ready[2] = {{.fd = open[0] ? l->out.read : -1, .events = POLLIN},
                                  {.fd = open[1] ? l->err.read : -1, .events = POLLIN}};
        (void)poll(ready, 2, 2);
        for (int i = 0; i < 2; i++)
            if (ready[i].revents != 0)
                open[i] = read_more(ready[i].fd, text[i], &length[i]);
        if (!sent && isinf(send) && catches(child, how->signal))
            send = child_seconds() + how->milliseconds * 1e-3;
        if (!sent && child_seconds() >= send) {
            sent = true;
            done->caught = catches(child, how->signal);
            (void)kill(child, how->signal);
        }
        ended = ended || waitpid(child, &status, WNOHANG) == child;
        if (!ended && !late && child_is_overdue(child, start, limit)) {
            late = true;
            (void)kill(child, SIGKILL);
        }
        end = ended && end == 0.0 ? child_seconds() : end;
        if (ended && !ends_within(l->alive.read, 0) && child_seconds() > end + SURVIVES)
            break; /* someone else holds the pipes */
    }
    return late ? -1 : status;
}

static int run_child(const char *program, char **argv, const abuse *how, outcome *done)
{
    lines l = {make_line(), make_line(), make_line(), make_line()};
    if (how->broken_out)
        (void)close(l.out.read); /* now: a run may be quicker than what comes after the fork */
    const pid_t child = fork();
    assert_true(child >= 0);
    if (child == 0)
        be_run(program, argv, how, &l);
    (void)close(l.out.write);
    (void)close(l.err.write);
    (void)close(l.alive.write);
    (void)close(l.in.read);
    const int status = follow(child, how, &l, done);
    done->survived = !ends_within(l.alive.read, (int)(1000.0 * SURVIVES));
    (void)close(l.in.write);
    (void)close(l.err.read);
    (void)close(l.alive.read);
    if (!how->broken_out)
        (void)close(l.out.read);
    return status;
}

const char *abuse_wrong_circuit(const char *name)
{
    static char option[1024];
    const char *build = getenv("GLINT_BUILD");
    (void)snprintf(option, sizeof option, " --rtl %s/wrong/%s", build != NULL ? build : "build",
                   name);
    return option;
}

int abuse_build_circuits(const char *scratch)
{
    static const char script[] =
        "set -e\n"
        "G=${GLINT:-build/glint} W=${GLINT_BUILD:-build}/wrong\n"
        "$G verify --clocks 1 --out $0/p\n"
        "$G verify --exhaustive --gate all --pipeline all --shard 1/1000 --stride 4096 --out $0/p\n"
        "$G bench --seconds 0.01\n"
        "$G render --size 8x8 --backend both --out $0/a.png\n"
        "$G wave --out $0/w\n"
        "$G wave --format vcd --out $0/v\n"
        "for w in truncating worn_out; do\n"
        "    $G verify --clocks 1 --lanes 1 --gate cosine --circuit specular --rtl $W/$w --out "
        "$0/p ||\n"
        "        [ $? = 1 ]\n"
        "    $G render --size 8x8 --backend rtl --lanes 1 --rtl $W/$w --out $0/a.png\n"
        "done\n";
    char place[1024], out[1100], err[1100];
    (void)snprintf(place, sizeof place, "%s/built", scratch);
    (void)snprintf(out, sizeof out, "%s.out", place);
    (void)snprintf(err, sizeof err, "%s.err", place);
    const char *const argv[] = {"sh", "-c", script, place, NULL};
    if (mkdir(place, 0777) != 0 || child_wait(child_start(argv, out, err), 3000.0) != 0) {
        char *said = scratch_read(err, NULL);
        print_error("the circuits cannot be built: %s\n", said);
        free(said);
        return -1;
    }
    return 0;
}

outcome abuse_run(const char *heading, const char *command_line, const abuse *how)
{
    static char words[4096];
    char *argv[WORDS_MAX + 2] = {NULL};
    const char *program = getenv("GLINT");
    program = program != NULL ? program : "build/glint";
    if (begun == 0.0)
        begun = child_seconds();
    headings[index_of(heading)].count++;
    assert_true(strlen(command_line) < sizeof words);
    strcpy(words, command_line);
    int argc = 0;
    argv[argc++] = (char *)(uintptr_t)program;
    for (char *word = strtok(words, " "); word != NULL; word = strtok(NULL, " ")) {
        assert_true(argc <= WORDS_MAX);
        argv[argc++] = word;
    }
    outcome done = {.out = calloc(1, KEPT_MAX + 1), .err = calloc(1, KEPT_MAX + 1)};
    assert_true(done.out != NULL && done.err != NULL);
    const int status = run_child(program, argv, how, &done);
    done.status = status < 0          ? ABUSE_TIMED_OUT
                  : WIFEXITED(status) ? WEXITSTATUS(status)
                                      : 128 + WTERMSIG(status);
    return done;
}

void abuse_forget(outcome *done)
{
    free(done->out);
    free(done->err);
}

/* ---- What must hold -----------------------------------------------------------------------------
 */

/* The last line of standard error is the message; a mismatch prints its report first. */
static bool says_one_line(const char *err)
{
    const size_t length = strlen(err);
    const char *end = strchr(err, '\n');
    return strncmp(err, "glint", 5) == 0 && end == err + length - 1;
}

void abuse_expect_sane(const outcome *done, const char *command_line)
{
    if (done->status < 0 || done->status > 2 || done->survived ||
        (done->status != 0 && done->err[0] != '\0' && !says_one_line(done->err))) {
        fail_msg("%s: exit status %d%s, standard error \"%s\"", command_line, done->status,
                 done->survived ? ", processes left behind" : "", done->err);
    }
}

void abuse_expect_failure(const outcome *done, const char *command_line, int status,
                          const char *part)
{
    abuse_expect_sane(done, command_line);
    if (done->status != status || !says_one_line(done->err) || strstr(done->err, part) == NULL) {
        fail_msg("%s: exit status %d, standard error \"%s\"; expected %d and \"%s\"", command_line,
                 done->status, done->err, status, part);
    }
}

static bool ends_with(const char *name, const char *ending)
{
    const size_t length = strlen(name), tail = strlen(ending);
    return length >= tail && strcmp(name + length - tail, ending) == 0;
}

static bool is_picture(const char *path)
{
    glint_image *image;
    const bool whole = glint_image_read_png(path, &image, NULL) == GLINT_OK;
    glint_image_destroy(image);
    return whole;
}

static bool is_json(const char *path)
{
    char *text = scratch_read(path, NULL);
    json_t *json = json_loads(text, JSON_REJECT_DUPLICATES | JSON_DECODE_ANY, NULL);
    free(text);
    json_decref(json);
    return json != NULL;
}

static bool ends_in(const char *path, const char *ending)
{
    char *text = scratch_read(path, NULL);
    const bool found = ends_with(text, ending);
    free(text);
    return found;
}

static bool is_whole(const char *path)
{
    return ends_with(path, ".png")    ? is_picture(path)
           : ends_with(path, ".fst")  ? glint_wave_is_whole(path)
           : ends_with(path, ".json") ? is_json(path)
           : ends_with(path, ".html") ? ends_in(path, "</html>\n")
                                      : true;
}

/* nftw() has no argument to hand on. */
static struct {
    bool in_the_making;
    int count;
    char bad[1024];
} walk;

static int look_at(const char *path, const struct stat *info, int type, struct FTW *place)
{
    const bool making = strstr(path + place->base, ".tmp") != NULL || strstr(path, ".tmp/") != NULL;
    walk.count += type == FTW_F;
    if (making ? !walk.in_the_making : type == FTW_F && (info->st_size == 0 || !is_whole(path)))
        (void)snprintf(walk.bad, sizeof walk.bad, "%s", path);
    return 0;
}

int abuse_expect_whole(const char *directory, bool in_the_making)
{
    walk.in_the_making = in_the_making;
    walk.count = 0;
    walk.bad[0] = '\0';
    assert_int_equal(nftw(directory, look_at, 8, FTW_PHYS), 0);
    if (walk.bad[0] != '\0')
        fail_msg("left behind, or not whole: %s", walk.bad);
    return walk.count;
}

/* ---- The counts ---------------------------------------------------------------------------------
 */

static bool is_documented(const char *text, const char *heading, int count)
{
    char row[256];
    (void)snprintf(row, sizeof row, "| %s | %d |", heading, count);
    return strstr(text, row) != NULL;
}

void abuse_expect_documented(const char *name, const char *what, int tests)
{
    char full[64];
    int total = 0, missing = 0;
    if (tests_ended != tests) {
        print_message("%d of %d tests did not come to their end: the counts are not all there\n",
                      tests - tests_ended, tests);
        skip();
    }
    char *text = scratch_read("docs/abuse.md", NULL);
    for (int i = 0; i < heading_count; i++) {
        const bool good = is_documented(text, headings[i].name, headings[i].count);
        print_message("| %s | %d |%s\n", headings[i].name, headings[i].count,
                      good ? "" : "  <- not so in docs/abuse.md");
        total += headings[i].count;
        missing += !good;
    }
    free(text);
    assert_int_equal(missing, 0);
    assert_true(total > 0);
    (void)snprintf(full, sizeof full, "abuse-%s", name);
    record(full, what, "running the command, checking its output and files", (uint64_t)total,
           "runs", child_seconds() - begun);
}
