/* A highlight unit's Verilog against its C model over the whole domain: W and the three colours of
 * every code of the cosine pin, 0…GLINT_COS_CODE_MAX, with every n, and every pair of a reachable W
 * code and a colour in multipliers 13, 14 and 15.
 *
 * The work is split by n. For each n and each circuit there are these sweeps:
 *   1. every cosine code with the colour 255,255,255;
 *   2. every cosine code with a colour that n chooses;
 *   3. the multipliers: a quarter of all the W codes with the colours c, c+85, c+170 (mod 256). The
 *      quarter is n / 256 and c is n mod 256: all n together try every W with every colour in each
 *      multiplier. The W codes are those of n = 2 for the specular device, where σ = 1 and
 *      t = cos γ, so that every possible t and W occurs; for other units those of n = 1…16 (a sweep
 *      for each n that adds some). A W that occurs elsewhere and not there is reported.
 *
 * Which lane sees what. A sweep fills every lane in every clock, so with `lanes` lanes each of them
 * sees one code in `lanes` of a sweep. The assignment rotates: code c of sweep 1 (with a stride,
 * the c-th that is taken) goes through lane c − n − n/16 (mod lanes), of sweep 2 through the one
 * lanes/2 away; with more than 16 lanes it is n/lanes. So with 1, 2, 4, 8 or 16 lanes any 16 values
 * of n from a multiple of 16 on take each code through each lane, equally often; but a lane does
 * not see each code with each n. With every_lane it does: each sweep runs `lanes` times, one lane
 * further each time.
 *
 * Not covered, because the inputs are one steady flow: a material is written with the first clock
 * of a run of at most 4096 points, when nothing is in flight; either all lanes are valid or none;
 * enable is always 1; the only reset is the initial one. Only outputs are compared. Lockstep and
 * `make formal` cover the rest. */
#ifndef GLINT_SIM_LOCKSTEP_EXHAUSTIVE_H
#define GLINT_SIM_LOCKSTEP_EXHAUSTIVE_H

#include <stdbool.h>

#include "circuit/units.h"
#include "lockstep/answer.h"
#include "lockstep/history.h"

#define GLINT_EXHAUSTIVE_CIRCUITS_MAX 32
#define GLINT_EXHAUSTIVE_THREADS_MAX  64
#define GLINT_EXHAUSTIVE_KEPT         16
#define GLINT_EXHAUSTIVE_CODES        (GLINT_COS_CODE_MAX + 1u) /* of the cosine pin */
#define GLINT_EXHAUSTIVE_WS           (GLINT_W_ONE + 1u)        /* codes of the widest W */

typedef struct glint_exhaustive_options {
    glint_setting setting[GLINT_EXHAUSTIVE_CIRCUITS_MAX]; /* of highlight units (units.h) */
    int settings;
    uint32_t from;          /* the first n, 0…1023 */
    uint32_t shard, shards; /* those n with n mod shards = shard − 1; 1…shards, 1…1024 */
    uint32_t stride; /* of the codes only every stride-th, 1…GLINT_EXHAUSTIVE_CODES; 1: all */
    uint64_t seed;   /* of where the stride begins, for each n */
    bool every_lane; /* each sweep once for each lane, so that each lane sees all of it */
    int threads;     /* 1…GLINT_EXHAUSTIVE_THREADS_MAX */
    const volatile bool *stop;                                      /* may be NULL */
    void (*progress)(void *context, uint64_t done, uint64_t total); /* points; may be NULL */
    void *progress_context;
    bool keep_history; /* in the result; to be destroyed */
} glint_exhaustive_options;

typedef struct glint_exhaustive_mismatch {
    uint32_t n; /* the part of the work; the material's n is another in the multipliers' */
    glint_setting setting;
    glint_answer answer;
} glint_exhaustive_mismatch;

/* What came of one circuit. */
typedef struct glint_exhaustive_circuit {
    uint64_t points;      /* asked for; up to lanes − 1 of a sweep may be there twice */
    uint64_t comparisons; /* values compared, counted where they are: GLINT_ANSWER_VALUES a point */
    uint64_t mismatches;  /* values that differ */
    uint64_t pairs;       /* of W and a colour that each multiplier was tried with; with every_lane
                           * that of each lane */
    uint64_t pairs_total; /* with all n and stride 1 */
    uint32_t w_codes;     /* different W codes that occurred, */
    uint32_t w_possible;  /* of so many from 0 to 1 */
    uint32_t w_untried;   /* of them, those that are not among the multipliers' */
} glint_exhaustive_circuit;

typedef struct glint_exhaustive_result {
    glint_exhaustive_circuit circuit[GLINT_EXHAUSTIVE_CIRCUITS_MAX]; /* in the order of setting */
    uint32_t n_done;                                                 /* how many n */
    uint32_t next; /* every chosen n below it is done; GLINT_N_COUNT: all are */
    int kept;      /* the first mismatches, n rising */
    glint_exhaustive_mismatch mismatch[GLINT_EXHAUSTIVE_KEPT];
    glint_history *history; /* of the first mismatch's circuit up to it, or of a circuit that failed
                             * to answer; NULL: neither, not requested, or out of memory */
} glint_exhaustive_result;

/* Where the stride begins for this n: 0…stride−1. */
uint32_t glint_exhaustive_offset(const glint_exhaustive_options *options, uint32_t n);

/* Runs it, one circuit of each setting for each thread; progress is called on the caller's thread.
 * GLINT_OK regardless of the finding, which is in result. GLINT_INTERRUPTED if stopped: any n
 * already started is finished, and result->next says where to resume. GLINT_BAD_ARGUMENT for
 * options out of range or an empty selection of n. GLINT_DEVICE_FAULT if a circuit fails to
 * answer. */
glint_status glint_exhaustive_run(const glint_exhaustive_options *options,
                                  glint_exhaustive_result *result, glint_error *err);

#endif
