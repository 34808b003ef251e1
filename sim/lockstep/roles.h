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
     * the first whose edge changed a signal. */
    uint64_t still;
    bool moves;  /* there was one; or none can be expected: no clock, neither pin, or all signals
                    MEALY */
    int follows; /* an output (its number among the signals) that changed before an edge; −1: none
                  */
} glint_roles;

/* Whether so many such clocks left every signal as it was that the roles must be wrong, or the
 * stimulus useless. */
bool glint_roles_stand_still(const glint_roles *roles);

/* A watch under way. */
typedef struct glint_roles_watch {
    glint_twin *twin;
    glint_roles *roles;
    bool live, was_live; /* the clock under way, and the one before, neither reset nor stall */
    int settles;         /* clocks still to be looked at for outputs that follow a pin */
    uint64_t model[GLINT_SIGNAL_WORDS_MAX], rtl[GLINT_SIGNAL_WORDS_MAX]; /* after the last edge */
    uint64_t settled[GLINT_SIGNAL_WORDS_MAX]; /* before the next, with its pins */
} glint_roles_watch;

/* Of a twin in reset state. */
void glint_roles_begin(glint_roles_watch *watch, const glint_setting *setting, glint_twin *twin,
                       glint_roles *roles);

/* With each clock's pins: before the twin has that clock, and after. */
void glint_roles_before(glint_roles_watch *watch, const glint_reach_count *reach,
                        const glint_pins *pins);
void glint_roles_after(glint_roles_watch *watch);

#endif
