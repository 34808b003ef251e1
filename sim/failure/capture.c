#include "failure/capture.h"

#include <inttypes.h>
#include <stdlib.h>

#include "lockstep/mismatch.h"
#include "lockstep/random_pins.h"

/* A play under way. The clocks kept are a ring: number c is at c mod its size. */
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

/* The clock that the capture is to end with, as far as is known. */
static uint64_t end_of(const player *p)
{
    const glint_lockstep_result *found = &p->capture->found;
    const uint64_t middle = found->mismatches != 0 ? found->first_clock : p->play->expected;
    return middle + GLINT_CAPTURE_AFTER;
}

static bool has_pins(const player *p)
{
    return p->play->pins == NULL || p->last + 1 - p->first < p->play->count;
}

static bool stopped(const player *p)
{
    return p->play->stop != NULL && *p->play->stop;
}

static void play_clock(player *p)
{
    const glint_play *play = p->play;
    glint_capture_clock *now = ring_at(p->capture, ++p->last);
    now->clock = p->last;
    if (play->pins != NULL)
        now->pins = play->pins[p->last - p->first];
    else
        glint_random_pins_next(&p->random, &now->pins);
    glint_twin_clock(p->twin, &now->pins);
    glint_twin_read(p->twin, now->model, now->rtl);
    p->capture->found.clocks = p->last;
    glint_mismatch_compare(&p->capture->found, play->setting, p->twin);
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
    const glint_lockstep_result *found = &capture->found;
    const uint64_t middle = found->mismatches != 0 ? found->first_clock : p->play->expected;
    const uint64_t played = p->last + 1 - p->first;
    const uint64_t kept = played < GLINT_CAPTURE_CLOCKS ? played : GLINT_CAPTURE_CLOCKS;
    if (middle < p->first || middle > p->last)
        return glint_fail(err, GLINT_BAD_ARGUMENT,
                          "the pins of clocks %" PRIu64 " to %" PRIu64 " do not reach clock "
                          "%" PRIu64,
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
    glint_random_pins_begin(&p->random, p->play->setting, p->play->seed);
    while (has_pins(p) && p->last < end_of(p) && !stopped(p))
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
        return glint_fail(err, GLINT_NO_MEMORY, "no memory for the clocks of a failure");
    p.capture->setting = *play->setting;
    const glint_status status = play_all(&p, err);
    if (status != GLINT_OK) {
        free(p.capture);
        return status;
    }
    *capture = p.capture;
    return GLINT_OK;
}
