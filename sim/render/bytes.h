/* A growable byte buffer. */
#ifndef GLINT_SIM_RENDER_BYTES_H
#define GLINT_SIM_RENDER_BYTES_H

#include <stdbool.h>
#include <stddef.h>

typedef struct glint_bytes {
    char *at; /* NULL while there are none */
    size_t count, room;
    bool failed; /* out of memory: something is missing */
} glint_bytes;

/* Appends room for `count` bytes and returns it; NULL when out of memory. */
char *glint_bytes_more(glint_bytes *bytes, size_t count);

void glint_bytes_add(glint_bytes *bytes, const void *from, size_t count);

/* Makes it empty and gives the memory back. */
void glint_bytes_free(glint_bytes *bytes);

#endif
