/* The sources of a circuit as read, so that exactly what was hashed is built even if a file is
 * edited meanwhile. */
#ifndef GLINT_SIM_RTL_SOURCES_H
#define GLINT_SIM_RTL_SOURCES_H

#include <stdbool.h>
#include <stddef.h>

#include "glint_status.h"

typedef struct glint_source {
    char *name; /* without directory; of data, as the Verilog calls it */
    char *text;
    size_t size;
    bool is_library; /* Verilog with modules of other names than its own (needed.h) */
    int package;  /* 1, 2, …: Verilog with packages, to be read in that order, first; 0: none */
    bool is_data; /* not Verilog, but what it reads (data.h) */
} glint_source;

typedef struct glint_sources {
    glint_source *file;
    int count;
} glint_sources;

/* Adds every file of a directory whose name has one of these endings (".v", …; the last NULL), by
 * name. GLINT_IO_ERROR, naming it, if there is none or one is unreadable. */
glint_status glint_sources_read(glint_sources *sources, const char *directory,
                                const char *const *endings, glint_error *err);

/* Adds one file; adds generated text as a file. */
glint_status glint_sources_read_file(glint_sources *sources, const char *directory,
                                     const char *name, glint_error *err);
glint_status glint_sources_add(glint_sources *sources, const char *name, const char *text,
                               size_t size, glint_error *err);

/* Writes them, but for data, into a directory. */
glint_status glint_sources_write(const glint_sources *sources, const char *directory,
                                 glint_error *err);

/* Whether some file declares a port of that name as inout, as far as its text tells. */
bool glint_sources_have_inout(const glint_sources *sources, const char *port);

/* One file of a directory, without a list. The text read ends with a NUL and is to be freed; NULL
 * with a failure. */
glint_status glint_text_read(const char *directory, const char *name, char **text, size_t *size,
                             glint_error *err);
glint_status glint_text_write(const char *directory, const char *name, const char *text,
                              size_t size, glint_error *err);

void glint_sources_free(glint_sources *sources);

/* A hash over names and texts, and one over bytes: SHA-256, its first 80 bits in hex. */
#define GLINT_HASH_TEXT 21
void glint_sources_hash(const glint_sources *sources, char text[GLINT_HASH_TEXT]);
void glint_hash_bytes(const void *what, size_t size, char text[GLINT_HASH_TEXT]);

#endif
