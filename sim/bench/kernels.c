#include "bench/kernels.h"

#include <math.h>

#include "multiversion.h"

void glint_kernel_powf(const float *restrict cosine, size_t count, float n, float *restrict result)
{
    for (size_t i = 0; i < count; i++)
        result[i] = powf(cosine[i], n);
}

void glint_kernel_pow(const float *restrict cosine, size_t count, double n, float *restrict result)
{
    for (size_t i = 0; i < count; i++)
        result[i] = (float)pow((double)cosine[i], n);
}

static inline float schlick(float cosine, float n)
{
    return cosine / (n - n * cosine + cosine);
}

GLINT_MULTIVERSION
void glint_kernel_schlick(const float *restrict cosine, size_t count, float n,
                          float *restrict result)
{
    for (size_t i = 0; i < count; i++)
        result[i] = schlick(cosine[i], n);
}

void glint_kernel_schlick_scalar(const float *restrict cosine, size_t count, float n,
                                 float *restrict result)
{
    for (size_t i = 0; i < count; i++) {
        result[i] = schlick(cosine[i], n);
        /* Keeps the compiler from joining this point with its neighbours. */
        __asm__ volatile("" ::: "memory");
    }
}
