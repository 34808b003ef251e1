#include "lockstep/history.h"

#include <stdlib.h>

/* Clock c, from 1 on, is at (c − 1) mod the size of the ring. */
struct glint_history {
    glint_setting setting;
    uint64_t clocks;
    glint_pins pins[GLINT_HISTORY_CLOCKS];
};

void glint_history_destroy(glint_history *history)
{
    free(history);
}

static glint_history *create(const glint_setting *setting)
{
    glint_history *created = malloc(sizeof *created);
    if (created == NULL)
        return NULL;
    created->setting = *setting;
    created->clocks = 0;
    return created;
}

void glint_history_add(glint_history **history, const glint_setting *setting,
                       const glint_batch *batch)
{
    const size_t clocks = glint_batch_clocks(setting, batch->count);
    glint_history *to = *history != NULL ? *history : create(setting);
    *history = to;
    for (size_t clock = 0; to != NULL && clock < clocks; clock++)
        to->pins[to->clocks++ % GLINT_HISTORY_CLOCKS] = glint_batch_pins(setting, batch, clock);
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
    glint_pins *pins = *count != 0 ? malloc(*count * sizeof *pins) : NULL;
    for (size_t i = 0; pins != NULL && i < *count; i++)
        pins[i] = history->pins[(*first_clock - 1 + i) % GLINT_HISTORY_CLOCKS];
    return pins;
}
