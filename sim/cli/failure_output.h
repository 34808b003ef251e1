/* What a subcommand does with a mismatch: write the packet and print its report. */
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

/* As glint_failure_of_lockstep(), with progress on a terminal, until the stop flag is raised. */
glint_status glint_failure_find(const char *command, const glint_lockstep_options *options,
                                const glint_lockstep_result *result, glint_failure **failure,
                                glint_error *err);

/* Writes the packet into `directory` and prints on out what it says, and where it is. A write
 * failure is reported on standard error, and the report is printed regardless. Returns whether the
 * packet was written. */
bool glint_failure_output(const char *command, const glint_failure *failure,
                          const glint_packet_frames *frames, const char *directory,
                          glint_failure_detail detail, FILE *out);

/* Records the circuit's --circuit-dir in the packet; NULL: a built-in circuit. */
void glint_failure_name_circuit(glint_failure *failure, const char *directory);

/* The name that this program was called by. */
const char *glint_failure_program(void);

/* A command line ready to be typed again: "PROGRAM COMMAND ARGUMENT…", quoted where needed, cut
 * where it is longer than `size`. argv[0] is the subcommand. */
void glint_failure_command(int argc, char *const *argv, char *text, size_t size);

#endif
