/* Divisions: answer_form.h. */
#include <inttypes.h>

#include "circuit/circuits.h"
#include "failure/answer_form.h"
#include "failure/report.h"

/* The components before the answer's put it in its place: `glint divide` uses lines with the same k
 * as R, G and B of one division. It is the last row printed. */
static void print_division_alone(FILE *out, const glint_failure *failure)
{
    const glint_answer *answer = &failure->answer;
    const glint_division *division = &answer->division[answer->at];
    const int *values = failure->setting.values;
    fprintf(out, "  alone: printf '");
    for (int c = 0; c <= (int)answer->value - GLINT_ANSWER_R; c++)
        fprintf(out, "%d %u\\n", division->difference[c], division->k);
    fprintf(out, "' | ");
    glint_failure_print_program(out, failure);
    fprintf(out, " divide --backend rtl --form %s --shifts %d",
            glint_divider_form_name((glint_divider_form)values[GLINT_DIVIDER_FORM]),
            values[GLINT_DIVIDER_SHIFTS]);
    glint_failure_print_directories(out, failure);
    fprintf(out, "\n");
}

static void print(FILE *out, const glint_failure *failure)
{
    const glint_answer *answer = &failure->answer;
    const glint_division *division = &answer->division[answer->at];
    const int component = (int)answer->value - GLINT_ANSWER_R;
    const double one = (double)(1 << failure->setting.values[GLINT_DIVIDER_SHIFTS]);
    fprintf(out,
            "  difference %d, k %u: quotient of %s: model %" PRId32 " (%.9g), rtl %" PRId32
            " (%.9g)\n",
            division->difference[component], division->k, glint_answer_value_name(answer->value),
            answer->model, answer->model / one, answer->rtl, answer->rtl / one);
    if (failure->finding.alone_differs)
        print_division_alone(out, failure);
}

static void write(json_t *to, const glint_answer *answer)
{
    json_t *list = glint_json_add(to, "divisions", json_array());
    for (int i = 0; i < answer->count; i++) {
        const glint_division *division = &answer->division[i];
        const double values[] = {division->difference[0], division->difference[1],
                                 division->difference[2], division->k};
        json_array_append_new(list, glint_json_numbers_of(values, 4));
    }
}

static void read(glint_json_reader *r, const json_t *json, glint_answer *answer)
{
    const json_t *list = glint_json_array(r, json, "divisions", 1, GLINT_ANSWER_DIVISIONS);
    const json_t *values;
    if (answer->value == GLINT_ANSWER_W)
        glint_json_refuse(r, "value is not an output of a divider");
    glint_json_each(values, list)
    {
        glint_division *division = &answer->division[answer->count++];
        for (int c = 0; c < GLINT_DIVIDER_COMPONENTS; c++)
            division->difference[c] = (int16_t)glint_json_integer_of(
                r, json_array_get(values, (size_t)c), "divisions", -GLINT_DIVIDER_DIFFERENCE_MAX,
                GLINT_DIVIDER_DIFFERENCE_MAX);
        division->k = (uint8_t)glint_json_integer_of(
            r, json_array_get(values, (size_t)GLINT_DIVIDER_COMPONENTS), "divisions", 0,
            (1 << GLINT_DIVIDER_K_BITS) - 1);
    }
}

const glint_answer_form glint_division_form = {
    .print = print,
    .write = write,
    .read = read,
};
