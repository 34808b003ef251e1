/* What of a file does not get into its mesh: one line for who asked for the mesh. */
#ifndef GLINT_SIM_RENDER_REMARKS_H
#define GLINT_SIM_RENDER_REMARKS_H

#include <stddef.h>

#include "render/mesh.h"

typedef struct glint_remarks {
    char text[GLINT_MESH_REMARKS]; /* "" while there is nothing to say */
} glint_remarks;

/* Puts one more behind the others, with a semicolon between; what there is no room for is lost. */
void glint_remark(glint_remarks *remarks, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* "12 lines left out", "1 line left out": nothing for a count of 0. */
void glint_remark_count(glint_remarks *remarks, size_t count, const char *one, const char *several);

/* A word of a file as it may stand in a message: what cannot be printed is '?', a long one is cut.
 */
typedef struct glint_word {
    char text[64];
} glint_word;

glint_word glint_word_of(const char *text, size_t length);

#endif
