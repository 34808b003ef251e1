/* Lines of values on standard input, as `glint eval` and `glint divide` read them. */
#ifndef GLINT_SIM_CLI_INPUT_H
#define GLINT_SIM_CLI_INPUT_H

#include <stddef.h>
#include <stdint.h>

#include "glint_status.h"

typedef enum glint_line_kind {
    GLINT_LINE_VALUES,
    GLINT_LINE_NOTHING, /* blank, or a comment: the first character that is no blank is # */
    GLINT_LINE_MALFORMED,
} glint_line_kind;

/* Cuts a line of the given length, with or without its line end (LF or CRLF), into exactly count
 * values. They stand apart by blanks, by a comma, or by a comma with blanks around it. The line is
 * altered; value[] points into it. GLINT_LINE_MALFORMED: err says what is wrong with it, calling
 * the values what `values` does ("the two values difference k"). */
glint_line_kind glint_line_cut(char *line, size_t length, char **value, int count,
                               const char *values, glint_error *err);

/* `name: "text" is not expected`, for a value that cannot be read. */
glint_line_kind glint_line_refuse(const char *name, const char *text, const char *expected,
                                  glint_error *err);

/* Takes a line (see above) of the given number, from 1; returns an exit status (output.h). line
 * NULL: no further line comes, and what was read is to be answered. */
typedef int glint_line_taker(void *context, uint64_t number, char *line, size_t length);

/* Hands over the lines of standard input until their end or until one is not taken with
 * GLINT_EXIT_OK, and then NULL when all were taken, also when the input cannot be read any further
 * or it was interrupted; says so after that. A line of 16 MB or more is handed over cut, for
 * glint_line_cut() to refuse. */
int glint_input_lines(const char *command, glint_line_taker *take, void *context);

#endif
