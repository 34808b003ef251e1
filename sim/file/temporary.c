/* Names for files in progress, and the clean-up of those that a killed process left; see
 * temporary.h. */
#define _XOPEN_SOURCE 700

#include "file/temporary.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/utsname.h>
#include <unistd.h>

/* FNV-1a. */
static uint32_t mix(uint32_t hash, const char *text)
{
    for (; *text != '\0'; text++)
        hash = (hash ^ (unsigned char)*text) * UINT32_C(16777619);
    return hash;
}

/* The machine's name and the space that its process numbers are of. */
static uint32_t host(void)
{
    struct utsname system;
    char space[64];
    const ssize_t length = readlink("/proc/self/ns/pid", space, sizeof space - 1);
    space[length > 0 ? length : 0] = '\0';
    const uint32_t hash = mix(UINT32_C(2166136261), uname(&system) == 0 ? system.nodename : "");
    return mix(hash, space);
}

/* Of the path, with its slash. */
static int directory_length(const char *path)
{
    const char *slash = strrchr(path, '/');
    return slash != NULL ? (int)(slash - path) + 1 : 0;
}

char *glint_temporary_name(const char *target, int attempt)
{
    const int length = directory_length(target);
    const size_t size = (size_t)length + 64;
    char *name = malloc(size);
    if (name != NULL) {
        (void)snprintf(name, size, "%.*s.glint-%08x-%ld-%d.tmp", length, target, (unsigned)host(),
                       (long)getpid(), attempt);
    }
    return name;
}

/* Whether the name is one, and its maker a process of this machine that is gone. */
static bool is_left_behind(const char *name, uint32_t here)
{
    unsigned made_on;
    long process;
    int attempt, end = 0;
    return sscanf(name, ".glint-%8x-%ld-%d.tmp%n", &made_on, &process, &attempt, &end) == 3 &&
           end > 0 && made_on == here && process > 0 && kill((pid_t)process, 0) != 0 &&
           errno == ESRCH;
}

/* A directory in the making holds files only. */
static void empty(int at, const char *name)
{
    const int fd = openat(at, name, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
    DIR *listing = fd >= 0 ? fdopendir(fd) : NULL;
    const struct dirent *entry;
    if (listing == NULL) {
        if (fd >= 0)
            (void)close(fd);
        return;
    }
    while ((entry = readdir(listing)) != NULL)
        (void)unlinkat(fd, entry->d_name, 0); /* "." and ".." refuse */
    (void)closedir(listing);
}

static void remove_left(int at, const char *name)
{
    struct stat info;
    if (fstatat(at, name, &info, AT_SYMLINK_NOFOLLOW) != 0 || info.st_uid != geteuid())
        return;
    if (S_ISDIR(info.st_mode))
        empty(at, name);
    (void)unlinkat(at, name, S_ISDIR(info.st_mode) ? AT_REMOVEDIR : 0);
}

void glint_temporary_sweep(const char *target)
{
    const int length = directory_length(target);
    char *directory = length > 0 ? strndup(target, (size_t)length) : strdup(".");
    DIR *listing = directory != NULL ? opendir(directory) : NULL;
    const uint32_t here = host();
    const struct dirent *entry;
    while (listing != NULL && (entry = readdir(listing)) != NULL)
        if (is_left_behind(entry->d_name, here))
            remove_left(dirfd(listing), entry->d_name);
    if (listing != NULL)
        (void)closedir(listing);
    free(directory);
}
