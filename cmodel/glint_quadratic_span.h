/* The span unit of quadratic interpolation, bit-exact: intensities along a row of a triangle by
 * second differences (docs/quadratic-span.md).
 *
 * Along a row the interpolated intensity (appendix A of the thesis) is a polynomial of second
 * degree in the pixel's place i, so three numbers and two additions a pixel and component give it:
 *
 *     value(0) = start    value(i+1) = value(i) + slope(i)
 *     slope(0) = first    slope(i+1) = slope(i) + second
 *
 * that is value(i) = start + i·first + i·(i−1)/2·second. A pixel's intensity is its value rounded
 * half up and held in 0 … 255.
 *
 * Formats. All three numbers, and both sums, are S10.F, F = `fraction`. Sums wrap around; since all
 * are modulo the same power of two, a value that fits in S10.F is right whatever wrapped on the way
 * there. On a triangle values are −85 … 340 (the six given ones being 0 … 255), and S10 holds −512
 * … 511.
 *
 * Error. Where the three numbers are rounded to nearest, value(i) is off by at most
 * 2^−(F+1)·(1 + i + i·(i−1)/2). glint_quadratic_span_longest() is how many pixels keep that within
 * half a level.
 *
 * Here the unit is a pure function, and clock by clock: the twin of rtl/quadratic_span.v. */
#ifndef GLINT_CMODEL_QUADRATIC_SPAN_H
#define GLINT_CMODEL_QUADRATIC_SPAN_H

#include <stddef.h>
#include <stdint.h>

#include "glint_formats.h"
#include "glint_status.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Bits before and behind the binary point; the former include the sign. By default, spans of 724
 * pixels stay within half a level. */
#define GLINT_QUADRATIC_SPAN_INT_BITS         10
#define GLINT_QUADRATIC_SPAN_FRACTION_MIN     8
#define GLINT_QUADRATIC_SPAN_FRACTION_MAX     26
#define GLINT_QUADRATIC_SPAN_FRACTION_DEFAULT 18

#define GLINT_QUADRATIC_SPAN_COMPONENTS 3

GLINT_REQUIRE(GLINT_QUADRATIC_SPAN_INT_BITS + GLINT_QUADRATIC_SPAN_FRACTION_MAX < 64,
              "a code fits in 64 bits");

/* What the unit is loaded with: codes with `fraction` fraction bits, of which only the low 10 +
 * fraction count. */
typedef struct glint_quadratic_walk {
    int64_t start[GLINT_QUADRATIC_SPAN_COMPONENTS];
    int64_t first[GLINT_QUADRATIC_SPAN_COMPONENTS];  /* value(1) − value(0) */
    int64_t second[GLINT_QUADRATIC_SPAN_COMPONENTS]; /* slope(1) − slope(0) */
} glint_quadratic_walk;

/* The most pixels of a span whose last value is off by at most half a level: the largest L with
 * 1 + L·(L−1)/2 ≤ 2^fraction. */
int glint_quadratic_span_longest(int fraction);

/* The intensities of pixels 0 … count−1, three bytes each. GLINT_BAD_ARGUMENT for a fraction out of
 * range. */
glint_status glint_quadratic_span(int fraction, const glint_quadratic_walk *walk, size_t count,
                                  uint8_t *rgb);

/* The unit's registers after `steps` pixels more: a walk from there. */
glint_quadratic_walk glint_quadratic_span_after(int fraction, const glint_quadratic_walk *walk,
                                                size_t steps);

/* ---- Clock by clock -------------------------------------------------------------------------- */

/* What the input pins carry at one rising edge. load: the three numbers are taken; step, without
 * load: on to the next pixel. */
typedef struct glint_quadratic_span_pins {
    uint8_t reset, en, load, step;
    glint_quadratic_walk walk;
} glint_quadratic_span_pins;

/* One component's signals. */
typedef struct glint_quadratic_component {
    int64_t value, slope, curve;    /* registers */
    int64_t next_value, next_slope; /* the two adders */
    int64_t level, clamped;         /* the value rounded, and held in 0 … 255 */
    int64_t out;
} glint_quadratic_component;

typedef struct glint_quadratic_span_signals {
    int64_t s1_valid;
    glint_quadratic_component component[GLINT_QUADRATIC_SPAN_COMPONENTS];
    int64_t out_valid;
} glint_quadratic_span_signals;

/* One rising edge; *signals begins as zeros. en = 0 freezes everything; reset = 1 clears everything
 * regardless of en. */
void glint_quadratic_span_clock(int fraction, glint_quadratic_span_signals *signals,
                                const glint_quadratic_span_pins *pins);

/* Clocks from the edge that loads or steps to the one after which that pixel is out, both counted.
 */
#define GLINT_QUADRATIC_SPAN_LATENCY 2

#ifdef __cplusplus
}
#endif

#endif
