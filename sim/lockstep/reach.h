/* What the pins of a run reached, counted at the pins as they are driven: how deep into the state
 * of a circuit it got, and what came while points or divisions were in flight. */
#ifndef GLINT_SIM_REACH_H
#define GLINT_SIM_REACH_H

#include "circuit/setting.h"

typedef struct glint_reach {
    uint64_t run;              /* the most clocks in a row without reset, stalls included */
    uint64_t run_enabled;      /* the most enabled clocks between two resets */
    uint64_t stall;            /* the most clocks in a row with neither enable nor reset */
    uint64_t resets;           /* clocks */
    uint64_t resets_in_flight; /* those that met a point or a division on its way */
    uint64_t taken;            /* clocks that took points, or a division */

    /* The specular device: */
    uint64_t changes;           /* clocks that took a material, or a part of one */
    uint64_t changes_in_flight; /* those that met a point on its way: none with a latency of 1 */
    uint64_t patterns;          /* different sets of lanes that took a point at the same clock */
    int lanes_alone;            /* lanes that took one while no other did */

    uint64_t ignored; /* the sequential divider: clocks with a start while it was busy */
} glint_reach;

/* A count under way. */
typedef struct glint_reach_count {
    const glint_setting *setting;
    glint_reach reach;
    uint64_t run, run_enabled, stall; /* under way */
    uint64_t in_flight;               /* bit i: something was taken i + 1 enabled clocks ago */
    uint64_t patterns[(1u << GLINT_LANES_MAX) / 64]; /* a bit each */
} glint_reach_count;

/* Of a circuit in reset state. setting is to stay. */
void glint_reach_begin(glint_reach_count *count, const glint_setting *setting);

/* The pins of one rising edge. */
void glint_reach_clock(glint_reach_count *count, const glint_pins *pins);

#endif
