/* One line of `glint eval`'s input: "n cos r g b". */
#ifndef GLINT_SIM_CLI_EVAL_LINE_H
#define GLINT_SIM_CLI_EVAL_LINE_H

#include <stddef.h>

#include "cli/input.h"
#include "glint_specular.h"

typedef struct glint_eval_point {
    glint_material material;
    uint32_t cos_code; /* U1.18, as written to register 1; above 1.0 only if given as a code */
} glint_eval_point;

/* Reads the five values of a line, as glint_line_cut() does; a header may have cos_code in the
 * place of cos. GLINT_LINE_MALFORMED: err says what is wrong with it. */
glint_line_kind glint_eval_read_line(glint_columns *columns, char *line, size_t length,
                                     glint_eval_point *point, glint_error *err);

#endif
