/* What somebody who mistyped a word will have meant. */
#ifndef GLINT_SIM_CLI_SUGGEST_H
#define GLINT_SIM_CLI_SUGGEST_H

/* The name nearest to word, of a list that ends with NULL; NULL when none is near enough to be
 * meant. Near is: the same but for upper and lower case, begun with the word (two characters at
 * least), or one slip away (a character wrong, missing, too many, or two swapped), two in a word of
 * five characters or more, three in one of nine or more. */
const char *glint_suggest(const char *word, const char *const *names);

/* " (did you mean NAME?)", or "" when there is nothing to suggest; with PREFIX before the name.
 * Returns text. */
typedef struct glint_suggestion {
    char text[96];
} glint_suggestion;

const char *glint_did_you_mean(const char *word, const char *const *names, const char *prefix,
                               glint_suggestion *suggestion);

#endif
