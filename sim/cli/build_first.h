/* Builds the circuits that a command is about to open, in parallel, with a progress line if
 * standard error is a terminal. */
#ifndef GLINT_SIM_CLI_BUILD_FIRST_H
#define GLINT_SIM_CLI_BUILD_FIRST_H

#include "rtl/rtl.h"

/* Builds those missing from the cache, this many at a time (0: one per processor). Returns GLINT_OK
 * or GLINT_INTERRUPTED; a circuit that fails to build reports that when opened. */
glint_status glint_build_first(const char *command, const glint_setting *settings, int count,
                               glint_rtl_kind kind, int threads, glint_error *err);

#endif
