/* Where a circuit's signals lie in the simulator's memory, found once by name. */
#ifndef GLINT_SIM_PLACES_H
#define GLINT_SIM_PLACES_H

#include <stdint.h>

#include "glint_signal.h"

typedef struct glint_signal_place {
    const void *data;
    int size; /* bytes: 1, 2, 4 or 8 */
    uint64_t mask;
} glint_signal_place;

/* The mask of a signal's bits. */
static inline uint64_t glint_signal_mask(const glint_signal_info *info)
{
    return (UINT64_C(1) << (info->int_bits + info->frac_bits)) - 1u;
}

static inline uint64_t glint_signal_read(const glint_signal_place *place)
{
    switch (place->size) {
    case 1:
        return *(const uint8_t *)place->data & place->mask;
    case 2:
        return *(const uint16_t *)place->data & place->mask;
    case 4:
        return *(const uint32_t *)place->data & place->mask;
    default:
        return *(const uint64_t *)place->data & place->mask;
    }
}

#endif
