/* Replays pins through both sides, keeping the last clocks in a ring; see capture.h. */
#include "failure/capture.h"

#include <inttypes.h>
#include <stdlib.h>

#include "circuit/random_pins.h"
#include "lockstep/mismatch.h"

/* A replay in progress. The kept clocks form a ring: clock c is at c mod its size. */
typedef struct player {
    const glint_play *play;
    glint_twin *twin;
    glint_random_pins random;
    glint_capture *capture;
    uint64_t first, last; /* clocks played; first − 1 = last: none */
} player;

static glint_capture_clock *ring_at(glint_capture *capture, uint64_t clock)
{
    return &capture->clock[clock % GLINT_CAPTURE_CLOCKS];
}

/* The clock that the capture is about, as far as is known. */
static uint64_t middle_of(const player *p)
{
    const glint_lockstep_result *found = &p->capture->found;
    const uint64_t expected = p->play->expected;
    const bool waits = p->play->up_to_expected && found->first_clock <= expected;
    return found->mismatches != 0 && !waits ? found->first_clock : expected;
}

static bool has_pins(const player *p)
{
    return p->play->pins == NULL || p->last + 1 - p->first < p->play->count;
}

static bool stopped(const player *p)
{
    const glint_capture_control *control = p->play->control;
    return control != NULL && control->stop != NULL && *control->stop &&
           p->last + 1 - p->first > GLINT_CAPTURE_UNSTOPPED;
}

static void tell_progress(const player *p)
{
    const glint_capture_control *control = p->play->control;
    if (control != NULL && control->progress != NULL && p->last % 1024 == 0)
        control->progress(control->progress_context, p->last + 1 - p->first,
                          middle_of(p) + GLINT_CAPTURE_AFTER + 1 - p->first);
}

/* The pins of the next clock. */
static void take_pins(player *p, glint_pins *pins)
{
    const glint_play *play = p->play;
    if (play->pins != NULL) {
        *pins = play->pins[p->last - p->first];
        return;
    }
    glint_random_pins_next(&p->random, pins);
    if (play->kept != NULL && p->last >= play->kept_from &&
        p->last - play->kept_from < play->kept_count)
        play->kept[p->last - play->kept_from] = *pins;
}

static void play_clock(player *p)
{
    glint_capture_clock *now = ring_at(p->capture, ++p->last);
    now->clock = p->last;
    take_pins(p, &now->pins);
    glint_twin_clock(p->twin, &now->pins);
    glint_twin_read(p->twin, now->model, now->rtl);
    p->capture->found.clocks = p->last;
    glint_mismatch_compare_values(&p->capture->found, &p->capture->signals, now->model, now->rtl);
    tell_progress(p);
}

static void swap_clocks(glint_capture_clock *a, glint_capture_clock *b)
{
    const glint_capture_clock kept = *a;
    *a = *b;
    *b = kept;
}

static void reverse(glint_capture_clock *clocks, size_t count)
{
    for (size_t i = 0; i + 1 < count - i; i++)
        swap_clocks(&clocks[i], &clocks[count - 1 - i]);
}

/* Turns the ring so that it begins with its oldest clock. */
static void straighten(glint_capture *capture, uint64_t oldest)
{
    const size_t count = GLINT_CAPTURE_CLOCKS;
    const size_t start = (size_t)(oldest % GLINT_CAPTURE_CLOCKS);
    if (start == 0)
        return;
    reverse(capture->clock, start);
    reverse(capture->clock + start, count - start);
    reverse(capture->clock, count);
}

static glint_status finish(player *p, glint_error *err)
{
    glint_capture *capture = p->capture;
    const uint64_t middle = middle_of(p);
    const uint64_t played = p->last + 1 - p->first;
    const uint64_t kept = played < GLINT_CAPTURE_CLOCKS ? played : GLINT_CAPTURE_CLOCKS;
    if (middle < p->first || middle > p->last)
        return glint_fail(err, GLINT_BAD_ARGUMENT,
                          "the pins, of clocks %" PRIu64 " to %" PRIu64
                          ", do not reach clock %" PRIu64,
                          p->first, p->last, middle);
    const uint64_t oldest = p->last + 1 - kept;
    straighten(capture, oldest);
    capture->count = (int)kept;
    capture->failing = (int)(middle - oldest);
    return GLINT_OK;
}

static glint_status play_all(player *p, glint_error *err)
{
    const glint_status status = glint_twin_create(p->play->setting, &p->twin, err);
    if (status != GLINT_OK)
        return status;
    p->capture->signals = *glint_twin_signals(p->twin);
    glint_random_pins_begin(&p->random, p->play->setting, p->play->seed);
    while (has_pins(p) && p->last < middle_of(p) + GLINT_CAPTURE_AFTER && !stopped(p))
        play_clock(p);
    glint_twin_destroy(p->twin);
    return stopped(p) ? glint_fail(err, GLINT_INTERRUPTED, "interrupted") : finish(p, err);
}

glint_status glint_capture_play(const glint_play *play, glint_capture **capture, glint_error *err)
{
    const uint64_t first = play->pins != NULL ? play->first_clock : 1;
    player p = {.play = play, .first = first, .last = first - 1};
    *capture = NULL;
    p.capture = calloc(1, sizeof *p.capture);
    if (p.capture == NULL)
        return glint_fail(err, GLINT_NO_MEMORY, "not enough memory for the clocks of a failure");
    p.capture->setting = *play->setting;
    const glint_status status = play_all(&p, err);
    if (status != GLINT_OK) {
        free(p.capture);
        return status;
    }
    *capture = p.capture;
    return GLINT_OK;
}
