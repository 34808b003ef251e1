/* Damerau–Levenshtein distance, and the nearest name within a tolerance that grows with length. */
#define _POSIX_C_SOURCE 200809L

#include "cli/suggest.h"

#include <ctype.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

/* A longer word is not a mistyped option or model. */
#define WORD_MAX 32

static bool same(char a, char b)
{
    return tolower((unsigned char)a) == tolower((unsigned char)b);
}

static int least(int a, int b)
{
    return a < b ? a : b;
}

/* Slips from a to b, by rows: row[2] is of the first i characters of a, row[1] and row[0] of one
 * and two fewer. */
static int slips(const char *a, const char *b)
{
    int row[3][WORD_MAX + 1] = {{0}};
    const int length_a = (int)strlen(a);
    const int length_b = (int)strlen(b);
    for (int j = 0; j <= length_b; j++)
        row[2][j] = j;
    for (int i = 1; i <= length_a; i++) {
        memcpy(row[0], row[1], sizeof row[0]);
        memcpy(row[1], row[2], sizeof row[1]);
        row[2][0] = i;
        for (int j = 1; j <= length_b; j++) {
            const int changed = row[1][j - 1] + (same(a[i - 1], b[j - 1]) ? 0 : 1);
            row[2][j] = least(changed, least(row[1][j], row[2][j - 1]) + 1);
            if (i > 1 && j > 1 && same(a[i - 1], b[j - 2]) && same(a[i - 2], b[j - 1]))
                row[2][j] = least(row[2][j], row[0][j - 2] + 1);
        }
    }
    return row[2][length_b];
}

static int allowed(size_t length)
{
    return length < 2 ? 0 : length < 5 ? 1 : length < 9 ? 2 : 3;
}

const char *glint_suggest(const char *word, const char *const *names)
{
    const size_t length = strlen(word);
    if (length > WORD_MAX)
        return NULL;
    const char *nearest = NULL;
    int fewest = allowed(length) + 1;
    for (int i = 0; names[i] != NULL; i++) {
        if (length >= 2 && strncasecmp(word, names[i], length) == 0)
            return names[i];
        const int found = strlen(names[i]) <= WORD_MAX ? slips(word, names[i]) : fewest;
        if (found < fewest) {
            fewest = found;
            nearest = names[i];
        }
    }
    return nearest;
}

const char *glint_did_you_mean(const char *word, const char *const *names, const char *prefix,
                               glint_suggestion *suggestion)
{
    const char *name = glint_suggest(word, names);
    suggestion->text[0] = '\0';
    if (name != NULL) {
        (void)snprintf(suggestion->text, sizeof suggestion->text, " (did you mean %s%s?)", prefix,
                       name);
    }
    return suggestion->text;
}
