/* Fills names into text; see template.h. */
#define _POSIX_C_SOURCE 200809L

#include "report/template.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define WORD_MAX        128
#define LINE_MAX_LENGTH 4096

/* One value by ".2f", ".3g", ".1e", ".1%"; NULL: in full. */
static void print_value(double value, const char *format, char *text, size_t room)
{
    const int decimals = format != NULL ? atoi(format + 1) : 12;
    const int kind = format != NULL ? format[strlen(format) - 1] : 'g';
    if (isnan(value))
        snprintf(text, room, "–");
    else if (kind == '%')
        snprintf(text, room, "%.*f", decimals, 100.0 * value);
    else if (kind == 'f')
        snprintf(text, room, "%.*f", decimals, value);
    else if (kind == 'e')
        snprintf(text, room, "%.*e", decimals, value);
    else
        snprintf(text, room, "%.*g", decimals, value);
}

static void print_number(const glint_number *number, const char *format, FILE *out)
{
    char lowest[64], highest[64];
    if (number->text != NULL) {
        const bool list = format != NULL && format[0] == ',';
        for (const char *at = number->text; *at != '\0'; at++)
            fputs(list && *at == ' ' ? ", " : (const char[]){*at, '\0'}, out);
        return;
    }
    print_value(number->lowest, format, lowest, sizeof lowest);
    print_value(number->highest, format, highest, sizeof highest);
    fputs(lowest, out);
    if (strcmp(lowest, highest) != 0)
        fprintf(out, " to %s", highest);
    if (format != NULL && format[strlen(format) - 1] == '%' && !isnan(number->lowest))
        fputs(" %", out);
}

static bool is_format(const char *format)
{
    char kind, more;
    int decimals;
    return strcmp(format, ",") == 0 || (sscanf(format, ".%d%c%c", &decimals, &kind, &more) == 2 &&
                                        strchr("fge%", kind) != NULL);
}

static glint_status write_line(const glint_template *how, const char *line, FILE *out,
                               glint_error *err);

/* The rest of the line for each word of the list. */
static glint_status write_each(const glint_template *how, const char *list, const char *rest,
                               FILE *out, glint_error *err)
{
    const glint_number *words = glint_number_find(how->numbers, list);
    char line[LINE_MAX_LENGTH];
    glint_status status = GLINT_OK;
    if (words == NULL || words->text == NULL)
        return glint_fail(err, GLINT_BAD_ARGUMENT, "the report's text repeats {%s}: no such list",
                          list);
    for (const char *word = words->text; *word != '\0' && status == GLINT_OK;) {
        const size_t length = strcspn(word, " ");
        size_t at = 0;
        for (const char *from = rest; *from != '\0' && at + length + 1 < sizeof line; from++)
            if (*from == '$') {
                memcpy(line + at, word, length);
                at += length;
            } else {
                line[at++] = *from;
            }
        line[at] = '\0';
        status = write_line(how, line, out, err);
        word += length + (word[length] == ' ');
        if (*word != '\0')
            fputc('\n', out);
    }
    return status;
}

/* What stands in braces; *rest is what follows it, and moves to the line's end where that is
 * used up. */
static glint_status write_word(const glint_template *how, char *word, const char **rest, FILE *out,
                               glint_error *err)
{
    char *format = strchr(word, ':');
    if (format != NULL)
        *format++ = '\0';
    const glint_number *number = glint_number_find(how->numbers, word);
    if (number != NULL && (format == NULL || is_format(format))) {
        print_number(number, format, out);
        return GLINT_OK;
    }
    const char *const all = *rest;
    const bool each = strncmp(word, "each ", 5) == 0;
    if (format != NULL || (!each && how->word == NULL))
        return glint_fail(err, GLINT_BAD_ARGUMENT,
                          "the report's text has {%s%s%s}: nothing measured that", word,
                          format != NULL ? ":" : "", format != NULL ? format : "");
    *rest += strlen(*rest);
    return each ? write_each(how, word + 5, all, out, err)
                : how->word(how->context, word, all, out, err);
}

static glint_status write_line(const glint_template *how, const char *line, FILE *out,
                               glint_error *err)
{
    glint_status status = GLINT_OK;
    while (*line != '\0' && status == GLINT_OK) {
        char word[WORD_MAX];
        const char *end = *line == '{' ? strchr(line, '}') : NULL;
        const size_t length = end != NULL ? (size_t)(end - line - 1) : 0;
        if (end == NULL || length >= sizeof word) {
            fputc(*line++, out);
            continue;
        }
        memcpy(word, line + 1, length);
        word[length] = '\0';
        line = end + 1;
        status = write_word(how, word, &line, out, err);
    }
    return status;
}

glint_status glint_template_write(const glint_template *how, const char *const *lines, FILE *out,
                                  glint_error *err)
{
    glint_status status = GLINT_OK;
    for (; *lines != NULL && status == GLINT_OK; lines++) {
        status = write_line(how, *lines, out, err);
        fputc('\n', out);
    }
    return status;
}

glint_status glint_template_line(const glint_template *how, const char *line, char *text,
                                 size_t room, glint_error *err)
{
    FILE *out = fmemopen(text, room, "w");
    if (out == NULL)
        return glint_fail(err, GLINT_NO_MEMORY, "no memory for a line of the report");
    const glint_status status = write_line(how, line, out, err);
    fclose(out);
    text[room - 1] = '\0';
    return status;
}
