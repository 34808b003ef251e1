/* Locks, work directories, renames and pruning; see cache.h. */
#define _GNU_SOURCE /* asprintf */

#include "rtl/cache.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include "file/temporary.h"

/* The names of work directories among the temporary ones. */
enum { FIRST_WORK = 2 * GLINT_TEMPORARY_FILES, LAST_WORK = 3 * GLINT_TEMPORARY_FILES };

/* Whether the locked file is still the one of that name: its last holder removed it otherwise. */
static bool is_current(int lock, const char *path)
{
    struct stat held, named;
    return fstat(lock, &held) == 0 && stat(path, &named) == 0 && held.st_ino == named.st_ino &&
           held.st_dev == named.st_dev;
}

static int take(const char *path, int operation)
{
    for (;;) {
        const int lock = open(path, O_RDWR | O_CREAT | O_CLOEXEC, 0666);
        if (lock < 0)
            return -1;
        int failed;
        while ((failed = flock(lock, operation)) != 0 && errno == EINTR)
            ;
        if (failed == 0 && is_current(lock, path))
            return lock;
        const int cause = errno;
        (void)close(lock);
        errno = cause;
        if (failed != 0)
            return -1;
    }
}

int glint_cache_lock(const char *path)
{
    return take(path, LOCK_EX);
}

int glint_cache_try_lock(const char *path)
{
    return take(path, LOCK_EX | LOCK_NB);
}

void glint_cache_unlock(const char *path, int lock)
{
    if (lock < 0)
        return;
    (void)unlink(path);
    (void)close(lock);
}

static glint_status make_work(glint_cache_entry *entry, glint_error *err)
{
    glint_temporary_sweep(entry->path);
    for (int attempt = FIRST_WORK; attempt < LAST_WORK; attempt++) {
        entry->work = glint_temporary_name(entry->path, attempt);
        if (entry->work == NULL)
            return glint_fail(err, GLINT_NO_MEMORY, "not enough memory for a path");
        if (mkdir(entry->work, 0777) == 0)
            return GLINT_OK;
        const int cause = errno;
        free(entry->work);
        entry->work = NULL;
        if (cause != EEXIST)
            return glint_fail(err, GLINT_IO_ERROR, "%s: cannot be created: %s", entry->path,
                              strerror(cause));
    }
    return glint_fail(err, GLINT_IO_ERROR, "%s: cannot be created: too many exist already",
                      entry->path);
}

static glint_status lock_and_make(glint_cache_entry *entry, glint_error *err)
{
    entry->lock = glint_cache_lock(entry->lock_path);
    if (entry->lock < 0)
        return glint_fail(err, GLINT_IO_ERROR, "%s: %s", entry->lock_path, strerror(errno));
    if (access(entry->path, R_OK) == 0) /* while this one waited */
        return GLINT_OK;
    return make_work(entry, err);
}

glint_status glint_cache_open(const char *cache, const char *name, glint_cache_entry *entry,
                              glint_error *err)
{
    *entry = (glint_cache_entry){.lock = -1};
    if (asprintf(&entry->path, "%s/%s", cache, name) < 0)
        entry->path = NULL;
    if (entry->path == NULL || asprintf(&entry->lock_path, "%s.lock", entry->path) < 0) {
        entry->lock_path = NULL;
        glint_cache_close(entry);
        return glint_fail(err, GLINT_NO_MEMORY, "not enough memory for a path");
    }
    if (access(entry->path, R_OK) == 0) {
        glint_cache_touch(entry->path);
        return GLINT_OK;
    }
    const glint_status status = lock_and_make(entry, err);
    if (status != GLINT_OK)
        glint_cache_close(entry);
    return status;
}

glint_status glint_cache_commit(glint_cache_entry *entry, const char *made, glint_error *err)
{
    char *from;
    if (asprintf(&from, "%s/%s", entry->work, made) < 0)
        return glint_fail(err, GLINT_NO_MEMORY, "not enough memory for a path");
    const int failed = rename(from, entry->path);
    const int cause = errno;
    free(from);
    return failed == 0 ? GLINT_OK
                       : glint_fail(err, GLINT_IO_ERROR, "%s: %s", entry->path, strerror(cause));
}

/* A work directory holds files only. */
static void remove_directory(const char *path)
{
    DIR *listing = opendir(path);
    const struct dirent *file;
    while (listing != NULL && (file = readdir(listing)) != NULL)
        (void)unlinkat(dirfd(listing), file->d_name, 0); /* "." and ".." refuse */
    if (listing != NULL)
        (void)closedir(listing);
    (void)rmdir(path);
}

void glint_cache_close(glint_cache_entry *entry)
{
    if (entry->work != NULL)
        remove_directory(entry->work);
    glint_cache_unlock(entry->lock_path, entry->lock);
    free(entry->path);
    free(entry->work);
    free(entry->lock_path);
    *entry = (glint_cache_entry){.lock = -1};
}

static bool is_between(const char *name, const char *begin, const char *end)
{
    const size_t length = strlen(name), first = strlen(begin), last = strlen(end);
    return length >= first + last && strncmp(name, begin, first) == 0 &&
           strcmp(name + length - last, end) == 0;
}

void glint_cache_touch(const char *path)
{
    (void)utimensat(AT_FDCWD, path, NULL, 0);
}

static bool is_older(const struct timespec *a, const struct timespec *b)
{
    return a->tv_sec != b->tv_sec ? a->tv_sec < b->tv_sec : a->tv_nsec < b->tv_nsec;
}

/* How many entries are so, and the one that is first by age: the newest, or the oldest, last used
 * at *time. To be freed. */
static char *first_of(const char *cache, const char *begin, const char *end, bool newest,
                      struct timespec *time, int *count)
{
    DIR *listing = opendir(cache);
    const struct dirent *file;
    struct stat info;
    char *first = NULL;
    *count = 0;
    while (listing != NULL && (file = readdir(listing)) != NULL) {
        if (!is_between(file->d_name, begin, end) ||
            fstatat(dirfd(listing), file->d_name, &info, AT_SYMLINK_NOFOLLOW) != 0)
            continue;
        (*count)++;
        if (first != NULL && is_older(&info.st_mtim, time) == newest)
            continue;
        *time = info.st_mtim;
        free(first);
        if (asprintf(&first, "%s/%s", cache, file->d_name) < 0)
            first = NULL;
    }
    if (listing != NULL)
        (void)closedir(listing);
    return first;
}

char *glint_cache_newest(const char *cache, const char *begin, const char *end)
{
    struct timespec time;
    int count;
    return first_of(cache, begin, end, true, &time, &count);
}

/* Renames a directory first, so that nobody sees half of it. */
static bool remove_entry(const char *path)
{
    if (unlink(path) == 0 || errno == ENOENT)
        return true;
    char *gone = glint_temporary_name(path, LAST_WORK);
    const bool removed = gone != NULL && rename(path, gone) == 0;
    if (removed)
        remove_directory(gone);
    free(gone);
    return removed;
}

void glint_cache_prune(const char *cache, const char *begin, const char *end, int keep, int seconds)
{
    const time_t used_before = time(NULL) - seconds;
    bool goes_on = true;
    while (goes_on) {
        struct timespec used = {0};
        int count;
        char *oldest = first_of(cache, begin, end, false, &used, &count);
        goes_on =
            oldest != NULL && count > keep && used.tv_sec <= used_before && remove_entry(oldest);
        free(oldest);
    }
}
