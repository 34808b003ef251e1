/* Lines of values on standard input; see input.h. */
#define _POSIX_C_SOURCE 200809L

#include "cli/input.h"

#include <errno.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

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
        if (found == count) {
            return count + 1;
        }
        value[found++] = cut_value(&text, &more);
    }
    return found;
}

/* Takes the line end off; returns false when a NUL byte is in the line. */
static bool trim(char *line, size_t length)
{
    if (memchr(line, '\0', length) != NULL) {
        return false;
    }
    if (length > 0 && line[length - 1] == '\n') {
        line[--length] = '\0';
    }
    if (length > 0 && line[length - 1] == '\r') {
        line[--length] = '\0';
    }
    return true;
}

glint_line_kind glint_line_cut(char *line, size_t length, char **value, int count,
                               const char *values, glint_error *err)
{
    if (length == LINE_MAX_BYTES) {
        glint_fail(err, GLINT_BAD_INPUT, "longer than 16 MB: this is not text");
        return GLINT_LINE_MALFORMED;
    }
    if (!trim(line, length)) {
        glint_fail(err, GLINT_BAD_INPUT, "a NUL byte is in it: this is not text");
        return GLINT_LINE_MALFORMED;
    }
    char *text = skip_blanks(line);
    if (*text == '\0' || *text == '#') {
        return GLINT_LINE_NOTHING;
    }
    const int found = cut_values(text, value, count);
    if (found != count) {
        glint_fail(err, GLINT_BAD_INPUT, "%s than %s", found < count ? "fewer" : "more", values);
        return GLINT_LINE_MALFORMED;
    }
    return GLINT_LINE_VALUES;
}

glint_line_kind glint_line_refuse(const char *name, const char *text, const char *expected,
                                  glint_error *err)
{
    glint_quoted quoted;
    glint_fail(err, GLINT_BAD_INPUT, "%s: %s is not %s", name, glint_quote(text, &quoted),
               expected);
    return GLINT_LINE_MALFORMED;
}

/* The line that is being read. */
typedef struct line_room {
    char *bytes;
    size_t size;
} line_room;

static bool grow(line_room *line)
{
    const size_t size = line->size == 0 ? 256 : 2 * line->size;
    char *bytes = realloc(line->bytes, size + 1); /* and a NUL */
    if (bytes == NULL) {
        return false;
    }
    *line = (line_room){bytes, size};
    return true;
}

/* Reads one line with its line end, of at most LINE_MAX_BYTES, and ends it with NUL. The length; 0
 * at the end of the input, at an error, with errno, or when it is to stop. */
static size_t read_line(line_room *line)
{
    size_t length = 0;
    int c = '\0';
    while (length < LINE_MAX_BYTES && c != '\n' && (c = getc_unlocked(stdin)) != EOF) {
        if (length == line->size && !grow(line)) {
            return 0;
        }
        line->bytes[length++] = (char)c;
    }
    if (length > 0) {
        line->bytes[length] = '\0';
    }
    return ferror(stdin) || glint_stop_requested() ? 0 : length;
}

/* Why there is no further line: the end of the input, or something worse. */
static int check_input(const char *command, int reason)
{
    if (glint_stop_requested()) {
        return glint_complain(command, GLINT_EXIT_FAILURE, "interrupted");
    }
    if (feof(stdin)) {
        return GLINT_EXIT_OK;
    }
    return glint_complain(command, GLINT_EXIT_FAILURE, "cannot read standard input: %s",
                          strerror(reason));
}

int glint_input_lines(const char *command, glint_line_taker *take, void *context)
{
    line_room line = {0};
    int status = GLINT_EXIT_OK;
    uint64_t number = 0;
    while (status == GLINT_EXIT_OK) {
        errno = 0;
        const size_t length = read_line(&line);
        const int reason = errno;
        if (length == 0) {
            status = take(context, number, NULL, 0);
            status = status == GLINT_EXIT_OK ? check_input(command, reason) : status;
            break;
        }
        status = take(context, ++number, line.bytes, length);
    }
    free(line.bytes);
    return status;
}
