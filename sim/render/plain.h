/* Valid or nearly valid files that assimp 5.2 misreads, rejects with a misleading message, or hangs
 * on are converted to a plainer form before assimp sees them.
 *
 * Each function below scans a whole file. If nothing needs fixing, `plain` stays empty and assimp
 * gets the file as it is. Unreadable content is GLINT_BAD_INPUT, with the line number for text
 * formats; readable content that does not become triangles gets a remark. */
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

/* Where a text begins after its byte order mark. UTF-16 is GLINT_BAD_INPUT. */
glint_status glint_plain_begin(const glint_text *text, size_t *begin, glint_error *err);

/* The line number, from 1, of a place in the text; lines end with \n, \r or \r\n. */
size_t glint_plain_line(const glint_text *text, const char *place);

/* A decimal number that fills a whole word; false otherwise. */
bool glint_plain_number(const char *word, size_t length, double *value);

/* Remarks on statements with unknown keywords: the first one and its line. */
void glint_plain_unknown(glint_remarks *remarks, size_t line, glint_word first, size_t count);

glint_status glint_plain_no_memory(const glint_text *text, glint_error *err);

#endif
