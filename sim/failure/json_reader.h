/* Reads the values of a packet's JSON with type and range checks: a packet may come from anywhere.
 *
 * Only the first fault is reported: after it, every value reads as 0, "" or NULL. */
#ifndef GLINT_SIM_FAILURE_JSON_READER_H
#define GLINT_SIM_FAILURE_JSON_READER_H

#include <stdbool.h>
#include <stdint.h>

#include "file/json.h"
#include "glint_specular.h"
#include "glint_status.h"

typedef struct glint_json_reader {
    glint_error *err;
    bool failed;
} glint_json_reader;

void glint_json_refuse(glint_json_reader *r, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* An item, or the member of that name, as a whole number in the range. */
int64_t glint_json_integer_of(glint_json_reader *r, const json_t *item, const char *name,
                              int64_t min, int64_t max);
int64_t glint_json_integer(glint_json_reader *r, const json_t *json, const char *name, int64_t min,
                           int64_t max);

bool glint_json_boolean(glint_json_reader *r, const json_t *json, const char *name);
const char *glint_json_string(glint_json_reader *r, const json_t *json, const char *name);

/* As glint_json_string(), for printable text: no control characters. */
void glint_json_printed(glint_json_reader *r, const json_t *json, const char *name, char *text,
                        size_t size);

/* A string of decimal digits only. */
uint64_t glint_json_decimal(glint_json_reader *r, const json_t *json, const char *name);

/* A string of "0x" and hexadecimal digits only, as a value of the given width. words: as many as it
 * needs, at most GLINT_VALUE_WORDS. */
void glint_json_words(glint_json_reader *r, const json_t *item, const char *name, int width,
                      uint64_t *words);

/* Index of the string among names. */
int glint_json_choice(glint_json_reader *r, const json_t *json, const char *name,
                      const char *const *names, int count);

/* An array of min to max; NULL after a refusal. */
const json_t *glint_json_array(glint_json_reader *r, const json_t *json, const char *name, int min,
                               int max);

const json_t *glint_json_object(glint_json_reader *r, const json_t *json, const char *name);

/* A colour, and a material with its n. */
void glint_json_rgb(glint_json_reader *r, const json_t *json, const char *name, uint8_t values[3]);
glint_material glint_json_material(glint_json_reader *r, const json_t *json);

#endif
