/* What the device is measured against: cos^n with the C library, and Schlick's formula (2.1), each
 * in a plain loop over many cosines. */
#ifndef GLINT_SIM_KERNELS_H
#define GLINT_SIM_KERNELS_H

#include <stddef.h>

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

#endif
