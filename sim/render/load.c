/* Mesh files, read in a process of their own; see load.h.
 *
 * assimp 5.2 has faults that damaged files reach: invalid accesses, exceptions that nobody catches,
 * loops over as many elements as a header claims. In a child process they are an error like any
 * other. What the child sends back is checked again, as its memory may have been damaged. */
#define _DEFAULT_SOURCE

#include "render/load.h"

#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "render/import.h"
#include "render/mesh_build.h"

#define POLL_MILLISECONDS 50

/* What the child sends first; the mesh's three arrays follow when status is GLINT_OK. */
typedef struct answer {
    glint_status status;
    size_t vertices, triangles;
    char remarks[GLINT_MESH_REMARKS];
    glint_error err;
} answer;

/* The reading side. */
typedef struct reader {
    const char *path;
    const volatile bool *stop;
    pid_t child;
    int pipe;
    double left; /* of the time it may take, seconds */
    glint_error *err;
} reader;

/* ---- The child ---------------------------------------------------------------------------------
 */

static bool send_bytes(int pipe, const void *bytes, size_t count)
{
    const char *next = bytes;
    while (count > 0) {
        const ssize_t sent = write(pipe, next, count);
        if (sent < 0) {
            if (errno == EINTR)
                continue;
            return false;
        }
        next += sent;
        count -= (size_t)sent;
    }
    return true;
}

static void limit(__rlimit_resource_t resource, rlim_t value)
{
    struct rlimit bound;
    if (getrlimit(resource, &bound) == 0 && value < bound.rlim_max) {
        bound.rlim_cur = value;
        (void)setrlimit(resource, &bound);
    }
}

/* Address space in use, bytes; 0 if unknown. */
static rlim_t address_space(void)
{
    unsigned long long pages = 0;
    FILE *file = fopen("/proc/self/statm", "r");
    if (file != NULL) {
        if (fscanf(file, "%llu", &pages) != 1)
            pages = 0;
        (void)fclose(file);
    }
    return (rlim_t)pages * (rlim_t)sysconf(_SC_PAGESIZE);
}

/* What a crash does is not left to handlers that the caller has installed for himself: they would
 * carry on here, as a second caller. Ctrl-C, which reaches both, is the parent's to answer. */
static void reset_signals(void)
{
    static const int deadly[] = {SIGSEGV, SIGBUS, SIGFPE,  SIGILL,
                                 SIGABRT, SIGSYS, SIGTRAP, SIGPIPE};
    for (size_t i = 0; i < sizeof deadly / sizeof deadly[0]; i++)
        (void)signal(deadly[i], SIG_DFL);
    (void)signal(SIGINT, SIG_IGN);
    (void)signal(SIGTERM, SIG_IGN);
    (void)signal(SIGHUP, SIG_IGN);
}

/* Only the parent learns what happens here: no messages, no core file, and the child dies with its
 * parent. */
static void confine(const glint_load_limits *limits, pid_t parent)
{
    (void)prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent)
        _exit(1);
    const int null = open("/dev/null", O_RDWR);
    if (null >= 0) {
        (void)dup2(null, STDOUT_FILENO);
        (void)dup2(null, STDERR_FILENO);
    }
    reset_signals();
    const rlim_t used = address_space();
    limit(RLIMIT_CORE, 0);
    if (used != 0)
        limit(RLIMIT_AS, used + limits->bytes);
}

/* _exit(): what the parent has in its streams and handlers is the parent's. */
static _Noreturn void be_child(const char *path, const glint_load_limits *limits, pid_t parent,
                               int pipe)
{
    glint_mesh *mesh = NULL;
    answer a = {.status = GLINT_OK};
    confine(limits, parent);
    a.status = glint_mesh_import(path, &mesh, &a.err);
    if (a.status == GLINT_OK) {
        a.vertices = mesh->vertex_count;
        a.triangles = mesh->triangle_count;
        memcpy(a.remarks, mesh->remarks, sizeof a.remarks);
    }
    bool sent = send_bytes(pipe, &a, sizeof a);
    if (sent && a.status == GLINT_OK) {
        sent = send_bytes(pipe, mesh->position, a.vertices * 3 * sizeof *mesh->position) &&
               send_bytes(pipe, mesh->normal, a.vertices * 3 * sizeof *mesh->normal) &&
               send_bytes(pipe, mesh->index, a.triangles * 3 * sizeof *mesh->index);
    }
    _exit(sent ? 0 : 1);
}

/* ---- The parent --------------------------------------------------------------------------------
 */

static double now(void)
{
    struct timespec time;
    (void)clock_gettime(CLOCK_MONOTONIC, &time);
    return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

/* Waits a moment for the child. A wait counts as no longer than twice what it should last: it does
 * not while this process is stopped, which the child is, too. */
static bool is_ready(reader *from)
{
    struct pollfd ready = {.fd = from->pipe, .events = POLLIN};
    const double start = now();
    const bool is = poll(&ready, 1, POLL_MILLISECONDS) > 0;
    from->left -= fmin(now() - start, 2e-3 * POLL_MILLISECONDS);
    return is;
}

/* GLINT_BAD_INPUT if the child stops sending or runs out of time. */
static glint_status receive(reader *from, void *bytes, size_t count)
{
    char *next = bytes;
    while (count > 0) {
        if (from->stop != NULL && *from->stop)
            return glint_fail(from->err, GLINT_INTERRUPTED, "interrupted");
        if (from->left <= 0.0)
            return GLINT_BAD_INPUT;
        if (!is_ready(from))
            continue;
        const ssize_t got = read(from->pipe, next, count);
        if (got == 0 || (got < 0 && errno != EINTR))
            return GLINT_BAD_INPUT;
        if (got > 0) {
            next += got;
            count -= (size_t)got;
        }
    }
    return GLINT_OK;
}

static bool all_finite(const float *value, size_t count)
{
    for (size_t i = 0; i < count; i++)
        if (!isfinite(value[i]))
            return false;
    return true;
}

/* What mesh.h promises, as far as the rasterizer's memory depends on it. */
static bool is_sound(const glint_mesh *mesh)
{
    for (size_t i = 0; i < 3 * mesh->triangle_count; i++)
        if (mesh->index[i] >= mesh->vertex_count)
            return false;
    return all_finite(mesh->position, 3 * mesh->vertex_count) &&
           all_finite(mesh->normal, 3 * mesh->vertex_count);
}

static glint_status receive_arrays(reader *from, const answer *a, glint_mesh *mesh)
{
    mesh->vertex_count = a->vertices;
    mesh->triangle_count = a->triangles;
    glint_status status = receive(from, mesh->position, a->vertices * 3 * sizeof *mesh->position);
    if (status == GLINT_OK)
        status = receive(from, mesh->normal, a->vertices * 3 * sizeof *mesh->normal);
    if (status == GLINT_OK)
        status = receive(from, mesh->index, a->triangles * 3 * sizeof *mesh->index);
    return status != GLINT_OK || is_sound(mesh) ? status : GLINT_BAD_INPUT;
}

/* *refused: the child itself reported why there is no mesh. */
static glint_status receive_mesh(reader *from, bool *refused, glint_mesh **mesh)
{
    answer a;
    *refused = false;
    glint_status status = receive(from, &a, sizeof a);
    if (status != GLINT_OK)
        return status;
    if (a.status == GLINT_BAD_INPUT || a.status == GLINT_IO_ERROR || a.status == GLINT_NO_MEMORY) {
        a.err.text[sizeof a.err.text - 1] = '\0';
        *refused = true;
        return glint_fail(from->err, a.status, "%s", a.err.text);
    }
    if (a.status != GLINT_OK || a.vertices > 3 * GLINT_MESH_TRIANGLES_MAX || a.triangles == 0 ||
        a.triangles > GLINT_MESH_TRIANGLES_MAX)
        return GLINT_BAD_INPUT;
    status = glint_mesh_new(from->path, a.vertices, a.triangles, mesh, from->err);
    if (status != GLINT_OK) {
        *refused = true;
        return status;
    }
    a.remarks[sizeof a.remarks - 1] = '\0';
    memcpy((*mesh)->remarks, a.remarks, sizeof a.remarks);
    status = receive_arrays(from, &a, *mesh);
    if (status != GLINT_OK) {
        glint_mesh_destroy(*mesh);
        *mesh = NULL;
    }
    return status;
}

/* How the child ended; waits for that. */
static int collect(pid_t child)
{
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    return status;
}

/* The child went without a word. */
static glint_status explain(const reader *from, int ended, const glint_load_limits *limits)
{
    if (from->left <= 0.0) {
        return glint_fail(from->err, GLINT_BAD_INPUT,
                          "%.300s: assimp was stopped after %u s without finishing: damaged, or "
                          "not the format its name says",
                          from->path, limits->seconds);
    }
    return glint_fail(from->err, GLINT_BAD_INPUT,
                      "%.300s: assimp crashed (%s): damaged, or not the format its name says",
                      from->path,
                      WIFSIGNALED(ended) ? strsignal(WTERMSIG(ended)) : "its answer is incomplete");
}

static glint_status be_parent(reader *from, const glint_load_limits *limits, glint_mesh **mesh)
{
    bool refused;
    const glint_status status = receive_mesh(from, &refused, mesh);
    if (status == GLINT_INTERRUPTED || from->left <= 0.0)
        (void)kill(from->child, SIGKILL);
    (void)close(from->pipe); /* one that still writes ends by that */
    const int ended = collect(from->child);
    if (status == GLINT_OK || status == GLINT_INTERRUPTED || refused)
        return status;
    if (from->stop != NULL && *from->stop) /* the same signal stopped the child */
        return glint_fail(from->err, GLINT_INTERRUPTED, "interrupted");
    return explain(from, ended, limits);
}

glint_status glint_mesh_load_within(const char *path, const glint_load_limits *limits,
                                    const volatile bool *stop, glint_mesh **mesh, glint_error *err)
{
    int ends[2];
    if (pipe(ends) != 0) {
        return glint_fail(err, GLINT_IO_ERROR, "%.300s: cannot create a pipe to read it: %s", path,
                          strerror(errno));
    }
    const pid_t parent = getpid();
    const pid_t child = fork();
    if (child == 0) {
        (void)close(ends[0]);
        be_child(path, limits, parent, ends[1]);
    }
    const int reason = errno;
    (void)close(ends[1]);
    if (child < 0) {
        (void)close(ends[0]);
        return glint_fail(err, GLINT_IO_ERROR, "%.300s: cannot start a process to read it: %s",
                          path, strerror(reason));
    }
    reader from = {path, stop, child, ends[0], (double)limits->seconds, err};
    return be_parent(&from, limits, mesh);
}

glint_load_limits glint_load_limits_for(size_t file_bytes)
{
    const size_t megabytes = file_bytes >> 20;
    return (glint_load_limits){
        .seconds = megabytes < 1u << 20 ? 5 + 2 * (unsigned)megabytes : 1u << 22,
        .bytes = ((size_t)1 << 30) + (megabytes < 1u << 20 ? 256 * file_bytes : (size_t)256 << 40),
    };
}

static glint_status check_file(const char *path, size_t *bytes, glint_error *err)
{
    struct stat file;
    if (stat(path, &file) != 0 || access(path, R_OK) != 0)
        return glint_fail(err, GLINT_IO_ERROR, "%.400s: %s", path, strerror(errno));
    if (!S_ISREG(file.st_mode))
        return glint_fail(err, GLINT_BAD_INPUT, "%.400s: not a file", path);
    if (file.st_size == 0)
        return glint_fail(err, GLINT_BAD_INPUT, "%.400s: empty file", path);
    *bytes = (size_t)file.st_size;
    return GLINT_OK;
}

glint_status glint_mesh_load(const char *path, const volatile bool *stop, glint_mesh **mesh,
                             glint_error *err)
{
    size_t bytes = 0;
    const glint_status status = check_file(path, &bytes, err);
    if (status != GLINT_OK)
        return status;
    const glint_load_limits limits = glint_load_limits_for(bytes);
    return glint_mesh_load_within(path, &limits, stop, mesh, err);
}
