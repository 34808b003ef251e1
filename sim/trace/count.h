/* How many pixels of a row are traced: the thesis's formulas (2.28) and (2.31), and the truth.
 * segment: L, a segment's inner pixels, those between two traced ones, ≥ 0. width ≥ 1. */
#ifndef GLINT_SIM_TRACE_COUNT_H
#define GLINT_SIM_TRACE_COUNT_H

#include <stddef.h>
#include <stdint.h>

/* The first pixel, each (L+1)th after it, and the last: ⌈(Xmax−1)/(L+1)⌉ + 1. */
uint64_t glint_count_row(int width, int segment);

/* (2.28): ⌈Xmax/(L+1) + 1⌉, one too many where L+1 divides Xmax − 1. */
uint64_t glint_count_by_2_28(int width, int segment);

/* (2.31), for a row's segments of different lengths, as it is printed: ⌈Xmax/(ΣL + 1)⌉ + 1. The
 * truth is segments + 1. inner: the sum of the lengths. */
uint64_t glint_count_by_2_31(int width, uint64_t inner);

#endif
