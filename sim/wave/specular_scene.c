/* The specular device's demonstration scene, clock by clock. */
#include "wave/specular_scene.h"

#include <string.h>

enum {
    RESET_CLOCK = 1,
    SCAN_FIRST = 3,
    SCAN_POINTS = 17, /* along the scan line, the centre in the middle */
    STALL_CLOCKS = 3,
};

static const glint_material warm = {60, 255, 190, 110};
static const glint_material sharp = {300, 120, 200, 255};
static const glint_material dull = {5, 255, 255, 255};

static void write_material(glint_specular_inputs *in, const glint_material *material)
{
    in->n_we = in->rgb_we = 1;
    in->n = material->n;
    in->r = material->r;
    in->g = material->g;
    in->b = material->b;
}

/* Point `point` of a scan line over the highlight of `n`, from a little outside its edge to as far
 * outside on the other side. */
static uint32_t scan_cos(int point, int n)
{
    double half = (SCAN_POINTS - 1) / 2.0;
    double reach = 1.15 * 3.0 / (n + 1.0); /* 1 − cos γ at the ends; the edge is at 3/(n+1) */
    double across = (point - half) / half;
    return glint_cos_code(1.0 - reach * across * across);
}

/* Clocks that a scan takes with so many lanes. */
static int scan_clocks(int lanes)
{
    return (SCAN_POINTS + lanes - 1) / lanes;
}

static void scan(glint_specular_inputs *in, int first_point, int lanes, int n)
{
    for (int i = 0; i < lanes && first_point + i < SCAN_POINTS; i++) {
        in->cos[i] = scan_cos(first_point + i, n);
        in->in_valid |= 1u << i;
    }
}

/* First clock of the stall: a third of the way through the scan, so that points are in flight and
 * more are to come, however few clocks the scan takes. */
static int stall_first(int lanes)
{
    return SCAN_FIRST + (scan_clocks(lanes) + 1) / 3;
}

static int is_stalled(int clock, int lanes)
{
    return clock >= stall_first(lanes) && clock < stall_first(lanes) + STALL_CLOCKS;
}

/* The clock number without stalled clocks, which determines a point's place in the scene. */
static int running_clock(int clock, int lanes)
{
    if (is_stalled(clock, lanes))
        return stall_first(lanes);
    return clock < stall_first(lanes) ? clock : clock - STALL_CLOCKS;
}

/* After the first scan: the second material with its first point, a gap, a code above 1.0, and a
 * third material between points. */
static void after_first_scan(int step, int lanes, glint_specular_inputs *in)
{
    const int second = scan_clocks(lanes);
    if (step == 0)
        write_material(in, &sharp);
    if (step < second)
        scan(in, step * lanes, lanes, sharp.n);
    else if (step == second + 1)
        for (int i = 0; i < lanes; i++) {
            in->cos[i] = GLINT_COS_ONE + 1000u;
            in->in_valid |= 1u << i;
        }
    else if (step == second + 3)
        write_material(in, &dull);
    else if (step == second + 4)
        scan(in, SCAN_POINTS / 2, lanes, sharp.n);
}

void glint_specular_scene(int clock, int lanes, glint_specular_inputs *in)
{
    const int running = running_clock(clock, lanes);
    const int step = running - SCAN_FIRST;
    memset(in, 0, sizeof *in);
    in->en = !is_stalled(clock, lanes);
    in->reset = clock == RESET_CLOCK;
    if (step < 0) {
        if (step == -1)
            write_material(in, &warm);
    } else if (step < scan_clocks(lanes)) {
        scan(in, step * lanes, lanes, warm.n);
    } else {
        after_first_scan(step - scan_clocks(lanes), lanes, in);
    }
}

int glint_specular_scene_centre(int lanes)
{
    int running = SCAN_FIRST + SCAN_POINTS / 2 / lanes;
    return running < stall_first(lanes) ? running : running + STALL_CLOCKS;
}
