/* What a subcommand does with a mismatch: the packet written, its report printed. */
#ifndef GLINT_SIM_CLI_FAILURE_OUTPUT_H
#define GLINT_SIM_CLI_FAILURE_OUTPUT_H

#include <stdbool.h>
#include <stdio.h>

#include "failure/packet.h"

/* How much of it is printed. */
typedef enum glint_failure_detail {
    GLINT_FAILURE_REPORT, /* the report */
    GLINT_FAILURE_BRIEFLY /* where the packet is */
} glint_failure_detail;

/* As glint_failure_of_lockstep(): with progress on a terminal, until the stop flag is up. */
glint_status glint_failure_find(const char *command, const glint_lockstep_options *options,
                                const glint_lockstep_result *result, glint_failure **failure,
                                glint_error *err);

/* Writes the packet into `directory` and prints on out what it says, and where it is. What cannot
 * be written is told on standard error; the report is printed all the same. Returns whether the
 * packet was written. */
bool glint_failure_output(const char *command, const glint_failure *failure,
                          const glint_packet_frames *frames, const char *directory,
                          glint_failure_detail detail, FILE *out);

/* Says in the packet which --circuit-dir has the circuit; NULL: it is one of Glint's own. */
void glint_failure_name_circuit(glint_failure *failure, const char *directory);

/* The name that this program was called by. */
const char *glint_failure_program(void);

/* A command line as one could type it again: "PROGRAM COMMAND ARGUMENT…", quoted where needed, cut
 * where it is longer than `size`. argv[0] is the subcommand. */
void glint_failure_command(int argc, char *const *argv, char *text, size_t size);

#endif
