/* Replaces invalid UTF-8, which cJSON passes through, in printed JSON. */
#include "file/json_text.h"

#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

static const char replacement[] = "\xef\xbf\xbd"; /* U+FFFD */

static bool is_between(unsigned char byte, unsigned char first, unsigned char last)
{
    return byte >= first && byte <= last;
}

/* The length of the character at the start of a string; 0 if it is not valid UTF-8, which excludes
 * overlong forms, surrogates and anything beyond U+10FFFF (Unicode, table 3-7). */
static size_t character(const unsigned char *at)
{
    const unsigned char lead = at[0];
    const unsigned char least = lead == 0xe0 ? 0xa0 : lead == 0xf0 ? 0x90 : 0x80;
    const unsigned char most = lead == 0xed ? 0x9f : lead == 0xf4 ? 0x8f : 0xbf;
    const size_t length = lead < 0x80                    ? 1
                          : is_between(lead, 0xc2, 0xdf) ? 2
                          : is_between(lead, 0xe0, 0xef) ? 3
                          : is_between(lead, 0xf0, 0xf4) ? 4
                                                         : 0;
    if (length > 1 && !is_between(at[1], least, most))
        return 0;
    for (size_t i = 2; i < length; i++)
        if (!is_between(at[i], 0x80, 0xbf))
            return 0;
    return length;
}

static void copy_clean(const char *from, char *to)
{
    while (*from != '\0') {
        const size_t length = character((const unsigned char *)from);
        const size_t written = length != 0 ? length : strlen(replacement);
        memcpy(to, length != 0 ? from : replacement, written);
        to += written;
        from += length != 0 ? length : 1;
    }
    *to = '\0';
}

char *glint_json_text(const cJSON *json)
{
    char *printed = json != NULL ? cJSON_Print(json) : NULL;
    char *text = printed != NULL ? malloc(strlen(printed) * strlen(replacement) + 1) : NULL;
    if (text != NULL)
        copy_clean(printed, text);
    cJSON_free(printed);
    return text;
}
