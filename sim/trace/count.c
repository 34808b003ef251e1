/* The thesis's counts of traced pixels, and ours. */
#include "trace/count.h"

static uint64_t ceil_of(uint64_t a, uint64_t b)
{
    return (a + b - 1) / b;
}

uint64_t glint_count_row(int width, int segment)
{
    return ceil_of((uint64_t)width - 1, (uint64_t)segment + 1) + 1;
}

uint64_t glint_count_by_2_28(int width, int segment)
{
    return ceil_of((uint64_t)width, (uint64_t)segment + 1) + 1;
}

uint64_t glint_count_by_2_31(int width, uint64_t inner)
{
    return ceil_of((uint64_t)width, inner + 1) + 1;
}
