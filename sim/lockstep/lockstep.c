/* The comparison loop itself: stimulus, twin, mismatch record and coverage come from their own
 * files. */
#include "lockstep/lockstep.h"

#include <string.h>

#include "circuit/random_pins.h"
#include "lockstep/mismatch.h"
#include "lockstep/reach.h"
#include "lockstep/roles.h"
#include "lockstep/twin.h"

static bool stopped(const glint_lockstep_options *options)
{
    return options->stop != NULL && *options->stop;
}

static glint_status run_twin(const glint_lockstep_options *options, glint_twin *twin,
                             glint_lockstep_result *result, glint_error *err)
{
    glint_random_pins source;
    glint_reach_count reach;
    glint_roles_watch roles;
    glint_pins pins;
    glint_reach_begin(&reach, &options->setting);
    glint_roles_begin(&roles, &options->setting, twin, &result->roles);
    glint_random_pins_begin(&source, &options->setting, options->seed);
    if (stopped(options))
        return glint_fail(err, GLINT_INTERRUPTED, "interrupted");
    while (result->clocks < options->clocks) {
        glint_random_pins_next(&source, &pins);
        glint_roles_before(&roles, &reach, &pins);
        glint_twin_clock(twin, &pins);
        glint_roles_after(&roles);
        glint_reach_clock(&reach, &pins);
        result->reach = reach.reach;
        result->clocks++;
        glint_mismatch_compare(result, twin);
        if (result->clocks % 1024 == 0) {
            if (options->progress != NULL)
                options->progress(options->progress_context, result->clocks, options->clocks);
            if (stopped(options))
                return glint_fail(err, GLINT_INTERRUPTED, "interrupted");
        }
    }
    return GLINT_OK;
}

glint_status glint_lockstep_run(const glint_lockstep_options *options,
                                glint_lockstep_result *result, glint_error *err)
{
    glint_twin *twin;
    memset(result, 0, sizeof *result);
    if (options->clocks == 0)
        return glint_fail(err, GLINT_BAD_ARGUMENT, "nothing to compare: 0 clocks");
    glint_status status = glint_twin_create(&options->setting, &twin, err);
    if (status == GLINT_OK)
        status = run_twin(options, twin, result, err);
    glint_twin_destroy(twin);
    return status;
}
