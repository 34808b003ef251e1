/* Points of a highlight unit: answer_form.h. */
#include <inttypes.h>
#include <string.h>

#include "circuit/units.h"
#include "failure/answer_form.h"
#include "failure/report.h"

static int lanes_of(const glint_failure *failure)
{
    return glint_highlight_lanes(&failure->setting);
}

/* A line for `glint eval` is more useful than a list of values. Points start at lane 0, so for
 * another lane the line is repeated, and the last row printed counts. */
static void print_point_alone(FILE *out, const glint_failure *failure)
{
    const glint_answer *answer = &failure->answer;
    const int lane = answer->at % lanes_of(failure);
    char options[GLINT_SETTING_OPTIONS];
    glint_setting_options(&failure->setting, options);
    fprintf(out, "  alone: %s '%u 0x%" PRIx32 " %u %u %u' | ", lane == 0 ? "echo" : "yes",
            answer->material.n, answer->cos_code[answer->at], answer->material.r,
            answer->material.g, answer->material.b);
    if (lane != 0)
        fprintf(out, "head -n %d | ", lane + 1);
    glint_failure_print_program(out, failure);
    fprintf(out, " eval --backend rtl %s", options);
    glint_failure_print_directories(out, failure);
    fprintf(out, "\n");
}

static void print(FILE *out, const glint_failure *failure)
{
    const glint_answer *answer = &failure->answer;
    const uint32_t code = answer->cos_code[answer->at];
    fprintf(out, "  n %u, cosine 0x%05" PRIx32 " (%.9g), R,G,B %u,%u,%u, lane %d: %s: ",
            answer->material.n, code, (double)code / GLINT_COS_ONE, answer->material.r,
            answer->material.g, answer->material.b, answer->at % lanes_of(failure),
            glint_answer_value_name(answer->value));
    fprintf(out, "model %" PRId32 ", rtl %" PRId32 "\n", answer->model, answer->rtl);
    if (failure->finding.alone_differs)
        print_point_alone(out, failure);
}

/* What the table's first clock left in the registers of the material: it may be older. */
static void print_below(FILE *out, const glint_capture *capture, int row)
{
    static const char *const names[] = {"reg2", "reg3", "reg4", "reg5"};
    uint64_t held[4] = {0};
    for (int i = 0; i < capture->signals.count; i++)
        for (int r = 0; r < 4; r++)
            if (strcmp(capture->signals.info[i].name, names[r]) == 0)
                held[r] = *glint_capture_words(capture, capture->clock[row].model, i);
    fprintf(out,
            "after the first of them registers 2 to 5 hold n = %" PRIu64 ", %" PRIu64 ", %" PRIu64
            ", %" PRIu64 "\n",
            held[0], held[1], held[2], held[3]);
}

static void write(json_t *to, const glint_answer *answer)
{
    const double rgb[] = {answer->material.r, answer->material.g, answer->material.b};
    glint_json_add_number(to, "n", answer->material.n);
    json_object_set_new(to, "rgb", glint_json_numbers_of(rgb, 3));
    json_t *list = glint_json_add(to, "cosines", json_array());
    for (int i = 0; i < answer->count; i++)
        json_array_append_new(list, glint_json_number_of(answer->cos_code[i]));
}

static void read(glint_json_reader *r, const json_t *json, glint_answer *answer)
{
    const json_t *list = glint_json_array(r, json, "cosines", 1, GLINT_ANSWER_POINTS);
    const json_t *code;
    glint_json_each(code, list)
    {
        answer->cos_code[answer->count++] =
            (uint32_t)glint_json_integer_of(r, code, "cosines", 0, GLINT_COS_CODE_MAX);
    }
    answer->material = glint_json_material(r, json);
}

const glint_answer_form glint_point_form = {
    .print = print,
    .print_below = print_below,
    .write = write,
    .read = read,
};
