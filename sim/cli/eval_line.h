/* One line of `glint eval`'s input: "n cos r g b". */
#ifndef GLINT_SIM_CLI_EVAL_LINE_H
#define GLINT_SIM_CLI_EVAL_LINE_H

#include <stddef.h>

#include "glint_specular.h"

typedef struct glint_eval_point {
    glint_material material;
    uint32_t cos_code; /* U1.18, what is written to register 1; above 1.0 only if given so */
} glint_eval_point;

typedef enum glint_eval_line_kind {
    GLINT_EVAL_POINT,
    GLINT_EVAL_NOTHING, /* blank, or a comment: the first character that is no blank is # */
    GLINT_EVAL_MALFORMED,
} glint_eval_line_kind;

/* Reads the five values of a line of the given length, with or without its line end (LF or CRLF).
 * They stand apart by blanks, by a comma, or by a comma with blanks around it. The line is altered.
 * GLINT_EVAL_MALFORMED: err says what is wrong with it. */
glint_eval_line_kind glint_eval_read_line(char *line, size_t length, glint_eval_point *point,
                                          glint_error *err);

#endif
