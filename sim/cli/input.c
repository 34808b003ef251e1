/* Lines of values on standard input; see input.h. */
#define _POSIX_C_SOURCE 200809L

#include "cli/input.h"

#include <errno.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "cli/output.h"
#include "cli/parse.h"

/* A device has lines without end. */
#define LINE_MAX_BYTES ((size_t)16 << 20)

static char *skip_blanks(char *text)
{
    return text + strspn(text, " \t");
}

/* Cuts one value off text: ends it with NUL and moves *text behind the separator. *more: a
 * separator with a comma followed, so another value must too. */
static char *cut_value(char **text, bool *more)
{
    char *value = *text;
    char *end = value + strcspn(value, " \t,");
    char *next = skip_blanks(end);
    *more = *next == ',';
    *text = *more ? skip_blanks(next + 1) : next;
    *end = '\0';
    return value;
}

/* Cuts a line that is not blank into its values; returns how many, count + 1 for more. */
static int cut_values(char *text, char **value, int count)
{
    int found = 0;
    bool more = true;
    while (more || *text != '\0') {
        if (found == count)
            return count + 1;
        value[found++] = cut_value(&text, &more);
    }
    return found;
}

/* Takes the line end off; returns false when a NUL byte is in the line. */
static bool trim(char *line, size_t length)
{
    if (memchr(line, '\0', length) != NULL)
        return false;
    if (length > 0 && line[length - 1] == '\n')
        line[--length] = '\0';
    if (length > 0 && line[length - 1] == '\r')
        line[--length] = '\0';
    return true;
}

/* The value's column in the header; -1 if absent. */
static int find_column(char *const *name, int width, const char *wanted)
{
    for (int i = 0; wanted != NULL && i < width; i++)
        if (strcmp(name[i], wanted) == 0)
            return i;
    return -1;
}

/* Whether a later column has the same name. */
static bool comes_again(char *const *name, int width, int at)
{
    return at >= 0 && find_column(name + at + 1, width - at - 1, name[at]) >= 0;
}

static glint_line_kind read_header(const glint_line_form *form, char *const *name, int width,
                                   glint_columns *columns, glint_error *err)
{
    for (int i = 0; i < form->count; i++) {
        const glint_column *column = &form->column[i];
        columns->at[i] = find_column(name, width, column->name);
        columns->is_other[i] = columns->at[i] < 0;
        if (columns->is_other[i])
            columns->at[i] = find_column(name, width, column->other);
        if (columns->at[i] < 0 && i < form->count - form->optional) {
            glint_fail(err, GLINT_BAD_INPUT, "this header has no column %s%s%s", column->name,
                       column->other != NULL ? " or " : "",
                       column->other != NULL ? column->other : "");
            return GLINT_LINE_MALFORMED;
        }
        if (comes_again(name, width, columns->at[i])) {
            glint_fail(err, GLINT_BAD_INPUT, "this header has two columns %s",
                       name[columns->at[i]]);
            return GLINT_LINE_MALFORMED;
        }
    }
    columns->width = width;
    return GLINT_LINE_NOTHING;
}

static bool is_letter(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

/* The values of a line that is not blank, in the order of the form. */
static glint_line_kind take_values(const glint_line_form *form, const glint_columns *columns,
                                   char *text, char **value, glint_error *err)
{
    char *cut[GLINT_COLUMNS_MAX];
    const int wanted = columns->width != 0 ? columns->width : form->count - form->optional;
    const int found = cut_values(text, cut, wanted);
    if (found != wanted) {
        glint_fail(err, GLINT_BAD_INPUT, "%s than %s", found < wanted ? "fewer" : "more",
                   columns->width != 0 ? "the header's values" : form->values);
        return GLINT_LINE_MALFORMED;
    }
    for (int i = 0; i < form->count; i++) {
        const int at = columns->width != 0 ? columns->at[i] : i < wanted ? i : -1;
        value[i] = at >= 0 ? cut[at] : NULL;
    }
    return GLINT_LINE_VALUES;
}

glint_line_kind glint_line_cut(const glint_line_form *form, glint_columns *columns, char *line,
                               size_t length, char **value, glint_error *err)
{
    if (length == LINE_MAX_BYTES) {
        glint_fail(err, GLINT_BAD_INPUT, "longer than 16 MB: not text");
        return GLINT_LINE_MALFORMED;
    }
    if (!trim(line, length)) {
        glint_fail(err, GLINT_BAD_INPUT, "contains a NUL byte: not text");
        return GLINT_LINE_MALFORMED;
    }
    char *text = skip_blanks(line);
    if (*text == '\0' || *text == '#')
        return GLINT_LINE_NOTHING;
    const bool first = !columns->begun;
    columns->begun = true;
    if (first && is_letter(*text)) {
        char *name[GLINT_COLUMNS_MAX];
        const int width = cut_values(text, name, GLINT_COLUMNS_MAX);
        return read_header(form, name, width <= GLINT_COLUMNS_MAX ? width : 0, columns, err);
    }
    return take_values(form, columns, text, value, err);
}

glint_line_kind glint_line_refuse(const char *name, const char *text, const char *expected,
                                  glint_error *err)
{
    glint_quoted quoted;
    glint_fail(err, GLINT_BAD_INPUT, "%s: %s is not %s", name, glint_quote(text, &quoted),
               expected);
    return GLINT_LINE_MALFORMED;
}

/* Standard input, and the line that is being read. It is not read by stdio, whose wait for input a
 * signal can miss. */
typedef struct reader {
    char *line;
    size_t room; /* of the line, without its NUL */
    size_t at, count;
    bool ended;
    char bytes[1 << 16];
} reader;

static bool grow(reader *in)
{
    const size_t room = in->room == 0 ? 256 : 2 * in->room;
    char *line = realloc(in->line, room + 1);
    if (line == NULL)
        return false;
    in->line = line;
    in->room = room;
    return true;
}

/* Fetches more bytes; false if there are none: at the end, on an error (with errno), or when asked
 * to stop. */
static bool fill(reader *in)
{
    if (in->ended)
        return false;
    ssize_t got = -1;
    while (got < 0 && glint_wait_readable(STDIN_FILENO)) {
        got = read(STDIN_FILENO, in->bytes, sizeof in->bytes);
        if (got < 0 && errno != EINTR && errno != EAGAIN)
            return false;
    }
    in->ended = got == 0;
    in->at = 0;
    in->count = got > 0 ? (size_t)got : 0;
    return got > 0;
}

/* Reads one line with its line end, of at most LINE_MAX_BYTES, and ends it with NUL. Returns the
 * length; 0 at the end of the input, on an error (with errno), or when asked to stop. */
static size_t read_line(reader *in)
{
    size_t length = 0;
    char c = '\0';
    while (length < LINE_MAX_BYTES && c != '\n' && (in->at < in->count || fill(in))) {
        if (length == in->room && !grow(in))
            return 0;
        c = in->bytes[in->at++];
        in->line[length++] = c;
    }
    if (length > 0)
        in->line[length] = '\0';
    const bool cut_off = c != '\n' && length < LINE_MAX_BYTES && !in->ended;
    return cut_off || glint_stop_requested() ? 0 : length;
}

/* Why there are no more lines: the end of the input, or something worse. */
static int check_input(const char *command, const reader *in, int reason)
{
    if (glint_stop_requested())
        return glint_complain(command, GLINT_EXIT_TROUBLE, "interrupted");
    if (in->ended)
        return GLINT_EXIT_OK;
    return glint_complain(command, GLINT_EXIT_TROUBLE, "cannot read standard input: %s",
                          strerror(reason));
}

int glint_input_lines(const char *command, const char *waits_for, glint_line_taker *take,
                      void *context)
{
    reader *in = calloc(1, sizeof *in);
    if (in == NULL)
        return glint_complain(command, GLINT_EXIT_TROUBLE,
                              "not enough memory to read standard input");
    if (isatty(STDIN_FILENO) == 1)
        fprintf(stderr, "glint %s: waiting for %s; end with Ctrl-D\n", command, waits_for);
    int status = GLINT_EXIT_OK;
    uint64_t number = 0;
    while (status == GLINT_EXIT_OK) {
        errno = 0;
        const size_t length = read_line(in);
        const int reason = errno;
        if (length == 0) {
            status = take(context, number, NULL, 0);
            status = status == GLINT_EXIT_OK ? check_input(command, in, reason) : status;
            break;
        }
        status = take(context, ++number, in->line, length);
    }
    free(in->line);
    free(in);
    return status;
}
