/* Strict readers of one token; see parse.h. */
#include "cli/parse.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

bool glint_parse_integer(const char *token, int64_t min, int64_t max, int64_t *value)
{
    const char *digits = token + (*token == '-' || *token == '+');
    if (*digits == '\0' || digits[strspn(digits, "0123456789")] != '\0') {
        return false;
    }
    errno = 0;
    const long long number = strtoll(token, NULL, 10);
    if (errno != 0 || number < min || number > max) {
        return false;
    }
    *value = number;
    return true;
}

bool glint_parse_hex(const char *token, uint64_t max, uint64_t *value)
{
    if (token[0] != '0' || (token[1] != 'x' && token[1] != 'X')) {
        return false;
    }
    const char *digits = token + 2;
    if (*digits == '\0' || digits[strspn(digits, "0123456789abcdefABCDEF")] != '\0') {
        return false;
    }
    errno = 0;
    const unsigned long long number = strtoull(digits, NULL, 16);
    if (errno != 0 || number > max) {
        return false;
    }
    *value = number;
    return true;
}

bool glint_parse_real(const char *token, double min, double max, double *value)
{
    /* strtod also takes white space, hexadecimal, "nan" and "inf": none has these characters only.
     */
    if (*token == '\0' || token[strspn(token, "0123456789+-.eE")] != '\0') {
        return false;
    }
    char *end;
    const double number = strtod(token, &end);
    if (end == token || *end != '\0' || !isfinite(number) || number < min || number > max) {
        return false;
    }
    *value = number;
    return true;
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
    while (*token != '\0' && length < room) {
        length += quote_character((unsigned char)*token++, quoted->text + length);
    }
    /* Not in the middle of a UTF-8 character. */
    while (((unsigned char)*token & 0xc0) == 0x80 && length < sizeof quoted->text - 8) {
        quoted->text[length++] = *token++;
    }
    strcpy(quoted->text + length, *token != '\0' ? "...\"" : "\"");
    return quoted->text;
}
