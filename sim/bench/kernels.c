/* The baseline loops. Some are built for several instruction sets (multiversion.h), some
 * deliberately kept scalar. */
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

void glint_kernel_integer_division(int shifts, const glint_division *restrict divisions,
                                   size_t count, glint_quotients *restrict quotients)
{
    for (size_t i = 0; i < count; i++) {
        for (int c = 0; c < GLINT_DIVIDER_COMPONENTS; c++)
            quotients[i].code[c] = divisions[i].difference[c] * (1 << shifts) / divisions[i].k;
        quotients[i].out_of_table = false;
    }
}

GLINT_MULTIVERSION
void glint_kernel_float_division(const float *restrict difference, const float *restrict k,
                                 size_t count, float *restrict result)
{
    for (size_t i = 0; i < count; i++)
        result[i] = difference[i] / k[i];
}

void glint_kernel_float_division_scalar(const float *restrict difference, const float *restrict k,
                                        size_t count, float *restrict result)
{
    for (size_t i = 0; i < count; i++) {
        result[i] = difference[i] / k[i];
        /* As above. */
        __asm__ volatile("" ::: "memory");
    }
}
