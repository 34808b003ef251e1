/* A growable byte buffer. */
#include "render/bytes.h"

#include <stdlib.h>
#include <string.h>

/* Grows by half each time; the pages of unused room are never touched. */
static bool make_room(glint_bytes *bytes, size_t count)
{
    if (bytes->failed || count > (size_t)-1 / 2 - bytes->count)
        return false;
    if (count <= bytes->room - bytes->count)
        return true;
    const size_t room = bytes->count + count + bytes->count / 2 + 4096;
    char *at = realloc(bytes->at, room);
    if (at == NULL)
        return false;
    bytes->at = at;
    bytes->room = room;
    return true;
}

char *glint_bytes_more(glint_bytes *bytes, size_t count)
{
    if (!make_room(bytes, count)) {
        bytes->failed = true;
        return NULL;
    }
    char *more = bytes->at + bytes->count;
    bytes->count += count;
    return more;
}

void glint_bytes_add(glint_bytes *bytes, const void *from, size_t count)
{
    char *to = count > 0 ? glint_bytes_more(bytes, count) : NULL;
    if (to != NULL)
        memcpy(to, from, count);
}

void glint_bytes_free(glint_bytes *bytes)
{
    free(bytes->at);
    *bytes = (glint_bytes){0};
}
