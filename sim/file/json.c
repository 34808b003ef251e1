/* Builds and prints JSON where jansson's own functions refuse (text that is not UTF-8) or are
 * verbose (reals, lists). */
#define _POSIX_C_SOURCE 200809L

#include "file/json.h"

#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- Texts ---- */

static const char replacement[] = "\xef\xbf\xbd"; /* U+FFFD */

static bool is_between(unsigned char byte, unsigned char first, unsigned char last)
{
    return byte >= first && byte <= last;
}

/* The length of the character at the start of a string; 0 if it is not valid UTF-8, which excludes
 * overlong forms, surrogates and anything beyond U+10FFFF (Unicode, table 3-7). */
static size_t character(const unsigned char *at)
{
    const unsigned char lead = at[0];
    const unsigned char least = lead == 0xe0 ? 0xa0 : lead == 0xf0 ? 0x90 : 0x80;
    const unsigned char most = lead == 0xed ? 0x9f : lead == 0xf4 ? 0x8f : 0xbf;
    const size_t length = lead < 0x80                    ? 1
                          : is_between(lead, 0xc2, 0xdf) ? 2
                          : is_between(lead, 0xe0, 0xef) ? 3
                          : is_between(lead, 0xf0, 0xf4) ? 4
                                                         : 0;
    if (length > 1 && !is_between(at[1], least, most))
        return 0;
    for (size_t i = 2; i < length; i++)
        if (!is_between(at[i], 0x80, 0xbf))
            return 0;
    return length;
}

static void copy_clean(const char *from, char *to)
{
    while (*from != '\0') {
        const size_t length = character((const unsigned char *)from);
        const size_t written = length != 0 ? length : strlen(replacement);
        memcpy(to, length != 0 ? from : replacement, written);
        to += written;
        from += length != 0 ? length : 1;
    }
    *to = '\0';
}

json_t *glint_json_text_of(const char *text)
{
    char *clean = text != NULL ? malloc(strlen(text) * strlen(replacement) + 1) : NULL;
    if (clean == NULL)
        return NULL;
    copy_clean(text, clean);
    json_t *made = json_string(clean);
    free(clean);
    return made;
}

/* ---- Numbers and members ---- */

#define INTEGER_MAX 9007199254740992.0 /* 2^53: a double has every integer up to it */

json_t *glint_json_number_of(double value)
{
    if (!isfinite(value))
        return json_null();
    if (value == floor(value) && fabs(value) <= INTEGER_MAX)
        return json_integer((json_int_t)value);
    return json_real(value);
}

json_t *glint_json_numbers_of(const double *values, int count)
{
    json_t *list = json_array();
    for (int i = 0; i < count; i++)
        json_array_append_new(list, glint_json_number_of(values[i]));
    return list;
}

json_t *glint_json_add(json_t *object, const char *name, json_t *value)
{
    return json_object_set_new(object, name, value) == 0 ? value : NULL;
}

bool glint_json_add_number(json_t *object, const char *name, double value)
{
    return glint_json_add(object, name, glint_json_number_of(value)) != NULL;
}

bool glint_json_add_text(json_t *object, const char *name, const char *text)
{
    return glint_json_add(object, name, glint_json_text_of(text)) != NULL;
}

/* ---- The printed form ---- */

static void print_value(FILE *out, const json_t *json, int depth);

static void print_tabs(FILE *out, int count)
{
    for (int i = 0; i < count; i++)
        fputc('\t', out);
}

static void print_text(FILE *out, const char *text)
{
    static const char escaped[] = "\"\\\b\f\n\r\t", letters[] = "\"\\bfnrt";
    fputc('"', out);
    for (; *text != '\0'; text++) {
        const char *found = strchr(escaped, *text);
        if (found != NULL)
            fprintf(out, "\\%c", letters[found - escaped]);
        else if ((unsigned char)*text < 0x20)
            fprintf(out, "\\u%04x", (unsigned)*text);
        else
            fputc(*text, out);
    }
    fputc('"', out);
}

static void print_real(FILE *out, double value)
{
    char text[32];
    int digits = 15;
    do
        (void)snprintf(text, sizeof text, "%.*g", digits, value);
    while (digits++ < 17 && strtod(text, NULL) != value);
    fputs(text, out);
}

static void print_object(FILE *out, const json_t *object, int depth)
{
    const char *name, *between = "{\n";
    json_t *value;
    json_object_foreach((json_t *)object, name, value)
    {
        fputs(between, out);
        print_tabs(out, depth + 1);
        print_text(out, name);
        fputs(":\t", out);
        print_value(out, value, depth + 1);
        between = ",\n";
    }
    fputs(json_object_size(object) != 0 ? "\n" : "{\n", out);
    print_tabs(out, depth);
    fputc('}', out);
}

static void print_array(FILE *out, const json_t *array, int depth)
{
    const char *between = "";
    const json_t *value;
    fputc('[', out);
    glint_json_each(value, array)
    {
        fputs(between, out);
        print_value(out, value, depth + 1);
        between = ", ";
    }
    fputc(']', out);
}

static void print_value(FILE *out, const json_t *json, int depth)
{
    switch (json_typeof(json)) {
    case JSON_OBJECT:
        print_object(out, json, depth);
        break;
    case JSON_ARRAY:
        print_array(out, json, depth);
        break;
    case JSON_STRING:
        print_text(out, json_string_value(json));
        break;
    case JSON_INTEGER:
        fprintf(out, "%" JSON_INTEGER_FORMAT, json_integer_value(json));
        break;
    case JSON_REAL:
        print_real(out, json_real_value(json));
        break;
    default:
        fputs(json_is_null(json) ? "null" : json_is_true(json) ? "true" : "false", out);
    }
}

char *glint_json_text(const json_t *json)
{
    char *text = NULL;
    size_t length;
    FILE *out = json != NULL ? open_memstream(&text, &length) : NULL;
    if (out == NULL)
        return NULL;
    print_value(out, json, 0);
    const bool failed = ferror(out) != 0;
    if (fclose(out) == 0 && !failed)
        return text;
    free(text);
    return NULL;
}
