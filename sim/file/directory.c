/* mkdir -p. */
#define _POSIX_C_SOURCE 200809L

#include "file/directory.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

/* Creates one directory. Returns the cause of a failure, or 0 if it exists afterwards. */
static int make_one(const char *path)
{
    struct stat found;
    if (mkdir(path, 0777) == 0)
        return 0;
    const int cause = errno; /* stat() sets it too */
    if (cause == EEXIST && stat(path, &found) == 0)
        return S_ISDIR(found.st_mode) ? 0 : ENOTDIR;
    return cause;
}

/* Makes each component of path in turn; path is written to and restored. Returns the
 * cause of the first failure, 0 for none. */
static int make_components(char *path)
{
    for (char *slash = path + 1; (slash = strchr(slash, '/')) != NULL; slash++) {
        *slash = '\0';
        const int cause = make_one(path);
        *slash = '/';
        if (cause != 0)
            return cause;
    }
    return make_one(path);
}

glint_status glint_directory_make(const char *path, glint_error *err)
{
    char *copy = strdup(path);
    if (copy == NULL)
        return glint_fail(err, GLINT_NO_MEMORY, "not enough memory for a path");
    const int cause = make_components(copy);
    free(copy);
    if (cause != 0)
        return glint_fail(err, GLINT_IO_ERROR, "%s: cannot create this directory: %s", path,
                          strerror(cause));
    return GLINT_OK;
}
