/* The report's measurements by name: "lobes.schlick.relative". Chapters store them; the table of
 * claims (claims.h), the text (template.h) and index.json use them.
 *
 *     glint_number_put(numbers, 0.103, "lobes.%s.relative", "schlick");
 *     glint_number_find(numbers, "lobes.schlick.relative")->lowest        → 0.103 */
#ifndef GLINT_SIM_REPORT_NUMBERS_H
#define GLINT_SIM_REPORT_NUMBERS_H

#include <stdbool.h>

typedef struct glint_number {
    char *name;
    /* Alike for one number; apart for a range: what was timed, or what can be read in several ways.
     * Not a number: nothing was measured. */
    double lowest, highest;
    char *text; /* words in place of a number; else NULL */
} glint_number;

typedef struct glint_numbers {
    glint_number *number;
    int count, room;
    bool incomplete; /* out of memory for one: the report fails */
} glint_numbers;

/* Start from {0}; empty it at the end. */
void glint_numbers_clear(glint_numbers *numbers);

/* The name is printed as printf() does. A name is put once. */
void glint_number_put(glint_numbers *numbers, double value, const char *name, ...)
    __attribute__((format(printf, 3, 4)));
void glint_number_put_range(glint_numbers *numbers, double lowest, double highest, const char *name,
                            ...) __attribute__((format(printf, 4, 5)));
void glint_number_put_text(glint_numbers *numbers, const char *text, const char *name, ...)
    __attribute__((format(printf, 3, 4)));

/* Puts a word behind those that the name has, for {each NAME} of template.h. */
void glint_number_add_word(glint_numbers *numbers, const char *name, const char *word);

/* Makes a range that begins as {NAN, NAN} take the value in. */
void glint_number_widen(double range[2], double value);

/* NULL: no such name. */
const glint_number *glint_number_find(const glint_numbers *numbers, const char *name);

#endif
