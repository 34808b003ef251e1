/* Each phase of the schedule picks its own density of starts and of k's that miss the table. */
#include "circuit/divider_stimulus.h"

#include <string.h>

void glint_divider_stimulus_init(glint_divider_stimulus *stimulus, uint64_t seed)
{
    *stimulus = (glint_divider_stimulus){.random = {seed}};
}

static uint32_t pick(glint_random *random, const uint32_t *choices, uint32_t count)
{
    return choices[glint_random_below(random, count)];
}

/* Each phase of the schedule has its own mood, as for the specular device. */
static void begin_phase(glint_divider_stimulus *s)
{
    static const uint32_t starts[] = {16, 64, 128, 255, 256};
    static const uint32_t rare_to_often[] = {0, 0, 16, 64, 160};
    s->start_chance = pick(&s->random, starts, 5);
    s->miss_chance = pick(&s->random, rare_to_often, 5);
}

/* 0, the first beyond the table, or any other. */
static uint32_t random_miss(glint_random *random)
{
    const uint32_t first = GLINT_DIVIDER_K_MAX + 1u;
    if (glint_random_chance(random, 64))
        return 0;
    if (glint_random_chance(random, 64))
        return first;
    return first + glint_random_below(random, (1u << GLINT_DIVIDER_K_BITS) - first);
}

static uint8_t random_k(glint_divider_stimulus *s)
{
    if (glint_random_chance(&s->random, s->miss_chance))
        return (uint8_t)random_miss(&s->random);
    return (uint8_t)(1 + glint_random_below(&s->random, GLINT_DIVIDER_K_MAX));
}

static int16_t random_difference(glint_random *random)
{
    static const int16_t corners[] = {0, 1, -1, GLINT_DIVIDER_DIFFERENCE_MAX,
                                      -GLINT_DIVIDER_DIFFERENCE_MAX};
    if (glint_random_chance(random, 64))
        return corners[glint_random_below(random, 5)];
    return (int16_t)((int)glint_random_below(random, 2 * GLINT_DIVIDER_DIFFERENCE_MAX + 1) -
                     GLINT_DIVIDER_DIFFERENCE_MAX);
}

void glint_divider_stimulus_next(glint_divider_stimulus *s, glint_divider_inputs *in)
{
    bool reset, en;
    if (glint_schedule_next(&s->schedule, &s->random, &reset, &en))
        begin_phase(s);

    memset(in, 0, sizeof *in);
    in->reset = reset;
    in->en = en;
    in->start = glint_random_chance(&s->random, s->start_chance);
    in->k = random_k(s);
    for (int c = 0; c < GLINT_DIVIDER_COMPONENTS; c++)
        in->difference[c] = random_difference(&s->random);
}
