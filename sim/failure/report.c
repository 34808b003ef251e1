#include "failure/report.h"

#include <inttypes.h>
#include <string.h>

#include "failure/packet.h"
#include "failure/pins.h"
#include "failure/shell.h"
#include "lockstep/mismatch.h"

#define COLUMN 24 /* the longest text in one */
#define WORD   8192

/* A word of a command line. */
static void print_word(FILE *out, const char *word)
{
    char text[WORD] = "";
    glint_shell_append(text, sizeof text, word);
    fprintf(out, "%s", text);
}

static void print_program(FILE *out, const glint_failure *failure)
{
    print_word(out, failure->program != NULL ? failure->program : "build/glint");
}

/* ---- What differs -------------------------------------------------------------------------------
 */

static void print_run(FILE *out, const glint_failure *failure)
{
    char setting[GLINT_SETTING_TEXT];
    glint_setting_describe(&failure->setting, setting);
    if (failure->kind == GLINT_FAILURE_RANDOM && failure->run.comparisons != 0)
        fprintf(out, "%s: %" PRIu64 " mismatches of %" PRIu64 "\n", setting,
                failure->run.mismatches, failure->run.comparisons);
    else
        fprintf(out, "%s: a mismatch (%s)\n", setting, glint_failure_kind_names[failure->kind]);
}

static void print_frame(FILE *out, const glint_failure_frame *frame)
{
    if (!frame->has_pixel) {
        fprintf(out, "frame of %dx%d: the circuit keeps an answer back\n", frame->width,
                frame->height);
        return;
    }
    fprintf(out, "frame of %dx%d, first at x=%d y=%d: model %u,%u,%u, rtl %u,%u,%u\n", frame->width,
            frame->height, frame->x, frame->y, frame->model[0], frame->model[1], frame->model[2],
            frame->rtl[0], frame->rtl[1], frame->rtl[2]);
    if (frame->has_triangle) {
        fprintf(out, "triangle %" PRIu32 " of the mesh:", frame->triangle);
        for (int i = 0; i < 3; i++)
            fprintf(out, " (%.9g, %.9g, %.9g)", (double)frame->corner[i][0],
                    (double)frame->corner[i][1], (double)frame->corner[i][2]);
        fprintf(out, "\n");
    }
    if (frame->has_fragment)
        fprintf(out, "its highlight there: n %u, cosine 0x%05" PRIx32 " (%.9g), R,G,B %u,%u,%u\n",
                frame->material.n, frame->cos_code, (double)frame->cos_code / GLINT_COS_ONE,
                frame->material.r, frame->material.g, frame->material.b);
}

/* The point as a line for `glint eval` says more than a list of its values. It takes lane 0: one of
 * another lane comes behind as many of itself, and is the last row printed. */
static void print_point_alone(FILE *out, const glint_failure *failure)
{
    const glint_answer *answer = &failure->answer;
    const glint_specular_config *config = &failure->setting.specular;
    const int lane = answer->at % config->lanes;
    fprintf(out, "  alone: %s '%u 0x%" PRIx32 " %u %u %u' | ", lane == 0 ? "echo" : "yes",
            answer->material.n, answer->cos_code[answer->at], answer->material.r,
            answer->material.g, answer->material.b);
    if (lane != 0)
        fprintf(out, "head -n %d | ", lane + 1);
    print_program(out, failure);
    fprintf(out, " eval --backend rtl --gate %s --pipeline %s --lanes %d\n",
            glint_gate_name(config->gate), glint_pipeline_name(config->pipeline), config->lanes);
}

static void print_point(FILE *out, const glint_failure *failure)
{
    const glint_answer *answer = &failure->answer;
    const glint_specular_config *config = &failure->setting.specular;
    const uint32_t code = answer->cos_code[answer->at];
    fprintf(out, "  n %u, cosine 0x%05" PRIx32 " (%.9g), R,G,B %u,%u,%u, lane %d: %s: ",
            answer->material.n, code, (double)code / GLINT_COS_ONE, answer->material.r,
            answer->material.g, answer->material.b, answer->at % config->lanes,
            glint_answer_value_name(answer->value));
    fprintf(out, "model %" PRId32 ", rtl %" PRId32 "\n", answer->model, answer->rtl);
    if (failure->finding.alone_differs)
        print_point_alone(out, failure);
}

/* The components before the answer's are there to put it in its place: `glint divide` takes lines
 * of one k for R, G and B of one division. It is the last row printed. */
static void print_division_alone(FILE *out, const glint_failure *failure)
{
    const glint_answer *answer = &failure->answer;
    const glint_division *division = &answer->division[answer->at];
    fprintf(out, "  alone: printf '");
    for (int c = 0; c <= (int)answer->value - GLINT_ANSWER_R; c++)
        fprintf(out, "%d %u\\n", division->difference[c], division->k);
    fprintf(out, "' | ");
    print_program(out, failure);
    fprintf(out, " divide --backend rtl --form %s --shifts %d\n",
            glint_divider_form_name(failure->setting.form), failure->setting.shifts);
}

static void print_division(FILE *out, const glint_failure *failure)
{
    const glint_answer *answer = &failure->answer;
    const glint_division *division = &answer->division[answer->at];
    const int component = (int)answer->value - GLINT_ANSWER_R;
    const double one = (double)(1 << failure->setting.shifts);
    fprintf(out,
            "  difference %d, k %u: quotient of %s: model %" PRId32 " (%.9g), rtl %" PRId32
            " (%.9g)\n",
            division->difference[component], division->k, glint_answer_value_name(answer->value),
            answer->model, answer->model / one, answer->rtl, answer->rtl / one);
    if (failure->finding.alone_differs)
        print_division_alone(out, failure);
}

static void print_answer(FILE *out, const glint_failure *failure)
{
    const glint_failure_finding *finding = &failure->finding;
    fprintf(out, "the first answer of the circuit that differs%s:\n",
            failure->kind == GLINT_FAILURE_FRAME ? ", in the order of rendering" : "");
    if (failure->setting.is_divider)
        print_division(out, failure);
    else
        print_point(out, failure);
    if (failure->pins != NULL)
        fprintf(out,
                "asked again, alone with its neighbours, the circuit answers as the model does: "
                "what is below went before them\n");
    else if (!finding->answer_differs)
        fprintf(out,
                "asked again, alone with its neighbours, the circuit answers %" PRId32
                " as the model does: what went before them matters\n",
                finding->rtl);
}

/* ---- The table of clocks ------------------------------------------------------------------------
 */

static void cell(FILE *out, const char *text, int width)
{
    fprintf(out, "  %*s", width, text);
}

static int wider(int a, int b)
{
    return a > b ? a : b;
}

/* Bits as bits, cosines as codes, all else as numbers. */
static void pin_text(const glint_pin_info *pin, int64_t value, char text[COLUMN])
{
    if (pin->frac_bits > 0 || strcmp(pin->name, "in_valid") == 0)
        (void)snprintf(text, COLUMN, "0x%0*" PRIx64, (pin->width + 3) / 4, (uint64_t)value);
    else
        (void)snprintf(text, COLUMN, "%" PRId64, value);
}

static void pin_name(const glint_pin_info *pin, int lanes, char text[COLUMN])
{
    if (pin->lane >= 0 && lanes > 1)
        (void)snprintf(text, COLUMN, "%s[%d]", pin->name, pin->lane);
    else
        (void)snprintf(text, COLUMN, "%s", pin->name);
}

static int pin_width(const glint_pin_info *pin, int lanes)
{
    char name[COLUMN], least[COLUMN], most[COLUMN];
    pin_name(pin, lanes, name);
    pin_text(pin, pin->min, least);
    pin_text(pin, pin->max, most);
    return wider((int)strlen(name), wider((int)strlen(least), (int)strlen(most)));
}

static bool differs_then(const glint_capture *capture, int signal)
{
    const glint_capture_clock *failing = &capture->clock[capture->failing];
    return failing->rtl[signal] != failing->model[signal];
}

/* Whether the signal is the output with the answer's value. */
static bool is_answer(const glint_failure *failure, const glint_signal_info *signal)
{
    static const char *const points[] = {"out_w", "out_r", "out_g", "out_b"};
    static const char *const divisions[] = {"", "quotient_r", "quotient_g", "quotient_b"};
    const glint_answer *answer = &failure->answer;
    const glint_setting *setting = &failure->setting;
    if (!failure->has_answer || failure->pins != NULL)
        return false;
    if (!answer->is_divider)
        return strcmp(signal->name, points[answer->value]) == 0 &&
               signal->lane == answer->at % setting->specular.lanes;
    return strcmp(signal->name, setting->form == GLINT_DIVIDER_SEQUENTIAL
                                    ? "quotient"
                                    : divisions[answer->value]) == 0;
}

/* Index of the signal that the table shows, of those that differ in the failing clock: the answer,
 * or else the first; −1: none does. */
static int signal_of_table(const glint_failure *failure, const glint_capture *capture)
{
    int first = -1;
    for (int i = glint_setting_signal_count(&capture->setting) - 1; i >= 0; i--) {
        const glint_signal_info signal = glint_setting_signal(&capture->setting, i);
        if (!differs_then(capture, i))
            continue;
        if (is_answer(failure, &signal))
            return i;
        first = i;
    }
    return first;
}

/* Of several lanes the table has the cosine of one: the failing one's. */
static bool is_in_table(const glint_capture *capture, const glint_pin_info *pin, int signal)
{
    const int lane = signal >= 0 ? glint_setting_signal(&capture->setting, signal).lane : 0;
    return pin->lane < 0 || pin->lane == wider(lane, 0);
}

static void print_heading(FILE *out, const glint_capture *capture, int signal)
{
    const glint_setting *setting = &capture->setting;
    fprintf(out, "  %10s", "clock");
    for (int i = 0; i < glint_pin_count(setting); i++) {
        char name[COLUMN];
        const glint_pin_info pin = glint_pin(setting, i);
        pin_name(&pin, setting->specular.lanes, name);
        if (is_in_table(capture, &pin, signal))
            cell(out, name, pin_width(&pin, setting->specular.lanes));
    }
    if (signal >= 0) {
        const glint_signal_info info = glint_setting_signal(setting, signal);
        fprintf(out, "  %s: model, rtl", info.name);
    }
    fprintf(out, "\n");
}

static void print_clock(FILE *out, const glint_capture *capture, int row, int signal)
{
    const glint_setting *setting = &capture->setting;
    const glint_capture_clock *clock = &capture->clock[row];
    fprintf(out, "%s %10" PRIu64, row == capture->failing ? ">" : " ", clock->clock);
    for (int i = 0; i < glint_pin_count(setting); i++) {
        char text[COLUMN];
        const glint_pin_info pin = glint_pin(setting, i);
        pin_text(&pin, glint_pin_get(setting, &clock->pins, i), text);
        if (is_in_table(capture, &pin, signal))
            cell(out, text, pin_width(&pin, setting->specular.lanes));
    }
    if (signal >= 0) {
        const glint_signal_info info = glint_setting_signal(setting, signal);
        const int digits = (info.int_bits + info.frac_bits + 3) / 4;
        fprintf(out, "  0x%0*" PRIx64 " 0x%0*" PRIx64, digits, clock->model[signal], digits,
                clock->rtl[signal]);
    }
    fprintf(out, "\n");
}

/* What the table's first clock left in the registers of the material: it may be older. */
static void print_material(FILE *out, const glint_capture *capture, int row)
{
    static const char *const names[] = {"reg2", "reg3", "reg4", "reg5"};
    uint64_t held[4] = {0};
    for (int i = 0; i < glint_setting_signal_count(&capture->setting); i++)
        for (int r = 0; r < 4; r++)
            if (strcmp(glint_setting_signal(&capture->setting, i).name, names[r]) == 0)
                held[r] = capture->clock[row].model[i];
    fprintf(out,
            "after the first of them registers 2 to 5 hold n = %" PRIu64 ", %" PRIu64 ", %" PRIu64
            ", %" PRIu64 "\n",
            held[0], held[1], held[2], held[3]);
}

static void print_table(FILE *out, const glint_failure *failure, const glint_capture *capture)
{
    const int last = capture->failing;
    const int first = last + 1 > GLINT_CAPTURE_BEFORE ? last + 1 - GLINT_CAPTURE_BEFORE : 0;
    const int signal = signal_of_table(failure, capture);
    const glint_signal_info shown =
        glint_setting_signal(&capture->setting, signal < 0 ? 0 : signal);
    fprintf(out, "the last %d clocks, at each edge the pins, and after it both values of the %s:\n",
            last + 1 - first,
            signal >= 0 && is_answer(failure, &shown) ? "answer" : "first signal to differ");
    print_heading(out, capture, signal);
    for (int row = first; row <= last; row++)
        print_clock(out, capture, row, signal);
    if (!capture->setting.is_divider)
        print_material(out, capture, first);
}

/* ---- All of it ----------------------------------------------------------------------------------
 */

void glint_failure_print_mismatches(FILE *out, const glint_failure *failure,
                                    const glint_failure_finding *finding,
                                    const glint_lockstep_result *found)
{
    if (!failure->has_answer || failure->pins != NULL) {
        glint_mismatch_print(out, &failure->setting, found);
        return;
    }
    if (found->kept != 0 && found->mismatch[0].clock < finding->clock) {
        fprintf(out, "the first signal to differ:\n");
        glint_mismatch_print_one(out, &failure->setting, &found->mismatch[0]);
        fprintf(out, "and when the answer is out:\n");
    }
    for (int i = 0; i < finding->count; i++)
        glint_mismatch_print_one(out, &failure->setting, &finding->mismatch[i]);
}

static void print_lockstep(FILE *out, const glint_failure *failure, const glint_capture *capture)
{
    const bool has_run = failure->run.comparisons != 0;
    if (!failure->finding.lockstep_differs && !failure->finding.answer_differs)
        return;
    if (!failure->finding.lockstep_differs) {
        fprintf(out,
                "clock by clock, in the build of the circuit whose signals can be read, nothing "
                "differs: the builds of one Verilog do not do the same\n");
        return;
    }
    glint_failure_print_mismatches(out, failure, &failure->finding,
                                   has_run ? &failure->run : &capture->found);
}

static void print_how_played(FILE *out, const glint_failure *failure)
{
    if (failure->kind == GLINT_FAILURE_RANDOM)
        fprintf(out, "seed: %" PRIu64 "\n", failure->seed);
    else if (failure->pins == NULL)
        return;
    if (failure->interrupted)
        fprintf(out, "interrupted before it was played again: there is no packet\n");
    else if (failure->pins == NULL)
        fprintf(out, "played from clock 1: no part of the run shows the mismatch by itself\n");
    else
        fprintf(out, "played from clock %" PRIu64 ", %zu clocks\n", failure->first_clock,
                failure->pin_count);
}

static void print_look(FILE *out, const char *directory)
{
    static const char *const files[] = {GLINT_PACKET_WAVE, GLINT_PACKET_SAVE_FILE};
    fprintf(out, "look:   gtkwave");
    for (int i = 0; i < 2; i++) {
        char path[WORD];
        (void)snprintf(path, sizeof path, "%s/%s", directory, files[i]);
        fprintf(out, " ");
        print_word(out, path);
    }
    fprintf(out, "\n");
}

void glint_failure_report(FILE *out, const glint_failure *failure, const glint_capture *capture,
                          const char *directory)
{
    print_run(out, failure);
    if (failure->kind == GLINT_FAILURE_FRAME)
        print_frame(out, &failure->frame);
    if (failure->has_answer)
        print_answer(out, failure);
    if (capture == NULL && failure->interrupted) {
        glint_failure_print_mismatches(out, failure, &failure->finding, &failure->run);
    } else if (capture == NULL) {
        fprintf(out, "no answer of the circuit was found to differ when the frame was rendered "
                     "again: there are no clocks to show\n");
    } else {
        print_lockstep(out, failure, capture);
        print_table(out, failure, capture);
    }
    if (failure->run.comparisons != 0)
        glint_mismatch_print_totals(out, &failure->run);
    print_how_played(out, failure);
    if (failure->command[0] != '\0')
        fprintf(out, "whole:  %s\n", failure->command);
    if (capture == NULL || directory == NULL)
        return;
    print_look(out, directory);
    fprintf(out, "replay: ");
    print_program(out, failure);
    fprintf(out, " replay ");
    print_word(out, directory);
    fprintf(out, "\n");
}
