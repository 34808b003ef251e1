/* The random pins of a lockstep run, of either circuit: the same for the same setting and seed. */
#ifndef GLINT_SIM_RANDOM_PINS_H
#define GLINT_SIM_RANDOM_PINS_H

#include "circuit/divider_stimulus.h"
#include "circuit/setting.h"
#include "circuit/stimulus.h"

typedef struct glint_random_pins {
    bool is_divider;
    glint_stimulus specular;
    glint_divider_stimulus divider;
} glint_random_pins;

static inline void glint_random_pins_begin(glint_random_pins *source, const glint_setting *setting,
                                           uint64_t seed)
{
    source->is_divider = setting->is_divider;
    glint_stimulus_init(&source->specular, seed, setting->specular.lanes);
    glint_divider_stimulus_init(&source->divider, seed);
}

/* The pins of the next clock, from clock 1 on. */
static inline void glint_random_pins_next(glint_random_pins *source, glint_pins *pins)
{
    if (source->is_divider)
        glint_divider_stimulus_next(&source->divider, &pins->divider);
    else
        glint_stimulus_next(&source->specular, &pins->specular);
}

#endif
