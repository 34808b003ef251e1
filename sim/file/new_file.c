/* A file that appears whole or not at all; see new_file.h. */
#define _GNU_SOURCE /* O_TMPFILE */

#include "file/new_file.h"

#include <errno.h>
#include <fcntl.h>
#include <stdbool.h>
#include <stdio_ext.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include "file/target.h"
#include "file/temporary.h"

#define WAIT_MILLISECONDS 50

struct glint_new_file {
    char *target;    /* its final name */
    char *temporary; /* its temporary name; NULL: none, or the target itself */
    int unnamed;     /* the descriptor of a file without a name; -1: it has one */
    FILE *stream;
    mode_t mode; /* permissions to keep; 0: a new file's */
};

static glint_status cannot_write(const char *path, int reason, glint_error *err)
{
    return glint_fail(err, reason == ENOMEM ? GLINT_NO_MEMORY : GLINT_IO_ERROR,
                      "cannot write %.400s: %s", path, strerror(reason));
}

static void free_file(glint_new_file *file)
{
    if (file->unnamed >= 0)
        close(file->unnamed);
    free(file->target);
    free(file->temporary);
    free(file);
}

/* What already exists at the path. */
typedef enum target_kind {
    REPLACED, /* a regular file, or nothing */
    DIRECT,   /* a device: written to as it is */
    PIPE,     /* the same, once somebody reads it */
} target_kind;

/* Fills target, mode and how the target is to be written. Returns 0 or an errno. */
static int look_at_target(const char *path, glint_new_file *file, target_kind *kind)
{
    struct stat existing;
    *kind = REPLACED;
    if (stat(path, &existing) != 0) {
        if (errno != ENOENT)
            return errno;
        return glint_target_follow(path, &file->target); /* a link that leads to nothing yet */
    }
    if (S_ISDIR(existing.st_mode))
        return EISDIR;
    /* A rename would replace a file that its owner made read-only. */
    if (access(path, W_OK) != 0)
        return errno;
    *kind = S_ISREG(existing.st_mode) ? REPLACED : S_ISFIFO(existing.st_mode) ? PIPE : DIRECT;
    file->mode = existing.st_mode & 07777;
    if (*kind == REPLACED)
        return glint_target_follow(path, &file->target);
    file->target = strdup(path);
    return file->target != NULL ? 0 : ENOMEM;
}

/* Creates a file of a name not yet taken in the target's directory. Not mkstemp(): that gives the
 * file permissions for its owner only. Returns the descriptor, or -1 with errno. */
static int create_beside(glint_new_file *file)
{
    for (int attempt = 0; attempt < GLINT_TEMPORARY_FILES; attempt++) {
        file->temporary = glint_temporary_name(file->target, attempt);
        const int fd = file->temporary != NULL
                           ? open(file->temporary, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666)
                           : -1;
        if (fd >= 0)
            return fd;
        const int reason = errno;
        free(file->temporary);
        file->temporary = NULL; /* nothing to remove */
        errno = reason;
        if (reason != EEXIST)
            break;
    }
    return -1;
}

/* How a file without a name is named for linkat(). */
static void path_of_descriptor(int fd, char path[64])
{
    (void)snprintf(path, 64, "/proc/self/fd/%d", fd);
}

/* Creates a file without a name in the target's directory: killed, a process leaves nothing. Not
 * every file system has them, and without /proc they could get no name later. Returns the
 * descriptor, or -1. */
static int create_unnamed(const glint_new_file *file)
{
    char path[64];
    const char *slash = strrchr(file->target, '/');
    char *directory =
        slash != NULL ? strndup(file->target, (size_t)(slash - file->target) + 1) : strdup(".");
    const int fd = directory != NULL ? open(directory, O_TMPFILE | O_WRONLY | O_CLOEXEC, 0666) : -1;
    free(directory);
    path_of_descriptor(fd, path);
    if (fd >= 0 && access(path, F_OK) != 0) {
        close(fd);
        return -1;
    }
    return fd;
}

static int create(glint_new_file *file)
{
    glint_temporary_sweep(file->target);
    file->unnamed = create_unnamed(file);
    /* The stream's own descriptor, as the file has to outlive the stream. */
    return file->unnamed >= 0 ? fcntl(file->unnamed, F_DUPFD_CLOEXEC, 0) : create_beside(file);
}

/* Opens a pipe once it has a reader; a plain open would wait for one forever. Returns the
 * descriptor, or -1 with errno: ENXIO if no reader appeared, EINTR if *stop became true. */
static int open_pipe(const char *path, const volatile bool *stop)
{
    const struct timespec pause = {0, WAIT_MILLISECONDS * 1000000L};
    const int attempts = GLINT_NEW_FILE_PATIENCE * 1000 / WAIT_MILLISECONDS;
    int fd = open(path, O_WRONLY | O_NONBLOCK | O_CLOEXEC);
    for (int i = 0; fd < 0 && errno == ENXIO && i < attempts; i++) {
        if (stop != NULL && *stop) {
            errno = EINTR;
            return -1;
        }
        (void)nanosleep(&pause, NULL);
        fd = open(path, O_WRONLY | O_NONBLOCK | O_CLOEXEC);
    }
    if (fd >= 0)
        (void)fcntl(fd, F_SETFL, fcntl(fd, F_GETFL) & ~O_NONBLOCK);
    return fd;
}

/* Returns 0 or an errno. */
static int open_stream(glint_new_file *file, target_kind kind, const volatile bool *stop)
{
    const int fd = kind == PIPE     ? open_pipe(file->target, stop)
                   : kind == DIRECT ? open(file->target, O_WRONLY | O_CLOEXEC)
                                    : create(file);
    if (fd < 0)
        return errno;
    if (kind == REPLACED && file->mode != 0 && fchmod(fd, file->mode) != 0) {
        const int reason = errno;
        close(fd);
        return reason;
    }
    file->stream = fdopen(fd, "wb");
    if (file->stream == NULL) {
        const int reason = errno;
        close(fd);
        return reason;
    }
    return 0;
}

static glint_status cannot_open(const char *path, target_kind kind, int reason,
                                const volatile bool *stop, glint_error *err)
{
    if (stop != NULL && *stop)
        return glint_fail(err, GLINT_INTERRUPTED, "interrupted");
    if (kind == PIPE && reason == ENXIO) {
        return glint_fail(err, GLINT_IO_ERROR,
                          "cannot write %.400s: it is a pipe, and no reader opened it within %d s",
                          path, GLINT_NEW_FILE_PATIENCE);
    }
    return cannot_write(path, reason, err);
}

glint_status glint_new_file_open_until(const char *path, const volatile bool *stop,
                                       glint_new_file **file, glint_error *err)
{
    *file = NULL;
    glint_new_file *made = calloc(1, sizeof *made);
    if (made == NULL)
        return cannot_write(path, ENOMEM, err);
    made->unnamed = -1;
    target_kind kind;
    int reason = look_at_target(path, made, &kind);
    if (reason == 0)
        reason = open_stream(made, kind, stop);
    if (reason != 0) {
        glint_new_file_discard(made);
        return cannot_open(path, kind, reason, stop, err);
    }
    *file = made;
    return GLINT_OK;
}

glint_status glint_new_file_open(const char *path, glint_new_file **file, glint_error *err)
{
    return glint_new_file_open_until(path, NULL, file, err);
}

FILE *glint_new_file_stream(const glint_new_file *file)
{
    return file->stream;
}

/* Closes the stream and discards its buffer: writing it to a pipe without a reader would block
 * forever. Returns 0 or an errno. */
static int drop_stream(glint_new_file *file)
{
    __fpurge(file->stream);
    const int reason = fclose(file->stream) == 0 ? 0 : errno;
    file->stream = NULL;
    return reason;
}

/* Closes the stream if it is open. Returns 0, or the errno of a failed write. */
static int close_stream(glint_new_file *file)
{
    if (file->stream == NULL)
        return 0;
    errno = 0;
    bool whole = fflush(file->stream) == 0 && !ferror(file->stream);
    int reason = errno;
    const int at_the_end = drop_stream(file); /* it is flushed, or cannot be */
    if (at_the_end != 0) {
        whole = false;
        reason = reason != 0 ? reason : at_the_end;
    }
    return whole ? 0 : (reason != 0 ? reason : EIO);
}

glint_status glint_new_file_close(glint_new_file *file, glint_error *err)
{
    const int reason = close_stream(file);
    if (reason == 0)
        return GLINT_OK;
    const glint_status status = cannot_write(file->target, reason, err);
    glint_new_file_discard(file);
    return status;
}

/* Gives an unnamed file a free temporary name next to the target. Returns 0 or an errno. */
static int name_beside(glint_new_file *file, const char *from)
{
    int reason = EEXIST;
    for (int attempt = 0; attempt < GLINT_TEMPORARY_FILES && reason == EEXIST; attempt++) {
        file->temporary = glint_temporary_name(file->target, attempt);
        if (file->temporary == NULL)
            return ENOMEM;
        reason =
            linkat(AT_FDCWD, from, AT_FDCWD, file->temporary, AT_SYMLINK_FOLLOW) == 0 ? 0 : errno;
        if (reason != 0) {
            free(file->temporary);
            file->temporary = NULL;
        }
    }
    return reason;
}

/* Returns 0 or an errno. linkat() replaces nothing: where something has the name, the file gets
 * another one first, for the moment until rename(). */
static int take_name(glint_new_file *file)
{
    if (file->unnamed >= 0) {
        char from[64];
        path_of_descriptor(file->unnamed, from);
        if (linkat(AT_FDCWD, from, AT_FDCWD, file->target, AT_SYMLINK_FOLLOW) == 0)
            return 0;
        const int reason = errno == EEXIST ? name_beside(file, from) : errno;
        if (reason != 0)
            return reason;
    }
    return file->temporary == NULL || rename(file->temporary, file->target) == 0 ? 0 : errno;
}

glint_status glint_new_file_commit(glint_new_file *file, glint_error *err)
{
    int reason = close_stream(file);
    if (reason == 0)
        reason = take_name(file);
    glint_status status = GLINT_OK;
    if (reason != 0) {
        status = cannot_write(file->target, reason, err);
        glint_new_file_discard(file);
    } else {
        free_file(file);
    }
    return status;
}

void glint_new_file_discard(glint_new_file *file)
{
    if (file == NULL)
        return;
    if (file->stream != NULL)
        (void)drop_stream(file);
    if (file->temporary != NULL)
        unlink(file->temporary);
    free_file(file);
}

glint_status glint_new_file_check(const char *path, glint_error *err)
{
    glint_new_file probe = {0};
    target_kind kind;
    int reason = look_at_target(path, &probe, &kind);
    free(probe.target);
    if (reason != 0)
        return cannot_write(path, reason, err);
    if (kind != REPLACED)
        return GLINT_OK; /* to a pipe's reader, opening and closing it would be the end */
    glint_new_file *file;
    const glint_status status = glint_new_file_open(path, &file, err);
    glint_new_file_discard(file);
    return status;
}
