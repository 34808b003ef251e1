/* Each phase of the schedule has its own character, so that long dense runs, trickles and storms of
 * material changes all occur, which uniformly random pins would never produce. */
#include "circuit/stimulus.h"

#include <string.h>

enum { STEPS, STAYS }; /* glint_stimulus.turns */

void glint_stimulus_init(glint_stimulus *stimulus, uint64_t seed, int lanes)
{
    *stimulus = (glint_stimulus){.random = {seed}, .lanes = lanes};
}

static uint32_t pick(glint_random *random, const uint32_t *choices, uint32_t count)
{
    return choices[glint_random_below(random, count)];
}

static void begin_phase(glint_stimulus *s)
{
    static const uint32_t rare_to_often[] = {0, 0, 16, 64, 160};
    static const uint32_t material[] = {0, 8, 64, 200, 255};
    s->gap_chance = pick(&s->random, rare_to_often, 5);
    s->lane_gap_chance = pick(&s->random, rare_to_often, 5);
    s->material_chance = pick(&s->random, material, 5);
    s->turn = glint_random_below(&s->random, (uint32_t)s->lanes);
    s->turns = glint_random_below(&s->random, 8);
}

static uint16_t random_n(glint_random *random)
{
    static const uint32_t corners[] = {0, 1, 2, 3, 4, 5, 1000, GLINT_N_MAX};
    if (glint_random_chance(random, 64))
        return (uint16_t)pick(random, corners, 8);
    if (glint_random_chance(random, 96))
        return (uint16_t)glint_random_below(random, 64);
    return (uint16_t)glint_random_below(random, GLINT_N_COUNT);
}

/* Full white is frequent: it reveals the most of W. */
static uint8_t random_color(glint_random *random)
{
    return glint_random_chance(random, 64) ? GLINT_COLOR_MAX
                                           : (uint8_t)glint_random_below(random, 256);
}

static uint32_t random_cos(glint_stimulus *s)
{
    static const uint32_t corners[] = {
        0, 1, GLINT_COS_ONE - 1, GLINT_COS_ONE, GLINT_COS_ONE + 1, GLINT_COS_CODE_MAX};
    uint32_t limit = glint_rom9(GLINT_GATE_COSINE, s->n);
    switch (glint_random_below(&s->random, 4)) {
    case 0:
        return glint_random_below(&s->random, GLINT_COS_CODE_MAX + 1);
    case 1: /* around the limit, a code below 0 wraps to a large one, which is a case too */
        return (limit + glint_random_below(&s->random, 9) - 4u) & GLINT_COS_CODE_MAX;
    case 2:
        return limit + glint_random_below(&s->random, GLINT_COS_ONE - limit + 1);
    default:
        return glint_random_chance(&s->random, 128)
                   ? pick(&s->random, corners, 6)
                   : glint_random_below(&s->random, GLINT_COS_ONE + 1);
    }
}

static void write_material(glint_stimulus *s, glint_specular_inputs *in)
{
    in->n = random_n(&s->random);
    in->r = random_color(&s->random);
    in->g = random_color(&s->random);
    in->b = random_color(&s->random);
    in->n_we = glint_random_chance(&s->random, s->material_chance);
    in->rgb_we = glint_random_chance(&s->random, s->material_chance);
}

/* Lanes one by one: each in its turn, or one for the whole phase. */
static uint32_t next_alone(glint_stimulus *s)
{
    const uint32_t valid = 1u << s->turn;
    if (s->turns == STEPS)
        s->turn = (s->turn + 1) % (uint32_t)s->lanes;
    return valid;
}

static uint32_t random_valid(glint_stimulus *s)
{
    uint32_t valid = 0;
    if (glint_random_chance(&s->random, s->gap_chance))
        return 0;
    if (s->turns == STEPS || s->turns == STAYS)
        return next_alone(s);
    for (int i = 0; i < s->lanes; i++)
        if (!glint_random_chance(&s->random, s->lane_gap_chance))
            valid |= 1u << i;
    return valid;
}

void glint_stimulus_next(glint_stimulus *s, glint_specular_inputs *in)
{
    bool reset, en;
    if (glint_schedule_next(&s->schedule, &s->random, &reset, &en))
        begin_phase(s);

    memset(in, 0, sizeof *in);
    in->reset = reset;
    in->en = en;
    write_material(s, in);
    in->in_valid = random_valid(s);
    for (int i = 0; i < s->lanes; i++)
        in->cos[i] = random_cos(s);
    if (in->reset)
        s->n = 0;
    else if (in->en && in->n_we)
        s->n = in->n;
}
