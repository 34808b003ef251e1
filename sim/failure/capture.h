/* The clocks around a mismatch, with everything on both sides, obtained by replaying pins through
 * the C model and the Verilog. */
#ifndef GLINT_SIM_FAILURE_CAPTURE_H
#define GLINT_SIM_FAILURE_CAPTURE_H

#include <string.h>

#include "lockstep/lockstep.h"
#include "lockstep/signals.h"

#define GLINT_CAPTURE_BEFORE 32
#define GLINT_CAPTURE_AFTER  8
#define GLINT_CAPTURE_CLOCKS (GLINT_CAPTURE_BEFORE + 1 + GLINT_CAPTURE_AFTER)

/* This many clocks are replayed even when stopped, so an interrupted run still leaves a packet for
 * an early mismatch. */
#define GLINT_CAPTURE_UNSTOPPED 16384

/* For work that may take long. */
typedef struct glint_capture_control {
    const volatile bool *stop;                                      /* may be NULL */
    void (*progress)(void *context, uint64_t done, uint64_t total); /* clocks; may be NULL */
    void *progress_context;
} glint_capture_control;

/* What is played, from reset state on. */
typedef struct glint_play {
    const glint_setting *setting;
    const glint_pins *pins; /* NULL: the random pins of seed, from clock 1 on, without end */
    size_t count;           /* of pins */
    uint64_t first_clock;   /* number of the clock that takes pins[0], 1… */
    uint64_t seed;
    uint64_t expected;                    /* the clock to capture around if nothing differs */
    bool up_to_expected;                  /* or also when an earlier one does */
    const glint_capture_control *control; /* may be NULL */
    glint_pins *kept; /* where random pins go, from clock kept_from to the last; NULL: nowhere */
    uint64_t kept_from;
    size_t kept_count; /* room there: later ones are not kept */
} glint_play;

/* The pins at one edge, and every signal just after it. */
typedef struct glint_capture_clock {
    uint64_t clock;
    glint_pins pins;
    uint64_t model[GLINT_SIGNAL_WORDS_MAX], rtl[GLINT_SIGNAL_WORDS_MAX];
} glint_capture_clock;

typedef struct glint_capture {
    glint_setting setting;
    glint_signals signals;       /* where each has its words in a clock */
    glint_lockstep_result found; /* up to the last clock here; found.clocks is its number */
    int failing; /* the first clock with a mismatch; without one, or if play.up_to_expected with
                  * earlier ones, the one that was expected to have one */
    int count;
    glint_capture_clock clock[GLINT_CAPTURE_CLOCKS];
} glint_capture;

/* The words of signal `index` in a clock's model or rtl. */
static inline const uint64_t *glint_capture_words(const glint_capture *capture,
                                                  const uint64_t *values, int index)
{
    return values + capture->signals.place[index];
}

/* Whether signal `index` differs in that clock of the capture. */
static inline bool glint_capture_differs_at(const glint_capture *capture, int clock, int index)
{
    const int at = capture->signals.place[index];
    const size_t words = (size_t)(capture->signals.place[index + 1] - at);
    return memcmp(capture->clock[clock].model + at, capture->clock[clock].rtl + at,
                  words * sizeof(uint64_t)) != 0;
}

/* Replays until 8 clocks after the first mismatch, or after the expected clock if there was none by
 * then or play.up_to_expected is set, or until the pins run out. Free the result with free().
 * GLINT_BAD_ARGUMENT if the pins run out before both; GLINT_INTERRUPTED if stopped. */
glint_status glint_capture_play(const glint_play *play, glint_capture **capture, glint_error *err);

#endif
