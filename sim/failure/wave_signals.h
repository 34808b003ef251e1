/* What the variables of a failure's waveform are called, and when it begins and ends, for its
 * writer and its save file. */
#ifndef GLINT_SIM_FAILURE_WAVE_SIGNALS_H
#define GLINT_SIM_FAILURE_WAVE_SIGNALS_H

#include "failure/capture.h"

#define GLINT_FAILURE_RTL     "_rtl"
#define GLINT_FAILURE_MODEL   "_model"
#define GLINT_FAILURE_DIFFERS "_differs"
#define GLINT_FAILURE_REAL    "_real" /* behind the others: the number that the code stands for */

/* The waveform's own variables. */
typedef enum glint_failure_own {
    GLINT_FAILURE_MISMATCH, /* any signal differs */
    GLINT_FAILURE_CLOCK,    /* its number */
    GLINT_FAILURE_CLK,
} glint_failure_own;

/* What it is called: "mismatch", "clock", "clk", or, of a circuit with a pin of that name,
 * "glint_mismatch". */
const char *glint_failure_own_name(const glint_setting *setting, glint_failure_own which);

#define GLINT_FAILURE_CLOCK_BITS 48 /* of the number of the clock */

/* ns. Where the marker would not be in view in every window, the waveform goes on behind its last
 * clock, everything unknown. */
typedef struct glint_failure_times {
    uint64_t first, marker, last_edge, end;
} glint_failure_times;
glint_failure_times glint_failure_times_of(const glint_capture *capture);

/* Whether signal `index` differs in any of the clocks. */
static inline bool glint_capture_differs(const glint_capture *capture, int index)
{
    bool differs = false;
    for (int i = 0; i < capture->count; i++)
        differs |= glint_capture_differs_at(capture, i, index);
    return differs;
}

#endif
