/* Lines of values on standard input, as `glint eval` and `glint divide` read them. */
#ifndef GLINT_SIM_CLI_INPUT_H
#define GLINT_SIM_CLI_INPUT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "glint_status.h"

typedef enum glint_line_kind {
    GLINT_LINE_VALUES,
    GLINT_LINE_NOTHING, /* blank, or a comment: its first non-blank character is # */
    GLINT_LINE_MALFORMED,
} glint_line_kind;

/* A value on each line, with the names a header may use for it; other: NULL if there is only
 * one. */
typedef struct glint_column {
    const char *name, *other;
} glint_column;

/* What the lines hold: at first {0}. The first line that is neither blank nor a comment may be a
 * header, which starts with a letter: then every later line has a value for each of its names, and
 * unwanted columns are ignored. This lets commands read their own CSV output. Without a header,
 * lines hold the wanted values in order. */
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
    int optional;       /* the last of them: only where a header names them, else NULL */
} glint_line_form;

/* Cuts a line of the given length, with or without its line end (LF or CRLF), into the values of
 * the form. Values are separated by blanks, by a comma, or by a comma with blanks around it. The
 * line is modified, and value[] points into it. GLINT_LINE_NOTHING also covers a header.
 * GLINT_LINE_MALFORMED: err says what is wrong with it. */
glint_line_kind glint_line_cut(const glint_line_form *form, glint_columns *columns, char *line,
                               size_t length, char **value, glint_error *err);

/* `name: "text" is not expected`, for a value that cannot be read. */
glint_line_kind glint_line_refuse(const char *name, const char *text, const char *expected,
                                  glint_error *err);

/* Handles the line of the given number, from 1; returns an exit status (output.h). line NULL: end
 * of input, time to answer what was read. */
typedef int glint_line_taker(void *context, uint64_t number, char *line, size_t length);

/* Passes on the lines of standard input until the end or until the handler does not return
 * GLINT_EXIT_OK, then NULL if all were accepted, even after a read error or an interrupt, which is
 * reported afterwards. A line of 16 MB or more is passed on truncated, for glint_line_cut() to
 * reject. If standard input is a terminal, first prints on standard error what it is waiting for:
 * `waits_for` ("points: n cos r g b"). */
int glint_input_lines(const char *command, const char *waits_for, glint_line_taker *take,
                      void *context);

#endif
