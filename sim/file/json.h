/* JSON by jansson, with what it leaves to its users: numbers that come as double, texts that need
 * not be UTF-8, and a printed form that is short and reads well. */
#ifndef GLINT_SIM_FILE_JSON_H
#define GLINT_SIM_FILE_JSON_H

#include <stdbool.h>

#include <jansson.h>

/* A whole number as JSON's integer, any other as its real; null for what is not finite. */
json_t *glint_json_number_of(double value);
json_t *glint_json_numbers_of(const double *values, int count);

/* Any bytes up to the 0: those that are not UTF-8 become U+FFFD, one for each byte. NULL
 * for NULL. */
json_t *glint_json_text_of(const char *text);

/* Adds a member to an object; NULL or false: no memory. */
json_t *glint_json_add(json_t *object, const char *name, json_t *value);
bool glint_json_add_number(json_t *object, const char *name, double value);
bool glint_json_add_text(json_t *object, const char *name, const char *text);

/* for (each item of the list): a block follows. What is no list has none. */
#define glint_json_each(item, list)                                                                \
    for (size_t item##_at = 0; ((item) = json_array_get(list, item##_at)) != NULL; item##_at++)

/* The printed form, to be freed with free(); NULL without memory, and for NULL. Members on lines of
 * their own behind tabs, lists on one; a real with the fewest digits that read back as the same
 * double. */
char *glint_json_text(const json_t *json);

#endif
