/* How answers are reported and stored in a packet, for each circuit that has any: point_form.c,
 * division_form.c and span_form.c. */
#ifndef GLINT_SIM_FAILURE_ANSWER_FORM_H
#define GLINT_SIM_FAILURE_ANSWER_FORM_H

#include <stdio.h>

#include "failure/failure.h"
#include "failure/json_reader.h"

typedef struct glint_answer_form {
    /* The report lines with question and answer. */
    void (*print)(FILE *out, const glint_failure *failure);

    /* What stands below the report's table, which begins with that row of the capture; may be NULL.
     */
    void (*print_below)(FILE *out, const glint_capture *capture, int row);

    /* What was asked, in the JSON of the answer, whose value is there. */
    void (*write)(json_t *to, const glint_answer *answer);
    void (*read)(glint_json_reader *r, const json_t *from, glint_answer *answer);
} glint_answer_form;

extern const glint_answer_form glint_point_form, glint_division_form, glint_span_form;

/* NULL: the circuit has no answers. */
const glint_answer_form *glint_answer_form_of(const glint_circuit *circuit);

#endif
