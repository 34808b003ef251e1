/* Files that are sound, or nearly, and that assimp 5.2 misreads, refuses with words that mislead,
 * or never comes to an end with: each is put into a plainer form before assimp sees it.
 *
 * Each function below looks through the whole text of a file. Where it finds nothing to put right
 * `plain` stays empty: assimp can have the file as it is. What cannot be read is GLINT_BAD_INPUT,
 * with the line where the format has lines; what can be read but does not become triangles gets a
 * remark. */
#ifndef GLINT_SIM_RENDER_PLAIN_H
#define GLINT_SIM_RENDER_PLAIN_H

#include "render/bytes.h"
#include "render/remarks.h"

typedef struct glint_text {
    const char *path; /* for messages */
    const char *at;
    size_t length;
} glint_text;

/* Wavefront .obj as plain .obj: without byte order mark, comments behind a statement, blanks before
 * one, lines that go on, points and lines; numbers as assimp knows them. */
glint_status glint_plain_obj(const glint_text *text, glint_bytes *plain, glint_remarks *remarks,
                             glint_error *err);

/* .stl as binary .stl: text in small letters or capitals, facets without a normal. Of a binary
 * file with bytes behind its last facet, those are cut off. */
glint_status glint_plain_stl(const glint_text *text, glint_bytes *plain, glint_remarks *remarks,
                             glint_error *err);

/* .ply of any kind as binary .ply with nothing but vertices and faces, in this order: triangle
 * strips become faces. */
glint_status glint_plain_ply(const glint_text *text, glint_bytes *plain, glint_remarks *remarks,
                             glint_error *err);

/* Where a text begins behind its byte order mark. UTF-16 is GLINT_BAD_INPUT. */
glint_status glint_plain_begin(const glint_text *text, size_t *begin, glint_error *err);

/* The line, from 1 on, in which a place of the text is; lines end with \n, \r or \r\n. */
size_t glint_plain_line(const glint_text *text, const char *place);

/* A decimal number that is a whole word; false when it is none. */
bool glint_plain_number(const char *word, size_t length, double *value);

/* Remarks on statements that begin with a word the format has not: the first of them and its line.
 */
void glint_plain_unknown(glint_remarks *remarks, size_t line, glint_word first, size_t count);

glint_status glint_plain_no_memory(const glint_text *text, glint_error *err);

#endif
