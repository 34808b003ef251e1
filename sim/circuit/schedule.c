/* Eras, phases and long runs, as schedule.h lays them out. */
#include "circuit/schedule.h"

#define STALL_MIN  64u   /* the shortest of the long stalls */
#define STALL_MOST 4096u /* doubling ends here */
#define ALWAYS     256u

static void begin_era(glint_schedule *s)
{
    static const uint64_t mixed[] = {1u << 14, 1u << 13};
    static const uint64_t run[] = {1u << 16, 1u << 20};
    const int fixed = sizeof run / sizeof run[0];
    s->mixed_left = s->era < fixed ? mixed[s->era] : s->previous_run;
    s->previous_run = s->era < fixed ? run[s->era] : 2 * s->previous_run;
    /* After so many clocks, a fault still needs a point that exposes it. */
    s->enabled_left = s->previous_run + 4096;
    s->era++;
}

static uint32_t long_stall(glint_random *random)
{
    uint32_t least = STALL_MIN;
    while (least < STALL_MOST && glint_random_chance(random, 96))
        least *= 2;
    return least + glint_random_below(random, least);
}

static void begin_phase(glint_schedule *s, glint_random *random)
{
    static const uint32_t rare_to_often[] = {0, 0, 16, 64, 160};
    static const uint32_t resets[] = {2, 8, 16, 64};
    const bool mixed = s->mixed_left != 0;
    s->clocks_left = 16 + glint_random_below(random, 128);
    s->reset_chance = 0;
    if (glint_random_below(random, mixed ? 24 : 192) == 0) {
        s->clocks_left = long_stall(random);
        s->stall_chance = ALWAYS;
    } else if (!mixed) {
        s->stall_chance = glint_random_below(random, 8) == 0 ? 16 : 0;
    } else {
        s->stall_chance = rare_to_often[glint_random_below(random, 5)];
        if (glint_random_below(random, 4) == 0)
            s->reset_chance = resets[glint_random_below(random, 4)];
    }
    if (mixed && s->clocks_left > s->mixed_left)
        s->clocks_left = (uint32_t)s->mixed_left;
}

bool glint_schedule_next(glint_schedule *s, glint_random *random, bool *reset, bool *en)
{
    const bool begins = s->clocks_left == 0;
    if (begins && s->mixed_left == 0 && s->enabled_left == 0)
        begin_era(s);
    if (begins)
        begin_phase(s, random);
    *reset = glint_random_chance(random, s->reset_chance);
    *en = !glint_random_chance(random, s->stall_chance);
    s->clocks_left--;
    if (s->mixed_left != 0)
        s->mixed_left--;
    else if (*en && s->enabled_left != 0)
        s->enabled_left--;
    return begins;
}
