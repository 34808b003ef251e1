/* From a lockstep run to the few clocks of it that show its first mismatch. */
#include <stdlib.h>
#include <string.h>

#include "failure/failure.h"
#include "lockstep/twin.h"

/* The fewest clocks before the window that are tried, and the most. Registers that are seldom
 * loaded may need many. */
#define LEAD_MIN 8u
#define LEAD_MAX 8192u
#define WINDOW   (GLINT_CAPTURE_BEFORE + 1u)
#define RECENT   (LEAD_MAX + WINDOW + GLINT_CAPTURE_AFTER)

/* The run once more, up to 8 clocks after the first mismatch. */
typedef struct history {
    const glint_setting *setting;
    uint64_t failing;
    uint64_t first; /* of the pins kept: the last RECENT clocks */
    size_t count;
    glint_pins *pins;
    glint_capture *capture; /* the clocks of the window, and those after it */
} history;

static uint64_t later(uint64_t a, uint64_t b)
{
    return a > b ? a : b;
}

/* The clock a given number before another, or 1. */
static uint64_t before(uint64_t clock, uint64_t count)
{
    return clock > count ? clock - count : 1;
}

/* Both sides are played, so that it need not be done again where only the whole run shows it. */
static glint_status remember(history *h, const glint_lockstep_options *options, glint_error *err)
{
    const uint64_t last = h->failing + GLINT_CAPTURE_AFTER;
    const glint_capture_control control = {options->stop, options->progress,
                                           options->progress_context};
    h->first = before(last + 1, RECENT);
    h->count = (size_t)(last + 1 - h->first);
    h->pins = calloc(h->count, sizeof *h->pins);
    if (h->pins == NULL)
        return glint_fail(err, GLINT_NO_MEMORY,
                          "not enough memory for the clocks before a failure");
    const glint_play whole = {.setting = h->setting,
                              .seed = options->seed,
                              .expected = h->failing,
                              .control = &control,
                              .kept = h->pins,
                              .kept_from = h->first,
                              .kept_count = h->count};
    return glint_capture_play(&whole, &h->capture, err);
}

/* Whether the C model, begun in reset state at clock `start`, has all that it had in the window. */
static glint_status suffices(const history *h, uint64_t start, bool *same, glint_error *err)
{
    const size_t size = (size_t)h->capture->signals.words * sizeof(uint64_t);
    const glint_capture_clock *window = h->capture->clock;
    uint64_t model[GLINT_SIGNAL_WORDS_MAX];
    glint_twin *twin;
    const glint_status status = glint_twin_create_model(h->setting, &twin, err);
    if (status != GLINT_OK)
        return status;
    *same = true;
    for (uint64_t clock = start; *same && clock <= h->failing; clock++) {
        glint_twin_clock(twin, &h->pins[clock - h->first]);
        if (clock < window[0].clock)
            continue;
        glint_twin_read(twin, model, NULL);
        *same = memcmp(model, window[clock - window[0].clock].model, size) == 0;
    }
    glint_twin_destroy(twin);
    return GLINT_OK;
}

static glint_status keep_pins(glint_failure *failure, const history *h, uint64_t start,
                              glint_error *err)
{
    const size_t skipped = (size_t)(start - h->first);
    failure->first_clock = start;
    failure->pin_count = h->count - skipped;
    free(failure->pins);
    failure->pins = calloc(failure->pin_count, sizeof *failure->pins);
    if (failure->pins == NULL)
        return glint_fail(err, GLINT_NO_MEMORY, "not enough memory for a failure's pins");
    memcpy(failure->pins, h->pins + skipped, failure->pin_count * sizeof *failure->pins);
    return GLINT_OK;
}

/* Whether the Verilog, played from `start` on, shows the mismatch that the run had. */
static glint_status shows(glint_failure *failure, const history *h, uint64_t start, bool *same,
                          glint_error *err)
{
    glint_failure_finding found;
    *same = false;
    glint_status status = suffices(h, start, same, err);
    if (status != GLINT_OK || !*same)
        return status;
    free(failure->capture);
    failure->capture = NULL;
    status = keep_pins(failure, h, start, err);
    if (status == GLINT_OK)
        status = glint_failure_play(failure, NULL, &found, &failure->capture, err);
    if (status == GLINT_OK)
        *same = glint_failure_same(&found, &failure->finding);
    return status;
}

/* If none are kept, the whole run must be replayed and the failure stores no pins. */
static glint_status find_shortest(glint_failure *failure, history *h, glint_error *err)
{
    const glint_capture *whole = h->capture;
    bool same = false;
    glint_status status = GLINT_OK;
    const bool again = whole->clock[whole->failing].clock == h->failing;
    for (uint64_t lead = LEAD_MIN; status == GLINT_OK && again && !same && lead <= LEAD_MAX;
         lead *= 2)
        status =
            shows(failure, h, later(before(whole->clock[0].clock, lead), h->first), &same, err);
    if (status == GLINT_OK && !same) {
        free(failure->pins);
        failure->pins = NULL;
        failure->pin_count = 0;
        failure->first_clock = 1;
        free(failure->capture);
        failure->capture = h->capture;
        h->capture = NULL;
    }
    return status;
}

/* The run's finding, in the form of a replay's. */
static void take_run(glint_failure *failure, const glint_lockstep_result *result)
{
    glint_failure_finding *finding = &failure->finding;
    failure->run = *result;
    finding->lockstep_differs = true;
    finding->clock = result->first_clock;
    while (finding->count < result->kept &&
           result->mismatch[finding->count].clock == result->first_clock) {
        finding->mismatch[finding->count] = result->mismatch[finding->count];
        finding->count++;
    }
}

/* Being stopped is not an error: the run's finding must still be reported. */
static glint_status play_again(glint_failure *made, const glint_lockstep_options *options,
                               glint_error *err)
{
    history h = {.setting = &options->setting, .failing = made->finding.clock};
    glint_status status = remember(&h, options, err);
    if (status == GLINT_OK)
        status = find_shortest(made, &h, err);
    made->interrupted = status == GLINT_INTERRUPTED;
    free(h.pins);
    free(h.capture);
    return made->interrupted ? GLINT_OK : status;
}

glint_status glint_failure_of_lockstep(const glint_lockstep_options *options,
                                       const glint_lockstep_result *result, glint_failure **failure,
                                       glint_error *err)
{
    *failure = NULL;
    if (result->mismatches == 0)
        return glint_fail(err, GLINT_BAD_ARGUMENT, "no mismatch: nothing to explain");
    glint_failure *made = calloc(1, sizeof *made);
    if (made == NULL)
        return glint_fail(err, GLINT_NO_MEMORY, "not enough memory for a failure");
    made->kind = GLINT_FAILURE_RANDOM;
    made->setting = options->setting;
    glint_failure_name_verilog(made);
    made->seed = options->seed;
    made->first_clock = 1;
    take_run(made, result);
    const glint_status status = play_again(made, options, err);
    if (status != GLINT_OK) {
        glint_failure_destroy(made);
        return status;
    }
    *failure = made;
    return GLINT_OK;
}
