/* The circuits by definition, in exact rationals of arbitrary size (GMP), for a bit-for-bit
 * comparison with the C model. Written from the formulas and docs/formats.md and sharing nothing
 * with cmodel/: no truncation, no shifts, and every rounding is the one function below.
 *
 *     σ = ⟨(n+1)/3⟩₁₃     t = 1 + ⟨σ(c − 1)⟩₁₈     W = ⟨t²⟩₁₈     (R,G,B)out = ⟨W·(R,G,B)⟩₀
 *
 * ⟨x⟩_f is the multiple of 2^−f nearest to x, the larger one where two are. c is the cosine; where
 * t < 0, W is 0 (gates cosine and sign). Gate drawn: W is 0 where ⟨t²⟩₁₈ is below ⟨1/510⟩₁₈, 1
 * where it is above 1. */
#ifndef GLINT_TESTS_REFERENCE_REFERENCE_H
#define GLINT_TESTS_REFERENCE_REFERENCE_H

#include <gmp.h>
#include <stdbool.h>
#include <stdint.h>

enum {
    REFERENCE_COS_BITS = 18, /* fraction bits of the cosine, of t and of W */
    REFERENCE_SIGMA_BITS = 13,
    REFERENCE_ONE = 1 << REFERENCE_COS_BITS,
    REFERENCE_CODES = 2 * REFERENCE_ONE, /* of the cosine: what 19 bits hold */
    REFERENCE_W_CODES = REFERENCE_ONE + 1,
};

/* floor(x·2^f + 1/2): the code of ⟨x⟩_f. */
long reference_nearest(const mpq_t x, unsigned f);

/* The same for the rational numerator / denominator. */
long reference_nearest_of(long numerator, unsigned long denominator, unsigned f);

/* The code of W for every cosine code, above 1.0 as for 1.0: gates cosine and sign in w, gate drawn
 * in drawn. *limit: the least code with t ≥ 0. */
void reference_w(unsigned long n, uint32_t *w, uint32_t *drawn, uint32_t *limit);

/* ⟨W·color⟩₀ for every W code. */
void reference_colors(unsigned long color, uint8_t *products);

/* The bits of 1/k in the divider's table, ⟨1/k⟩ with `shifts` fraction bits; 0 outside of it. */
long reference_reciprocal(unsigned shifts, unsigned long k);

/* (2.18): the sum of difference/2^j over those j whose bit is 1, as a code with `shifts` fraction
 * bits. false if it is not a whole number of units. */
bool reference_quotient(unsigned shifts, long difference, long bits, long *code);

#endif
