/* Drives every circuit that counts its lines and toggles: the random pins of lockstep and a strided
 * part of the exhaustive run, each compared with the C model. Clock for clock it does what `glint
 * verify` does; the counts are written by the circuits themselves as they go (sim/rtl/shim.cpp).
 *
 *   drive DIR: where the counts go
 *
 * GLINT_COVERAGE_CLOCKS: clocks of lockstep for each circuit; GLINT_SEED: their seed. */
#define _POSIX_C_SOURCE 200809L

#include <inttypes.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include "../netlist/opinions.h"
#include "circuit/circuits.h"
#include "lockstep/exhaustive.h"
#include "lockstep/lockstep.h"

enum { STRIDE = 4093 }; /* of the cosine codes: 65 of them for each n, and for each colour */

typedef struct counts {
    uint64_t comparisons, mismatches;
} counts;

static glint_status run_random(const glint_setting *setting, uint64_t clocks, uint64_t seed,
                               counts *counts, glint_error *err)
{
    static glint_lockstep_result found;
    const glint_lockstep_options options = {.setting = *setting, .clocks = clocks, .seed = seed};
    const glint_status status = glint_lockstep_run(&options, &found, err);
    counts->comparisons += found.comparisons;
    counts->mismatches += found.mismatches;
    return status;
}

static glint_status run_sweep(const glint_setting *setting, uint64_t seed, counts *counts,
                              glint_error *err)
{
    static glint_exhaustive_result result;
    const glint_exhaustive_options options = {.setting = {*setting},
                                              .settings = 1,
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

/* What its instances leave: DIR/SETTING-NUMBER.dat. */
static bool count_in(const char *directory, const opinion *circuit)
{
    char name[GLINT_SETTING_TEXT], path[1024];
    glint_setting_name(&circuit->setting, name);
    (void)snprintf(path, sizeof path, "%s/%s", directory, name);
    return opinion_choose(circuit) && setenv("GLINT_COVERAGE", path, 1) == 0;
}

static glint_status run(const opinion *circuit, const char *directory, uint64_t clocks,
                        uint64_t seed, counts *counts, glint_error *err)
{
    if (!count_in(directory, circuit))
        return glint_fail(err, GLINT_NO_MEMORY, "not enough memory for the environment");
    glint_status status = run_random(&circuit->setting, clocks, seed, counts, err);
    if (status == GLINT_OK && circuit->setting.circuit == &glint_circuit_specular)
        status = run_sweep(&circuit->setting, seed, counts, err);
    return status;
}

static uint64_t number_from(const char *name, uint64_t otherwise)
{
    const char *given = getenv(name);
    return given != NULL ? strtoull(given, NULL, 0) : otherwise;
}

int main(int argc, char **argv)
{
    static opinion circuits[OPINIONS_MAX];
    const uint64_t clocks = number_from("GLINT_COVERAGE_CLOCKS", 300000);
    const uint64_t seed = number_from("GLINT_SEED", 1);
    const int count = opinions_read("coverage/circuits", circuits);
    counts all = {0};
    if (argc != 2 || count < 0) {
        (void)fprintf(stderr, "drive: a directory, and a list of circuits, are needed\n");
        return 2;
    }
    for (int i = 0; i < count; i++) {
        glint_error err;
        if (run(&circuits[i], argv[1], clocks, seed, &all, &err) != GLINT_OK) {
            (void)fprintf(stderr, "%s: %s\n", circuits[i].name, err.text);
            return 1;
        }
    }
    printf("%" PRIu64 " mismatches of %" PRIu64 " comparisons, %d circuits, seed %" PRIu64 "\n",
           all.mismatches, all.comparisons, count, seed);
    return all.mismatches == 0 && all.comparisons > 0 ? 0 : 1;
}
