/* Circuits that a command is about to open, built before: together, with a line of progress where
 * standard error is a terminal. */
#ifndef GLINT_SIM_CLI_BUILD_FIRST_H
#define GLINT_SIM_CLI_BUILD_FIRST_H

#include "rtl/rtl.h"

/* Builds those that the cache has not, so many at a time (0: one a processor). One that does not
 * build says so when it is opened: GLINT_OK, or GLINT_INTERRUPTED. */
glint_status glint_build_first(const char *command, const glint_setting *settings, int count,
                               glint_rtl_kind kind, int threads, glint_error *err);

#endif
