#define _POSIX_C_SOURCE 200809L

#include "file/directory.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

static int is_directory(const char *path)
{
    struct stat found;
    return stat(path, &found) == 0 && S_ISDIR(found.st_mode);
}

/* Makes each component of path in turn; path is written to and restored. */
static int make_components(char *path)
{
    for (char *slash = path + 1; (slash = strchr(slash, '/')) != NULL; slash++) {
        *slash = '\0';
        int failed = mkdir(path, 0777) != 0 && !is_directory(path);
        *slash = '/';
        if (failed)
            return -1;
    }
    return mkdir(path, 0777) != 0 && !is_directory(path) ? -1 : 0;
}

glint_status glint_directory_make(const char *path, glint_error *err)
{
    char *copy = strdup(path);
    if (copy == NULL)
        return glint_fail(err, GLINT_NO_MEMORY, "no memory for a path");
    int failed = make_components(copy);
    int cause = errno;
    free(copy);
    if (failed)
        return glint_fail(err, GLINT_IO_ERROR, "%s: cannot make this directory: %s", path,
                          strerror(cause));
    return GLINT_OK;
}
