/* Joins remarks into one line of printable text. */
#include "render/remarks.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

void glint_remark(glint_remarks *remarks, const char *format, ...)
{
    const size_t used = strlen(remarks->text);
    const size_t between = used > 0 ? 2 : 0;
    if (sizeof remarks->text - used <= between)
        return;
    memcpy(remarks->text + used, "; ", between);
    va_list values;
    va_start(values, format);
    (void)vsnprintf(remarks->text + used + between, sizeof remarks->text - used - between, format,
                    values);
    va_end(values);
}

void glint_remark_count(glint_remarks *remarks, size_t count, const char *one, const char *several)
{
    if (count > 0)
        glint_remark(remarks, "%zu %s left out", count, count == 1 ? one : several);
}

glint_word glint_word_of(const char *text, size_t length)
{
    glint_word word = {""};
    const size_t room = sizeof word.text - 1;
    const size_t kept = length <= room ? length : room - 3;
    for (size_t i = 0; i < kept; i++) {
        const char c = text[i];
        word.text[i] = c;
        if (c < ' ' || c > '~')
            word.text[i] = '?';
    }
    if (kept < length)
        memcpy(word.text + kept, "...", 3);
    return word;
}
