/* What a mesh leaves out of its file: one line for the caller. */
#ifndef GLINT_SIM_RENDER_REMARKS_H
#define GLINT_SIM_RENDER_REMARKS_H

#include <stddef.h>

#include "render/mesh.h"

typedef struct glint_remarks {
    char text[GLINT_MESH_REMARKS]; /* "" while there is nothing to say */
} glint_remarks;

/* Appends one, separated by a semicolon; text that does not fit is dropped. */
void glint_remark(glint_remarks *remarks, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* "12 lines left out", "1 line left out": nothing for a count of 0. */
void glint_remark_count(glint_remarks *remarks, size_t count, const char *one, const char *several);

/* A word from a file, safe for a message: unprintable characters become '?', and a long word is
 * cut. */
typedef struct glint_word {
    char text[64];
} glint_word;

glint_word glint_word_of(const char *text, size_t length);

#endif
