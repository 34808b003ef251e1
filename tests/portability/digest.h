/* The C model's results condensed to a few numbers, which a program on another kind of machine
 * prints as well (main.c): 64-bit FNV-1a over the values' bytes, lowest first regardless of the
 * machine's byte order.
 *
 * The domain is the same for all: PORTABILITY_EXPONENTS of n, PORTABILITY_CODES of the cosine, a
 * colour that depends on n; all the divisions of PORTABILITY_DIFFERENCES by every k and every
 * number of shifts. */
#ifndef GLINT_TESTS_PORTABILITY_DIGEST_H
#define GLINT_TESTS_PORTABILITY_DIGEST_H

#include <stdint.h>
#include <stdio.h>

enum {
    PORTABILITY_EXPONENTS = 147,
    PORTABILITY_CODES = 512,
    PORTABILITY_DIFFERENCES = 511,
};

static inline uint32_t portability_exponent(int i)
{
    return (uint32_t)i * 7;
}

/* Even and odd codes from 0 to 1.0. */
static inline uint32_t portability_code(int i)
{
    return i == 0 ? UINT32_C(262144) : (uint32_t)(i - 1) * 513;
}

static inline uint8_t portability_color(uint32_t n, int component)
{
    return component == 0 ? 255 : (uint8_t)(n * (component == 1 ? 1 : 7));
}

#define PORTABILITY_DIGEST_START UINT64_C(0xcbf29ce484222325)

static inline uint64_t portability_take(uint64_t digest, uint64_t value, int bytes)
{
    for (int i = 0; i < bytes; i++)
        digest = (digest ^ (value >> 8 * i & 0xff)) * UINT64_C(0x100000001b3);
    return digest;
}

/* W, R, G and B of a point. */
static inline uint64_t portability_take_point(uint64_t digest, uint32_t w, uint8_t r, uint8_t g,
                                              uint8_t b)
{
    return portability_take(digest, w | (uint64_t)r << 32 | (uint64_t)g << 40 | (uint64_t)b << 48,
                            7);
}

/* Prints the digests of this machine's C model, "name hexadecimal" a line. */
void portability_print(FILE *out);

#endif
