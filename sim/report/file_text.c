/* The text of a whole file; see file_text.h. */
#include "report/file_text.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define CHUNK 65536

/* Appends the rest of the stream to the *size bytes already there. */
static glint_status read_all(FILE *stream, char **text, size_t *size)
{
    size_t room = 0, count;
    do {
        if (room - *size < CHUNK + 1) {
            room = 2 * room + CHUNK + 1;
            char *larger = realloc(*text, room);
            if (larger == NULL)
                return GLINT_NO_MEMORY;
            *text = larger;
        }
        count = fread(*text + *size, 1, CHUNK, stream);
        *size += count;
    } while (count == CHUNK);
    (*text)[*size] = '\0';
    return ferror(stream) ? GLINT_IO_ERROR : GLINT_OK;
}

glint_status glint_file_text(const char *path, char **text, size_t *size, glint_error *err)
{
    *text = NULL;
    *size = 0;
    FILE *stream = fopen(path, "rb");
    if (stream == NULL)
        return glint_fail(err, GLINT_IO_ERROR, "%.400s: %s", path, strerror(errno));
    const glint_status status = read_all(stream, text, size);
    const int error = errno;
    fclose(stream);
    if (status == GLINT_OK)
        return GLINT_OK;
    free(*text);
    *text = NULL;
    return glint_fail(err, status, "%.400s: %s", path,
                      status == GLINT_NO_MEMORY ? "out of memory" : strerror(error));
}
