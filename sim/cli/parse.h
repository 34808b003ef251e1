/* Strict parsers for one token: the whole token must be the value.
 *
 * No white space, trailing characters, hexadecimal floating point, "nan" or "inf". Every function
 * returns false and leaves *value alone if the token is not such a value or is outside min…max. */
#ifndef GLINT_SIM_CLI_PARSE_H
#define GLINT_SIM_CLI_PARSE_H

#include <stdbool.h>
#include <stdint.h>

#include "color/color.h"

/* Decimal digits, with or without a sign. */
bool glint_parse_integer(const char *token, int64_t min, int64_t max, int64_t *value);

/* The same, or a whole number in a short form: 1e6, 2.5e6, 100k, 10M, 2.5G, 1T (powers of 1000). */
bool glint_parse_count(const char *token, int64_t min, int64_t max, int64_t *value);

/* 0x or 0X and at least one hexadecimal digit. */
bool glint_parse_hex(const char *token, uint64_t max, uint64_t *value);

/* A decimal number such as 1, -0.5, .5, 2e-3. */
bool glint_parse_real(const char *token, double min, double max, double *value);

/* Count of them with a separator between, each within the same min…max. */
bool glint_parse_integers(const char *token, char separator, int count, int64_t min, int64_t max,
                          int64_t *value);
bool glint_parse_reals(const char *token, char separator, int count, double min, double max,
                       double *value);

/* A colour (thesis section 1.4): R,G,B or rgb:R,G,B, integers 0…255; #rrggbb; hsv:H,S,V, degrees
 * 0…360 and percents; cmyk:C,M,Y,K, percents. GLINT_COLOR_FORMS describes this for users. */
bool glint_parse_color(const char *token, glint_rgb *value);

#define GLINT_COLOR_FORMS                                                                          \
    "R,G,B (0 to 255), #rrggbb, hsv:H,S,V (0 to 360, %, %) or cmyk:C,M,Y,K (%)"

/* Copies the next part of text, up to separator or the end, into part; returns what follows it, or
 * NULL at the end of text. A part too long to be a number comes out empty, which is not a number
 * either. */
const char *glint_next_part(const char *text, char separator, char part[64]);

/* A token for a message: in double quotes, control characters written \xNN, cut with "..." when
 * long. Returns quoted->text. */
typedef struct glint_quoted {
    char text[80];
} glint_quoted;

const char *glint_quote(const char *token, glint_quoted *quoted);

#endif
