/* JSON by jansson, plus what it leaves to its users: numbers given as double, text that need not be
 * UTF-8, and a compact, readable printed form. */
#ifndef GLINT_SIM_FILE_JSON_H
#define GLINT_SIM_FILE_JSON_H

#include <stdbool.h>

#include <jansson.h>

/* A whole number as a JSON integer, any other as a real; null if not finite. */
json_t *glint_json_number_of(double value);
json_t *glint_json_numbers_of(const double *values, int count);

/* Any bytes up to the 0; each one that is not UTF-8 becomes U+FFFD. NULL for NULL. */
json_t *glint_json_text_of(const char *text);

/* Adds a member to an object; NULL or false when out of memory. */
json_t *glint_json_add(json_t *object, const char *name, json_t *value);
bool glint_json_add_number(json_t *object, const char *name, double value);
bool glint_json_add_text(json_t *object, const char *name, const char *text);

/* for (each item of the list), followed by a block; anything but a list has no items. */
#define glint_json_each(item, list)                                                                \
    for (size_t item##_at = 0; ((item) = json_array_get(list, item##_at)) != NULL; item##_at++)

/* The printed form, to be freed with free(); NULL when out of memory and for NULL. Members are on
 * separate, tab-indented lines, lists on one; a real has the fewest digits that read back as the
 * same double. */
char *glint_json_text(const json_t *json);

#endif
