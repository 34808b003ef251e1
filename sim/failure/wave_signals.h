/* What the variables of a failure's waveform are called, for its writer and its save file. */
#ifndef GLINT_SIM_FAILURE_WAVE_SIGNALS_H
#define GLINT_SIM_FAILURE_WAVE_SIGNALS_H

#include "failure/capture.h"

#define GLINT_FAILURE_RTL     "_rtl"
#define GLINT_FAILURE_MODEL   "_model"
#define GLINT_FAILURE_DIFFERS "_differs"

#define GLINT_FAILURE_CLOCK_BITS 48 /* of the number of the clock */

/* Whether signal `index` differs in any of the clocks. */
static inline bool glint_capture_differs(const glint_capture *capture, int index)
{
    bool differs = false;
    for (int i = 0; i < capture->count; i++)
        differs |= capture->clock[i].rtl[index] != capture->clock[i].model[index];
    return differs;
}

#endif
