/* Reserves the space with posix_fallocate, then removes the file again. */
#define _POSIX_C_SOURCE 200809L

#include "file/room.h"

#include <errno.h>
#include <fcntl.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

/* Closes the file. A file system without reservations fails with a different errno, which is not a
 * reason to refuse. */
static bool has_room(FILE *file, long bytes)
{
    int why = posix_fallocate(fileno(file), 0, bytes);
    (void)fclose(file);
    errno = why;
    return why != ENOSPC && why != EFBIG && why != EDQUOT && why != EIO;
}

glint_status glint_file_room(const char *path, long bytes, glint_error *err)
{
    FILE *file = fopen(path, "wb");
    if (file == NULL)
        return glint_fail(err, GLINT_IO_ERROR, "cannot write %s: %s", path, strerror(errno));
    bool fits = has_room(file, bytes);
    int why = errno;
    (void)remove(path);
    if (!fits)
        return glint_fail(err, GLINT_IO_ERROR, "cannot write %s: %s", path, strerror(why));
    file = tmpfile();
    if (file == NULL || !has_room(file, bytes))
        return glint_fail(err, GLINT_IO_ERROR,
                          "no space for the temporary files needed to write %s: %s", path,
                          strerror(errno));
    return GLINT_OK;
}
