/* Whether a device, with any number of stages, holds points that are not out yet. */
#ifndef GLINT_TESTS_UNDER_WAY_H
#define GLINT_TESTS_UNDER_WAY_H

#include <stdbool.h>

#include "glint_specular_device.h"

static inline bool points_are_under_way(const glint_specular_config *config,
                                        const glint_specular_signals *signals)
{
    for (int i = 0; i < glint_specular_signal_count(config); i++) {
        const glint_signal_info info = glint_specular_signal_info(config, i);
        if (info.kind == GLINT_SIGNAL_STAGE && info.block == 0 &&
            glint_specular_signal_bits(config, signals, i) != 0)
            return true;
    }
    return false;
}

#endif
