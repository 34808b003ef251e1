/* What a random run says about a description that nothing else would notice when it is wrong: a
 * reset or an enable of the wrong polarity, under which a circuit stands still on both sides, and
 * an output that follows a pin, whose value before the edge is compared only as kind MEALY. */
#ifndef GLINT_SIM_LOCKSTEP_ROLES_H
#define GLINT_SIM_LOCKSTEP_ROLES_H

#include <stdbool.h>

#include "lockstep/reach.h"
#include "lockstep/twin.h"

typedef struct glint_roles {
    /* Clocks that, like the one before, neither reset nor stall by the description's word, until
     * the first after which a register had changed. */
    uint64_t still;
    bool moves;  /* there was such a clock, or the circuit has no clock, or neither pin */
    int follows; /* an output (its number among the signals) that changed before an edge; −1: none
                  */
} glint_roles;

/* Whether so many such clocks left every register as it was that the roles must be wrong, or the
 * stimulus useless. */
bool glint_roles_stand_still(const glint_roles *roles);

/* A watch under way. */
typedef struct glint_roles_watch {
    glint_twin *twin;
    glint_roles *roles;
    bool has_clock, live, was_live;        /* of the clock under way, of the one before */
    int settles;                           /* clocks still to look at before their edge */
    bool is_state[GLINT_SIGNAL_WORDS_MAX]; /* words that must change */
    uint64_t model[GLINT_SIGNAL_WORDS_MAX], rtl[GLINT_SIGNAL_WORDS_MAX]; /* after the last edge */
} glint_roles_watch;

/* Of a twin in reset state. */
void glint_roles_begin(glint_roles_watch *watch, const glint_setting *setting, glint_twin *twin,
                       glint_roles *roles);

/* With each clock's pins: before the twin has that clock, and after. */
void glint_roles_before(glint_roles_watch *watch, const glint_reach_count *reach,
                        const glint_pins *pins);
void glint_roles_after(glint_roles_watch *watch);

#endif
