/* Follows symbolic links one at a time, so that a dangling one still gives its target. */
#define _XOPEN_SOURCE 700

#include "file/target.h"

#include <errno.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* As many as the system follows. */
#define LINKS_MAX 40

/* The path that the link names, which is relative to the link's directory. NULL with errno. */
static char *read_link(const char *link)
{
    char to[PATH_MAX];
    const ssize_t length = readlink(link, to, sizeof to - 1);
    if (length < 0)
        return NULL;
    to[length] = '\0';
    const char *slash = to[0] != '/' ? strrchr(link, '/') : NULL;
    const size_t before = slash != NULL ? (size_t)(slash - link) + 1 : 0;
    char *path = malloc(before + (size_t)length + 1);
    if (path != NULL) {
        memcpy(path, link, before);
        memcpy(path + before, to, (size_t)length + 1);
    }
    return path;
}

int glint_target_follow(const char *path, char **target)
{
    struct stat info;
    char *at = strdup(path);
    for (int links = 0; at != NULL && lstat(at, &info) == 0 && S_ISLNK(info.st_mode); links++) {
        char *next = links < LINKS_MAX ? read_link(at) : NULL;
        const int reason = links < LINKS_MAX ? errno : ELOOP;
        free(at);
        if (next == NULL)
            return reason;
        at = next;
    }
    *target = at;
    return at != NULL ? 0 : ENOMEM;
}
