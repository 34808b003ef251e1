/* What the signals of the dividers are called in a waveform. */
#ifndef GLINT_TESTS_DIVIDER_SIGNAL_NAME_H
#define GLINT_TESTS_DIVIDER_SIGNAL_NAME_H

#include <stdio.h>

#include "glint_divider_device.h"

static inline const char *divider_top(glint_divider_form form)
{
    return form == GLINT_DIVIDER_SEQUENTIAL ? "TOP.shift_divider" : "TOP.pipelined_divider";
}

static inline void divider_signal_name(glint_divider_form form, const glint_signal_info *signal,
                                       char *name, size_t size)
{
    if (signal->lane >= 0) {
        (void)snprintf(name, size, "%s.stage[%d].u.%s", divider_top(form), signal->lane,
                       signal->name);
    } else {
        (void)snprintf(name, size, "%s.%s", divider_top(form), signal->name);
    }
}

#endif
