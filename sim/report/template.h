/* Prose with numbers in it: text/NAME.md, made part of the program, and its names filled in.
 *
 *     {NAME}            a measured number, in full, or words
 *     {NAME:.2f}        as printf's f, g or e has it; {NAME:.1%} times 100, with " %" behind it
 *     {LIST:,}          words with commas between them
 *     {each LIST}…      the rest of the line once for each word of LIST, which stands for every $
 *     {figure NAME}…    the figure NAME.svg, the rest of the line its caption
 *     {claims}          the claims of this chapter by verdict, as links into the table
 *     {table}           the table of all claims
 *
 * A range is printed as "0.1 to 0.3", what was not measured as "–". A name that nothing measured is
 * an error: the text cannot state what the run did not find. */
#ifndef GLINT_SIM_REPORT_TEMPLATE_H
#define GLINT_SIM_REPORT_TEMPLATE_H

#include <stdio.h>

#include "glint_status.h"
#include "report/numbers.h"

/* What stands in for {claims} and so on. `rest` is what follows the braces in their line. */
typedef glint_status glint_template_word(void *context, const char *word, const char *rest,
                                         FILE *out, glint_error *err);

typedef struct glint_template {
    const glint_numbers *numbers;
    glint_template_word *word; /* for a name that no number has; may be NULL */
    void *context;
} glint_template;

/* Lines without their newline, the last one NULL. */
glint_status glint_template_write(const glint_template *how, const char *const *lines, FILE *out,
                                  glint_error *err);

/* One line, without a newline; into text, cut at the room. */
glint_status glint_template_line(const glint_template *how, const char *line, char *text,
                                 size_t room, glint_error *err);

#endif
