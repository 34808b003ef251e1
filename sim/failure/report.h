/* The human-readable report of a failure. */
#ifndef GLINT_SIM_FAILURE_REPORT_H
#define GLINT_SIM_FAILURE_REPORT_H

#include <stdio.h>

#include "failure/failure.h"

/* Writes it: what differs where, both values as bits and as numbers, the pins of the last 32 clocks
 * as a table with the failing one marked, the seed, and the commands to view and replay it. It
 * includes the command that evaluates an answer's point alone if that shows the difference.
 * capture: from the failure's replay; NULL if there is none. directory: the packet's; NULL if there
 * is no packet. */
void glint_failure_report(FILE *out, const glint_failure *failure, const glint_capture *capture,
                          const char *directory);

/* Of an answer: what differs first, where that is before the failing clock, and what differs in the
 * failing clock. Of others: the first mismatches, as they came. found: of the play or the run. */
void glint_failure_print_mismatches(FILE *out, const glint_failure *failure,
                                    const glint_failure_finding *finding,
                                    const glint_lockstep_result *found);

/* The program of the commands, as a shell reads it, and behind a subcommand of it the options for
 * what is not Glint's own: the circuit's directory, that of its Verilog. */
void glint_failure_print_program(FILE *out, const glint_failure *failure);
void glint_failure_print_directories(FILE *out, const glint_failure *failure);

#endif
