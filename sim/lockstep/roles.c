/* Watches the first clocks of a run for what a wrong role or kind would hide; see roles.h. */
#include "lockstep/roles.h"

#include <string.h>

/* Outputs that follow pins do so at once; looking costs an evaluation a clock. */
#define SETTLES 1000

/* A circuit that lives does not stand still that long, whatever its inputs. */
#define STILL_MAX 1000

bool glint_roles_stand_still(const glint_roles *roles)
{
    return !roles->moves && roles->still >= STILL_MAX;
}

/* Whether an edge is expected to change what is compared. */
static bool can_move(const glint_setting *setting, const glint_signals *signals)
{
    bool is_seen = false;
    for (int i = 0; i < signals->count; i++)
        is_seen |= signals->info[i].kind != GLINT_SIGNAL_MEALY;
    const bool has_roles = glint_reach_has(setting, GLINT_PIN_RESET) ||
                           glint_reach_has(setting, GLINT_PIN_RESET_LOW) ||
                           glint_reach_has(setting, GLINT_PIN_ENABLE) ||
                           glint_reach_has(setting, GLINT_PIN_ENABLE_LOW);
    return is_seen && has_roles && setting->circuit->clock_port != NULL;
}

void glint_roles_begin(glint_roles_watch *watch, const glint_setting *setting, glint_twin *twin,
                       glint_roles *roles)
{
    memset(watch, 0, sizeof *watch);
    watch->twin = twin;
    watch->roles = roles;
    watch->settles = setting->circuit->clock_port != NULL ? SETTLES : 0;
    *roles = (glint_roles){.moves = !can_move(setting, glint_twin_signals(twin)), .follows = -1};
    glint_twin_read(twin, watch->model, watch->rtl);
}

/* The first signal of such a kind, or of any but MEALY, that differs. */
static int find_difference(const glint_roles_watch *watch, bool outputs)
{
    const glint_signals *signals = glint_twin_signals(watch->twin);
    for (int i = 0; i < signals->count; i++) {
        const glint_signal_kind kind = signals->info[i].kind;
        const int at = signals->place[i];
        const size_t size = (size_t)(signals->place[i + 1] - at) * sizeof *watch->rtl;
        if (outputs ? kind != GLINT_SIGNAL_OUTPUT : kind == GLINT_SIGNAL_MEALY)
            continue;
        if (memcmp(watch->rtl + at, watch->settled + at, size) != 0)
            return i;
    }
    return -1;
}

static bool is_over(const glint_roles_watch *watch)
{
    return watch->settles == 0 && watch->roles->moves;
}

void glint_roles_before(glint_roles_watch *watch, const glint_reach_count *reach,
                        const glint_pins *pins)
{
    if (is_over(watch))
        return;
    watch->live = glint_reach_is_live(reach, pins);
    glint_twin_settle(watch->twin, pins, watch->settled);
    if (watch->settles == 0)
        return;
    watch->settles--;
    /* An asynchronous reset changes registers, too. */
    if (watch->roles->follows < 0 && !glint_reach_is_reset(reach, pins))
        watch->roles->follows = find_difference(watch, true);
}

void glint_roles_after(glint_roles_watch *watch)
{
    if (is_over(watch))
        return;
    glint_twin_read(watch->twin, watch->model, watch->rtl);
    /* Pins are the same on both sides of the edge: what differs follows the state. */
    if (!watch->roles->moves && watch->live && watch->was_live) {
        watch->roles->moves = find_difference(watch, false) >= 0;
        watch->roles->still += !watch->roles->moves;
    }
    watch->was_live = watch->live;
}
