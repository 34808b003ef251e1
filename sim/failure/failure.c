/* Failures from findings, their comparison and their end; see failure.h. */
#include "failure/failure.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "lockstep/mismatch.h"

const char *const glint_failure_kind_names[GLINT_FAILURE_KINDS] = {"random", "exhaustive", "frame"};

void glint_failure_name_verilog(glint_failure *failure)
{
    const char *verilog = failure->setting.verilog;
    (void)snprintf(failure->rtl, sizeof failure->rtl, "%s", verilog != NULL ? verilog : "");
}

void glint_failure_destroy(glint_failure *failure)
{
    if (failure == NULL)
        return;
    free(failure->pins);
    free(failure->capture);
    free(failure);
}

static void take_finding(const glint_capture *capture, glint_failure_finding *finding)
{
    const glint_capture_clock *failing = &capture->clock[capture->failing];
    finding->lockstep_differs = capture->found.mismatches != 0;
    finding->clock = failing->clock;
    finding->count = 0;
    for (int i = 0; i < capture->signals.count && finding->count < GLINT_MISMATCHES_KEPT; i++)
        if (glint_capture_differs_at(capture, capture->failing, i))
            finding->mismatch[finding->count++] =
                glint_mismatch_of(failing->clock, &capture->signals.info[i],
                                  glint_capture_words(capture, failing->model, i),
                                  glint_capture_words(capture, failing->rtl, i));
}

static glint_status play(const glint_play *play, glint_failure_finding *finding,
                         glint_capture **capture, glint_error *err)
{
    glint_capture *played;
    const glint_status status = glint_capture_play(play, &played, err);
    if (status != GLINT_OK)
        return status;
    take_finding(played, finding);
    if (capture != NULL)
        *capture = played;
    else
        free(played);
    return GLINT_OK;
}

/* As a frame asks, among its neighbours, and in isolation. If a circuit fails to answer, there is
 * no answer to show the difference. */
static glint_status ask(const glint_failure *failure, glint_failure_finding *finding,
                        glint_error *err)
{
    const glint_setting *setting = &failure->setting;
    glint_answer alone;
    int32_t model, rtl;
    glint_status status =
        glint_answer_ask(&failure->answer, setting, &finding->model, &finding->rtl, err);
    if (status != GLINT_OK)
        return status;
    glint_answer_alone(&failure->answer, setting, &alone);
    status = glint_answer_ask(&alone, setting, &model, &rtl, err);
    finding->answer_differs = finding->model != finding->rtl;
    finding->alone_differs = status == GLINT_OK && finding->answer_differs &&
                             model == finding->model && rtl == finding->rtl;
    return status == GLINT_DEVICE_FAULT ? GLINT_OK : status;
}

/* Up to the clock after which the answer is out. Where nothing differs there but something does
 * before, up to that. */
static glint_status play_asked(glint_play *asked, glint_failure_finding *finding,
                               glint_capture **capture, glint_error *err)
{
    asked->up_to_expected = true;
    glint_status status = play(asked, finding, capture, err);
    if (status != GLINT_OK || !finding->lockstep_differs || finding->count != 0)
        return status;
    if (capture != NULL) {
        free(*capture);
        *capture = NULL;
    }
    asked->up_to_expected = false;
    return play(asked, finding, capture, err);
}

static glint_status play_answer(const glint_failure *failure, const glint_capture_control *control,
                                glint_failure_finding *finding, glint_capture **capture,
                                glint_error *err)
{
    glint_play asked = {.setting = &failure->setting, .first_clock = 1, .control = control};
    glint_status status = ask(failure, finding, err);
    if (status != GLINT_OK)
        return status;
    glint_pins *pins =
        glint_answer_pins(&failure->answer, &failure->setting, &asked.count, &asked.expected);
    if (pins == NULL)
        return glint_fail(err, GLINT_NO_MEMORY, "not enough memory for a failure's pins");
    asked.pins = pins;
    status = play_asked(&asked, finding, capture, err);
    free(pins);
    return status;
}

glint_status glint_failure_play(const glint_failure *failure, const glint_capture_control *control,
                                glint_failure_finding *finding, glint_capture **capture,
                                glint_error *err)
{
    memset(finding, 0, sizeof *finding);
    if (capture != NULL)
        *capture = NULL;
    if (failure->kind == GLINT_FAILURE_RANDOM || failure->pins != NULL)
        return play(&(glint_play){.setting = &failure->setting,
                                  .pins = failure->pins,
                                  .count = failure->pin_count,
                                  .first_clock = failure->first_clock,
                                  .seed = failure->seed,
                                  .expected = failure->finding.clock,
                                  .control = control},
                    finding, capture, err);
    if (!glint_failure_playable(failure))
        return glint_fail(err, GLINT_BAD_INPUT,
                          "nothing to replay: no differing answer of the circuit was found");
    return play_answer(failure, control, finding, capture, err);
}

static bool same_mismatch(const glint_mismatch *a, const glint_mismatch *b)
{
    return strcmp(a->signal.name, b->signal.name) == 0 && a->signal.lane == b->signal.lane &&
           memcmp(a->model, b->model, sizeof a->model) == 0 &&
           memcmp(a->rtl, b->rtl, sizeof a->rtl) == 0;
}

bool glint_failure_same(const glint_failure_finding *a, const glint_failure_finding *b)
{
    bool same = a->answer_differs == b->answer_differs &&
                a->lockstep_differs == b->lockstep_differs && a->model == b->model &&
                a->rtl == b->rtl && a->clock == b->clock && a->count == b->count;
    for (int i = 0; same && i < a->count; i++)
        same = same_mismatch(&a->mismatch[i], &b->mismatch[i]);
    return same;
}

glint_status glint_failure_of_answer(glint_failure_kind kind, const glint_setting *setting,
                                     const glint_answer *answer, glint_failure **failure,
                                     glint_error *err)
{
    *failure = NULL;
    glint_failure *made = calloc(1, sizeof *made);
    if (made == NULL)
        return glint_fail(err, GLINT_NO_MEMORY, "not enough memory for a failure");
    made->kind = kind;
    made->setting = *setting;
    glint_failure_name_verilog(made);
    if (answer != NULL) {
        made->has_answer = true;
        made->answer = *answer;
        const glint_status status =
            glint_failure_play(made, NULL, &made->finding, &made->capture, err);
        if (status != GLINT_OK) {
            glint_failure_destroy(made);
            return status;
        }
    }
    *failure = made;
    return GLINT_OK;
}
