/* Spans, pixel by pixel: answer_form.h. */
#include <inttypes.h>

#include "circuit/circuits.h"
#include "failure/answer_form.h"
#include "failure/report.h"

#define COMPONENTS GLINT_QUADRATIC_SPAN_COMPONENTS
#define NUMBERS    (1 + 3 * COMPONENTS) /* load, start, first, second */

static void numbers_of(const glint_span_step *step, double numbers[NUMBERS])
{
    numbers[0] = step->load;
    for (int c = 0; c < COMPONENTS; c++) {
        numbers[1 + c] = (double)step->walk.start[c];
        numbers[1 + COMPONENTS + c] = (double)step->walk.first[c];
        numbers[1 + 2 * COMPONENTS + c] = (double)step->walk.second[c];
    }
}

/* Lines for `glint eval`, of which the last row printed counts. */
static void print_pixel_alone(FILE *out, const glint_failure *failure)
{
    static glint_answer alone;
    double numbers[NUMBERS];
    glint_answer_alone(&failure->answer, &failure->setting, &alone);
    fprintf(out, "  alone: printf 'load step start_r start_g start_b first_r first_g first_b "
                 "second_r second_g second_b\\n");
    for (int i = 0; i < alone.count; i++) {
        numbers_of(&alone.step[i], numbers);
        fprintf(out, "%g 1", numbers[0]);
        for (int k = 1; k < NUMBERS; k++)
            fprintf(out, " %.0f", numbers[k]);
        fprintf(out, "\\n");
    }
    fprintf(out, "' | ");
    glint_failure_print_program(out, failure);
    fprintf(out, " eval --circuit span --fraction %d --backend rtl", failure->setting.values[0]);
    glint_failure_print_directories(out, failure);
    fprintf(out, "\n");
}

static void print(FILE *out, const glint_failure *failure)
{
    const glint_answer *answer = &failure->answer;
    int pixel = 0;
    while (pixel < answer->at && !answer->step[answer->at - pixel].load)
        pixel++;
    fprintf(out, "  %d pixels after a load: %s: model %" PRId32 ", rtl %" PRId32 "\n", pixel,
            glint_answer_value_name(answer->value), answer->model, answer->rtl);
    if (failure->finding.alone_differs)
        print_pixel_alone(out, failure);
}

static void write(json_t *to, const glint_answer *answer)
{
    json_t *list = glint_json_add(to, "steps", json_array());
    for (int i = 0; i < answer->count; i++) {
        double numbers[NUMBERS];
        numbers_of(&answer->step[i], numbers);
        json_array_append_new(list, glint_json_numbers_of(numbers, NUMBERS));
    }
}

static void read_step(glint_json_reader *r, const json_t *values, glint_span_step *step)
{
    const int64_t end = INT64_C(1) << 48;
    int64_t number[NUMBERS];
    for (size_t k = 0; k < NUMBERS; k++)
        number[k] = glint_json_integer_of(r, json_array_get(values, k), "steps", k == 0 ? 0 : -end,
                                          k == 0 ? 1 : end);
    step->load = (uint8_t)number[0];
    for (int c = 0; c < COMPONENTS; c++) {
        step->walk.start[c] = number[1 + c];
        step->walk.first[c] = number[1 + COMPONENTS + c];
        step->walk.second[c] = number[1 + 2 * COMPONENTS + c];
    }
}

static void read(glint_json_reader *r, const json_t *json, glint_answer *answer)
{
    const json_t *list = glint_json_array(r, json, "steps", 1, GLINT_ANSWER_STEPS);
    const json_t *values;
    if (answer->value == GLINT_ANSWER_W)
        glint_json_refuse(r, "value is not an output of a span unit");
    glint_json_each(values, list)
    {
        read_step(r, values, &answer->step[answer->count++]);
    }
}

const glint_answer_form glint_span_form = {
    .print = print,
    .write = write,
    .read = read,
};
