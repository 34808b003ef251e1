/* Suggestions for mistyped words. */
#ifndef GLINT_SIM_CLI_SUGGEST_H
#define GLINT_SIM_CLI_SUGGEST_H

/* The name in the NULL-terminated list that is nearest to word, or NULL if none is close. Close
 * means equal but for case, starting with the word (at least two characters), or one slip away (a
 * character wrong, missing, extra, or two swapped); two slips from five characters up, three from
 * nine. */
const char *glint_suggest(const char *word, const char *const *names);

/* " (did you mean NAME?)", or "" without a suggestion; PREFIX is put before the name. Returns
 * text. */
typedef struct glint_suggestion {
    char text[96];
} glint_suggestion;

const char *glint_did_you_mean(const char *word, const char *const *names, const char *prefix,
                               glint_suggestion *suggestion);

#endif
