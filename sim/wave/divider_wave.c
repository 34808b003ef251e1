#include "wave/divider_wave.h"

#include <string.h>

#include "file/room.h"
#include "rtl/divider_rtl.h"

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

/* The stall comes while the second division is under way. */
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
    /* A start in the middle of the second division: it is to be ignored. */
    const bool too_early = form == GLINT_DIVIDER_SEQUENTIAL && step == each + each / 2 + 1;
    if (step % each != 0 && !too_early)
        return;
    in->start = 1;
    in->k = divisions[step / each].k;
    memcpy(in->difference, divisions[step / each].difference, sizeof in->difference);
}

/* What record_scene() is to run. */
typedef struct scene {
    glint_divider_form form;
    int shifts;
} scene;

static glint_status record_scene(const void *context, const char *path, glint_error *err)
{
    const scene *scene = context;
    glint_divider_rtl *rtl;
    glint_divider_inputs inputs;
    glint_status status = glint_divider_rtl_create(scene->form, scene->shifts, &rtl, err);
    if (status == GLINT_OK)
        status = glint_file_room(path, GLINT_WAVE_ROOM, err);
    if (status == GLINT_OK)
        status = glint_divider_rtl_trace_open(rtl, path, err);
    const int clocks = glint_divider_scene_clocks(scene->form, scene->shifts);
    for (int clock = 1; status == GLINT_OK && clock <= clocks; clock++) {
        glint_divider_scene(scene->form, scene->shifts, clock, &inputs);
        glint_divider_rtl_clock(rtl, &inputs);
    }
    glint_divider_rtl_destroy(rtl);
    return status;
}

glint_status glint_divider_wave_record(glint_divider_form form, int shifts,
                                       glint_wave_format format, const char *path, glint_error *err)
{
    const scene scene = {form, shifts};
    return glint_wave_write(path, format, record_scene, &scene, err);
}
