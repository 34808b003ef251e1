/* Drives every circuit that counts its lines and toggles: the random pins of lockstep and a strided
 * part of the exhaustive run, each compared with the C model. Clock for clock it does what `glint
 * verify` does; the counts are written by the circuits themselves as they go (counters.hpp).
 *
 * GLINT_COVERAGE_CLOCKS: clocks of lockstep for each circuit; GLINT_SEED: their seed. */
#include <inttypes.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include "../netlist/opinions.h"
#include "lockstep/exhaustive.h"
#include "lockstep/lockstep.h"

enum { STRIDE = 4093 }; /* of the cosine codes: 65 of them for each n, and for each colour */

typedef struct counts {
    uint64_t comparisons, mismatches;
} counts;

static glint_status run_random(const opinion *circuit, uint64_t clocks, uint64_t seed,
                               counts *counts, glint_error *err)
{
    static glint_lockstep_result found;
    const glint_lockstep_options options = {
        .setting = opinion_setting(circuit), .clocks = clocks, .seed = seed};
    const glint_status status = glint_lockstep_run(&options, &found, err);
    counts->comparisons += found.comparisons;
    counts->mismatches += found.mismatches;
    return status;
}

static glint_status run_sweep(const glint_rtl_model *model, uint64_t seed, counts *counts,
                              glint_error *err)
{
    static glint_exhaustive_result result;
    const glint_exhaustive_options options = {.config = {model->config},
                                              .configs = 1,
                                              .model = model,
                                              .shard = 1,
                                              .shards = 1,
                                              .stride = STRIDE,
                                              .seed = seed,
                                              .threads = 1};
    const glint_status status = glint_exhaustive_run(&options, &result, err);
    counts->comparisons += result.circuit[0].comparisons;
    counts->mismatches += result.circuit[0].mismatches;
    return status;
}

static uint64_t number_from(const char *name, uint64_t otherwise)
{
    const char *given = getenv(name);
    return given != NULL ? strtoull(given, NULL, 0) : otherwise;
}

int main(void)
{
    const uint64_t clocks = number_from("GLINT_COVERAGE_CLOCKS", 300000);
    const uint64_t seed = number_from("GLINT_SEED", 1);
    counts all = {0};
    for (int i = 0; i < opinion_count; i++) {
        glint_error err;
        glint_status status = run_random(&opinions[i], clocks, seed, &all, &err);
        if (status == GLINT_OK && opinions[i].specular != NULL)
            status = run_sweep(opinions[i].specular, seed, &all, &err);
        if (status != GLINT_OK) {
            (void)fprintf(stderr, "%s: %s\n", opinions[i].name, err.text);
            return 1;
        }
    }
    printf("%" PRIu64 " mismatches of %" PRIu64 " comparisons, %d circuits, seed %" PRIu64 "\n",
           all.mismatches, all.comparisons, opinion_count, seed);
    return all.mismatches == 0 && all.comparisons > 0 ? 0 : 1;
}
