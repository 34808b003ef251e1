/* Narrows a circuit's history down to the few clocks that show a difference. */
#include <stdlib.h>
#include <string.h>

#include "failure/failure.h"

#define LEAD_MIN 8u

/* Of the history that shows a mismatch: its pins up to some clocks after that. */
typedef struct shown {
    const volatile bool *stop;
    glint_pins *pins;
    size_t count;
    uint64_t first_clock;
} shown;

static glint_status play(const glint_setting *setting, const shown *of, size_t skipped,
                         glint_failure_finding *finding, glint_capture **capture, glint_error *err)
{
    const glint_failure played = {.kind = GLINT_FAILURE_RANDOM,
                                  .setting = *setting,
                                  .first_clock = of->first_clock + skipped,
                                  .pins = of->pins + skipped,
                                  .pin_count = of->count - skipped,
                                  .finding = {.clock = of->first_clock + of->count - 1}};
    const glint_capture_control control = {.stop = of->stop};
    return glint_failure_play(&played, &control, finding, capture, err);
}

/* Whether both sides had the same values in all the clocks about the mismatch. */
static bool same_clocks(const glint_capture *a, const glint_capture *b)
{
    bool same = a->count == b->count;
    for (int i = 0; same && i < a->count; i++)
        same = a->clock[i].clock == b->clock[i].clock &&
               memcmp(a->clock[i].model, b->clock[i].model, sizeof a->clock[i].model) == 0 &&
               memcmp(a->clock[i].rtl, b->clock[i].rtl, sizeof a->clock[i].rtl) == 0;
    return same;
}

static glint_status try_skipped(const glint_setting *setting, const shown *of, size_t skipped,
                                const glint_capture *whole, bool *same, glint_error *err)
{
    glint_failure_finding found;
    glint_capture *capture;
    const glint_status status = play(setting, of, skipped, &found, &capture, err);
    *same = status == GLINT_OK && found.lockstep_differs && same_clocks(capture, whole);
    if (status == GLINT_OK)
        free(capture);
    return status;
}

/* How many clocks can be left out at the beginning: of those before the window of the mismatch all
 * but 8, all but 48, … or none. */
static glint_status find_skipped(const glint_setting *setting, const shown *of, uint64_t failing,
                                 const glint_capture *whole, size_t *skipped, glint_error *err)
{
    const size_t before = (size_t)(failing - of->first_clock);
    glint_status status = GLINT_OK;
    bool same = false;
    *skipped = 0;
    for (size_t lead = LEAD_MIN + GLINT_CAPTURE_BEFORE;
         status == GLINT_OK && !same && lead < before; lead *= 2) {
        status = try_skipped(setting, of, before - lead, whole, &same, err);
        if (same)
            *skipped = before - lead;
    }
    return status;
}

static glint_status keep(glint_failure *failure, const shown *of, size_t skipped, glint_error *err)
{
    const size_t count = of->count - skipped;
    failure->pins = malloc(count * sizeof *failure->pins);
    if (failure->pins == NULL)
        return glint_fail(err, GLINT_NO_MEMORY, "not enough memory for a failure's pins");
    memcpy(failure->pins, of->pins + skipped, count * sizeof *failure->pins);
    failure->pin_count = count;
    failure->first_clock = of->first_clock + skipped;
    return GLINT_OK;
}

/* Keeps what shows the mismatch of the whole, and nothing where that shows none either. */
static glint_status keep_shown(glint_failure *failure, shown *of, glint_error *err)
{
    glint_failure_finding whole;
    glint_capture *capture;
    size_t skipped = 0;
    glint_status status = play(&failure->setting, of, 0, &whole, &capture, err);
    if (status != GLINT_OK)
        return status;
    if (whole.lockstep_differs) {
        const size_t up_to = (size_t)(whole.clock - of->first_clock) + 1 + GLINT_CAPTURE_AFTER;
        of->count = up_to < of->count ? up_to : of->count;
        status = find_skipped(&failure->setting, of, whole.clock, capture, &skipped, err);
        if (status == GLINT_OK)
            status = keep(failure, of, skipped, err);
        if (status == GLINT_OK) {
            failure->finding = whole;
            free(failure->capture);
            failure->capture = capture;
            return GLINT_OK;
        }
    }
    free(capture);
    return status;
}

static glint_status play_history(glint_failure *failure, const glint_history *history,
                                 const volatile bool *stop, glint_error *err)
{
    shown all = {.stop = stop};
    all.pins = glint_history_pins(history, &all.count, &all.first_clock);
    if (all.pins == NULL)
        return glint_fail(err, GLINT_NO_MEMORY, "not enough memory for a circuit's history");
    const glint_status status = keep_shown(failure, &all, err);
    free(all.pins);
    return status;
}

static glint_status play_block(glint_failure *failure, const glint_domain_options *options,
                               const glint_domain_mismatch *mismatch, glint_error *err)
{
    shown all = {.stop = options->stop, .first_clock = 1};
    all.pins = glint_domain_pins(options, mismatch->block, mismatch->signal.clock,
                                 GLINT_CAPTURE_AFTER, &all.count);
    if (all.pins == NULL)
        return glint_fail(err, GLINT_NO_MEMORY, "not enough memory for a circuit's history");
    glint_status status = keep_shown(failure, &all, err);
    free(all.pins);
    if (status == GLINT_OK && failure->pins == NULL)
        status = glint_fail(err, GLINT_DEVICE_FAULT,
                            "when replayed, the Verilog agrees with the C model: one of the two is "
                            "not deterministic");
    return status;
}

glint_status glint_failure_of_domain(const glint_domain_options *options,
                                     const glint_domain_mismatch *mismatch, glint_failure **failure,
                                     glint_error *err)
{
    glint_status status =
        glint_failure_of_answer(GLINT_FAILURE_EXHAUSTIVE, &options->setting, NULL, failure, err);
    if (status != GLINT_OK)
        return status;
    status = play_block(*failure, options, mismatch, err);
    if (status != GLINT_OK) {
        glint_failure_destroy(*failure);
        *failure = NULL;
    }
    return status;
}

glint_status glint_failure_of_history(glint_failure_kind kind, const glint_setting *setting,
                                      const glint_answer *answer, const glint_history *history,
                                      const volatile bool *stop, glint_failure **failure,
                                      glint_error *err)
{
    glint_status status = glint_failure_of_answer(kind, setting, answer, failure, err);
    if (status != GLINT_OK || history == NULL || glint_failure_differs(&(*failure)->finding))
        return status;
    status = play_history(*failure, history, stop, err);
    if (status != GLINT_OK) {
        glint_failure_destroy(*failure);
        *failure = NULL;
    }
    return status;
}
