/* The dividers' demonstration scene, clock by clock. */
#include "wave/divider_scene.h"

#include <stdbool.h>
#include <string.h>

enum {
    RESET_CLOCK = 1,
    FIRST_START = 3,
    STALL_CLOCKS = 3,
    QUIET_CLOCKS = 4, /* at the end */
};

static const glint_division divisions[GLINT_DIVIDER_SCENE_DIVISIONS] = {
    {{255, 128, -7}, 7},  {{-255, 90, 9}, 9}, {{100, -100, 1}, 1},
    {{200, 16, -16}, 16}, {{37, 1, -1}, 17},
};

/* Clocks from one start to the next, without the stall. */
static int pace(glint_divider_form form, int shifts)
{
    return form == GLINT_DIVIDER_SEQUENTIAL ? shifts + 1 : 1;
}

/* The stall occurs while the second division is in progress. */
static int stall_first(glint_divider_form form, int shifts)
{
    return FIRST_START + pace(form, shifts) + (form == GLINT_DIVIDER_SEQUENTIAL ? 4 : 1);
}

int glint_divider_scene_clocks(glint_divider_form form, int shifts)
{
    return FIRST_START + GLINT_DIVIDER_SCENE_DIVISIONS * pace(form, shifts) + shifts +
           STALL_CLOCKS + QUIET_CLOCKS;
}

int glint_divider_scene_first_result(glint_divider_form form, int shifts)
{
    /* The stall holds up the first division of the pipelined form too. */
    return 1 + FIRST_START + shifts + (form == GLINT_DIVIDER_PIPELINED ? STALL_CLOCKS : 0);
}

void glint_divider_scene(glint_divider_form form, int shifts, int clock, glint_divider_inputs *in)
{
    const int stall = stall_first(form, shifts);
    const bool stalled = clock >= stall && clock < stall + STALL_CLOCKS;
    const int running = clock < stall ? clock : stalled ? stall : clock - STALL_CLOCKS;
    const int step = running - FIRST_START;
    const int each = pace(form, shifts);
    memset(in, 0, sizeof *in);
    in->reset = clock == RESET_CLOCK;
    in->en = !stalled;
    if (step < 0 || step >= GLINT_DIVIDER_SCENE_DIVISIONS * each)
        return;
    /* A start in the middle of the second division, which must be ignored. */
    const bool too_early = form == GLINT_DIVIDER_SEQUENTIAL && step == each + each / 2 + 1;
    if (step % each != 0 && !too_early)
        return;
    in->start = 1;
    in->k = divisions[step / each].k;
    memcpy(in->difference, divisions[step / each].difference, sizeof in->difference);
}
