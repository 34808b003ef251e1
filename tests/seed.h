/* The seed of a random test: new each time, printed, and reproducible with GLINT_SEED. Include it
 * after cmocka.h. */
#ifndef GLINT_TESTS_SEED_H
#define GLINT_TESTS_SEED_H

#include <inttypes.h>
#include <stdlib.h>
#include <time.h>

static inline uint64_t seed_of_this_run(void)
{
    const char *given = getenv("GLINT_SEED");
    const uint64_t seed = given != NULL ? strtoull(given, NULL, 0) : (uint64_t)time(NULL);
    print_message("seed %" PRIu64 " (the same again: GLINT_SEED=%" PRIu64 ")\n", seed, seed);
    return seed;
}

#endif
