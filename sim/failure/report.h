/* What a person reads of a failure. */
#ifndef GLINT_SIM_FAILURE_REPORT_H
#define GLINT_SIM_FAILURE_REPORT_H

#include <stdio.h>

#include "failure/failure.h"

/* Writes it: what differs where, both values as bits and as numbers, the pins of the last 32 clocks
 * as a table with the failing one marked, the seed, and the commands that look at it and play it
 * again. capture: what the failure's play gave; NULL when it has none. directory: of the packet;
 * NULL when there is none to look at. */
void glint_failure_report(FILE *out, const glint_failure *failure, const glint_capture *capture,
                          const char *directory);

#endif
