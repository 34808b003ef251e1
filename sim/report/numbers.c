/* The store of measured numbers; see numbers.h. Some hundreds of names: it is searched from the
 * front. */
#define _POSIX_C_SOURCE 200809L

#include "report/numbers.h"

#include <math.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define NAME_MAX_LENGTH 128

static glint_number *add(glint_numbers *numbers)
{
    if (numbers->count == numbers->room) {
        const int room = numbers->room + 256;
        glint_number *larger = realloc(numbers->number, (size_t)room * sizeof *larger);
        if (larger == NULL)
            return NULL;
        numbers->number = larger;
        numbers->room = room;
    }
    return &numbers->number[numbers->count];
}

static void put(glint_numbers *numbers, const double range[2], const char *text, const char *name,
                va_list arguments)
{
    char printed[NAME_MAX_LENGTH];
    vsnprintf(printed, sizeof printed, name, arguments);
    glint_number *number = add(numbers);
    if (number == NULL) {
        numbers->incomplete = true;
        return;
    }
    *number = (glint_number){.name = strdup(printed),
                             .lowest = range[0],
                             .highest = range[1],
                             .text = text != NULL ? strdup(text) : NULL};
    if (number->name != NULL && (number->text != NULL || text == NULL)) {
        numbers->count++;
        return;
    }
    free(number->name);
    free(number->text);
    numbers->incomplete = true;
}

void glint_numbers_clear(glint_numbers *numbers)
{
    for (int i = 0; i < numbers->count; i++) {
        free(numbers->number[i].name);
        free(numbers->number[i].text);
    }
    free(numbers->number);
    *numbers = (glint_numbers){0};
}

void glint_number_put(glint_numbers *numbers, double value, const char *name, ...)
{
    va_list arguments;
    va_start(arguments, name);
    put(numbers, (const double[2]){value, value}, NULL, name, arguments);
    va_end(arguments);
}

void glint_number_put_range(glint_numbers *numbers, double lowest, double highest, const char *name,
                            ...)
{
    va_list arguments;
    va_start(arguments, name);
    put(numbers, (const double[2]){lowest, highest}, NULL, name, arguments);
    va_end(arguments);
}

void glint_number_put_text(glint_numbers *numbers, const char *text, const char *name, ...)
{
    va_list arguments;
    va_start(arguments, name);
    put(numbers, (const double[2]){NAN, NAN}, text, name, arguments);
    va_end(arguments);
}

void glint_number_add_word(glint_numbers *numbers, const char *name, const char *word)
{
    const glint_number *there = glint_number_find(numbers, name);
    if (there == NULL) {
        glint_number_put_text(numbers, word, "%s", name);
        return;
    }
    glint_number *number = &numbers->number[there - numbers->number];
    const size_t length = strlen(number->text), more = strlen(word) + 2;
    char *longer = realloc(number->text, length + more);
    if (longer == NULL) {
        numbers->incomplete = true;
        return;
    }
    snprintf(longer + length, more, " %s", word);
    number->text = longer;
}

void glint_number_widen(double range[2], double value)
{
    range[0] = fmin(range[0], value); /* of NAN and a number it is the number */
    range[1] = fmax(range[1], value);
}

const glint_number *glint_number_find(const glint_numbers *numbers, const char *name)
{
    for (int i = 0; i < numbers->count; i++)
        if (strcmp(numbers->number[i].name, name) == 0)
            return &numbers->number[i];
    return NULL;
}
