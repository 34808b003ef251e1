/* One line of `glint eval`'s input; see eval_line.h. */
#include "cli/eval_line.h"

#include <stdbool.h>
#include <string.h>

#include "cli/parse.h"

#define FIELD_COUNT 5

static const char *const field_name[FIELD_COUNT] = {"n", "cos", "r", "g", "b"};

static glint_eval_line_kind malformed(glint_error *err, const char *field, const char *text,
                                      const char *expected)
{
    glint_quoted quoted;
    glint_fail(err, GLINT_BAD_INPUT, "%s: %s is not %s", field, glint_quote(text, &quoted),
               expected);
    return GLINT_EVAL_MALFORMED;
}

static char *skip_blanks(char *text)
{
    return text + strspn(text, " \t");
}

/* Cuts one field off text: ends it with NUL and moves *text behind the separator. *more: a
 * separator with a comma followed, so another field must too. */
static char *cut_field(char **text, bool *more)
{
    char *field = *text;
    char *end = field + strcspn(field, " \t,");
    char *next = skip_blanks(end);
    *more = *next == ',';
    *text = *more ? skip_blanks(next + 1) : next;
    *end = '\0';
    return field;
}

/* Cuts a line that is not blank into its fields; returns how many, FIELD_COUNT + 1 for more. */
static int cut_fields(char *text, char *field[FIELD_COUNT])
{
    int count = 0;
    bool more = true;
    while (more || *text != '\0') {
        if (count == FIELD_COUNT) {
            return FIELD_COUNT + 1;
        }
        field[count++] = cut_field(&text, &more);
    }
    return count;
}

static bool read_cosine(const char *text, uint32_t *code)
{
    uint64_t raw;
    double cosine;
    if (glint_parse_hex(text, GLINT_COS_CODE_MAX, &raw)) {
        *code = (uint32_t)raw;
        return true;
    }
    if (glint_parse_real(text, 0.0, 1.0, &cosine)) {
        *code = glint_cos_code(cosine);
        return true;
    }
    return false;
}

static glint_eval_line_kind read_fields(char *const field[FIELD_COUNT], glint_eval_point *point,
                                        glint_error *err)
{
    int64_t n;
    int64_t color[3];
    if (!glint_parse_integer(field[0], 0, GLINT_N_MAX, &n)) {
        return malformed(err, field_name[0], field[0], "an integer from 0 to 1023");
    }
    if (!read_cosine(field[1], &point->cos_code)) {
        return malformed(err, field_name[1], field[1],
                         "a number from 0 to 1 or a code from 0x0 to 0x7ffff");
    }
    for (int i = 0; i < 3; i++) {
        if (!glint_parse_integer(field[2 + i], 0, GLINT_COLOR_MAX, &color[i])) {
            return malformed(err, field_name[2 + i], field[2 + i], "an integer from 0 to 255");
        }
    }
    point->material = (glint_material){
        .n = (uint16_t)n, .r = (uint8_t)color[0], .g = (uint8_t)color[1], .b = (uint8_t)color[2]};
    return GLINT_EVAL_POINT;
}

/* Takes the line end off; returns false when a NUL byte is in the line. */
static bool trim(char *line, size_t length)
{
    if (memchr(line, '\0', length) != NULL) {
        return false;
    }
    if (length > 0 && line[length - 1] == '\n') {
        line[--length] = '\0';
    }
    if (length > 0 && line[length - 1] == '\r') {
        line[--length] = '\0';
    }
    return true;
}

glint_eval_line_kind glint_eval_read_line(char *line, size_t length, glint_eval_point *point,
                                          glint_error *err)
{
    if (!trim(line, length)) {
        glint_fail(err, GLINT_BAD_INPUT, "a NUL byte is in it: this is not text");
        return GLINT_EVAL_MALFORMED;
    }
    char *text = skip_blanks(line);
    if (*text == '\0' || *text == '#') {
        return GLINT_EVAL_NOTHING;
    }
    char *field[FIELD_COUNT];
    const int count = cut_fields(text, field);
    if (count != FIELD_COUNT) {
        glint_fail(err, GLINT_BAD_INPUT, "%s than the five values n cos r g b",
                   count < FIELD_COUNT ? "fewer" : "more");
        return GLINT_EVAL_MALFORMED;
    }
    return read_fields(field, point, err);
}
