/* The Verilog against the C model over the whole domain in a circuit's description (glint_domain):
 * each point goes in on one clock, and every output is compared after every clock.
 *
 * A point's pins: all 0 except enables, the lowest bit of valid pins and active-low resets, which
 * are 1; then the domain's put(). A circuit with a pace gets idle clocks after each point, with no
 * valid pin set. Points run in order, in blocks of GLINT_DOMAIN_BLOCK clocks; each block starts
 * from reset with its own circuits and ends with idle clocks until everything has come out. A
 * block's result is therefore independent of the number of threads, and it can be replayed by
 * itself.
 *
 * Not covered: resets and stalls, unless the domain's points contain them, and signals other than
 * outputs. Lockstep covers those. */
#ifndef GLINT_SIM_LOCKSTEP_DOMAIN_H
#define GLINT_SIM_LOCKSTEP_DOMAIN_H

#include <stdbool.h>

#include "lockstep/lockstep.h"

#define GLINT_DOMAIN_BLOCK       32768 /* clocks, idle ones included; at least one point */
#define GLINT_DOMAIN_THREADS_MAX 64

typedef struct glint_domain_options {
    glint_setting setting;
    uint64_t from;             /* the first point, 0… */
    uint64_t shard, shards;    /* those points p with p mod shards = shard − 1; 1…shards */
    uint64_t stride;           /* of them only every stride-th; 1: all */
    uint64_t seed;             /* of where the stride begins */
    int threads;               /* 1…GLINT_DOMAIN_THREADS_MAX */
    const volatile bool *stop; /* may be NULL */
    void (*progress)(void *context, uint64_t done, uint64_t total); /* points; may be NULL */
    void *progress_context;
} glint_domain_options;

/* One output that differed. */
typedef struct glint_domain_mismatch {
    uint64_t block, point; /* the block's number, from 0 on; the last point taken before it */
    glint_mismatch signal; /* its clock: of the block */
} glint_domain_mismatch;

typedef struct glint_domain_result {
    uint64_t points_total; /* of the domain */
    uint64_t points;       /* taken */
    uint64_t clocks;       /* compared after */
    uint64_t comparisons;  /* values compared, counted where they are */
    uint64_t mismatches;   /* values that differ */
    uint64_t next;         /* every chosen point below it is done; points_total: all are */
    int kept;              /* the first mismatches, blocks rising */
    glint_domain_mismatch mismatch[GLINT_MISMATCHES_KEPT];
} glint_domain_result;

/* Where the stride begins: 0…stride−1. */
uint64_t glint_domain_offset(const glint_domain_options *options);

/* Runs it; progress is called on the caller's thread. GLINT_OK regardless of the finding, which is
 * in result. GLINT_INTERRUPTED if stopped: blocks already started are finished, and result->next
 * says where to resume. GLINT_BAD_ARGUMENT for a circuit without a domain or without outputs, for
 * options out of range, or with no point among those chosen. */
glint_status glint_domain_run(const glint_domain_options *options, glint_domain_result *result,
                              glint_error *err);

/* The pins of a block, from its first clock, which is clock 1, to `after` clocks behind the given
 * one or to the block's end; to be freed with free(). NULL: no memory. */
glint_pins *glint_domain_pins(const glint_domain_options *options, uint64_t block, uint64_t clock,
                              uint64_t after, size_t *count);

#endif
