/* What is left for a person when lockstep of a divider finds a mismatch; as failure.h. */
#ifndef GLINT_SIM_DIVIDER_FAILURE_H
#define GLINT_SIM_DIVIDER_FAILURE_H

#include "lockstep/divider_lockstep.h"
#include "lockstep/failure.h"

/* As glint_lockstep_report(). */
void glint_divider_lockstep_report(FILE *out, const glint_divider_lockstep_options *options,
                                   const glint_divider_lockstep_result *result);

/* As glint_lockstep_failure_wave(). */
glint_status glint_divider_failure_wave(const glint_divider_lockstep_options *options,
                                        const glint_divider_lockstep_result *result,
                                        const char *directory, glint_failure_files *files,
                                        glint_error *err);

#endif
