/* Type and range checks for single JSON values; json_read.c reads a whole packet with them. */
#include "failure/json_reader.h"

#include <inttypes.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "circuit/words.h"

void glint_json_refuse(glint_json_reader *r, const char *format, ...)
{
    char text[256];
    va_list arguments;
    if (r->failed)
        return;
    va_start(arguments, format);
    (void)vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    (void)glint_fail(r->err, GLINT_BAD_INPUT, "%s", text);
    r->failed = true;
}

int64_t glint_json_integer_of(glint_json_reader *r, const json_t *item, const char *name,
                              int64_t min, int64_t max)
{
    const int64_t value = json_integer_value(item);
    if (!json_is_integer(item) || value < min || value > max) {
        glint_json_refuse(r, "%s is not an integer from %" PRId64 " to %" PRId64, name, min, max);
        return min;
    }
    return value;
}

int64_t glint_json_integer(glint_json_reader *r, const json_t *json, const char *name, int64_t min,
                           int64_t max)
{
    return glint_json_integer_of(r, json_object_get(json, name), name, min, max);
}

bool glint_json_boolean(glint_json_reader *r, const json_t *json, const char *name)
{
    const json_t *item = json_object_get(json, name);
    if (!json_is_boolean(item))
        glint_json_refuse(r, "%s is neither true nor false", name);
    return json_is_true(item);
}

const char *glint_json_string(glint_json_reader *r, const json_t *json, const char *name)
{
    const char *value = json_string_value(json_object_get(json, name));
    if (value == NULL)
        glint_json_refuse(r, "%s is not a string", name);
    return value != NULL ? value : "";
}

static bool has_only(const char *text, const char *allowed, size_t most)
{
    const size_t length = strlen(text);
    return length != 0 && length <= most && strspn(text, allowed) == length;
}

/* U+0080 to U+009F are two bytes of UTF-8; some terminals obey them. */
static bool is_control(const char *c)
{
    const unsigned char first = (unsigned char)c[0], second = (unsigned char)c[1];
    return first < 0x20 || first == 0x7f || (first == 0xc2 && second >= 0x80 && second < 0xa0);
}

void glint_json_printed(glint_json_reader *r, const json_t *json, const char *name, char *text,
                        size_t size)
{
    const char *value = glint_json_string(r, json, name);
    for (const char *c = value; *c != '\0'; c++)
        if (is_control(c))
            glint_json_refuse(r, "%s contains an unprintable character", name);
    (void)snprintf(text, size, "%s", value);
}

uint64_t glint_json_decimal(glint_json_reader *r, const json_t *json, const char *name)
{
    const char *value = glint_json_string(r, json, name);
    if (!has_only(value, "0123456789", 19))
        glint_json_refuse(r, "%s is not a number", name);
    return r->failed ? 0 : strtoull(value, NULL, 10);
}

void glint_json_words(glint_json_reader *r, const json_t *item, const char *name, int width,
                      uint64_t *words)
{
    const char *value = json_string_value(item);
    memset(words, 0, (size_t)glint_words_of(width) * sizeof *words);
    if (value == NULL || strncmp(value, "0x", 2) != 0 ||
        !has_only(value + 2, "0123456789abcdef", GLINT_VALUE_TEXT) ||
        !glint_words_parse(value, width, false, words))
        glint_json_refuse(r, "%s is not a number of %d bits", name, width);
}

int glint_json_choice(glint_json_reader *r, const json_t *json, const char *name,
                      const char *const *names, int count)
{
    const char *value = glint_json_string(r, json, name);
    for (int i = 0; i < count; i++)
        if (strcmp(names[i], value) == 0)
            return i;
    glint_json_refuse(r, "%s is unknown", name);
    return 0;
}

const json_t *glint_json_array(glint_json_reader *r, const json_t *json, const char *name, int min,
                               int max)
{
    const json_t *list = json_object_get(json, name);
    const int size = json_is_array(list) ? (int)json_array_size(list) : -1;
    if (size < min || size > max)
        glint_json_refuse(r, "%s is not a list of %d to %d", name, min, max);
    return r->failed ? NULL : list;
}

const json_t *glint_json_object(glint_json_reader *r, const json_t *json, const char *name)
{
    const json_t *item = json_object_get(json, name);
    if (!json_is_object(item))
        glint_json_refuse(r, "%s is missing", name);
    return item;
}

void glint_json_rgb(glint_json_reader *r, const json_t *json, const char *name, uint8_t values[3])
{
    const json_t *list = glint_json_array(r, json, name, 3, 3);
    for (int i = 0; list != NULL && i < 3; i++)
        values[i] = (uint8_t)glint_json_integer_of(r, json_array_get(list, (size_t)i), name, 0,
                                                   GLINT_COLOR_MAX);
}

glint_material glint_json_material(glint_json_reader *r, const json_t *json)
{
    uint8_t colors[3] = {0};
    const uint16_t n = (uint16_t)glint_json_integer(r, json, "n", 0, GLINT_N_MAX);
    glint_json_rgb(r, json, "rgb", colors);
    return (glint_material){n, colors[0], colors[1], colors[2]};
}
