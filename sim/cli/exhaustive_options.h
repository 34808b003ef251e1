/* The command line of `glint verify --exhaustive` for any circuit. */
#ifndef GLINT_SIM_CLI_EXHAUSTIVE_OPTIONS_H
#define GLINT_SIM_CLI_EXHAUSTIVE_OPTIONS_H

#include "cli/circuit_options.h"

typedef struct glint_exhaustive_choice {
    glint_circuit_options circuits;
    bool exhaustive, json, every_lane, seed_given, threads_given, out_given;
    int64_t from, stride, seed, threads;
    const char *shard, *out;
    int64_t shard_number, shard_count;
} glint_exhaustive_choice;

/* Returns GLINT_OPTIONS_RUN with *chosen filled, or the exit status to leave with. One circuit is
 * chosen. */
int glint_exhaustive_options_parse(int argc, char **argv, glint_exhaustive_choice *chosen);

/* Of a circuit that is no highlight unit: every point of its domain (verify_domain.c). */
int glint_verify_domain(const glint_exhaustive_choice *chosen);

/* Printed with every result for a highlight unit: where differences could remain. */
#define GLINT_NOT_REACHED                                                                          \
    "material changes in flight, partly valid lanes, stalls, resets, registers"

/* Appends " --threads N --out DIR --json", each if it was given. */
void glint_exhaustive_options_append(const glint_exhaustive_choice *chosen, char *text,
                                     size_t size);

#endif
