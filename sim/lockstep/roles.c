/* Watches the first clocks of a run for what a wrong role or kind would hide; see roles.h. */
#include "lockstep/roles.h"

#include <string.h>

/* Outputs that follow pins do so at once; looking costs an evaluation a clock. */
#define SETTLES 1000

/* A circuit that lives does not stand still that long, whatever its inputs. */
#define STILL_MAX 500

bool glint_roles_stand_still(const glint_roles *roles)
{
    return !roles->moves && roles->still >= STILL_MAX;
}

/* The words that hold state: of registers; where there are none, of outputs. */
static void find_state(glint_roles_watch *watch)
{
    const glint_signals *signals = glint_twin_signals(watch->twin);
    bool has_registers = false;
    for (int i = 0; i < signals->count; i++)
        has_registers |= signals->info[i].kind == GLINT_SIGNAL_REGISTER ||
                         signals->info[i].kind == GLINT_SIGNAL_STAGE;
    for (int i = 0; i < signals->count; i++) {
        const glint_signal_kind kind = signals->info[i].kind;
        const bool is_state = has_registers
                                  ? kind == GLINT_SIGNAL_REGISTER || kind == GLINT_SIGNAL_STAGE
                                  : kind == GLINT_SIGNAL_OUTPUT;
        for (int w = signals->place[i]; w < signals->place[i + 1]; w++)
            watch->is_state[w] = is_state;
    }
}

void glint_roles_begin(glint_roles_watch *watch, const glint_setting *setting, glint_twin *twin,
                       glint_roles *roles)
{
    memset(watch, 0, sizeof *watch);
    watch->twin = twin;
    watch->roles = roles;
    watch->has_clock = setting->circuit->clock_port != NULL;
    watch->settles = watch->has_clock ? SETTLES : 0;
    const bool has_roles = glint_reach_has(setting, GLINT_PIN_RESET) ||
                           glint_reach_has(setting, GLINT_PIN_RESET_LOW) ||
                           glint_reach_has(setting, GLINT_PIN_ENABLE) ||
                           glint_reach_has(setting, GLINT_PIN_ENABLE_LOW);
    *roles = (glint_roles){.moves = !watch->has_clock || !has_roles, .follows = -1};
    find_state(watch);
    glint_twin_read(twin, watch->model, watch->rtl);
}

static bool differ(const glint_signals *signals, int i, const uint64_t *a, const uint64_t *b)
{
    const int at = signals->place[i];
    return memcmp(a + at, b + at, (size_t)(signals->place[i + 1] - at) * sizeof *a) != 0;
}

/* The first output that the pins alone have changed. */
static int find_follower(const glint_roles_watch *watch, const uint64_t *settled)
{
    const glint_signals *signals = glint_twin_signals(watch->twin);
    for (int i = 0; i < signals->count; i++)
        if (signals->info[i].kind == GLINT_SIGNAL_OUTPUT && differ(signals, i, watch->rtl, settled))
            return i;
    return -1;
}

void glint_roles_before(glint_roles_watch *watch, const glint_reach_count *reach,
                        const glint_pins *pins)
{
    if (watch->settles == 0 && watch->roles->moves)
        return;
    watch->live = glint_reach_is_live(reach, pins);
    if (watch->settles == 0)
        return;
    watch->settles--;
    uint64_t settled[GLINT_SIGNAL_WORDS_MAX];
    glint_twin_settle(watch->twin, pins, settled);
    /* An asynchronous reset changes registers, too. */
    if (watch->roles->follows < 0 && !glint_reach_is_reset(reach, pins))
        watch->roles->follows = find_follower(watch, settled);
}

static bool has_moved(const glint_roles_watch *watch, const uint64_t *model)
{
    const int words = glint_twin_signals(watch->twin)->words;
    bool moved = false;
    for (int w = 0; w < words; w++)
        moved |= watch->is_state[w] && model[w] != watch->model[w];
    return moved;
}

void glint_roles_after(glint_roles_watch *watch)
{
    if (watch->settles == 0 && watch->roles->moves)
        return;
    uint64_t model[GLINT_SIGNAL_WORDS_MAX];
    glint_twin_read(watch->twin, model, watch->rtl);
    if (!watch->roles->moves && watch->live && watch->was_live) {
        watch->roles->moves = has_moved(watch, model);
        watch->roles->still += !watch->roles->moves;
    }
    watch->was_live = watch->live;
    memcpy(watch->model, model, sizeof model);
}
