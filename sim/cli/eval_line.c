/* One line of `glint eval`'s input; see eval_line.h. */
#include "cli/eval_line.h"

#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "cli/parse.h"

#define FIELD_COUNT 5

static const glint_column fields[FIELD_COUNT] = {
    {"n", NULL}, {"cos", "cos_code"}, {"r", NULL}, {"g", NULL}, {"b", NULL}};

/* A code of register 1, which a cosine cannot be taken for. */
static bool read_code(const char *text, uint32_t *code)
{
    static const char prefix[] = "code:";
    uint64_t raw;
    int64_t number;
    if (glint_parse_hex(text, GLINT_COS_CODE_MAX, &raw)) {
        *code = (uint32_t)raw;
        return true;
    }
    if (strncmp(text, prefix, strlen(prefix)) == 0 &&
        glint_parse_integer(text + strlen(prefix), 0, GLINT_COS_CODE_MAX, &number)) {
        *code = (uint32_t)number;
        return true;
    }
    return false;
}

/* What is no number of the expected kind, and no code either. */
static glint_line_kind refuse_cosine(const char *name, const char *text, const char *number,
                                     glint_error *err)
{
    char expected[128];
    (void)snprintf(expected, sizeof expected, "%s or a code: 0x0 to 0x%x or code:0 to code:%u",
                   number, GLINT_COS_CODE_MAX, GLINT_COS_CODE_MAX);
    return glint_line_refuse(name, text, expected, err);
}

static glint_line_kind read_cosine(const char *text, uint32_t *code, glint_error *err)
{
    double cosine;
    if (read_code(text, code))
        return GLINT_LINE_VALUES;
    if (!glint_parse_real(text, 0.0, 1.0, &cosine))
        return refuse_cosine("cos", text, "a number from 0 to 1", err);
    *code = glint_cos_code(cosine);
    return GLINT_LINE_VALUES;
}

/* Of a column cos_code, where a bare number is a code. */
static glint_line_kind read_code_column(const char *text, uint32_t *code, glint_error *err)
{
    int64_t number;
    if (read_code(text, code))
        return GLINT_LINE_VALUES;
    if (!glint_parse_integer(text, 0, GLINT_COS_CODE_MAX, &number)) {
        char number[64];
        (void)snprintf(number, sizeof number, "an integer from 0 to %u", GLINT_COS_CODE_MAX);
        return refuse_cosine("cos_code", text, number, err);
    }
    *code = (uint32_t)number;
    return GLINT_LINE_VALUES;
}

static glint_line_kind read_fields(char *const field[FIELD_COUNT], bool is_code,
                                   glint_eval_point *point, glint_error *err)
{
    int64_t n;
    int64_t color[3];
    if (!glint_parse_integer(field[0], 0, GLINT_N_MAX, &n)) {
        char expected[64];
        (void)snprintf(expected, sizeof expected, "an integer from 0 to %u", GLINT_N_MAX);
        return glint_line_refuse("n", field[0], expected, err);
    }
    const glint_line_kind kind = is_code ? read_code_column(field[1], &point->cos_code, err)
                                         : read_cosine(field[1], &point->cos_code, err);
    if (kind != GLINT_LINE_VALUES)
        return kind;
    for (int i = 0; i < 3; i++) {
        if (!glint_parse_integer(field[2 + i], 0, GLINT_COLOR_MAX, &color[i])) {
            return glint_line_refuse(fields[2 + i].name, field[2 + i], "an integer from 0 to 255",
                                     err);
        }
    }
    point->material = (glint_material){
        .n = (uint16_t)n, .r = (uint8_t)color[0], .g = (uint8_t)color[1], .b = (uint8_t)color[2]};
    return GLINT_LINE_VALUES;
}

glint_line_kind glint_eval_read_line(glint_columns *columns, char *line, size_t length,
                                     glint_eval_point *point, glint_error *err)
{
    static const glint_line_form form = {fields, FIELD_COUNT, "five values (n cos r g b)", 0};
    char *field[FIELD_COUNT];
    const glint_line_kind kind = glint_line_cut(&form, columns, line, length, field, err);
    return kind == GLINT_LINE_VALUES
               ? read_fields(field, columns->width != 0 && columns->is_other[1], point, err)
               : kind;
}
