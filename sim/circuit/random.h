/* A small seeded generator (splitmix64) that gives the same run on every machine. */
#ifndef GLINT_SIM_CIRCUIT_RANDOM_H
#define GLINT_SIM_CIRCUIT_RANDOM_H

#include <stdbool.h>
#include <stdint.h>

typedef struct glint_random {
    uint64_t state; /* set it to the seed */
} glint_random;

static inline uint64_t glint_random_bits(glint_random *random)
{
    uint64_t z = random->state += UINT64_C(0x9e3779b97f4a7c15);
    z = (z ^ (z >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
    z = (z ^ (z >> 27)) * UINT64_C(0x94d049bb133111eb);
    return z ^ (z >> 31);
}

/* A number 0…count−1; count 1…2^32−1. */
static inline uint32_t glint_random_below(glint_random *random, uint32_t count)
{
    return (uint32_t)((glint_random_bits(random) >> 32) * count >> 32);
}

/* True in `chances` of 256 cases. */
static inline bool glint_random_chance(glint_random *random, uint32_t chances)
{
    return (glint_random_bits(random) >> 56) < chances;
}

#endif
