/* A ring of the last clocks' pins. */
#include "lockstep/history.h"

#include <stdlib.h>
#include <string.h>

/* Clock c, from 1 on, is at (c − 1) mod the size of the ring. A clock has as many bytes as the
 * circuit's pins: glint_pins has room for any circuit's, which would be ten times as much. */
struct glint_history {
    glint_setting setting;
    uint64_t clocks;
    unsigned char pins[];
};

void glint_history_destroy(glint_history *history)
{
    free(history);
}

static size_t pins_size(const glint_setting *setting)
{
    return setting->circuit->pins_size;
}

static glint_history *create(const glint_setting *setting)
{
    glint_history *created = malloc(sizeof *created + GLINT_HISTORY_CLOCKS * pins_size(setting));
    if (created == NULL)
        return NULL;
    created->setting = *setting;
    created->clocks = 0;
    return created;
}

static size_t place_of(const glint_history *history, uint64_t clock)
{
    return (size_t)((clock - 1) % GLINT_HISTORY_CLOCKS) * pins_size(&history->setting);
}

void glint_history_add(glint_history **history, const glint_setting *setting,
                       const glint_batch *batch)
{
    const size_t clocks = glint_batch_clocks(setting, batch->count);
    glint_history *to = *history != NULL ? *history : create(setting);
    glint_pins pins;
    *history = to;
    for (size_t clock = 0; to != NULL && clock < clocks; clock++) {
        glint_batch_pins(setting, batch, clock, &pins);
        memcpy(to->pins + place_of(to, ++to->clocks), &pins, pins_size(setting));
    }
}

const glint_setting *glint_history_setting(const glint_history *history)
{
    return &history->setting;
}

glint_pins *glint_history_pins(const glint_history *history, size_t *count, uint64_t *first_clock)
{
    *count = history->clocks < GLINT_HISTORY_CLOCKS ? (size_t)history->clocks
                                                    : (size_t)GLINT_HISTORY_CLOCKS;
    *first_clock = history->clocks - *count + 1;
    glint_pins *pins = *count != 0 ? calloc(*count, sizeof *pins) : NULL;
    for (size_t i = 0; pins != NULL && i < *count; i++)
        memcpy(&pins[i], history->pins + place_of(history, *first_clock + i),
               pins_size(&history->setting));
    return pins;
}
