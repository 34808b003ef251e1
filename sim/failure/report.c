/* The text of report.txt, section by section. */
#include "failure/report.h"

#include <inttypes.h>
#include <string.h>

#include "circuit/circuits.h"
#include "circuit/units.h"
#include "circuit/words.h"
#include "failure/answer_form.h"
#include "failure/packet.h"
#include "failure/shell.h"
#include "lockstep/answer_kind.h"
#include "lockstep/mismatch.h"
#include "wave/presentation.h"

#define COLUMN GLINT_VALUE_TEXT /* the longest text in one */
#define PATH   (GLINT_FAILURE_DIRECTORY + 64)

/* A word of a command line. */
static void print_word(FILE *out, const char *word)
{
    char text[GLINT_SHELL_WORD(PATH)] = "";
    glint_shell_append(text, sizeof text, word);
    fprintf(out, "%s", text);
}

/* A positional argument, not an option. */
static void print_path(FILE *out, const char *path)
{
    fprintf(out, " %s", path[0] == '-' ? "./" : "");
    print_word(out, path);
}

void glint_failure_print_program(FILE *out, const glint_failure *failure)
{
    print_word(out, failure->program != NULL ? failure->program : "build/glint");
}

static void print_directory(FILE *out, const char *option, const char *directory)
{
    if (directory[0] == '\0')
        return;
    fprintf(out, " %s ", option);
    print_word(out, directory);
}

void glint_failure_print_directories(FILE *out, const glint_failure *failure)
{
    print_directory(out, "--circuit-dir", failure->circuit_dir);
    print_directory(out, "--rtl", glint_failure_rtl(failure));
}

const glint_answer_form *glint_answer_form_of(const glint_circuit *circuit)
{
    if (glint_is_highlight(circuit))
        return &glint_point_form;
    return circuit == &glint_circuit_divider ? &glint_division_form
           : circuit == &glint_circuit_span  ? &glint_span_form
                                             : NULL;
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
        fprintf(out, "frame of %dx%d: the circuit failed to answer\n", frame->width, frame->height);
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
        fprintf(out, "the highlight there: n %u, cosine 0x%05" PRIx32 " (%.9g), R,G,B %u,%u,%u\n",
                frame->material.n, frame->cos_code, (double)frame->cos_code / GLINT_COS_ONE,
                frame->material.r, frame->material.g, frame->material.b);
}

static void print_answer(FILE *out, const glint_failure *failure)
{
    const glint_failure_finding *finding = &failure->finding;
    fprintf(out, "the first answer of the circuit to differ%s:\n",
            failure->kind == GLINT_FAILURE_FRAME ? ", in the order of rendering" : "");
    glint_answer_form_of(failure->setting.circuit)->print(out, failure);
    if (failure->pins != NULL)
        fprintf(out, "when replayed in isolation, the circuit agrees with the model; the clocks "
                     "before it, shown below, matter\n");
    else if (!finding->answer_differs)
        fprintf(out,
                "when replayed in isolation, the circuit answers %" PRId32
                " and agrees with the model; the clocks before it matter\n",
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

/* Lane bits as bits, cosines as codes, wide values as hex; everything else as numbers. */
static bool is_code(const glint_pin_info *pin)
{
    return pin->frac_bits > 0 || strcmp(pin->name, "in_valid") == 0 || glint_pin_width(pin) > 64;
}

static void words_text(const glint_pin_info *pin, const uint64_t *words, char text[COLUMN])
{
    const int width = glint_pin_width(pin);
    if (is_code(pin))
        glint_words_hex(words, width, text);
    else
        glint_words_decimal(words, width, pin->is_signed, text);
}

static void pin_name(const glint_setting *setting, const glint_pin_info *pin, char text[COLUMN])
{
    if (pin->lane >= 0 && glint_show_place(setting) != NULL)
        (void)snprintf(text, COLUMN, "%s[%d]", pin->name, pin->lane);
    else
        (void)snprintf(text, COLUMN, "%s", pin->name);
}

/* Of the name and of the longest value: the largest, or with a sign the smallest. */
static int pin_width(const glint_setting *setting, const glint_pin_info *pin)
{
    char name[COLUMN], longest[COLUMN];
    uint64_t words[GLINT_VALUE_WORDS];
    const int top = glint_pin_width(pin) - 1;
    memset(words, pin->is_signed ? 0 : 0xff, sizeof words);
    if (pin->is_signed)
        words[top / 64] = UINT64_C(1) << top % 64;
    pin_name(setting, pin, name);
    words_text(pin, words, longest);
    return wider((int)strlen(name), (int)strlen(longest));
}

/* Whether the signal is the output with the answer's value. */
static bool is_answer(const glint_failure *failure, const glint_signal_info *signal)
{
    const glint_setting *setting = &failure->setting;
    if (!failure->has_answer || failure->pins != NULL)
        return false;
    return glint_answer_kind_of(setting->circuit)->is_output(&failure->answer, setting, signal);
}

/* Index of the signal that the table shows, of those that differ in the failing clock: the answer,
 * or else the first; −1: none does. */
static int signal_of_table(const glint_failure *failure, const glint_capture *capture)
{
    int first = -1;
    for (int i = capture->signals.count - 1; i >= 0; i--) {
        if (!glint_capture_differs_at(capture, capture->failing, i))
            continue;
        if (is_answer(failure, &capture->signals.info[i]))
            return i;
        first = i;
    }
    return first;
}

/* Of several lanes the table has the pins of one: the failing one's. */
static bool is_in_table(const glint_capture *capture, const glint_pin_info *pin, int signal)
{
    const int lane = signal >= 0 ? capture->signals.info[signal].lane : 0;
    return pin->lane < 0 || pin->lane == wider(lane, 0);
}

static void print_heading(FILE *out, const glint_capture *capture, int signal)
{
    const glint_setting *setting = &capture->setting;
    fprintf(out, "  %10s", "clock");
    for (int i = 0; i < glint_setting_pin_count(setting); i++) {
        char name[COLUMN];
        const glint_pin_info pin = glint_setting_pin(setting, i);
        pin_name(setting, &pin, name);
        if (is_in_table(capture, &pin, signal))
            cell(out, name, pin_width(setting, &pin));
    }
    if (signal >= 0)
        fprintf(out, "  %s: model, rtl", capture->signals.info[signal].name);
    fprintf(out, "\n");
}

static void print_both(FILE *out, const glint_capture *capture, int row, int signal)
{
    const glint_capture_clock *clock = &capture->clock[row];
    const int width = glint_signal_width(&capture->signals.info[signal]);
    char text[GLINT_VALUE_TEXT];
    glint_words_hex(glint_capture_words(capture, clock->model, signal), width, text);
    fprintf(out, "  %s", text);
    glint_words_hex(glint_capture_words(capture, clock->rtl, signal), width, text);
    fprintf(out, " %s", text);
}

static void print_clock(FILE *out, const glint_capture *capture, int row, int signal)
{
    const glint_setting *setting = &capture->setting;
    const glint_capture_clock *clock = &capture->clock[row];
    fprintf(out, "%s %10" PRIu64, row == capture->failing ? ">" : " ", clock->clock);
    for (int i = 0; i < glint_setting_pin_count(setting); i++) {
        char text[COLUMN];
        uint64_t words[GLINT_VALUE_WORDS];
        const glint_pin_info pin = glint_setting_pin(setting, i);
        glint_pin_get(&pin, &clock->pins, words);
        words_text(&pin, words, text);
        if (is_in_table(capture, &pin, signal))
            cell(out, text, pin_width(setting, &pin));
    }
    if (signal >= 0)
        print_both(out, capture, row, signal);
    fprintf(out, "\n");
}

static void print_table(FILE *out, const glint_failure *failure, const glint_capture *capture)
{
    const int last = capture->failing;
    const int first = last + 1 > GLINT_CAPTURE_BEFORE ? last + 1 - GLINT_CAPTURE_BEFORE : 0;
    const int signal = signal_of_table(failure, capture);
    const glint_answer_form *form = glint_answer_form_of(capture->setting.circuit);
    if (last == first)
        fprintf(out, "the only clock");
    else
        fprintf(out, "the last %d clocks", last + 1 - first);
    fprintf(out, ": the pins at each edge, then both values of the %s after it:\n",
            signal >= 0 && is_answer(failure, &capture->signals.info[signal])
                ? "answer"
                : "first signal to differ");
    print_heading(out, capture, signal);
    for (int row = first; row <= last; row++)
        print_clock(out, capture, row, signal);
    if (form != NULL && form->print_below != NULL)
        form->print_below(out, capture, first);
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
        fprintf(out, "and when the answer comes out:\n");
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
        fprintf(out, "clock by clock, in the build whose signals can be read, nothing differs: two "
                     "builds of the same Verilog behave differently\n");
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
        fprintf(out, "interrupted before the replay: no packet was written\n");
    else if (failure->pins == NULL)
        fprintf(out, "replayed from clock 1: no shorter part of the run reproduces the mismatch\n");
    else
        fprintf(out, "replayed from clock %" PRIu64 ", %zu clocks\n", failure->first_clock,
                failure->pin_count);
}

static void print_look(FILE *out, const char *directory)
{
    static const char *const files[] = {GLINT_PACKET_WAVE, GLINT_PACKET_SAVE_FILE};
    fprintf(out, "look:   gtkwave");
    for (int i = 0; i < 2; i++) {
        char path[PATH];
        (void)snprintf(path, sizeof path, "%s/%s", directory, files[i]);
        print_path(out, path);
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
        fprintf(out, "no answer of the circuit differed when the frame was rendered again, so "
                     "there are no clocks to show\n");
    } else {
        print_lockstep(out, failure, capture);
        print_table(out, failure, capture);
    }
    if (failure->run.comparisons != 0)
        glint_mismatch_print_totals(out, &failure->run);
    print_how_played(out, failure);
    if (failure->command[0] != '\0')
        fprintf(out, "whole:  %s%s\n", failure->command,
                strlen(failure->command) == sizeof failure->command - 1 ? "… (cut)" : "");
    if (capture == NULL || directory == NULL)
        return;
    print_look(out, directory);
    fprintf(out, "replay: ");
    glint_failure_print_program(out, failure);
    fprintf(out, " replay");
    print_path(out, directory);
    glint_failure_print_directories(out, failure);
    fprintf(out, "\n");
}
