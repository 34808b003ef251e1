/* What a run's pins covered, counted at the pins by their roles: how deep into the circuit's state
 * it got, and what happened while something was in flight. */
#ifndef GLINT_SIM_LOCKSTEP_REACH_H
#define GLINT_SIM_LOCKSTEP_REACH_H

#include "lockstep/signals.h"

typedef struct glint_reach {
    uint64_t run;              /* the most clocks in a row without reset, stalls included */
    uint64_t run_enabled;      /* the most enabled clocks between two resets */
    uint64_t stall;            /* the most clocks in a row with neither enable nor reset */
    uint64_t resets;           /* clocks */
    uint64_t resets_in_flight; /* those that hit a point or a division in flight */
    uint64_t taken;            /* clocks that accepted points or a division */

    /* Pins of role strobe, as those of the specular device's material: */
    uint64_t changes;           /* clocks with one of them 1, or several */
    uint64_t changes_in_flight; /* those that met a point on its way: none with a latency of 1 */

    /* A valid pin of several bits, one a lane: */
    uint64_t patterns; /* different sets of lanes that took a point at the same clock; counted up to
                        * GLINT_REACH_PATTERN_LANES lanes, else 0 */
    int lanes_alone;   /* lanes that took one while no other did */

    uint64_t ignored; /* a circuit with a pace: clocks with a valid pin 1 while it was busy */
} glint_reach;

#define GLINT_REACH_PATTERN_LANES 16

/* Roles are told apart for so many pins that are no data. */
#define GLINT_REACH_PINS_MAX 32

/* A pin that counts: where it lies. */
typedef struct glint_reach_pin {
    glint_pin_role role;
    size_t offset, size;
    uint64_t mask;
} glint_reach_pin;

/* A count under way. */
typedef struct glint_reach_count {
    glint_reach reach;
    glint_reach_pin pin[GLINT_REACH_PINS_MAX];
    int pins;
    bool has_valid;
    int lanes; /* as glint_reach_lanes() */
    uint64_t latency, pace;
    uint64_t run, run_enabled, stall; /* under way */
    uint64_t since; /* enabled clocks since the last input, 1 at the next; 0: none yet */
    uint64_t alone; /* a bit for each lane that was */
    uint64_t patterns[(1u << GLINT_REACH_PATTERN_LANES) / 64]; /* a bit each */
} glint_reach_count;

/* Of a circuit in reset state. */
void glint_reach_begin(glint_reach_count *count, const glint_setting *setting);

/* The pins of one rising edge. */
void glint_reach_clock(glint_reach_count *count, const glint_pins *pins);

/* Whether that edge neither resets nor is one that an enable keeps out. */
bool glint_reach_is_live(const glint_reach_count *count, const glint_pins *pins);

/* Whether the pins reset. */
bool glint_reach_is_reset(const glint_reach_count *count, const glint_pins *pins);

/* Lanes of a setting whose valid pin has a bit for each, at most 64; 0: a circuit without lanes. */
int glint_reach_lanes(const glint_setting *setting);

/* Whether it has pins of that role. */
bool glint_reach_has(const glint_setting *setting, glint_pin_role role);

#endif
