/* What the readers of plain.h share. */
#include "render/plain.h"

#include <stdlib.h>
#include <string.h>

glint_status glint_plain_begin(const glint_text *text, size_t *begin, glint_error *err)
{
    const unsigned char *bytes = (const unsigned char *)text->at;
    *begin = text->length >= 3 && memcmp(bytes, "\xef\xbb\xbf", 3) == 0 ? 3 : 0;
    if (text->length >= 2 &&
        ((bytes[0] == 0xff && bytes[1] == 0xfe) || (bytes[0] == 0xfe && bytes[1] == 0xff))) {
        return glint_fail(err, GLINT_BAD_INPUT, "%.300s: UTF-16 text: save it as ASCII or UTF-8",
                          text->path);
    }
    return GLINT_OK;
}

size_t glint_plain_line(const glint_text *text, const char *place)
{
    size_t line = 1;
    for (const char *c = text->at; c < place; c++)
        line += *c == '\n' || (*c == '\r' && c + 1 < text->at + text->length && c[1] != '\n');
    return line;
}

bool glint_plain_number(const char *word, size_t length, double *value)
{
    char copy[128];
    char *end;
    if (length == 0 || length >= sizeof copy)
        return false;
    memcpy(copy, word, length);
    copy[length] = '\0';
    *value = strtod(copy, &end);
    return end == copy + length;
}

void glint_plain_unknown(glint_remarks *remarks, size_t line, glint_word first, size_t count)
{
    glint_remark(remarks, "line %zu: unknown keyword \"%s\" ignored", line, first.text);
    if (count > 1)
        glint_remark(remarks, "as are %zu more like it", count - 1);
}

glint_status glint_plain_no_memory(const glint_text *text, glint_error *err)
{
    return glint_fail(err, GLINT_NO_MEMORY, "%.300s: not enough memory to read it", text->path);
}
