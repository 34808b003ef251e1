/* Strict readers of one token; see parse.h. */
#include "cli/parse.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

bool glint_parse_integer(const char *token, int64_t min, int64_t max, int64_t *value)
{
    const char *digits = token + (*token == '-' || *token == '+');
    if (*digits == '\0' || digits[strspn(digits, "0123456789")] != '\0')
        return false;
    errno = 0;
    const long long number = strtoll(token, NULL, 10);
    if (errno != 0 || number < min || number > max)
        return false;
    *value = number;
    return true;
}

/* The power of ten that ends a number: "e6", "M"; -1 for anything else. */
static int power_of(const char *text)
{
    static const struct {
        char letter;
        int power;
    } suffixes[] = {{'k', 3}, {'K', 3}, {'M', 6}, {'G', 9}, {'T', 12}};
    int64_t power;
    if ((*text == 'e' || *text == 'E') && glint_parse_integer(text + 1, 0, 18, &power))
        return (int)power;
    for (size_t i = 0; i < sizeof suffixes / sizeof suffixes[0]; i++)
        if (text[0] == suffixes[i].letter && text[1] == '\0')
            return suffixes[i].power;
    return -1;
}

/* The token without its point and with as many zeros as the power asks for is the number. */
bool glint_parse_count(const char *token, int64_t min, int64_t max, int64_t *value)
{
    char digits[64];
    const size_t whole = strcspn(token, ".eEkKMGT");
    const char *fraction = token[whole] == '.' ? token + whole + 1 : token + whole;
    const size_t places = strspn(fraction, "0123456789");
    if (token[whole] == '\0')
        return glint_parse_integer(token, min, max, value);
    const int power = power_of(fraction + places);
    if (whole + 20 > sizeof digits || power < 0 || places > (size_t)power ||
        (token[whole] == '.' && places == 0) || strcspn(token, "0123456789") >= whole)
        return false;
    (void)snprintf(digits, sizeof digits, "%.*s%.*s%.*s", (int)whole, token, (int)places, fraction,
                   power - (int)places, "000000000000000000");
    return glint_parse_integer(digits, min, max, value);
}

bool glint_parse_hex(const char *token, uint64_t max, uint64_t *value)
{
    if (token[0] != '0' || (token[1] != 'x' && token[1] != 'X'))
        return false;
    const char *digits = token + 2;
    if (*digits == '\0' || digits[strspn(digits, "0123456789abcdefABCDEF")] != '\0')
        return false;
    errno = 0;
    const unsigned long long number = strtoull(digits, NULL, 16);
    if (errno != 0 || number > max)
        return false;
    *value = number;
    return true;
}

bool glint_parse_real(const char *token, double min, double max, double *value)
{
    /* strtod also takes white space, hexadecimal, "nan" and "inf": none has these characters only.
     */
    if (*token == '\0' || token[strspn(token, "0123456789+-.eE")] != '\0')
        return false;
    char *end;
    const double number = strtod(token, &end);
    if (end == token || *end != '\0' || !isfinite(number) || number < min || number > max)
        return false;
    *value = number;
    return true;
}

const char *glint_next_part(const char *text, char separator, char part[64])
{
    const char *end = strchr(text, separator);
    const size_t length = end != NULL ? (size_t)(end - text) : strlen(text);
    part[0] = '\0';
    if (length < 64) {
        memcpy(part, text, length);
        part[length] = '\0';
    }
    return end != NULL ? end + 1 : NULL;
}

bool glint_parse_integers(const char *token, char separator, int count, int64_t min, int64_t max,
                          int64_t *value)
{
    char part[64];
    for (int i = 0; i < count; i++) {
        if (token == NULL)
            return false;
        token = glint_next_part(token, separator, part);
        if (!glint_parse_integer(part, min, max, &value[i]))
            return false;
    }
    return token == NULL;
}

bool glint_parse_reals(const char *token, char separator, int count, double min, double max,
                       double *value)
{
    char part[64];
    for (int i = 0; i < count; i++) {
        if (token == NULL)
            return false;
        token = glint_next_part(token, separator, part);
        if (!glint_parse_real(part, min, max, &value[i]))
            return false;
    }
    return token == NULL;
}

/* ---- Colours --------------------------------------------------------------------------------- */

#define DEGREES 360.0
#define PERCENT 100.0

static bool parse_rgb(const char *text, glint_rgb *value)
{
    int64_t part[3];
    if (!glint_parse_integers(text, ',', 3, 0, 255, part))
        return false;
    *value = (glint_rgb){(uint8_t)part[0], (uint8_t)part[1], (uint8_t)part[2]};
    return true;
}

static bool parse_hex_rgb(const char *digits, glint_rgb *value)
{
    if (strlen(digits) != 6 || digits[strspn(digits, "0123456789abcdefABCDEF")] != '\0')
        return false;
    const unsigned long code = strtoul(digits, NULL, 16);
    *value = (glint_rgb){(uint8_t)(code >> 16), (uint8_t)(code >> 8), (uint8_t)code};
    return true;
}

static bool parse_hsv(const char *text, glint_rgb *value)
{
    double part[3];
    if (!glint_parse_reals(text, ',', 3, 0, DEGREES, part))
        return false;
    const glint_hsv hsv = {part[0], part[1] / PERCENT, part[2] / PERCENT};
    return glint_rgb_of_hsv(&hsv, value) == GLINT_OK;
}

static bool parse_cmyk(const char *text, glint_rgb *value)
{
    double part[4];
    if (!glint_parse_reals(text, ',', 4, 0, PERCENT, part))
        return false;
    const glint_cmyk cmyk = {part[0] / PERCENT, part[1] / PERCENT, part[2] / PERCENT,
                             part[3] / PERCENT};
    return glint_rgb_of_cmyk(&cmyk, value) == GLINT_OK;
}

bool glint_parse_color(const char *token, glint_rgb *value)
{
    static const struct {
        const char *prefix;
        bool (*parse)(const char *text, glint_rgb *value);
    } forms[] = {
        {"#", parse_hex_rgb},
        {"rgb:", parse_rgb},
        {"hsv:", parse_hsv},
        {"cmyk:", parse_cmyk},
    };
    for (size_t i = 0; i < sizeof forms / sizeof forms[0]; i++) {
        const size_t length = strlen(forms[i].prefix);
        if (strncmp(token, forms[i].prefix, length) == 0)
            return forms[i].parse(token + length, value);
    }
    return parse_rgb(token, value);
}

/* Writes one character as a message shows it; returns how many characters that took. */
static size_t quote_character(unsigned char c, char out[4])
{
    static const char hex[] = "0123456789abcdef";
    if (c >= 0x20 && c != 0x7f) {
        out[0] = (char)c;
        return 1;
    }
    out[0] = '\\';
    out[1] = 'x';
    out[2] = hex[c >> 4];
    out[3] = hex[c & 15];
    return 4;
}

const char *glint_quote(const char *token, glint_quoted *quoted)
{
    const size_t room = sizeof quoted->text - sizeof "\\xNN...\"";
    size_t length = 0;
    quoted->text[length++] = '"';
    while (*token != '\0' && length < room)
        length += quote_character((unsigned char)*token++, quoted->text + length);
    /* Not in the middle of a UTF-8 character. */
    while (((unsigned char)*token & 0xc0) == 0x80 && length < sizeof quoted->text - 8)
        quoted->text[length++] = *token++;
    strcpy(quoted->text + length, *token != '\0' ? "...\"" : "\"");
    return quoted->text;
}
