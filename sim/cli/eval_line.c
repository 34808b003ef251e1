/* One line of `glint eval`'s input; see eval_line.h. */
#include "cli/eval_line.h"

#include <stdbool.h>

#include "cli/parse.h"

#define FIELD_COUNT 5

static const char *const field_name[FIELD_COUNT] = {"n", "cos", "r", "g", "b"};

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

static glint_line_kind read_fields(char *const field[FIELD_COUNT], glint_eval_point *point,
                                   glint_error *err)
{
    int64_t n;
    int64_t color[3];
    if (!glint_parse_integer(field[0], 0, GLINT_N_MAX, &n)) {
        return glint_line_refuse(field_name[0], field[0], "an integer from 0 to 1023", err);
    }
    if (!read_cosine(field[1], &point->cos_code)) {
        return glint_line_refuse(field_name[1], field[1],
                                 "a number from 0 to 1 or a code from 0x0 to 0x7ffff", err);
    }
    for (int i = 0; i < 3; i++) {
        if (!glint_parse_integer(field[2 + i], 0, GLINT_COLOR_MAX, &color[i])) {
            return glint_line_refuse(field_name[2 + i], field[2 + i], "an integer from 0 to 255",
                                     err);
        }
    }
    point->material = (glint_material){
        .n = (uint16_t)n, .r = (uint8_t)color[0], .g = (uint8_t)color[1], .b = (uint8_t)color[2]};
    return GLINT_LINE_VALUES;
}

glint_line_kind glint_eval_read_line(char *line, size_t length, glint_eval_point *point,
                                     glint_error *err)
{
    char *field[FIELD_COUNT];
    const glint_line_kind kind =
        glint_line_cut(line, length, field, FIELD_COUNT, "the five values n cos r g b", err);
    return kind == GLINT_LINE_VALUES ? read_fields(field, point, err) : kind;
}
