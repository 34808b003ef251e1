/* Lines of values on standard input, as `glint eval` and `glint divide` read them. */
#ifndef GLINT_SIM_CLI_INPUT_H
#define GLINT_SIM_CLI_INPUT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "glint_status.h"

typedef enum glint_line_kind {
    GLINT_LINE_VALUES,
    GLINT_LINE_NOTHING, /* blank, or a comment: the first character that is no blank is # */
    GLINT_LINE_MALFORMED,
} glint_line_kind;

/* A value that each line has, by the names that a header may call it; other: NULL for one only. */
typedef struct glint_column {
    const char *name, *other;
} glint_column;

/* What the lines hold: at first {0}. The first line that is not blank and no comment may be a
 * header, which a letter begins: then each further line has a value for each of its names, and
 * those that are not asked for are passed over. So what a command has printed as CSV is read
 * again. Without a header the values are those asked for, in their order. */
#define GLINT_COLUMNS_MAX 128
typedef struct glint_columns {
    bool begun;
    int width; /* values a line; 0: no header */
    int at[GLINT_COLUMNS_MAX];
    bool is_other[GLINT_COLUMNS_MAX];
} glint_columns;

/* What a subcommand reads from its lines. */
typedef struct glint_line_form {
    const glint_column *column;
    int count;          /* at most GLINT_COLUMNS_MAX */
    const char *values; /* what messages call them: "the two values difference k" */
} glint_line_form;

/* Cuts a line of the given length, with or without its line end (LF or CRLF), into the values of
 * the form. They stand apart by blanks, by a comma, or by a comma with blanks around it. The line
 * is altered; value[] points into it. GLINT_LINE_NOTHING: it was a header, too.
 * GLINT_LINE_MALFORMED: err says what is wrong with it. */
glint_line_kind glint_line_cut(const glint_line_form *form, glint_columns *columns, char *line,
                               size_t length, char **value, glint_error *err);

/* `name: "text" is not expected`, for a value that cannot be read. */
glint_line_kind glint_line_refuse(const char *name, const char *text, const char *expected,
                                  glint_error *err);

/* Takes a line (see above) of the given number, from 1; returns an exit status (output.h). line
 * NULL: no further line comes, and what was read is to be answered. */
typedef int glint_line_taker(void *context, uint64_t number, char *line, size_t length);

/* Hands over the lines of standard input until their end or until one is not taken with
 * GLINT_EXIT_OK, and then NULL when all were taken, also when the input cannot be read any further
 * or it was interrupted; says so after that. A line of 16 MB or more is handed over cut, for
 * glint_line_cut() to refuse. Where standard input is a terminal, standard error is told first what
 * is waited for: `waits_for` ("points: n cos r g b"). */
int glint_input_lines(const char *command, const char *waits_for, glint_line_taker *take,
                      void *context);

#endif
