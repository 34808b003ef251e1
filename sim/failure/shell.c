/* Quotes words for a POSIX shell. */
#include "failure/shell.h"

#include <stdbool.h>
#include <stdio.h>
#include <string.h>

/* Whether the word needs no quotes. */
static bool is_plain(const char *word)
{
    static const char plain[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789"
                                "_-+./,:=%@";
    return word[0] != '\0' && strspn(word, plain) == strlen(word);
}

static void append(char *text, size_t size, const char *part)
{
    const size_t used = strlen(text);
    (void)snprintf(text + used, size - used, "%s", part);
}

void glint_shell_append(char *text, size_t size, const char *word)
{
    if (is_plain(word)) {
        append(text, size, word);
        return;
    }
    append(text, size, "'");
    for (; *word != '\0'; word++) {
        const char letter[] = {*word, '\0'};
        append(text, size, *word == '\'' ? "'\\''" : letter);
    }
    append(text, size, "'");
}
