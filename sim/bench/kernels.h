/* The baselines for the circuits, each in a plain loop: cos^n with the C library and Schlick's
 * formula (2.1) over many cosines; the machine's own division over many divisions. */
#ifndef GLINT_SIM_BENCH_KERNELS_H
#define GLINT_SIM_BENCH_KERNELS_H

#include <stddef.h>

#include "glint_divider.h"

/* result[i] = cosine[i]^n, by powf(), call after call. */
void glint_kernel_powf(const float *restrict cosine, size_t count, float n, float *restrict result);

/* The same by pow(). */
void glint_kernel_pow(const float *restrict cosine, size_t count, double n, float *restrict result);

/* result[i] = c / (n − n·c + c), as the compiler vectorises it. */
void glint_kernel_schlick(const float *restrict cosine, size_t count, float n,
                          float *restrict result);

/* The same with one point after the other. */
void glint_kernel_schlick_scalar(const float *restrict cosine, size_t count, float n,
                                 float *restrict result);

/* Quotients as glint_divide_batch() gives them (k in the table is assumed), but by the machine's
 * integer division, cut off towards 0. */
void glint_kernel_integer_division(int shifts, const glint_division *restrict divisions,
                                   size_t count, glint_quotients *restrict quotients);

/* result[i] = difference[i]/k[i] in single precision, one after the other. */
void glint_kernel_float_division_scalar(const float *restrict difference, const float *restrict k,
                                        size_t count, float *restrict result);

/* The same as the compiler vectorises it. */
void glint_kernel_float_division(const float *restrict difference, const float *restrict k,
                                 size_t count, float *restrict result);

#endif
